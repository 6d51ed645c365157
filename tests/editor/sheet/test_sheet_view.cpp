// The sheet's view in ImGui frames, driven by mouse and keyboard.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "editor/frame/keyboard.h"
#include "editor/sheet/panel_faces.h"
#include "editor/sheet/sheet_labels.h"
#include "editor/sheet/sheet_paint.h"
#include "editor/sheet/sheet_view.h"
#include "sim/pattern/outline.h"
#include "sim/tartan/tartan_file.h"
#include "tests/editor/sheet/sheet_support.h"

namespace selvedge::editor {
namespace {

TEST(SheetView, frames_all_panels_when_it_opens) {
    SheetFixture stage(shipped_pattern("tshirt"));
    const SheetBox seen = visible_box(stage.view.camera());
    EXPECT_TRUE(seen.contains(stage.tools.geometry().box()));
}

TEST(SheetView, f_frames_what_is_selected) {
    SheetFixture stage(shipped_pattern("tshirt"));
    const double before = stage.view.camera().scale;
    stage.click(stage.vertex("front", 0) + 0.5 * (stage.vertex("front", 2) - stage.vertex("front", 0)));
    ASSERT_EQ(stage.document.selection().panels.size(), 1U);
    stage.key(key_of('F'));
    EXPECT_GT(stage.view.camera().scale, before);
    EXPECT_TRUE(visible_box(stage.view.camera()).contains(stage.tools.geometry().find("front")->sheet_box()));
}

TEST(SheetView, frames_all_panels_that_are_not_hidden) {
    SheetFixture stage(shipped_pattern("tshirt"));
    const double all = stage.view.camera().scale;
    PanelStates states;
    for (const sim::Panel& panel : stage.document.pattern().panels)
        if (panel.name != "front") states.hidden.insert(panel.name);
    stage.document.set_panel_states(states);
    stage.view.frame_all();
    stage.frame();
    EXPECT_GT(stage.view.camera().scale, 1.2 * all);
    EXPECT_TRUE(visible_box(stage.view.camera()).contains(stage.tools.geometry().find("front")->sheet_box()));
}

TEST(SheetView, the_wheel_zooms_to_the_cursor) {
    SheetFixture stage(shipped_pattern("tshirt"));
    const Vec2d at = stage.vertex("front", 0);
    const Vec2d px = to_px(stage.view.camera(), at);
    const double before = stage.view.camera().scale;
    stage.wheel(at, 2);
    EXPECT_GT(stage.view.camera().scale, before);
    EXPECT_LT((to_px(stage.view.camera(), at) - px).norm(), 1);
}

TEST(SheetView, the_middle_button_pans_and_the_right_one_asks_for_a_menu_where_it_only_clicks) {
    SheetFixture stage(shipped_pattern("tshirt"));
    const Vec2d centre = stage.view.camera().centre;
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = {500, 400};
    stage.frame();
    io.MouseDown[2] = true;
    stage.frame();
    io.MousePos = {560, 400};
    stage.frame();
    io.MouseDown[2] = false;
    stage.frame();
    EXPECT_NEAR(stage.view.camera().centre.x(), centre.x() - 60 / stage.view.camera().scale, 1e-9);
    EXPECT_FALSE(stage.answer.wants_menu);
    io.MouseDown[1] = true;
    stage.frame();
    io.MouseDown[1] = false;
    stage.frame();
    EXPECT_TRUE(stage.answer.wants_menu);
}

TEST(SheetView, a_dragged_vertex_is_one_entry_of_the_history) {
    SheetFixture stage(shipped_pattern("tshirt"));
    const Vec2d at = stage.vertex("front", 0);
    stage.drag(at, at + Vec2d(-0.03, -0.02));
    EXPECT_EQ(stage.document.position(), 1U);
    EXPECT_GT((stage.vertex("front", 0) - at).norm(), 0.02);
}

TEST(SheetView, keys_that_it_uses_are_named_and_others_are_left) {
    SheetFixture stage(shipped_pattern("tshirt"));
    stage.move({0, 0});
    set_key(ImGui::GetIO(), key_of('H'), true);
    stage.frame();
    EXPECT_EQ(stage.answer.used_keys, (std::vector<Key>{key_of('H')}));
    EXPECT_EQ(stage.tools.info().id, "polygon");
    set_key(ImGui::GetIO(), key_of('H'), false);
    ImGui::GetIO().KeyCtrl = true;
    set_key(ImGui::GetIO(), key_of('Z'), true);
    stage.frame();
    EXPECT_TRUE(stage.answer.used_keys.empty());
    EXPECT_EQ(stage.tools.info().id, "polygon");
}

TEST(SheetView, a_tartan_is_held_once_for_each_size) {
    SheetFixture stage(shipped_pattern("tshirt"));
    ASSERT_EQ(stage.output.pictures.size(), 1U);
    for (int i = 0; i < 5; ++i) stage.frame();
    EXPECT_EQ(stage.output.pictures.size(), 1U);
    stage.wheel({0, 0}, 12);
    EXPECT_EQ(stage.output.pictures.size(), 2U);
    stage.document.run(SetTartan{.tartan = "black_watch"});
    stage.frame();
    EXPECT_EQ(stage.output.pictures.size(), 3U);
}

TEST(SheetView, panels_out_of_view_cost_nothing) {
    SheetFixture stage(shipped_pattern("tshirt"));
    const std::size_t framed = stage.drawn_vertices();
    stage.view.set_camera({.centre = Vec2d(50, 50), .scale = stage.view.camera().scale});
    stage.frame();
    EXPECT_LT(stage.drawn_vertices(), framed / 2);
}

TEST(SheetView, any_zoom_and_an_empty_document_can_be_drawn) {
    SheetFixture empty(sim::PatternDocument{});
    EXPECT_GT(empty.view.camera().scale, 0);
    SheetFixture stage(shipped_pattern("skirt"));
    for (const double scale : {kMinSheetScale, 300.0, 8000.0, kMaxSheetScale}) {
        stage.view.set_camera({.centre = stage.tools.geometry().box().min(), .scale = scale});
        stage.frame();
        EXPECT_LT(stage.drawn_vertices(), 300000U);
    }
}

bool meet(const LabelBox& a, const LabelBox& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

constexpr const char* kLongName =
    "front of the left half of the shell, to be cut twice on the fold from the second fabric";

sim::PatternDocument with_long_name() {
    sim::PatternDocument document = shipped_pattern("tshirt");
    document.pattern.panels[0].name = kLongName;
    return document;
}

TEST(SheetLabels, a_long_name_is_shortened_at_its_end_and_stays_within_its_panel) {
    for (const double scale : {1.0, 2.0}) {
        SheetFixture stage(with_long_name(), {900, 700, scale});
        const auto is_long = [](const PanelName& name) { return name.panel == kLongName; };
        const auto name = std::ranges::find_if(stage.view.names(), is_long);
        ASSERT_NE(name, stage.view.names().end());
        ASSERT_GT(name->shown.size(), 5U) << "at scale " << scale;
        EXPECT_FALSE(name->is_whole());
        EXPECT_TRUE(name->shown.ends_with("..."));
        EXPECT_TRUE(std::string(kLongName).starts_with(name->shown.substr(0, name->shown.size() - 3)));
        const SheetBox panel = stage.tools.geometry().find(kLongName)->sheet_box();
        EXPECT_GT(double(name->box.low.x), to_px(stage.view.camera(), panel.min()).x());
        EXPECT_LT(double(name->box.high.x), to_px(stage.view.camera(), panel.max()).x());
    }
}

TEST(SheetLabels, the_whole_name_is_a_tooltip_of_its_panel) {
    SheetFixture stage(with_long_name());
    const Vec2d middle = stage.tools.geometry().find(kLongName)->sheet_box().center();
    stage.move(middle);
    stage.frame();
    const auto has_tooltip = [] {
        const ImDrawData& drawn = *ImGui::GetDrawData();
        ImDrawList* const* lists = &drawn.CmdLists[0];  // an array, or since 1.89.8 a vector
        return std::any_of(lists, lists + drawn.CmdListsCount, [](const ImDrawList* list) {
            return std::string_view(list->_OwnerName).starts_with("##Tooltip");
        });
    };
    EXPECT_TRUE(has_tooltip());
    stage.move(stage.tools.geometry().find("back")->sheet_box().center());
    stage.frame();
    EXPECT_FALSE(has_tooltip()) << "this name is shown whole";
}

TEST(SheetLabels, badges_of_lengths_cover_no_name_and_no_other_badge) {
    for (const double scale : {1.0, 2.0}) {
        sim::PatternDocument document = shipped_pattern("tshirt");
        for (sim::Seam& seam : document.pattern.seams) seam.is_eased = false;
        for (Vec2d& vertex : document.pattern.panels[0].vertices) vertex.y() *= 1.3;  // its seams become uneven
        SheetFixture stage(std::move(document), {900, 700, scale});
        const std::vector<LabelBox>& boxes = stage.view.labels();
        const auto has_text = [](const PanelName& name) { return !name.shown.empty(); };
        const auto names = std::ranges::count_if(stage.view.names(), has_text);
        EXPECT_GT(std::ssize(boxes), names + 3) << "there are badges";
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(meet(boxes[i], boxes[k])) << i << " " << k;
        }
    }
}

TEST(SheetLabels, where_all_places_are_taken_the_one_is_used_that_covers_least) {
    LabelPlaces places;
    places.reserve({{0, 0}, {10, 10}});
    places.reserve({{18, 0}, {28, 10}});
    const std::array<ImVec2, 2> centres{ImVec2{5, 5}, ImVec2{14, 5}};
    const ImVec2 centre = places.place({10, 10}, centres);
    EXPECT_EQ(centre.x, 14);
    EXPECT_EQ(places.taken().size(), 3U);
}

TEST(SheetView, a_small_view_at_a_large_scale_is_used_for_the_panels) {
    SheetFixture stage(shipped_pattern("tshirt"), {200, 700, 2});
    const SheetBox seen = visible_box(stage.view.camera()), panels = stage.tools.geometry().box();
    EXPECT_GT(panels.sizes().x(), 0.5 * seen.sizes().x());
}

TEST(SeamPaint, a_seam_runs_inside_of_its_edge) {
    const std::vector<ImVec2> line{{100, 200}, {200, 200}};  // to the right: the inside is above, at smaller y
    const std::vector<ImVec2> inner = inset_line(line, 4, 10);
    ASSERT_EQ(inner.size(), 2U);
    EXPECT_FLOAT_EQ(inner[0].x, 110);
    EXPECT_FLOAT_EQ(inner[0].y, 196);
    EXPECT_FLOAT_EQ(inner[1].x, 190);
}

}  // namespace

namespace {

double area_of(const PanelFace& face) {
    double area = 0;
    for (const auto& [a, b, c] : face.triangles) {
        const Vec2d &p = face.points[std::size_t(a)], &q = face.points[std::size_t(b)],
                    &r = face.points[std::size_t(c)];
        area += sim::cross2(q - p, r - p) / 2;
    }
    return area;
}

TEST(PanelFaces, triangles_fill_the_outline_of_every_shipped_panel) {
    for (const char* name : {"tshirt", "skirt", "poncho"}) {
        for (const sim::Panel& panel : shipped_pattern(name).pattern.panels) {
            const PanelFace face = make_face(panel, 1e-4);
            EXPECT_NEAR(area_of(face), outline_area(panel), 1e-3 * outline_area(panel)) << panel.name;
        }
    }
}

TEST(PanelFaces, edges_of_a_face_end_where_the_next_begin) {
    const sim::Panel panel = shipped_pattern("tshirt").pattern.panels.at(0);
    const PanelFace face = make_face(panel, 1e-3);
    for (std::size_t i = 0; i < panel.edges.size(); ++i) {
        EXPECT_EQ(edge_points(face, i).back(), edge_points(face, (i + 1) % panel.edges.size()).front());
    }
}

TEST(PanelFaces, an_outline_that_crosses_itself_has_no_triangles) {
    sim::Panel panel;
    panel.vertices = {{0, 0}, {0.1, 0.1}, {0.1, 0}, {0, 0.1}};
    for (int i = 0; i < 4; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 4});
    EXPECT_TRUE(make_face(panel, 1e-3).triangles.empty());
}

TEST(PanelFaces, come_finer_as_one_comes_near) {
    const sim::PatternDocument source = shipped_pattern("tshirt");
    SheetGeometry geometry;
    geometry.update(source.pattern, 1);
    PanelFaces faces;
    faces.begin_frame(geometry);
    const std::size_t far = faces.face(geometry.panels()[0], 200).points.size();
    EXPECT_GT(faces.face(geometry.panels()[0], 20000).points.size(), far);
}

constexpr render::Rgba8 kBlack{0, 0, 0, 255}, kWhite{255, 255, 255, 255};

sim::Sett checks() {
    return sim::parse_threadcount("A=#000000; B=#FFFFFF; A16 B16");
}

TEST(SettPicture, one_repeat_shows_each_stripe_where_it_crosses_itself) {
    const render::Image picture = sett_tile(checks(), 64);
    ASSERT_EQ(picture.width_px, 64);
    ASSERT_EQ(picture.height_px, 64);
    EXPECT_EQ(picture.at(8, 8), kBlack);
    EXPECT_EQ(picture.at(40, 40), kWhite);
}

TEST(SettPicture, threads_of_both_are_seen_where_they_cross_and_mix_from_afar) {
    const render::Image near = sett_tile(checks(), 64);
    bool has_black = false, has_white = false;
    for (int y = 4; y < 20; ++y) {
        for (int x = 40; x < 56; ++x) {
            has_black |= near.at(x, y) == kBlack;
            has_white |= near.at(x, y) == kWhite;
        }
    }
    EXPECT_TRUE(has_black && has_white);
    const render::Rgba8 mixed = sett_tile(checks(), 32).at(24, 8);
    EXPECT_NEAR(mixed[0], 188, 1) << "half the light, in sRGB";
}

TEST(SettPicture, has_the_proportions_of_warp_and_weft) {
    const sim::Sett sett = sim::parse_threadcount("K24 W8 weft: K8 W8");
    EXPECT_EQ(sett_tile(sett, 64).height_px, 32);
}

TEST(SettPicture, sizes_are_powers_of_two_that_the_screen_has_use_for) {
    EXPECT_EQ(sett_tile_side(3), 32);
    EXPECT_EQ(sett_tile_side(100), 128);
    EXPECT_EQ(sett_tile_side(1e9), 1024);
}

}  // namespace

}  // namespace selvedge::editor
