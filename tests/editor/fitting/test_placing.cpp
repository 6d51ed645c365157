#include "editor/fitting/placing.h"

#include <gtest/gtest.h>

#include "editor/document/document.h"
#include "tests/editor/fitting/fitting_desk.h"

namespace selvedge {
namespace {

Pattern two_panels() {
    Pattern pattern = square_pattern();
    Panel other = pattern.panels.front();
    other.name = "other";
    other.translation = {0.6, 1, 0.3};
    other.wrap_radius = 0.15;
    pattern.panels.push_back(other);
    return pattern;
}

TEST(Placing, several_panels_turn_about_one_centre_and_stay_bent) {
    Document document({.pattern = two_panels(), .json = {}});
    const std::vector<Panel> panels = panels_of(document.pattern(), {"other", "square"});
    ASSERT_EQ(panels.size(), 2U);
    const Eigen::Matrix3d half = Eigen::AngleAxisd(3.14159265358979, Vec3d::UnitY()).toRotationMatrix();
    document.run(move_command(panels, {.centre = {0.3, 1, 0.3}, .turn = half, .shift = {0, 0.1, 0}}));
    const std::vector<Panel>& placed = document.pattern().panels;
    EXPECT_NEAR((placed[0].translation - Vec3d(0.6, 1.1, 0.3)).norm(), 0, 1e-9);
    EXPECT_NEAR((placed[1].translation - Vec3d(0, 1.1, 0.3)).norm(), 0, 1e-9);
    EXPECT_EQ(placed[1].wrap_radius, 0.15);
    EXPECT_EQ(document.history().size(), 1U) << "one entry for both";
    document.undo();
    EXPECT_EQ(document.pattern(), two_panels());
}

TEST(Placing, one_panel_is_placed_by_a_command_of_its_own) {
    const Command command = move_command(square_pattern().panels, {.shift = {0.1, 0, 0}});
    ASSERT_TRUE(std::holds_alternative<PlacePanel>(command));
    EXPECT_NEAR((std::get<PlacePanel>(command).translation - Vec3d(0.1, 1, 0.3)).norm(), 0, 1e-12);
}

TEST(Placing, the_centre_is_that_of_the_box_about_all) {
    EXPECT_NEAR((placed_centre(square_pattern().panels) - Vec3d(0, 1, 0.3)).norm(), 0, 1e-6);
}

TEST(Placing, the_outline_of_a_bent_panel_is_round) {
    const std::vector<Vec3f> outline = placed_outline(two_panels().panels[1]);
    ASSERT_GT(outline.size(), 40U);
    EXPECT_EQ(outline.front(), outline.back());
    for (const Vec3f& x : outline) EXPECT_NEAR(std::hypot(x.x() - 0.6F, x.z() - 0.15F), 0.15F, 1e-5F);
}

}  // namespace
}  // namespace selvedge
