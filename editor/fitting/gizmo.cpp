#include "editor/fitting/gizmo.h"

#include <cmath>
#include <limits>

#include "editor/fitting/ray_pick.h"

namespace selvedge {
namespace {

Vec3f towards_eye(const Gizmo& gizmo, const Viewing& viewing) {
    return (viewing.camera.eye - gizmo.centre).normalized();
}

bool is_inside(const std::array<std::optional<Vec2f>, 4>& corners, const Vec2f& px) {
    int left = 0, right = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto &a = corners[i], &b = corners[(i + 1) % 4];
        if (!a || !b) return false;
        const Vec2f along = *b - *a, to = px - *a;
        (along.x() * to.y() - along.y() * to.x() > 0 ? left : right) += 1;
    }
    return left == 4 || right == 4;
}

bool is_in_square(const Gizmo& gizmo, const Viewing& viewing, const Vec2f& px, int axis) {
    std::array<std::optional<Vec2f>, 4> corners;
    const std::array<Vec3f, 4> square = square_of(gizmo, axis);
    for (std::size_t i = 0; i < 4; ++i) corners[i] = px_of(viewing, square[i]);
    return is_inside(corners, px);
}

}  // namespace

Gizmo make_gizmo(const Viewing& viewing, const Vec3f& centre, const Eigen::Matrix3f& axes, float reach_px) {
    return {.centre = centre, .axes = axes, .reach = reach_px * metres_per_px(viewing, centre)};
}

bool is_shown(const Gizmo& gizmo, const Viewing& viewing, const GizmoHandle& handle) {
    const float facing = std::abs(gizmo.axis(handle.axis).dot(towards_eye(gizmo, viewing)));
    switch (handle.kind) {
        case GizmoKind::MoveAxis:
            return facing < 0.97F;
        case GizmoKind::MovePlane:
            return facing > 0.2F;
        case GizmoKind::Turn:
        case GizmoKind::MoveScreen:
            return true;
    }
    return true;
}

std::array<Vec3f, 2> arrow_of(const Gizmo& gizmo, int axis) {
    const Vec3f along = gizmo.reach * gizmo.axis(axis);
    return {gizmo.centre + kArrowStart * along, gizmo.centre + along};
}

std::array<Vec3f, 4> square_of(const Gizmo& gizmo, int normal_axis) {
    const Vec3f a = gizmo.reach * gizmo.axis((normal_axis + 1) % 3),
                b = gizmo.reach * gizmo.axis((normal_axis + 2) % 3);
    const Vec3f& c = gizmo.centre;
    return {c + kSquareNear * (a + b), c + kSquareFar * a + kSquareNear * b, c + kSquareFar * (a + b),
            c + kSquareNear * a + kSquareFar * b};
}

std::vector<Vec3f> ring_of(const Gizmo& gizmo, const Viewing& viewing, int axis) {
    constexpr int kParts = 48;
    constexpr float kHalfTurn = 3.14159265F;
    const Vec3f normal = gizmo.axis(axis), eye = towards_eye(gizmo, viewing);
    Vec3f facing = eye - eye.dot(normal) * normal;
    const bool is_flat_on = facing.norm() < 0.15F;  // then all of it faces the eye
    if (is_flat_on) facing = gizmo.axis((axis + 1) % 3);
    facing.normalize();
    const Vec3f side = normal.cross(facing);
    const float half = is_flat_on ? kHalfTurn : kHalfTurn / 2;
    std::vector<Vec3f> ring;
    for (int i = 0; i <= kParts; ++i) {
        const float angle = half * (2 * float(i) / float(kParts) - 1);
        ring.push_back(gizmo.centre + kRingRadius * gizmo.reach * (std::cos(angle) * facing + std::sin(angle) * side));
    }
    return ring;
}

std::optional<GizmoHandle> pick_gizmo(const Gizmo& gizmo, const Viewing& viewing, const Vec2f& px, float tolerance_px) {
    std::optional<GizmoHandle> best;
    float least = tolerance_px;
    const auto offer = [&](const GizmoHandle& handle, const std::vector<Vec3f>& path) {
        if (!is_shown(gizmo, viewing, handle)) return;
        const std::optional<ScreenDistance> distance = distance_to_path(viewing, px, path);
        if (!distance || !(distance->px < least)) return;
        least = distance->px;
        best = handle;
    };
    for (int axis = 0; axis < 3; ++axis) {
        const std::array<Vec3f, 2> arrow = arrow_of(gizmo, axis);
        offer({GizmoKind::MoveAxis, axis}, {arrow[0], arrow[1]});
    }
    if (best) return best;
    for (int axis = 0; axis < 3; ++axis) {
        const GizmoHandle square{GizmoKind::MovePlane, axis};
        if (is_shown(gizmo, viewing, square) && is_in_square(gizmo, viewing, px, axis)) return square;
    }
    for (int axis = 0; axis < 3; ++axis) offer({GizmoKind::Turn, axis}, ring_of(gizmo, viewing, axis));
    return best;
}

}  // namespace selvedge
