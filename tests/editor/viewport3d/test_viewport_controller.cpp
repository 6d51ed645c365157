#include <gtest/gtest.h>
#include <cmath>

#include "editor/document/document.h"
#include "editor/viewport3d/viewport_controller.h"
#include "tests/editor/viewport3d/viewport_support.h"

namespace selvedge::editor {
namespace {

const Vec3f kMiddle(0, 1, 0.3F);  // centre of the panel

// Selects the panel, so that its gizmo is shown.
ViewportFixture& chosen(ViewportFixture& desk) {
    desk.click(desk.seen(kMiddle + Vec3f(-0.17F, 0.17F, 0)));
    EXPECT_TRUE(desk.controller().gizmo().has_value());
    return desk;
}

TEST(ViewportController, shows_the_panel_as_it_is_placed) {
    ViewportFixture desk;
    EXPECT_TRUE(desk.controller().garment().is_placed());
    ASSERT_FALSE(desk.controller().garment().mesh().x.empty());
    for (const Vec3f& x : desk.controller().garment().mesh().x) EXPECT_NEAR(x.z(), 0.3F, 1e-6F);
}

TEST(ViewportController, the_panel_under_the_cursor_is_hovered_and_a_click_selects_it) {
    ViewportFixture desk;
    desk.move_to(desk.seen(kMiddle));
    EXPECT_EQ(desk.workspace().hover.panel, "square");
    desk.click(desk.seen(kMiddle));
    EXPECT_EQ(desk.document().selection().panels, (std::set<std::string>{"square"}));
    desk.click({5, 5});
    EXPECT_TRUE(desk.document().selection().is_empty()) << "a click beside it";
    EXPECT_EQ(desk.workspace().hover, Hover{});
}

TEST(ViewportController, parts_of_an_outline_are_chosen_where_they_lie_on_the_cloth) {
    ViewportFixture desk;
    desk.choice = ClothChoice::Parts;
    desk.move_to(desk.seen(kMiddle + Vec3f(0.2F, 0.02F, 0)) + Vec2f(-3, 0));
    EXPECT_EQ(desk.workspace().hover.edge, (PartRef{"square", 1}));
    desk.click(desk.seen(kMiddle + Vec3f(0.2F, 0.2F, 0)) + Vec2f(-3, 3));
    EXPECT_EQ(desk.document().selection().vertices, (std::set<PartRef>{{"square", 2}}));
}

TEST(ViewportController, an_arrow_moves_the_panel_along_its_axis_and_makes_one_entry_of_the_history) {
    ViewportFixture desk;
    chosen(desk);
    const Vec3f tip = arrow_of(*desk.controller().gizmo(), 0)[1];
    desk.move_to(desk.seen(tip));
    EXPECT_EQ(desk.controller().under().handle, (GizmoHandle{GizmoKind::MoveAxis, 0}));
    desk.press();
    desk.move_to(desk.seen(tip + Vec3f(0.05F, 0.03F, 0)));
    desk.move_to(desk.seen(tip + Vec3f(0.1F, 0.03F, 0)));
    EXPECT_TRUE(desk.document().is_previewing());
    EXPECT_EQ(desk.controller().drag()->readout(), "x 10.0 cm");
    desk.release();
    EXPECT_FALSE(desk.document().is_previewing());
    EXPECT_NEAR((desk.panel().translation - Vec3d(0.1, 1, 0.3)).norm(), 0, 1e-4);
    EXPECT_EQ(desk.document().history().size(), 1U);
}

TEST(ViewportController, a_number_typed_during_a_drag_holds_until_it_is_let_go) {
    ViewportFixture desk;
    chosen(desk);
    const Vec3f tip = arrow_of(*desk.controller().gizmo(), 1)[1];
    desk.move_to(desk.seen(tip));
    desk.press();
    desk.move_to(desk.seen(tip + Vec3f(0, 0.02F, 0)));
    desk.type("1");
    desk.type("2");
    desk.move_to(desk.seen(tip + Vec3f(0, 0.07F, 0)));
    EXPECT_NEAR(desk.panel().translation.y(), 1.12, 1e-9);
    desk.release();
    EXPECT_NEAR(desk.panel().translation.y(), 1.12, 1e-9);
}

TEST(ViewportController, escape_takes_a_drag_back) {
    ViewportFixture desk;
    chosen(desk);
    const Vec3f tip = arrow_of(*desk.controller().gizmo(), 1)[1];
    desk.move_to(desk.seen(tip));
    desk.press();
    desk.move_to(desk.seen(tip + Vec3f(0, 0.2F, 0)));
    EXPECT_GT(desk.panel().translation.y(), 1.1);
    desk.key(Key::Escape);
    desk.release();
    EXPECT_EQ(desk.panel().translation, Vec3d(0, 1, 0.3));
    EXPECT_TRUE(desk.document().history().empty());
}

TEST(ViewportController, a_ring_turns_the_panel_about_its_middle) {
    ViewportFixture desk;
    chosen(desk);
    const Gizmo gizmo = *desk.controller().gizmo();
    const float radius = kRingRadius * gizmo.reach;
    const auto on_ring = [&](float degrees) {
        const float angle = degrees * 3.14159265F / 180;
        return desk.seen(gizmo.centre + radius * Vec3f(std::cos(angle), std::sin(angle), 0));
    };
    desk.move_to(on_ring(30));
    ASSERT_EQ(desk.controller().under().handle, (GizmoHandle{GizmoKind::Turn, 2}));
    desk.press();
    desk.move_to(on_ring(50));
    desk.move_to(on_ring(75));
    desk.release();
    const Eigen::AngleAxisd turn(desk.panel().rotation);
    EXPECT_NEAR(turn.angle() * turn.axis().z(), 45 * 3.14159265 / 180, 1e-3);
    EXPECT_NEAR((desk.panel().place({0, 0}) - Vec3d(0, 1, 0.3)).norm(), 0, 1e-6);
}

TEST(ViewportController, a_panel_that_is_taken_itself_follows_the_cursor) {
    ViewportFixture desk;
    const Vec3f grip = kMiddle + Vec3f(-0.15F, -0.15F, 0);
    desk.move_to(desk.seen(grip));
    desk.press();
    desk.move_to(desk.seen(grip + Vec3f(0.1F, 0, 0)));
    desk.move_to(desk.seen(grip + Vec3f(0.3F, 0.1F, 0)));
    desk.release();
    EXPECT_NEAR((desk.panel().translation - Vec3d(0.3, 1.1, 0.3)).norm(), 0, 1e-3);
}

TEST(ViewportController, a_click_on_an_arrangement_point_wraps_the_panel_there) {
    ViewportFixture desk;
    const Vec2f point = desk.seen({0, 1.35F, 0.2F});
    desk.move_to(point);
    EXPECT_FALSE(desk.controller().under().point) << "nothing is selected";
    chosen(desk);
    desk.move_to(point);
    ASSERT_EQ(desk.controller().under().point, 0U);
    ASSERT_EQ(desk.controller().ghosts().size(), 1U);
    const std::vector<Vec3f> ghost = desk.controller().ghosts().front();
    desk.press();
    desk.release();
    EXPECT_EQ(desk.panel().wrap_radius, 0.2);
    EXPECT_NEAR((desk.panel().place({0, 0}) - Vec3d(0, 1.35, 0.2)).norm(), 0, 1e-9);
    EXPECT_NEAR((desk.panel().place({-0.2, -0.2}).cast<float>() - ghost.front()).norm(), 0, 1e-6F);
    EXPECT_EQ(desk.document().history().size(), 1U);
}

TEST(ViewportController, a_point_behind_the_cloth_cannot_be_clicked) {
    ViewportFixture desk;
    chosen(desk);
    desk.move_to(desk.seen({0, 1, -0.2F}));
    EXPECT_FALSE(desk.controller().under().point);
}

TEST(ViewportController, the_right_button_orbits_and_the_middle_one_pans) {
    ViewportFixture desk;
    const CameraPose before = desk.controller().orbit().standpoint();
    desk.move_to({100, 100});
    desk.press(MouseButton::Right);
    desk.move_to({180, 100});
    desk.release(MouseButton::Right);
    desk.move_to({300, 100});
    const CameraPose orbited = desk.controller().orbit().standpoint();
    EXPECT_LT(orbited.azimuth, before.azimuth - 0.3F);
    EXPECT_GT(orbited.azimuth, before.azimuth - 1) << "no further after the button was let go";
    EXPECT_EQ(orbited.target, before.target);
    desk.press(MouseButton::Middle);
    desk.move_to({300, 160});
    desk.release(MouseButton::Middle);
    EXPECT_GT(desk.controller().orbit().standpoint().target.y(), before.target.y() + 0.1F);
}

TEST(ViewportController, keys_turn_the_camera_and_frame_what_is_selected) {
    ViewportFixture desk;
    desk.key(static_cast<Key>(static_cast<int>(Key::Keypad0) + 3));
    desk.rest();
    EXPECT_NEAR(desk.controller().orbit().standpoint().azimuth, 1.5707963F, 1e-4F);
    Selection square;
    square.panels.insert("square");
    desk.workspace().document->select(square);
    desk.key(key_of('F'));
    desk.rest();
    EXPECT_NEAR((desk.controller().orbit().standpoint().target - kMiddle).norm(), 0, 0.1F);
}

TEST(ViewportController, sewn_cloth_is_pulled_instead_of_moved) {
    ViewportFixture desk;
    desk.workspace().drape.session().start();
    for (int i = 0; i < 5; ++i) {
        desk.workspace().drape.session().advance(1);
        desk.rest();
    }
    desk.workspace().drape.session().pause();
    desk.rest();
    ASSERT_FALSE(desk.controller().garment().is_placed());
    const Vec3f grip = desk.controller().garment().mesh().x.front();
    const auto& triangle = desk.controller().garment().mesh().triangles.front();
    const std::vector<Vec3f>& x = desk.controller().garment().mesh().x;
    const Vec3f middle = (x[triangle[0]] + x[triangle[1]] + x[triangle[2]]) / 3;
    desk.move_to(desk.seen(middle));
    ASSERT_TRUE(desk.controller().under().cloth);
    desk.press();
    desk.move_to(desk.seen(middle) + Vec2f(30, 0));
    desk.move_to(desk.seen(middle) + Vec2f(60, 0));
    ASSERT_TRUE(desk.controller().pulled_to());
    EXPECT_GT(desk.controller().pulled_to()->x(), grip.x());
    EXPECT_NEAR(desk.controller().pulled_to()->z(), middle.z(), 0.05F) << "in the picture's plane";
    ASSERT_TRUE(desk.controller().pulled_at());
    EXPECT_NEAR((*desk.controller().pulled_at() - middle).norm(), 0, 1e-3F) << "time has not gone on";
    EXPECT_EQ(desk.panel().translation, Vec3d(0, 1, 0.3)) << "where it is placed does not change";
    desk.release();
    EXPECT_FALSE(desk.controller().pulled_to());
}

sim::Pattern two_panels() {
    sim::Pattern pattern = square_pattern();
    sim::Panel other = pattern.panels.front();
    other.name = "other";
    other.translation = {0.6, 1, 0.3};
    other.wrap_radius = 0.15;
    pattern.panels.push_back(other);
    return pattern;
}

TEST(Placing, several_panels_turn_about_one_centre_and_stay_bent) {
    Document document({.pattern = two_panels(), .json = {}});
    const std::vector<sim::Panel> panels = panels_of(document.pattern(), {"other", "square"});
    ASSERT_EQ(panels.size(), 2U);
    const Eigen::Matrix3d half = Eigen::AngleAxisd(3.14159265358979, Vec3d::UnitY()).toRotationMatrix();
    document.run(move_command(panels, {.centre = {0.3, 1, 0.3}, .turn = half, .shift = {0, 0.1, 0}}));
    const std::vector<sim::Panel>& placed = document.pattern().panels;
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

}  // namespace selvedge::editor
