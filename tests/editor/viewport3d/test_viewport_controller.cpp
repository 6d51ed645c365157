#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

#include "editor/document/document.h"
#include "editor/viewport3d/viewport_controller.h"
#include "tests/editor/viewport3d/viewport_support.h"

namespace selvedge::editor {
namespace {

const Vec3f kMiddle(0, 1, 0.3F);  // centre of the panel

// Selects the panel, so that its gizmo is shown.
ViewportFixture& chosen(ViewportFixture& viewport) {
    viewport.click(viewport.seen(kMiddle + Vec3f(-0.17F, 0.17F, 0)));
    EXPECT_TRUE(viewport.controller().gizmo().has_value());
    return viewport;
}

TEST(ViewportController, shows_the_panel_as_it_is_placed) {
    ViewportFixture viewport;
    EXPECT_TRUE(viewport.controller().garment().is_placed());
    ASSERT_FALSE(viewport.controller().garment().mesh().x.empty());
    for (const Vec3f& x : viewport.controller().garment().mesh().x) EXPECT_NEAR(x.z(), 0.3F, 1e-6F);
}

TEST(ViewportController, the_panel_under_the_cursor_is_hovered_and_a_click_selects_it) {
    ViewportFixture viewport;
    viewport.move_to(viewport.seen(kMiddle));
    EXPECT_EQ(viewport.workspace().hover.panel, "square");
    viewport.click(viewport.seen(kMiddle));
    EXPECT_EQ(viewport.document().selection().panels, (std::set<std::string>{"square"}));
    viewport.click({5, 5});
    EXPECT_TRUE(viewport.document().selection().is_empty()) << "a click beside it";
    EXPECT_EQ(viewport.workspace().hover, Hover{});
}

TEST(ViewportController, parts_of_an_outline_are_chosen_where_they_lie_on_the_cloth) {
    ViewportFixture viewport;
    viewport.choice = ClothChoice::Parts;
    viewport.move_to(viewport.seen(kMiddle + Vec3f(0.2F, 0.02F, 0)) + Vec2f(-3, 0));
    EXPECT_EQ(viewport.workspace().hover.edge, (PartRef{"square", 1}));
    viewport.click(viewport.seen(kMiddle + Vec3f(0.2F, 0.2F, 0)) + Vec2f(-3, 3));
    EXPECT_EQ(viewport.document().selection().vertices, (std::set<PartRef>{{"square", 2}}));
}

// A second square, 10 cm behind the first.
ViewportFixture& with_one_behind(ViewportFixture& viewport) {
    sim::Panel other = viewport.panel();
    other.name = "other";
    other.translation.z() -= 0.1;
    viewport.workspace().run(AddPanels{.panels = {other}});
    viewport.rest();
    viewport.workspace().drape.session().advance(0);
    viewport.workspace().document->select({});
    viewport.rest();
    return viewport;
}

TEST(ViewportController, hidden_and_locked_panels_are_passed_over) {
    ViewportFixture viewport;
    with_one_behind(viewport);
    const PanelStates hidden{.hidden = {"square"}, .locked = {}}, locked{.hidden = {}, .locked = {"square"}};
    for (const PanelStates& states : {hidden, locked}) {
        viewport.workspace().document->set_panel_states(states);
        viewport.workspace().document->select({});  // else the cursor is over a gizmo
        viewport.move_to(viewport.seen(kMiddle));
        EXPECT_EQ(viewport.workspace().hover.panel, "other") << "what lies behind it";
        viewport.click(viewport.seen(kMiddle));
        EXPECT_EQ(viewport.document().selection().panels, std::set<std::string>{"other"});
        viewport.choice = ClothChoice::Parts;
        viewport.move_to(viewport.seen(kMiddle + Vec3f(0.2F, 0.02F, 0)) + Vec2f(-3, 0));
        EXPECT_NE(viewport.workspace().hover.panel, "square");
        viewport.choice = ClothChoice::Panels;
    }
    viewport.workspace().document->set_panel_states({});
    viewport.move_to(viewport.seen(kMiddle + Vec3f(-0.17F, 0.17F, 0)));
    EXPECT_EQ(viewport.workspace().hover.panel, "square");
}

TEST(ViewportController, panels_of_hidden_garments_are_passed_over) {
    ViewportFixture viewport;
    with_one_behind(viewport);
    viewport.workspace().look.hidden_garments = {""};  // that of both
    viewport.move_to(viewport.seen(kMiddle));
    EXPECT_EQ(viewport.workspace().hover.panel, "");
}

TEST(ViewportController, a_locked_panel_has_no_gizmo_although_it_is_selected) {
    ViewportFixture viewport;
    chosen(viewport);
    viewport.workspace().document->set_panel_states({.hidden = {}, .locked = {"square"}});
    Selection selected;
    selected.panels = {"square"};
    viewport.workspace().document->select(selected);  // as a click in the tree of objects does
    viewport.rest();
    EXPECT_FALSE(viewport.controller().gizmo());
    EXPECT_FALSE(viewport.controller().shows_points());
    viewport.move_to(viewport.seen(kMiddle));
    viewport.press();
    viewport.move_to(viewport.seen(kMiddle + Vec3f(0.1F, 0, 0)));
    viewport.release();
    EXPECT_EQ(viewport.panel().translation, Vec3d(0, 1, 0.3)) << "the hand does not take it";
    EXPECT_TRUE(viewport.document().history().empty());
}

TEST(ViewportController, an_arrow_moves_the_panel_along_its_axis_and_makes_one_entry_of_the_history) {
    ViewportFixture viewport;
    chosen(viewport);
    const Vec3f tip = arrow_of(*viewport.controller().gizmo(), 0)[1];
    viewport.move_to(viewport.seen(tip));
    EXPECT_EQ(viewport.controller().under().handle, (GizmoHandle{GizmoKind::MoveAxis, 0}));
    viewport.press();
    viewport.move_to(viewport.seen(tip + Vec3f(0.05F, 0.03F, 0)));
    viewport.move_to(viewport.seen(tip + Vec3f(0.1F, 0.03F, 0)));
    EXPECT_TRUE(viewport.document().is_previewing());
    EXPECT_EQ(viewport.controller().drag()->readout(), "x 10.0 cm");
    viewport.release();
    EXPECT_FALSE(viewport.document().is_previewing());
    EXPECT_NEAR((viewport.panel().translation - Vec3d(0.1, 1, 0.3)).norm(), 0, 1e-4);
    EXPECT_EQ(viewport.document().history().size(), 1U);
}

TEST(ViewportController, a_number_typed_during_a_drag_holds_until_it_is_let_go) {
    ViewportFixture viewport;
    chosen(viewport);
    const Vec3f tip = arrow_of(*viewport.controller().gizmo(), 1)[1];
    viewport.move_to(viewport.seen(tip));
    viewport.press();
    viewport.move_to(viewport.seen(tip + Vec3f(0, 0.02F, 0)));
    viewport.type("1");
    viewport.type("2");
    viewport.move_to(viewport.seen(tip + Vec3f(0, 0.07F, 0)));
    EXPECT_NEAR(viewport.panel().translation.y(), 1.12, 1e-9);
    viewport.release();
    EXPECT_NEAR(viewport.panel().translation.y(), 1.12, 1e-9);
}

TEST(ViewportController, escape_takes_a_drag_back) {
    ViewportFixture viewport;
    chosen(viewport);
    const Vec3f tip = arrow_of(*viewport.controller().gizmo(), 1)[1];
    viewport.move_to(viewport.seen(tip));
    viewport.press();
    viewport.move_to(viewport.seen(tip + Vec3f(0, 0.2F, 0)));
    EXPECT_GT(viewport.panel().translation.y(), 1.1);
    viewport.key(Key::Escape);
    viewport.release();
    EXPECT_EQ(viewport.panel().translation, Vec3d(0, 1, 0.3));
    EXPECT_TRUE(viewport.document().history().empty());
}

TEST(ViewportController, a_ring_turns_the_panel_about_its_middle) {
    ViewportFixture viewport;
    chosen(viewport);
    const Gizmo gizmo = *viewport.controller().gizmo();
    const float radius = kRingRadius * gizmo.reach;
    const auto on_ring = [&](float degrees) {
        const float angle = degrees * 3.14159265F / 180;
        return viewport.seen(gizmo.centre + radius * Vec3f(std::cos(angle), std::sin(angle), 0));
    };
    viewport.move_to(on_ring(30));
    ASSERT_EQ(viewport.controller().under().handle, (GizmoHandle{GizmoKind::Turn, 2}));
    viewport.press();
    viewport.move_to(on_ring(50));
    viewport.move_to(on_ring(75));
    viewport.release();
    const Eigen::AngleAxisd turn(viewport.panel().rotation);
    EXPECT_NEAR(turn.angle() * turn.axis().z(), 45 * 3.14159265 / 180, 1e-3);
    EXPECT_NEAR((viewport.panel().place({0, 0}) - Vec3d(0, 1, 0.3)).norm(), 0, 1e-6);
}

TEST(ViewportController, a_panel_that_is_taken_itself_follows_the_cursor) {
    ViewportFixture viewport;
    const Vec3f grip = kMiddle + Vec3f(-0.15F, -0.15F, 0);
    viewport.move_to(viewport.seen(grip));
    viewport.press();
    viewport.move_to(viewport.seen(grip + Vec3f(0.1F, 0, 0)));
    viewport.move_to(viewport.seen(grip + Vec3f(0.3F, 0.1F, 0)));
    viewport.release();
    EXPECT_NEAR((viewport.panel().translation - Vec3d(0.3, 1.1, 0.3)).norm(), 0, 1e-3);
}

TEST(ViewportController, a_click_on_an_arrangement_point_wraps_the_panel_there) {
    ViewportFixture viewport;
    const Vec2f point = viewport.seen({0, 1.35F, 0.2F});
    viewport.move_to(point);
    EXPECT_FALSE(viewport.controller().under().point) << "nothing is selected";
    chosen(viewport);
    viewport.move_to(point);
    ASSERT_EQ(viewport.controller().under().point, 0U);
    ASSERT_EQ(viewport.controller().ghosts().size(), 1U);
    const std::vector<Vec3f> ghost = viewport.controller().ghosts().front();
    viewport.press();
    viewport.release();
    EXPECT_EQ(viewport.panel().wrap_radius, 0.2);
    EXPECT_NEAR((viewport.panel().place({0, 0}) - Vec3d(0, 1.35, 0.2)).norm(), 0, 1e-9);
    EXPECT_NEAR((viewport.panel().place({-0.2, -0.2}).cast<float>() - ghost.front()).norm(), 0, 1e-6F);
    EXPECT_EQ(viewport.document().history().size(), 1U);
}

TEST(ViewportController, a_point_behind_the_cloth_cannot_be_clicked) {
    ViewportFixture viewport;
    chosen(viewport);
    viewport.move_to(viewport.seen({0, 1, -0.2F}));
    EXPECT_FALSE(viewport.controller().under().point);
}

TEST(ViewportController, the_right_button_orbits_and_the_middle_one_pans) {
    ViewportFixture viewport;
    const CameraPose before = viewport.controller().orbit().standpoint();
    viewport.move_to({100, 100});
    viewport.press(MouseButton::Right);
    viewport.move_to({180, 100});
    viewport.release(MouseButton::Right);
    viewport.move_to({300, 100});
    const CameraPose orbited = viewport.controller().orbit().standpoint();
    EXPECT_LT(orbited.azimuth, before.azimuth - 0.3F);
    EXPECT_GT(orbited.azimuth, before.azimuth - 1) << "no further after the button was let go";
    EXPECT_EQ(orbited.target, before.target);
    viewport.press(MouseButton::Middle);
    viewport.move_to({300, 160});
    viewport.release(MouseButton::Middle);
    EXPECT_GT(viewport.controller().orbit().standpoint().target.y(), before.target.y() + 0.1F);
}

TEST(ViewportController, keys_turn_the_camera_and_frame_what_is_selected) {
    ViewportFixture viewport;
    viewport.key(static_cast<Key>(static_cast<int>(Key::Keypad0) + 3));
    viewport.rest();
    EXPECT_NEAR(viewport.controller().orbit().standpoint().azimuth, 1.5707963F, 1e-4F);
    Selection square;
    square.panels.insert("square");
    viewport.workspace().document->select(square);
    viewport.key(key_of('F'));
    viewport.rest();
    EXPECT_NEAR((viewport.controller().orbit().standpoint().target - kMiddle).norm(), 0, 0.1F);
}

TEST(ViewportController, sewn_cloth_is_pulled_instead_of_moved) {
    ViewportFixture viewport;
    viewport.workspace().drape.session().start();
    for (int i = 0; i < 5; ++i) {
        viewport.workspace().drape.session().advance(1);
        viewport.rest();
    }
    viewport.workspace().drape.session().pause();
    viewport.rest();
    ASSERT_FALSE(viewport.controller().garment().is_placed());
    const Vec3f grip = viewport.controller().garment().mesh().x.front();
    const auto& triangle = viewport.controller().garment().mesh().triangles.front();
    const std::vector<Vec3f>& x = viewport.controller().garment().mesh().x;
    const Vec3f middle = (x[triangle[0]] + x[triangle[1]] + x[triangle[2]]) / 3;
    viewport.move_to(viewport.seen(middle));
    ASSERT_TRUE(viewport.controller().under().cloth);
    viewport.press();
    viewport.move_to(viewport.seen(middle) + Vec2f(30, 0));
    viewport.move_to(viewport.seen(middle) + Vec2f(60, 0));
    ASSERT_TRUE(viewport.controller().pulled_to());
    EXPECT_GT(viewport.controller().pulled_to()->x(), grip.x());
    EXPECT_NEAR(viewport.controller().pulled_to()->z(), middle.z(), 0.05F) << "in the picture's plane";
    ASSERT_TRUE(viewport.controller().pulled_at());
    EXPECT_NEAR((*viewport.controller().pulled_at() - middle).norm(), 0, 1e-3F) << "time has not gone on";
    EXPECT_EQ(viewport.panel().translation, Vec3d(0, 1, 0.3)) << "where it is placed does not change";
    viewport.release();
    EXPECT_FALSE(viewport.controller().pulled_to());
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
    const sim::Pattern before = document.pattern();
    const std::vector<sim::Panel> panels = panels_of(before, {"other", "square"});
    ASSERT_EQ(panels.size(), 2U);
    const Eigen::Matrix3d half = Eigen::AngleAxisd(3.14159265358979, Vec3d::UnitY()).toRotationMatrix();
    document.run(move_command(panels, {.centre = {0.3, 1, 0.3}, .turn = half, .shift = {0, 0.1, 0}}));
    const std::vector<sim::Panel>& placed = document.pattern().panels;
    EXPECT_NEAR((placed[0].translation - Vec3d(0.6, 1.1, 0.3)).norm(), 0, 1e-9);
    EXPECT_NEAR((placed[1].translation - Vec3d(0, 1.1, 0.3)).norm(), 0, 1e-9);
    EXPECT_EQ(placed[1].wrap_radius, 0.15);
    EXPECT_EQ(document.history().size(), 1U) << "one entry for both";
    document.undo();
    EXPECT_EQ(document.pattern(), before);
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

// The joints of a mannequin are shown, without a panel in front of it.
struct JointsOfMannequin : testing::Test {
    JointsOfMannequin() {
        viewport.workspace().look.has_joints = true;
        viewport.controller().frame_all(viewport.workspace());
        viewport.rest();
        viewport.rest();
    }
    const BodyJoint& joint(const std::string& title) {
        const std::vector<BodyJoint>& all = viewport.workspace().drape.current_body().joints;
        return *std::ranges::find(all, title, &BodyJoint::title);
    }
    Vec2f dot(const std::string& title) {
        const auto i =
            static_cast<std::size_t>(&joint(title) - viewport.workspace().drape.current_body().joints.data());
        return viewport.seen(viewport.controller().joints().at(i));
    }
    Vec3d angles(const std::string& title) { return angles_of(*viewport.workspace().drape.angles(), joint(title)); }
    // Drags the ring about that axis by 0.5 rad.
    void drag_ring(int axis) {
        const Gizmo gizmo = viewport.controller().gizmo().value();
        const std::vector<Vec3f> ring = ring_of(gizmo, viewport.controller().viewing(), axis);
        const Eigen::AngleAxisf turn(0.5F, gizmo.axis(axis));
        const Vec3f from = ring[ring.size() / 4];
        viewport.move_to(viewport.seen(from));
        ASSERT_EQ(viewport.controller().under().handle, (GizmoHandle{GizmoKind::Turn, axis}));
        viewport.press();
        viewport.move_to(viewport.seen(gizmo.centre + turn * (from - gizmo.centre)));
    }

    ViewportFixture viewport{sim::Pattern{}, make_mannequin_body};
};

TEST_F(JointsOfMannequin, have_dots_of_which_a_click_chooses_one) {
    ASSERT_EQ(viewport.controller().joint_dots(), sim::kJointCount);
    viewport.move_to(dot("Left elbow"));
    EXPECT_TRUE(viewport.controller().under().joint.has_value());
    viewport.click(dot("Left elbow"));
    ASSERT_NE(chosen_joint(viewport.workspace()), nullptr);
    EXPECT_EQ(chosen_joint(viewport.workspace())->title, "Left elbow");
    EXPECT_TRUE(viewport.controller().gizmo().has_value());
    const Vec2f knee = dot("Right knee");
    viewport.workspace().look.has_joints = false;
    viewport.move_to(knee);
    EXPECT_FALSE(viewport.controller().gizmo().has_value()) << "it has rings only while the dots are shown";
    EXPECT_FALSE(viewport.controller().under().joint.has_value());
}

TEST_F(JointsOfMannequin, are_turned_by_rings_on_both_sides_or_on_one) {
    viewport.workspace().joint = {.bone = joint("Left elbow").bone, .has_both_sides = false};
    viewport.rest();
    EXPECT_TRUE(viewport.controller().gizmo().value().is_turning_only);
    const Vec3d left = angles("Left elbow"), right = angles("Right elbow");
    drag_ring(2);
    EXPECT_TRUE(viewport.controller().is_turning_joint());
    viewport.release();
    EXPECT_NEAR((angles("Left elbow") - left).norm(), 0.5, 0.05);
    EXPECT_EQ(angles("Right elbow"), right);
    viewport.workspace().joint.has_both_sides = true;
    drag_ring(2);
    viewport.release();
    EXPECT_EQ(angles("Right elbow"), angles("Left elbow"));
    EXPECT_EQ(viewport.document().history().size(), 0U) << "a pose is no part of the pattern";
}

TEST_F(JointsOfMannequin, go_back_when_a_drag_is_cancelled_and_take_typed_degrees) {
    viewport.workspace().joint = {.bone = joint("Left shoulder").bone, .has_both_sides = false};
    viewport.rest();
    const Vec3d before = angles("Left shoulder");
    drag_ring(2);
    EXPECT_GT((angles("Left shoulder") - before).norm(), 0.3);
    viewport.key(Key::Escape);
    EXPECT_LT((angles("Left shoulder") - before).norm(), 1e-12);
    viewport.release();
    drag_ring(2);
    viewport.type("20");
    viewport.release();
    const Eigen::Quaterniond from = rotation_of(joint("Left shoulder"), before);
    const Eigen::Quaterniond to = rotation_of(joint("Left shoulder"), angles("Left shoulder"));
    EXPECT_NEAR(from.angularDistance(to) * 180 / 3.14159265358979, 20, 1e-6);
}

}  // namespace

}  // namespace selvedge::editor
