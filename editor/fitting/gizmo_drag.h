#pragma once
// A drag by one of the gizmo's handles: from the cursor's way to a motion in the room.
#include <string>
#include <vector>

#include "editor/fitting/gizmo.h"

namespace selvedge {

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

}  // namespace selvedge
