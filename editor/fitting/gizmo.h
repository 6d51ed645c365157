#pragma once
// The handles by which panels are placed in the room: arrows along three axes, squares in their planes, rings about
// them. They keep their size on the screen.
#include <array>
#include <optional>
#include <vector>

#include "editor/fitting/view_ray.h"

namespace selvedge {

enum class GizmoKind {
    MoveAxis,
    MovePlane,   // the axis is its normal
    MoveScreen,  // in the picture's plane, by what is moved itself
    Turn
};

struct GizmoHandle {
    GizmoKind kind = GizmoKind::MoveAxis;
    int axis = 0;  // 0, 1, 2

    bool operator==(const GizmoHandle&) const = default;
};

struct Gizmo {
    Vec3f centre = Vec3f::Zero();                        // m
    Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();  // columns, a rotation
    float reach = 0.1F;                                  // m, of an arrow

    Vec3f axis(int i) const { return axes.col(i); }
};

// `reach_px`: of an arrow that is seen from its side.
Gizmo make_gizmo(const Viewing& viewing, const Vec3f& centre, const Eigen::Matrix3f& axes, float reach_px);

// Nothing can be drawn along an axis that points at the eye, nor in a plane or ring that is seen on edge.
bool is_shown(const Gizmo& gizmo, const Viewing& viewing, const GizmoHandle& handle);

inline constexpr float kArrowStart = 0.16F;                      // of the reach
inline constexpr float kSquareNear = 0.26F, kSquareFar = 0.46F;  // of the reach, from the centre
inline constexpr float kRingRadius = 1.22F;                      // of the reach

std::array<Vec3f, 2> arrow_of(const Gizmo& gizmo, int axis);
std::array<Vec3f, 4> square_of(const Gizmo& gizmo, int normal_axis);

// The half of the ring that faces the eye.
std::vector<Vec3f> ring_of(const Gizmo& gizmo, const Viewing& viewing, int axis);

// The handle under the cursor, within `tolerance_px`: never MoveScreen.
std::optional<GizmoHandle> pick_gizmo(const Gizmo& gizmo, const Viewing& viewing, const Vec2f& px, float tolerance_px);

}  // namespace selvedge
