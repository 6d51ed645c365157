#include <gtest/gtest.h>
#include <limits>

#include "editor/tools/sheet_geometry.h"

namespace selvedge::editor {
namespace {

TEST(SheetCamera, a_place_goes_to_the_screen_and_back) {
    const SheetCamera camera{.centre = {0.3, -0.2}, .scale = 750, .view_low = {40, 60}, .view_size = {800, 500}};
    EXPECT_TRUE(to_px(camera, camera.centre).isApprox(Vec2d(440, 310)));
    EXPECT_GT(to_px(camera, {0.3, -0.3}).y(), 310) << "y is up on the sheet and down on the screen";
    EXPECT_TRUE(to_sheet(camera, to_px(camera, {0.123, 0.456})).isApprox(Vec2d(0.123, 0.456)));
}

TEST(SheetCamera, zooming_keeps_what_is_under_the_cursor) {
    SheetCamera camera;
    const Vec2d cursor(123, 456), held = to_sheet(camera, cursor);
    zoom_at(camera, cursor, 3);
    EXPECT_GT(camera.scale, SheetCamera{}.scale);
    EXPECT_LT((to_sheet(camera, cursor) - held).norm(), 1e-12);
}

TEST(SheetCamera, zooming_has_limits) {
    SheetCamera camera;
    for (int i = 0; i < 100; ++i) zoom_at(camera, {100, 100}, 50);
    EXPECT_EQ(camera.scale, kMaxSheetScale);
    for (int i = 0; i < 100; ++i) zoom_at(camera, {100, 100}, -50);
    EXPECT_EQ(camera.scale, kMinSheetScale);
    zoom_at(camera, {100, 100}, std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(camera.scale, kMinSheetScale);
}

TEST(SheetCamera, a_framed_box_is_seen_whole_within_its_margin) {
    SheetCamera camera;
    const SheetBox box(Vec2d(1, 2), Vec2d(1.5, 4));
    frame(camera, box, 30);
    const Vec2d low = to_px(camera, {1, 4}), high = to_px(camera, {1.5, 2});
    EXPECT_NEAR(low.y(), 30, 1e-9);
    EXPECT_NEAR(high.y(), camera.view_size.y() - 30, 1e-9);
    EXPECT_GE(low.x(), 30);
}

TEST(SheetCamera, nothing_is_framed_by_an_empty_box) {
    SheetCamera camera;
    const SheetCamera before = camera;
    frame(camera, SheetBox(), 30);
    EXPECT_EQ(camera, before);
}

TEST(SheetCamera, the_grid_grows_coarser_as_one_goes_away) {
    SheetCamera camera;
    camera.scale = 10000;
    EXPECT_EQ(grid_step(camera, 6), 0.001);
    camera.scale = 1000;
    EXPECT_EQ(grid_step(camera, 6), 0.01);
    camera.scale = 20;
    EXPECT_EQ(grid_step(camera, 6), 0.5);
}

}  // namespace

}  // namespace selvedge::editor
