// All inspectors with the shipped patterns, in an offscreen window.
#include <gtest/gtest.h>
#include <array>
#include <numbers>

#include "editor/geometry/draft.h"
#include "editor/geometry/panel_edit.h"
#include "editor/inspectors/body_inspector.h"
#include "editor/inspectors/drape_inspector.h"
#include "editor/inspectors/material_inspector.h"
#include "editor/inspectors/pattern_measures.h"
#include "sim/mannequin/mannequin.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/pattern_read.h"
#include "sim/tartan/tartan_file.h"
#include "tests/editor/inspectors/inspector_support.h"

namespace selvedge::editor {
namespace {

constexpr std::array<InspectorFixture::Draw, 7> kInspectors{draw_properties, draw_seams,   draw_materials, draw_body,
                                                            draw_drape,      draw_history, draw_objects};
constexpr std::array<const char*, 5> kPatterns{"tshirt.json", "tshirt_thesis.json", "skirt.json", "poncho.json",
                                               "two_squares.json"};

std::vector<Selection> selections(const sim::Pattern& pattern) {
    std::vector<Selection> list(7);
    const std::string& first = pattern.panels[0].name;
    list[1].panels.insert(first);
    for (const sim::Panel& panel : pattern.panels) list[2].panels.insert(panel.name);
    list[3].vertices.insert({first, 0});
    list[4].vertices = {{first, 0}, {first, 1}};
    for (int i = 0; i < static_cast<int>(pattern.panels[0].edges.size()); ++i) list[5].edges.insert({first, i});
    for (int i = 0; i < static_cast<int>(pattern.seams.size()); ++i) list[6].seams.insert(i);
    Selection one;
    one.seams.insert(0);
    one.notches.insert({first, 0});
    one.internal_lines.insert({first, 0});
    list.push_back(one);
    return list;
}

void add_parts(Document& document) {
    const std::string panel = document.pattern().panels[0].name;
    document.run(AddNotch{.panel = panel, .edge = 0, .t = 0.3});
    document.run(AddInternalLine{.panel = panel, .line = {"pocket", {{0.01, 0.02}, {0.05, 0.02}}}});
    sim::OutlineEdge arc = document.pattern().panels[0].edges[0];
    arc.kind = sim::CurveKind::Arc;
    arc.arc_radius = 2;
    document.run(SetCurve{.panel = panel, .edge = 0, .curve = arc});
}

bool is_inside(const WidgetBox& box, const WindowSize& size) {
    return box.low.x() >= 0 && box.high.x() <= size.width_px * size.scale;
}

class AllInspectors : public testing::TestWithParam<WindowSize> {};

TEST_P(AllInspectors, stay_inside_their_window_whatever_is_selected) {
    for (const char* file : kPatterns) {
        InspectorFixture inspector(shipped_pattern(file), draw_properties, GetParam());
        add_parts(inspector.document());
        inspector.document().undo();
        for (const Selection& selected : selections(inspector.document().pattern())) {
            inspector.document().select(selected);
            for (std::size_t i = 0; i < kInspectors.size(); ++i) {
                inspector.show(kInspectors[i]);
                inspector.frame();
                inspector.frame();
                EXPECT_LE(inspector.overhang_px(), 0.5F) << file << ", inspector " << i;
                for (const auto& [name, box] : inspector.widgets) EXPECT_TRUE(is_inside(box, GetParam())) << name;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Widths, AllInspectors,
                         testing::Values(WindowSize{.width_px = 260, .scale = 1},
                                         WindowSize{.width_px = 300, .scale = 2},
                                         WindowSize{.width_px = 420, .scale = 1},
                                         WindowSize{.width_px = 420, .scale = 2}));

TEST(Inspectors, show_an_empty_pattern) {
    InspectorFixture inspector({}, draw_properties);
    for (const InspectorFixture::Draw draw : kInspectors) {
        inspector.show(draw);
        inspector.frame();
        inspector.frame();
    }
    EXPECT_TRUE(inspector.document().history().empty());
}

TEST(GarmentInspector, lists_garments_that_are_worn_over_each_other_hides_and_removes_them) {
    InspectorFixture inspector(shipped_pattern("tshirt.json"), draw_properties);
    inspector.frame();
    EXPECT_FALSE(inspector.widgets.contains("garment.show.tshirt")) << "one alone";
    EXPECT_TRUE(inspector.workspace.wear_over(shipped_pattern("skirt.json")));
    inspector.document().select({});
    inspector.frame();
    inspector.click("garment.show.skirt");
    EXPECT_EQ(inspector.workspace.look.hidden_garments, std::set<std::string>{"skirt"});
    inspector.click("garment.show.skirt");
    EXPECT_TRUE(inspector.workspace.look.hidden_garments.empty());
    inspector.click("garment.select.skirt");
    EXPECT_EQ(inspector.document().selection().panels.size(), 2U);
    inspector.document().select({});
    inspector.frame();
    inspector.click("garment.remove.skirt");
    EXPECT_EQ(inspector.document().pattern().panels.size(), 6U);
    inspector.document().undo();
    EXPECT_EQ(inspector.document().pattern().panels.size(), 8U);
}

TEST(GarmentInspector, a_garment_that_is_hidden_can_be_shown_again) {
    InspectorFixture inspector(shipped_pattern("tshirt.json"), draw_properties);
    EXPECT_TRUE(inspector.workspace.wear_over(shipped_pattern("skirt.json")));
    inspector.document().select({});
    inspector.frame();
    inspector.click("garment.show.tshirt");
    inspector.click("garment.show.skirt");
    inspector.click("garment.remove.skirt");
    EXPECT_EQ(inspector.workspace.look.hidden_garments, std::set<std::string>{"tshirt"});
    inspector.document().select({});
    inspector.frame();
    ASSERT_TRUE(inspector.widgets.contains("garment.show.tshirt")) << "alone, but hidden";
    inspector.click("garment.show.tshirt");
    EXPECT_TRUE(inspector.workspace.look.hidden_garments.empty());
    inspector.frame();
    EXPECT_FALSE(inspector.widgets.contains("garment.show.tshirt"));
}

// The lower edge of a trapezium: from (0, 0) to (0.4, 0), between sides that lean out by 45 degrees.
sim::Pattern trapezium() {
    sim::Panel panel = make_polygon({{0, 0}, {0.4, 0}, {0.6, 0.2}, {-0.2, 0.2}});
    panel.name = "trapezium";
    panel.sheet_position = Vec2d(1, 2);
    sim::Pattern pattern;
    pattern.panels = {panel};
    return pattern;
}

TEST(EdgeLength, that_is_typed_moves_what_was_chosen) {
    const auto edge_after = [](LengthMove move) {
        Document document({.pattern = trapezium(), .json = {}});
        document.run(command_for_length(document.pattern(), {"trapezium", 0}, move, {.before = 0.4, .after = 0.5}));
        const sim::Panel& panel = document.pattern().panels[0];
        return std::pair<Vec2d, Vec2d>{panel.vertices[0], panel.vertices[1]};
    };
    const auto expect = [&](LengthMove move, const Vec2d& start, const Vec2d& end) {
        const auto [now_start, now_end] = edge_after(move);
        EXPECT_TRUE(now_start.isApprox(start, 1e-9) || (now_start - start).norm() < 1e-9) << now_start.transpose();
        EXPECT_TRUE(now_end.isApprox(end, 1e-9)) << now_end.transpose();
    };
    expect(LengthMove::End, {0, 0}, {0.5, 0});
    expect(LengthMove::Start, {-0.1, 0}, {0.4, 0});
    expect(LengthMove::Both, {-0.05, 0}, {0.45, 0});
    expect(LengthMove::Parallel, {-0.05, 0.05}, {0.45, 0.05});
}

TEST(EdgeLength, cannot_change_between_parallel_neighbours_by_a_parallel_move) {
    sim::Pattern pattern;
    pattern.panels = {make_rectangle({0, 0}, {0.4, 0.2})};
    EXPECT_THROW(
        command_for_length(pattern, {pattern.panels[0].name, 0}, LengthMove::Parallel, {.before = 0.4, .after = 0.5}),
        GeometryError);
}

TEST(EdgeLength, moves_the_end_of_the_edge_that_is_chosen_in_the_list) {
    InspectorFixture inspector({.pattern = trapezium(), .json = {}}, draw_properties);
    Selection selected;
    selected.edges.insert({"trapezium", 0});
    inspector.document().select(selected);
    inspector.state.length_move = LengthMove::Start;
    inspector.frame();
    inspector.click("edge.length");
    inspector.type("50");
    inspector.key(Key::Enter);
    inspector.frame();
    EXPECT_NEAR(inspector.panel(0).vertices[0].x(), -0.1, 1e-9);
    EXPECT_NEAR(inspector.panel(0).vertices[1].x(), 0.4, 1e-9);
}

TEST(WearOver, takes_a_garment_whose_file_names_a_body_file) {
    InspectorFixture inspector(shipped_pattern("tshirt.json"), draw_properties);
    std::string text = write_pattern(shipped_pattern("skirt.json"));
    const std::string body = "\"body\": \"mannequin:sex=female\"";
    ASSERT_NE(text.find(body), std::string::npos) << text;
    text.replace(text.find(body), body.size(), "\"body\": \"none.obj\"");
    EXPECT_TRUE(inspector.workspace.wear_over(sim::parse_pattern(text, "skirt.json")));
    EXPECT_EQ(inspector.document().pattern().panels.size(), 8U);
}

TEST(Workspace, tells_what_it_assumes_about_a_garment_that_is_worn_over_another) {
    Workspace workspace(shipped_pattern("tshirt.json"), sim::SessionDrive::Caller, make_mannequin_body);
    sim::PatternDocument skirt = shipped_pattern("skirt.json");
    skirt.pattern.tartan = "gingham";
    skirt.pattern.edge_length = 0.03;
    EXPECT_TRUE(workspace.wear_over(skirt));
    ASSERT_EQ(workspace.messages.count(), 1U);
    EXPECT_NE(workspace.messages.all().back().text.find("another edge length"), std::string::npos);
    EXPECT_EQ(workspace.document->pattern().panels.back().surface.value().source, "gingham");
    EXPECT_EQ(workspace.document->pattern().tartan, "royal_stewart");
    workspace.document->undo();
    EXPECT_EQ(workspace.document->pattern(), Document(shipped_pattern("tshirt.json")).pattern());
}

TEST(SeamInspector, a_click_selects_a_seam_and_the_buttons_change_it) {
    InspectorFixture inspector(shipped_pattern("tshirt.json"), draw_seams);
    inspector.click("seams.2");
    EXPECT_EQ(inspector.document().selection().seams, std::set<int>{2});
    EXPECT_EQ(inspector.workspace.hover.seam, std::optional<int>(2)) << "lights up where the cursor rests";
    const bool was_reversed = inspector.document().pattern().seams[2].is_reversed;
    EXPECT_FALSE(inspector.widgets.contains("seam.right_wrong"));
    inspector.click("seam.reverse");
    EXPECT_NE(inspector.document().pattern().seams[2].is_reversed, was_reversed);
    inspector.frame();
    EXPECT_TRUE(joins_right_to_wrong(inspector.document().pattern().seams[2]));
    EXPECT_TRUE(inspector.widgets.contains("seam.right_wrong")) << "says which sides it joins";
    inspector.click("seam.delete");
    EXPECT_EQ(inspector.document().pattern().seams.size(), 11U);
}

TEST(MaterialInspector, a_click_takes_a_tartan_and_its_picture_is_made_once) {
    InspectorFixture inspector(shipped_pattern("skirt.json"), draw_materials);
    inspector.frame();
    EXPECT_TRUE(inspector.output.pictures.empty()) << "held since the first frame";
    inspector.click("tartan.anderson");
    EXPECT_EQ(inspector.document().pattern().tartan, "anderson");
}

TEST(MaterialInspector, a_threadcount_is_tried_in_the_preview_and_told_when_it_is_wrong) {
    InspectorFixture inspector(shipped_pattern("skirt.json"), draw_materials);
    inspector.click("tartan.threadcount");
    inspector.type("K8 W");
    EXPECT_FALSE(inspector.state.boxes.typed.wrong.empty());
    inspector.type("8");
    EXPECT_TRUE(inspector.state.boxes.typed.wrong.empty());
    inspector.frame();
    EXPECT_EQ(inspector.state.material.previewed.substr(0, 5), "K8 W8");
    EXPECT_NE(inspector.document().pattern().tartan, "K8 W8") << "not before Enter";
    inspector.key(Key::Enter);
    EXPECT_EQ(inspector.document().pattern().tartan, "K8 W8");
}

TEST(MaterialInspector, stripes_are_matched_and_the_result_is_told_by_seam) {
    InspectorFixture inspector(shipped_pattern("skirt.json"), draw_materials);
    inspector.frame();
    inspector.click("material.match");
    EXPECT_EQ(inspector.state.material.matched.size(), inspector.document().pattern().seams.size());
    EXPECT_TRUE(inspector.document().pattern().matched_sett);
}

TEST(HistoryInspector, a_click_goes_back_and_forth) {
    InspectorFixture inspector(shipped_pattern("skirt.json"), draw_history);
    inspector.document().run(RenamePattern{"a"});
    inspector.document().run(RenamePattern{"b"});
    inspector.frame();
    inspector.click("history.1");
    EXPECT_EQ(inspector.document().pattern().name, "a");
    EXPECT_EQ(inspector.document().position(), 1U);
    inspector.click("history.2");
    EXPECT_EQ(inspector.document().pattern().name, "b");
    inspector.click("history.0");
    EXPECT_EQ(inspector.document().position(), 0U);
}

TEST(BodyInspector, a_measure_becomes_the_documents_with_the_panels_moved_along) {
    InspectorFixture inspector(shipped_pattern("tshirt.json"), draw_body);
    inspector.workspace.drape.update(inspector.document(), inspector.workspace.messages);
    inspector.frame();
    const double before = inspector.panel(0).translation.y();
    inspector.click("body.height");
    inspector.type("175");
    inspector.key(Key::Enter);
    EXPECT_EQ(inspector.state.body.pending, "mannequin:sex=female,height=175");
    inspector.workspace.drape.update(inspector.document(), inspector.workspace.messages);
    inspector.frame();
    EXPECT_EQ(inspector.document().pattern().body, "mannequin:sex=female,height=175");
    EXPECT_GT(inspector.panel(0).translation.y(), before + 0.05) << "the panel stands as high on the taller body";
    EXPECT_TRUE(inspector.state.body.pending.empty());
    inspector.document().undo();
    EXPECT_EQ(inspector.panel(0).translation.y(), before);
}

TEST(BodyInspector, a_body_from_a_file_takes_the_panels_into_its_own_frame) {
    const sim::Pattern pattern = shipped_pattern("tshirt.json").pattern;
    const sim::Body mannequin = sim::make_mannequin({.subdivisions = 1}).body;
    sim::Body scan = mannequin;  // in its file, its feet are 1.1 m below the origin
    scan.file = "/scans/anna.obj";
    scan.lift = 1.1;
    const SetBody adopt = set_body_command(pattern, "anna.obj", mannequin, scan);
    EXPECT_EQ(adopt.body, scan.file);
    ASSERT_EQ(adopt.shifts.size(), pattern.panels.size());
    for (const Vec3d& shift : adopt.shifts) EXPECT_LT((shift - Vec3d(0, -1.1, 0)).norm(), 1e-9);
    for (const Vec3d& shift : set_body_command(pattern, kDefaultBody, scan, mannequin).shifts)
        EXPECT_LT((shift - Vec3d(0, 1.1, 0)).norm(), 1e-9);
}

TEST(BodyInspector, a_measure_that_no_body_has_is_told_and_not_worn) {
    InspectorFixture inspector(shipped_pattern("tshirt.json"), draw_body);
    inspector.click("body.bust");
    inspector.type("12");
    inspector.key(Key::Enter);
    EXPECT_NE(inspector.state.body.wrong.find("bust"), std::string::npos);
    EXPECT_TRUE(inspector.state.body.pending.empty());
    EXPECT_TRUE(inspector.document().history().empty());
}

TEST(DrapeInspector, options_are_typed_and_switched) {
    InspectorFixture inspector(shipped_pattern("skirt.json"), draw_drape);
    inspector.click("drape.max_level");
    inspector.type("2");
    inspector.key(Key::Enter);
    EXPECT_EQ(inspector.workspace.drape.options().max_level, 2);
    inspector.click("drape.gravity");
    EXPECT_FALSE(inspector.workspace.drape.options().has_gravity);
    EXPECT_TRUE(inspector.workspace.drape.options().self_collision);
    inspector.click("drape.self_collision");
    EXPECT_FALSE(inspector.workspace.drape.options().self_collision);
    inspector.click("drape.self_collision");
    EXPECT_TRUE(inspector.workspace.drape.options().self_collision);
    inspector.click("drape.budget");
    inspector.type("2500");
    inspector.key(Key::Enter);
    EXPECT_EQ(inspector.workspace.drape.options().triangle_budget, std::optional<int>(2500));
}

}  // namespace

// Text of fabrics, threadcounts, mannequins and drapes.

namespace {

std::string value_of(const sim::Fabric& fabric, const std::string& label) {
    for (const FabricRow& row : fabric_rows(fabric)) {
        if (row.label == label) return row.value;
    }
    return "";
}

TEST(FabricText, speaks_in_units_of_the_trade) {
    const sim::Fabric fabric;
    EXPECT_EQ(value_of(fabric, "Weight"), "120 g/m\u00B2");
    EXPECT_EQ(value_of(fabric, "Stretch"), "8000 \u00D7 5000 N/m");
    EXPECT_EQ(value_of(fabric, "Bending"), "9 \u00D7 6 \u00B5N\u00B7m");
    EXPECT_EQ(value_of(fabric, "Thickness"), "0.28 mm");
    EXPECT_EQ(value_of(fabric, "Strain limit"), "3 %");
}

TEST(FabricText, names_are_made_readable) {
    EXPECT_EQ(readable_name("wool_twill_light"), "Wool twill light");
    EXPECT_EQ(readable_name("cloths/my_wool.json"), "my_wool.json");
}

TEST(ThreadcountText, every_tartan_that_ships_is_woven_alike_from_it) {
    EXPECT_FALSE(sim::shipped_tartans().empty());
    for (const std::string& name : sim::shipped_tartans()) {
        const sim::Sett sett = sim::find_tartan(name);
        const std::string text = threadcount_of(sett);
        ASSERT_EQ(tartan_error(text), "") << name << ": " << text;
        const sim::Sett again = sim::find_tartan(text);
        EXPECT_EQ(thread_colours(again), thread_colours(sett)) << name << ": " << text;
        EXPECT_EQ(weft_thread_colours(again), weft_thread_colours(sett)) << name << ": " << text;
        EXPECT_EQ(again.weave, sett.weave) << name;
    }
}

TEST(ThreadcountText, tells_what_is_wrong) {
    EXPECT_NE(tartan_error("K8 ?5"), "");
    EXPECT_EQ(tartan_error("K8 W8"), "");
    sim::Pattern pattern;
    pattern.tartan = "K8 ?5";
    EXPECT_FALSE(valid_sett(pattern));
}

TEST(ThreadcountText, tartans_are_found_by_parts_of_their_words) {
    EXPECT_TRUE(has_all_words("Hunting Stewart", "stew hunt"));
    EXPECT_FALSE(has_all_words("Hunting Stewart", "stew dress"));
    EXPECT_TRUE(has_all_words("Hunting Stewart", ""));
}

TEST(BodyText, only_what_is_set_is_written_and_read_back) {
    sim::MannequinOptions options{.sex = sim::Sex::Male};
    options.measures.bust = 1.02;
    options.measures.mid_thigh = 0.525;
    options.stance = 0.0349065850398866;  // 2 degrees
    const std::string text = mannequin_text(options);
    EXPECT_EQ(text, "mannequin:sex=male,bust=102,mid_thigh=52.5,stance=2");
    EXPECT_EQ(wrong_with_body(text), "");
    EXPECT_EQ(mannequin_text(sim::parse_mannequin(text)), text);
}

TEST(BodyText, measures_out_of_range_are_told) {
    EXPECT_NE(wrong_with_body("mannequin:bust=20").find("bust"), std::string::npos);
    EXPECT_EQ(wrong_with_body("somebody.obj"), "") << "files are tried by those who read them";
}

TEST(BodyText, every_measure_has_words) {
    for (const std::string_view name : sim::measure_names()) EXPECT_STRNE(measure_tip(name), "") << name;
    EXPECT_EQ(measure_label("bust", sim::Sex::Male), "Chest");
    EXPECT_EQ(measure_label("high_hip", sim::Sex::Female), "High hip");
}

TEST(DrapeText, counts_have_commas) {
    EXPECT_EQ(count_text(0), "0");
    EXPECT_EQ(count_text(999), "999");
    EXPECT_EQ(count_text(1000), "1,000");
    EXPECT_EQ(count_text(1234567), "1,234,567");
}

TEST(DrapeText, rejoining_stays_below_splitting) {
    const sim::CurvatureOptions usual;
    EXPECT_LT(curvature_with(usual, 0.05, {}).rejoin_angle, 0.05F);
    EXPECT_LT(curvature_with(usual, {}, 1.0).rejoin_angle, usual.split_angle);
    EXPECT_EQ(curvature_with(usual, {}, {}).rejoin_angle, usual.rejoin_angle);
}

TEST(DrapeText, kept_drapes_get_names_of_their_own) {
    EXPECT_EQ(free_drape_name({}, ""), "drape");
    EXPECT_EQ(free_drape_name({"drape", "drape 2"}, ""), "drape 3");
    EXPECT_EQ(free_drape_name({"wide"}, "wide"), "wide 2");
}

sim::SessionFrame running_frame(std::uint64_t number) {
    sim::SessionFrame frame;
    frame.number = number;
    frame.is_running = true;
    frame.statistics.leaf_triangles = static_cast<int>(number);
    return frame;
}

TEST(DrapeTrace, keeps_the_newest_frames_in_their_order) {
    DrapeTrace trace;
    for (std::uint64_t number = 1; number <= DrapeTrace::kLength + 5; ++number) trace.take(running_frame(number));
    ASSERT_EQ(trace.size(), DrapeTrace::kLength);
    EXPECT_EQ(trace.triangles(0), 6.0F);
    EXPECT_EQ(trace.triangles(trace.size() - 1), static_cast<float>(DrapeTrace::kLength + 5));
}

TEST(DrapeTrace, takes_no_frame_twice_and_none_that_stands) {
    DrapeTrace trace;
    trace.take(running_frame(1));
    trace.take(running_frame(1));
    sim::SessionFrame paused = running_frame(2);
    paused.is_running = false;
    trace.take(paused);
    EXPECT_EQ(trace.size(), 1U);
}

}  // namespace

// Measurements of a pattern, and the transforms and curves that typed values define.

namespace {

constexpr double kPi = std::numbers::pi;

sim::Panel square(double side) {
    sim::Panel panel;
    panel.name = "square";
    panel.vertices = {{0, 0}, {side, 0}, {side, side}, {0, side}};
    for (int i = 0; i < 4; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 4});
    return panel;
}

TEST(Angles, are_those_that_files_have) {
    for (const Vec3d& degrees : {Vec3d(10, 20, 30), Vec3d(-170, 80, 5), Vec3d(0, 0, 180), Vec3d(90, -45, -90)}) {
        const Vec3d angles = angles_of(sim::rotation_from_degrees(degrees));
        EXPECT_TRUE(angles.isApprox(degrees * kPi / 180, 1e-9)) << angles.transpose() * 180 / kPi;
    }
}

TEST(Angles, come_round_to_the_same_rotation_also_where_two_axes_fall_together) {
    for (const double y : {90.0, -90.0, 89.9999999, 90.0000001}) {
        for (const double x : {0.0, 35.0, -120.0}) {
            const Eigen::Matrix3d rotation = sim::rotation_from_degrees({x, y, 50});
            EXPECT_TRUE(rotation_of(angles_of(rotation)).isApprox(rotation, 1e-6)) << x << " " << y;
        }
    }
}

TEST(GarmentCentre, is_the_middle_of_all_panels_as_they_are_placed) {
    sim::Pattern pattern;
    pattern.panels = {square(1), square(1)};
    pattern.panels[1].translation = {3, 0, 2};
    EXPECT_TRUE(garment_centre(pattern).isApprox(Vec3d(2, 0.5, 1)));
    EXPECT_TRUE(garment_centre({}).isZero());
}

TEST(ScaleAbout, leaves_the_centre_where_it_is) {
    const PlaneMap map = scale_about({2, 3}, {1.5, 0.5});
    const Vec2d centre = map.x_axis * 2 + map.y_axis * 3 + map.shift;
    EXPECT_TRUE(centre.isApprox(Vec2d(2, 3)));
    EXPECT_TRUE((map.x_axis * 4 + map.y_axis * 3 + map.shift).isApprox(Vec2d(5, 3)));
}

TEST(WithKind, keeps_the_middle_of_the_curve) {
    sim::Panel panel = square(1);
    sim::OutlineEdge bulge = panel.edges[0];
    bulge.kind = sim::CurveKind::Quadratic;
    bulge.control[0] = {0.5, -0.6};
    const Vec2d middle = outline_point(panel, bulge, 0.5);
    for (const sim::CurveKind kind : {sim::CurveKind::Quadratic, sim::CurveKind::Cubic, sim::CurveKind::Arc}) {
        const sim::OutlineEdge curve = with_kind(panel, bulge, kind);
        EXPECT_EQ(curve.kind, kind);
        EXPECT_NEAR((outline_point(panel, curve, 0.5) - middle).norm(), 0, 1e-6) << static_cast<int>(kind);
        const sim::OutlineEdge cubic = with_kind(panel, curve, sim::CurveKind::Cubic);
        EXPECT_NEAR((outline_point(panel, cubic, 0.5) - middle).norm(), 0, 0.005) << static_cast<int>(kind);
    }
    EXPECT_EQ(with_kind(panel, bulge, sim::CurveKind::Line).kind, sim::CurveKind::Line);
}

TEST(WithKind, a_line_becomes_an_arc_that_bulges_out) {
    const sim::Panel panel = square(1);
    const sim::OutlineEdge arc = with_kind(panel, panel.edges[0], sim::CurveKind::Arc);
    EXPECT_LT(outline_point(panel, arc, 0.5).y(), -0.05);
    EXPECT_GE(arc.arc_radius, min_arc_radius(panel, arc));
}

TEST(WithKind, arcs_of_more_than_half_the_circle_and_hollow_ones_keep_their_side) {
    sim::Panel panel = square(1);
    for (const double height : {-0.9, -0.2, 0.2, 0.9}) {
        sim::OutlineEdge curve = panel.edges[0];
        curve.kind = sim::CurveKind::Quadratic;
        curve.control[0] = {0.5, 2 * height};
        const sim::OutlineEdge arc = with_kind(panel, curve, sim::CurveKind::Arc);
        EXPECT_NEAR(outline_point(panel, arc, 0.5).y(), height, 1e-6);
    }
}

TEST(ShiftForLength, starts_from_the_edge_as_it_was_also_while_another_length_is_tried) {
    sim::Panel panel = square(1);
    const LengthChange change{.before = 1, .after = 1.5};
    EXPECT_TRUE(shift_for_length(panel, panel.edges[0], change).isApprox(Vec2d(0.5, 0)));
    panel.vertices[1] = {1.2, 0};  // previewed
    EXPECT_TRUE(shift_for_length(panel, panel.edges[0], change).isApprox(Vec2d(0.5, 0)));
    EXPECT_TRUE(shift_for_length(panel, panel.edges[0], {.before = 1, .after = 0}).isZero());
}

TEST(SeamMeasures, tell_which_seams_are_wrong) {
    sim::Pattern pattern;
    pattern.panels = {square(1), square(1.002)};
    pattern.panels[1].name = "other";
    pattern.seams = {{.first = {0, 1}, .second = {1, 3}}};
    EXPECT_TRUE(seam_measures(pattern, 0).is_wrong());
    EXPECT_EQ(difference_text(seam_measures(pattern, 0)), "+2 mm");
    pattern.seams[0].is_eased = true;
    EXPECT_FALSE(seam_measures(pattern, 0).is_wrong());
    pattern.panels[1] = square(1.0005);
    EXPECT_FALSE(seam_measures(pattern, 0).is_uneven) << "half a millimetre is no difference";
}

}  // namespace

}  // namespace selvedge::editor
