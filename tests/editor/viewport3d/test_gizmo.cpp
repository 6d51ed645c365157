#include <gtest/gtest.h>
#include <cmath>

#include "editor/viewport3d/gizmo.h"

namespace selvedge::editor {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

const Viewing kFromFront{{.eye = {0, 1, 4}, .target = {0, 1, 0}}, {800, 600}};
const Viewing kSlanted{{.eye = {2.5F, 2, 3}, .target = {0, 1, 0}}, {800, 600}};

Gizmo gizmo_at(const Viewing& viewing, const Vec3f& centre) {
    return make_gizmo(viewing, centre, Eigen::Matrix3f::Identity(), 90);
}

Vec2f seen(const Viewing& viewing, const Vec3f& x) {
    return px_of(viewing, x).value();
}

TEST(Gizmo, keeps_its_size_on_the_screen) {
    for (const float z : {0.0F, -2.0F, 1.0F}) {
        const Gizmo gizmo = gizmo_at(kFromFront, {0.2F, 1.1F, z});
        const auto arrow = arrow_of(gizmo, 1);
        EXPECT_NEAR((seen(kFromFront, arrow[1]) - seen(kFromFront, gizmo.centre)).norm(), 90, 0.1F);
    }
}

TEST(Gizmo, each_handle_is_found_where_it_is_drawn) {
    const Gizmo gizmo = gizmo_at(kSlanted, {0, 1, 0});
    for (int axis = 0; axis < 3; ++axis) {
        const auto arrow = arrow_of(gizmo, axis);
        EXPECT_EQ(pick_gizmo(gizmo, kSlanted, seen(kSlanted, arrow[1]), 7), (GizmoHandle{GizmoKind::MoveAxis, axis}));
        const auto square = square_of(gizmo, axis);
        EXPECT_EQ(pick_gizmo(gizmo, kSlanted, seen(kSlanted, (square[0] + square[2]) / 2), 3),
                  (GizmoHandle{GizmoKind::MovePlane, axis}));
        const auto ring = ring_of(gizmo, kSlanted, axis);
        EXPECT_EQ(pick_gizmo(gizmo, kSlanted, seen(kSlanted, ring[17]), 7), (GizmoHandle{GizmoKind::Turn, axis}));
    }
    EXPECT_FALSE(pick_gizmo(gizmo, kSlanted, {20, 20}, 7));
}

TEST(Gizmo, an_axis_that_points_at_the_eye_has_no_arrow) {
    const Gizmo gizmo = gizmo_at(kFromFront, {0, 1, 0});
    EXPECT_FALSE(is_shown(gizmo, kFromFront, {GizmoKind::MoveAxis, 2}));
    EXPECT_TRUE(is_shown(gizmo, kFromFront, {GizmoKind::MoveAxis, 0}));
    EXPECT_FALSE(is_shown(gizmo, kFromFront, {GizmoKind::MovePlane, 0})) << "seen on edge";
}

TEST(GizmoDrag, an_axis_moves_along_itself_by_what_the_cursor_goes_along_it) {
    const Gizmo gizmo = gizmo_at(kSlanted, {0, 1, 0});
    const Vec3f from = gizmo.centre + Vec3f(0.1F, 0, 0), to = from + Vec3f(0.25F, 0, 0);
    GizmoDrag drag(gizmo, {GizmoKind::MoveAxis, 0}, kSlanted, seen(kSlanted, from));
    drag.move(kSlanted, seen(kSlanted, to));
    EXPECT_NEAR((drag.motion().shift - Vec3d(0.25, 0, 0)).norm(), 0, 1e-4);
    EXPECT_TRUE(drag.motion().turn.isIdentity(1e-12));
    EXPECT_EQ(drag.readout(), "x 25.0 cm");
    drag.move(kSlanted, seen(kSlanted, to + Vec3f(0, 0.13F, 0)));
    EXPECT_EQ(drag.motion().shift.y(), 0) << "along that axis only";
    EXPECT_EQ(drag.motion().shift.z(), 0);
}

TEST(GizmoDrag, a_square_moves_in_its_plane) {
    const Gizmo gizmo = gizmo_at(kSlanted, {0, 1, 0});
    const Vec3f from = gizmo.centre + Vec3f(0.03F, 0, 0.03F), by(0.2F, 0, -0.1F);
    GizmoDrag drag(gizmo, {GizmoKind::MovePlane, 1}, kSlanted, seen(kSlanted, from));
    drag.move(kSlanted, seen(kSlanted, from + by));
    EXPECT_NEAR((drag.motion().shift - by.cast<double>()).norm(), 0, 1e-4);
    EXPECT_EQ(drag.readout(), "x 20.0   z -10.0 cm");
    drag.type({3, -4});
    EXPECT_NEAR((drag.motion().shift - Vec3d(0.03, 0, -0.04)).norm(), 0, 1e-9);
}

TEST(GizmoDrag, what_is_taken_itself_follows_the_cursor) {
    const Gizmo gizmo = gizmo_at(kFromFront, {0, 1, 0});
    GizmoDrag drag(gizmo, {GizmoKind::MoveScreen, 0}, kFromFront, seen(kFromFront, gizmo.centre));
    drag.move(kFromFront, seen(kFromFront, gizmo.centre + Vec3f(0.3F, -0.2F, 0)));
    EXPECT_NEAR((drag.motion().shift - Vec3d(0.3, -0.2, 0)).norm(), 0, 1e-4);
}

// Drags along the ring in small moves.
double turned_by(const Gizmo& gizmo, const Viewing& viewing, int axis, double angle) {
    const auto at = [&](double turn) {
        const Vec3f from = gizmo.reach * gizmo.axis((axis + 1) % 3);
        const Eigen::AngleAxisf by(static_cast<float>(turn), gizmo.axis(axis));
        return seen(viewing, gizmo.centre + by * from);
    };
    GizmoDrag drag(gizmo, {GizmoKind::Turn, axis}, viewing, at(0));
    for (int i = 1; i <= 40; ++i) drag.move(viewing, at(angle * i / 40));
    const Eigen::AngleAxisd turn(drag.motion().turn);
    return turn.angle() * (turn.axis().dot(gizmo.axis(axis).cast<double>()) > 0 ? 1 : -1);
}

TEST(GizmoDrag, a_ring_turns_by_the_angle_that_the_cursor_goes_round) {
    for (int axis = 0; axis < 3; ++axis) {
        const Gizmo gizmo = gizmo_at(kSlanted, {0, 1, 0});
        EXPECT_NEAR(turned_by(gizmo, kSlanted, axis, 70 * kDegree), 70 * kDegree, 1e-3);
        EXPECT_NEAR(turned_by(gizmo, kSlanted, axis, -160 * kDegree), -160 * kDegree, 1e-3);
    }
}

TEST(GizmoDrag, a_ring_that_is_seen_on_edge_turns_by_the_way_along_it) {
    const Gizmo gizmo = gizmo_at(kFromFront, {0, 1, 0});
    const Vec2f middle = seen(kFromFront, gizmo.centre);
    GizmoDrag drag(gizmo, {GizmoKind::Turn, 1}, kFromFront, middle);
    drag.move(kFromFront, middle + Vec2f(90 * kRingRadius, 0));
    const Eigen::AngleAxisd turn(drag.motion().turn);
    EXPECT_NEAR(turn.angle(), 1, 0.01) << "a radius for a radian";
    EXPECT_GT(turn.axis().y(), 0) << "the near side goes to the right";
}

TEST(GizmoDrag, whole_steps_are_centimetres_and_five_degrees) {
    const Gizmo gizmo = gizmo_at(kSlanted, {0, 1, 0});
    GizmoDrag drag(gizmo, {GizmoKind::MoveAxis, 1}, kSlanted, seen(kSlanted, gizmo.centre));
    drag.move(kSlanted, seen(kSlanted, gizmo.centre + Vec3f(0, 0.123F, 0)));
    drag.set_steps(DragSteps::Whole);
    EXPECT_NEAR(drag.motion().shift.y(), 0.12, 1e-9);
    GizmoDrag ring(gizmo, {GizmoKind::Turn, 1}, kSlanted, seen(kSlanted, gizmo.centre + Vec3f(0.1F, 0, 0)));
    ring.set_steps(DragSteps::Whole);
    const auto to = Eigen::AngleAxisf(float(23 * kDegree), Vec3f::UnitY()) * Vec3f(0.1F, 0, 0);
    ring.move(kSlanted, seen(kSlanted, gizmo.centre + to));
    EXPECT_NEAR(Eigen::AngleAxisd(ring.motion().turn).angle(), 25 * kDegree, 1e-9);
    EXPECT_EQ(ring.readout(), "y 25.0\u00B0");
}

TEST(GizmoDrag, a_typed_number_takes_the_cursors_place) {
    const Gizmo gizmo = gizmo_at(kSlanted, {0, 1, 0});
    GizmoDrag drag(gizmo, {GizmoKind::Turn, 2}, kSlanted, seen(kSlanted, gizmo.centre + Vec3f(0.1F, 0, 0)));
    drag.type({-30});
    const Eigen::AngleAxisd turn(drag.motion().turn);
    EXPECT_NEAR(turn.angle() * turn.axis().z(), -30 * kDegree, 1e-9);
    drag.type({});
    EXPECT_TRUE(drag.motion().turn.isIdentity(1e-9)) << "the cursor holds again";
}

}  // namespace

}  // namespace selvedge::editor
