#pragma once
// The handles by which panels are placed in the room: arrows along three axes, squares in their planes, rings about
// them. They keep their size on the screen.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "editor/viewport3d/orbit_camera.h"

namespace selvedge::editor {

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

// A drag by one of the gizmo's handles: from the cursor's way to a motion in the room.

// A turn about the gizmo's centre, then a shift.
struct RigidMotion {
    Vec3d centre = Vec3d::Zero();  // m
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Vec3d shift = Vec3d::Zero();  // m
};

enum class DragSteps {
    Free,
    Whole  // whole centimetres, or 5 degrees
};

class GizmoDrag {
 public:
    GizmoDrag(const Gizmo& gizmo, const GizmoHandle& handle, const Viewing& viewing, const Vec2f& px);

    const GizmoHandle& handle() const { return handle_; }
    const Gizmo& gizmo() const { return gizmo_; }

    // The gizmo where it has been moved to.
    Gizmo moved_gizmo() const;

    void move(const Viewing& viewing, const Vec2f& px);
    void set_steps(DragSteps steps) { steps_ = steps; }

    // Numbers that were typed take the place of what the cursor says: cm along the axis, degrees about it, or, in a
    // plane, cm along its two axes in their order. Empty: the cursor holds again.
    void type(std::vector<double> numbers) { typed_ = std::move(numbers); }

    RigidMotion motion() const;

    // "x 12.5 cm", "y -15.0°".
    std::string readout() const;

 private:
    Vec3d amounts() const;  // m along the axes, or rad about them
    double angle_of_cursor(const Viewing& viewing, const Vec2f& px) const;

    Gizmo gizmo_;
    GizmoHandle handle_;
    Vec3f grip_ = Vec3f::Zero();  // where it was taken
    Vec3d way_ = Vec3d::Zero();   // that the cursor made, m along the gizmo's axes
    double angle_ = 0;            // rad, that the cursor made
    double cursor_angle_ = 0;     // rad, at the last move
    bool is_on_edge_ = false;     // a ring that is turned by the way along it on the screen
    DragSteps steps_ = DragSteps::Free;
    std::vector<double> typed_;
};

}  // namespace selvedge::editor
