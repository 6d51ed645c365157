// Fitting a photo under the sheet by two of its points.
#include "editor/tools/underlay_tool.h"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

#include "tests/editor/tools/tool_support.h"

namespace selvedge::editor {
namespace {

constexpr double kQuarter = std::numbers::pi / 2;

class UnderlayToolOnSheet : public testing::Test {
 protected:
    UnderlayToolOnSheet() {
        user_.document.run(SetUnderlays{.underlays = {{.file = "old.png", .position = Vec2d(1, 1)},
                                                      {.file = "new.png", .position = Vec2d(0.3, 0.1)}}});
        user_.tools.choose(user_.host(), underlay_tool());
    }
    const sim::Underlay& underlay(std::size_t index) { return user_.pattern().underlays.at(index); }

    SheetUser user_;
};

TEST_F(UnderlayToolOnSheet, the_typed_distance_scales_the_photo_about_the_first_point) {
    user_.click({0.1, 0.1});
    user_.click({0.3, 0.1});
    user_.type("10");
    EXPECT_NEAR(underlay(1).pixel_size, 0.0005, 1e-9);
    EXPECT_TRUE(underlay(1).position.isApprox(Vec2d(0.2, 0.1), 1e-6)) << underlay(1).position.transpose();
    EXPECT_EQ(underlay(0).pixel_size, 0.001) << "the one below stays";
    user_.document.undo();
    EXPECT_EQ(underlay(1).pixel_size, 0.001);
}

TEST_F(UnderlayToolOnSheet, can_be_scaled_again_from_the_same_points) {
    user_.click({0.1, 0.1});
    user_.click({0.3, 0.1});
    user_.type("10");
    user_.type("20");
    EXPECT_NEAR(underlay(1).pixel_size, 0.001, 1e-9);
    EXPECT_TRUE(underlay(1).position.isApprox(Vec2d(0.3, 0.1), 1e-6));
}

TEST_F(UnderlayToolOnSheet, refuses_a_distance_of_nothing) {
    user_.click({0.1, 0.1});
    user_.click({0.3, 0.1});
    user_.type("0");
    EXPECT_EQ(user_.message(), "The distance between the two points is more than 0 cm");
    user_.click({0.1, 0.1});
    user_.click({0.1, 0.1});
    user_.type("10");
    EXPECT_EQ(user_.message(), "The two points are too close to each other for a scale");
    EXPECT_EQ(underlay(1).pixel_size, 0.001);
}

TEST_F(UnderlayToolOnSheet, turns_a_leaning_line_upright) {
    user_.click({0.3, 0.1});
    user_.click({0.28, 0.3});  // leans to the left
    ASSERT_TRUE(user_.key(key_of('L')));
    EXPECT_NEAR(underlay(1).rotation, kQuarter - std::atan2(0.2, -0.02), 1e-3);
    EXPECT_TRUE(underlay(1).position.isApprox(Vec2d(0.3, 0.1), 1e-3)) << "about the first point";
}

TEST_F(UnderlayToolOnSheet, a_drag_moves_it_and_is_one_step_back) {
    user_.drag({0.3, 0.1}, {0.5, 0.2});
    EXPECT_TRUE(underlay(1).position.isApprox(Vec2d(0.5, 0.2), 1e-6)) << underlay(1).position.transpose();
    user_.document.undo();
    EXPECT_TRUE(underlay(1).position.isApprox(Vec2d(0.3, 0.1)));
}

TEST_F(UnderlayToolOnSheet, tab_goes_on_to_the_photo_below) {
    user_.key(Key::Tab);
    user_.drag({0.3, 0.1}, {0.4, 0.1});
    EXPECT_TRUE(underlay(0).position.isApprox(Vec2d(1.1, 1), 1e-6));
    EXPECT_TRUE(underlay(1).position.isApprox(Vec2d(0.3, 0.1)));
}

TEST(Underlay, its_corners_turn_with_it) {
    const sim::Underlay underlay{.file = "", .position = Vec2d(1, 0), .pixel_size = 0.01, .rotation = kQuarter};
    const std::array<Vec2d, 4> corners = underlay_corners(underlay, 20, 10);
    EXPECT_TRUE(corners[0].isApprox(Vec2d(0.95, -0.1))) << "the upper left corner is at the lower left";
    EXPECT_TRUE(corners[2].isApprox(Vec2d(1.05, 0.1)));
}

}  // namespace
}  // namespace selvedge::editor
