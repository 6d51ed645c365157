#include "editor/viewport3d/gizmo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "editor/viewport3d/pick.h"
#include "sim/core/math.h"

namespace selvedge::editor {
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
    if (gizmo.is_turning_only && handle.kind != GizmoKind::Turn) return false;
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
    const bool is_flat_on = facing.norm() < 0.15F;  // then the whole ring faces the eye
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

namespace {

constexpr double kLengthStep = 0.01;  // m
constexpr double kAngleStep = 5 * sim::kDegree;
constexpr double kMaxMotion = 20;  // m: limits the motion when a ray is almost parallel to an axis or a plane

// The axis parameter (m from `through`) of the point on the axis nearest to the ray. None: they are parallel.
std::optional<float> along_axis(const Ray& ray, const Vec3f& through, const Vec3f& axis) {
    const float slant = ray.direction.dot(axis);
    const float sine2 = 1 - slant * slant;
    if (sine2 < 1e-4F) return std::nullopt;
    const Vec3f to = through - ray.origin;
    return (slant * to.dot(ray.direction) - to.dot(axis)) / sine2;
}

std::optional<Vec3f> on_plane(const Ray& ray, const Vec3f& through, const Vec3f& normal) {
    const float slope = ray.direction.dot(normal);
    if (std::abs(slope) < 1e-3F) return std::nullopt;
    const float distance = (through - ray.origin).dot(normal) / slope;
    if (!(distance > 0)) return std::nullopt;
    return ray.at(distance);
}

double stepped(double value, double step) {
    return step * std::round(value / step);
}

// The point where the drag starts: on the handle's axis, in its plane, or in the image plane through the centre.
Vec3f handle_point(const Gizmo& gizmo, const GizmoHandle& handle, const Viewing& viewing, const Vec2f& px) {
    const Ray ray = ray_through(viewing, px);
    const Vec3f axis = gizmo.axis(handle.axis);
    switch (handle.kind) {
        case GizmoKind::MoveAxis:
            return gizmo.centre + along_axis(ray, gizmo.centre, axis).value_or(0.0F) * axis;
        case GizmoKind::MovePlane:
        case GizmoKind::Turn:
            return on_plane(ray, gizmo.centre, axis).value_or(gizmo.centre);
        case GizmoKind::MoveScreen:
            return in_picture_plane(viewing, px, gizmo.centre);
    }
    return gizmo.centre;
}

}  // namespace

GizmoDrag::GizmoDrag(const Gizmo& gizmo, const GizmoHandle& handle, const Viewing& viewing, const Vec2f& px)
    : gizmo_(gizmo), handle_(handle), start_(handle_point(gizmo, handle, viewing, px)) {
    const Vec3f to_eye = (viewing.camera.eye - gizmo.centre).normalized();
    is_on_edge_ = handle.kind == GizmoKind::Turn && std::abs(to_eye.dot(gizmo.axis(handle.axis))) < 0.2F;
    if (handle.kind == GizmoKind::Turn) cursor_angle_ = angle_of_cursor(viewing, px);
}

// The cursor's angle about the axis, rad. If the ring is seen edge-on: the motion across the axis on the screen, with
// one ring radius per radian.
double GizmoDrag::angle_of_cursor(const Viewing& viewing, const Vec2f& px) const {
    const Vec3f axis = gizmo_.axis(handle_.axis);
    if (is_on_edge_) {
        const Vec3f to_eye = (viewing.camera.eye - gizmo_.centre).normalized();
        const Vec3f across = axis.cross(to_eye).normalized();
        const Vec3f at = in_picture_plane(viewing, px, gizmo_.centre) - gizmo_.centre;
        return static_cast<double>(at.dot(across) / (kRingRadius * gizmo_.reach));
    }
    const std::optional<Vec3f> at = on_plane(ray_through(viewing, px), gizmo_.centre, axis);
    if (!at) return cursor_angle_;
    const Vec3f from = *at - gizmo_.centre;
    const float x = from.dot(gizmo_.axis((handle_.axis + 1) % 3)), y = from.dot(gizmo_.axis((handle_.axis + 2) % 3));
    return static_cast<double>(std::atan2(y, x));
}

void GizmoDrag::move(const Viewing& viewing, const Vec2f& px) {
    const Ray ray = ray_through(viewing, px);
    const Vec3f axis = gizmo_.axis(handle_.axis);
    std::optional<Vec3f> at;
    switch (handle_.kind) {
        case GizmoKind::MoveAxis:
            if (const auto along = along_axis(ray, start_, axis)) at = start_ + *along * axis;
            break;
        case GizmoKind::MovePlane:
            at = on_plane(ray, start_, axis);
            break;
        case GizmoKind::MoveScreen:
            at = in_picture_plane(viewing, px, start_);
            break;
        case GizmoKind::Turn: {
            const double angle = angle_of_cursor(viewing, px);
            const double by = angle - cursor_angle_;
            angle_ += is_on_edge_ ? by : std::remainder(by, 360 * sim::kDegree);
            cursor_angle_ = angle;
            return;
        }
    }
    if (!at || !at->allFinite() || static_cast<double>((*at - start_).norm()) > kMaxMotion) return;
    way_ = (gizmo_.axes.transpose() * (*at - start_)).cast<double>();
}

Vec3d GizmoDrag::amounts() const {
    const auto axis = static_cast<Eigen::Index>(handle_.axis);
    Vec3d amounts = Vec3d::Zero();
    const bool is_turn = handle_.kind == GizmoKind::Turn;
    const double unit = is_turn ? sim::kDegree : 0.01;
    if (!typed_.empty() && handle_.kind != GizmoKind::MoveScreen) {
        if (handle_.kind != GizmoKind::MovePlane) {
            amounts[axis] = unit * typed_[0];
            return amounts;
        }
        std::array<Eigen::Index, 2> others{(axis + 1) % 3, (axis + 2) % 3};
        std::sort(others.begin(), others.end());
        amounts[others[0]] = unit * typed_[0];
        if (typed_.size() > 1) amounts[others[1]] = unit * typed_[1];
        return amounts;
    }
    if (is_turn) {
        amounts[axis] = steps_ == DragSteps::Whole ? stepped(angle_, kAngleStep) : angle_;
        return amounts;
    }
    amounts = way_;
    if (steps_ == DragSteps::Whole) {
        for (double& amount : amounts) amount = stepped(amount, kLengthStep);
    }
    return amounts;
}

RigidMotion GizmoDrag::motion() const {
    RigidMotion motion{.centre = gizmo_.centre.cast<double>()};
    const Eigen::Matrix3d axes = gizmo_.axes.cast<double>();
    const Vec3d by = amounts();
    if (handle_.kind != GizmoKind::Turn) {
        motion.shift = axes * by;
        return motion;
    }
    const Vec3d axis = axes.col(handle_.axis).normalized();
    motion.turn = Eigen::AngleAxisd(by[handle_.axis], axis).toRotationMatrix();
    return motion;
}

Gizmo GizmoDrag::moved_gizmo() const {
    Gizmo moved = gizmo_;
    moved.centre += motion().shift.cast<float>();
    return moved;
}

std::string GizmoDrag::readout() const {
    constexpr std::array<const char*, 3> kNames{"x", "y", "z"};
    const Vec3d by = amounts();
    const bool is_turn = handle_.kind == GizmoKind::Turn;
    std::string text;
    for (int i = 0; i < 3; ++i) {
        const bool is_shown =
            handle_.kind == GizmoKind::MoveScreen || (i == handle_.axis) != (handle_.kind == GizmoKind::MovePlane);
        if (!is_shown) continue;
        std::array<char, 40> part{};
        const double value = is_turn ? by[i] / sim::kDegree : 100 * by[i];
        std::snprintf(part.data(), part.size(), "%s %.1f%s", kNames[static_cast<std::size_t>(i)], value,
                      is_turn ? "\u00B0" : "");
        text += (text.empty() ? "" : "   ") + std::string(part.data());
    }
    return is_turn ? text : text + " cm";
}

}  // namespace selvedge::editor
