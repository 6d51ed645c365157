// The sheet's view in ImGui frames, driven by mouse and keyboard.
#include "editor/sheet/sheet_view.h"

#include <gtest/gtest.h>

#include "editor/sheet/sheet_paint.h"
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
    ImGui::GetIO().KeysDown[static_cast<int>(key_of('H'))] = true;
    stage.frame();
    EXPECT_EQ(stage.answer.used_keys, (std::vector<Key>{key_of('H')}));
    EXPECT_EQ(stage.tools.kind(), ToolKind::Polygon);
    ImGui::GetIO().KeysDown[static_cast<int>(key_of('H'))] = false;
    ImGui::GetIO().KeyCtrl = true;
    ImGui::GetIO().KeysDown[static_cast<int>(key_of('Z'))] = true;
    stage.frame();
    EXPECT_TRUE(stage.answer.used_keys.empty());
    EXPECT_EQ(stage.tools.kind(), ToolKind::Polygon);
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

TEST(SeamPaint, a_seam_runs_inside_of_its_edge) {
    const std::vector<ImVec2> line{{100, 200}, {200, 200}};  // to the right: the inside is above, at smaller y
    const std::vector<ImVec2> inner = inset_line(line, 4, 10);
    ASSERT_EQ(inner.size(), 2U);
    EXPECT_FLOAT_EQ(inner[0].x, 110);
    EXPECT_FLOAT_EQ(inner[0].y, 196);
    EXPECT_FLOAT_EQ(inner[1].x, 190);
}

}  // namespace
}  // namespace selvedge::editor
