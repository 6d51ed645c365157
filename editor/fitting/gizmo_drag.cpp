#include "editor/fitting/gizmo_drag.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace selvedge {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;
constexpr double kLengthStep = 0.01;  // m
constexpr double kAngleStep = 5 * kDegree;
constexpr double kFarthest = 20;  // m: a ray that nearly misses an axis or a plane must not fling panels away

// Where the ray is nearest to the axis through `through`: m along it from there. Nothing where they are parallel.
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

// The grip's place where an axis drag begins: on the axis, under the cursor.
Vec3f grip_of(const Gizmo& gizmo, const GizmoHandle& handle, const Viewing& viewing, const Vec2f& px) {
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
    : gizmo_(gizmo), handle_(handle), grip_(grip_of(gizmo, handle, viewing, px)) {
    const Vec3f to_eye = (viewing.camera.eye - gizmo.centre).normalized();
    is_on_edge_ = handle.kind == GizmoKind::Turn && std::abs(to_eye.dot(gizmo.axis(handle.axis))) < 0.2F;
    if (handle.kind == GizmoKind::Turn) cursor_angle_ = angle_of_cursor(viewing, px);
}

// rad about the axis. Of a ring that is seen on edge: by the way across the axis on the screen, a radius for a radian.
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
            if (const auto along = along_axis(ray, grip_, axis)) at = grip_ + *along * axis;
            break;
        case GizmoKind::MovePlane:
            at = on_plane(ray, grip_, axis);
            break;
        case GizmoKind::MoveScreen:
            at = in_picture_plane(viewing, px, grip_);
            break;
        case GizmoKind::Turn: {
            const double angle = angle_of_cursor(viewing, px);
            const double by = angle - cursor_angle_;
            angle_ += is_on_edge_ ? by : std::remainder(by, 360 * kDegree);
            cursor_angle_ = angle;
            return;
        }
    }
    if (!at || !at->allFinite() || static_cast<double>((*at - grip_).norm()) > kFarthest) return;
    way_ = (gizmo_.axes.transpose() * (*at - grip_)).cast<double>();
}

Vec3d GizmoDrag::amounts() const {
    const auto axis = static_cast<Eigen::Index>(handle_.axis);
    Vec3d amounts = Vec3d::Zero();
    const bool is_turn = handle_.kind == GizmoKind::Turn;
    const double unit = is_turn ? kDegree : 0.01;
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
        const bool is_told =
            handle_.kind == GizmoKind::MoveScreen || (i == handle_.axis) != (handle_.kind == GizmoKind::MovePlane);
        if (!is_told) continue;
        std::array<char, 40> part{};
        const double value = is_turn ? by[i] / kDegree : 100 * by[i];
        std::snprintf(part.data(), part.size(), "%s %.1f%s", kNames[static_cast<std::size_t>(i)], value,
                      is_turn ? "\u00B0" : "");
        text += (text.empty() ? "" : "   ") + std::string(part.data());
    }
    return is_turn ? text : text + " cm";
}

}  // namespace selvedge
