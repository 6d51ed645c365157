#pragma once
// The gizmo that moves and rotates panels in 3D: an arrow along each of three axes, a square in each plane, a ring
// about each axis. Its size on the screen is constant. GizmoDrag converts a drag of a handle to a rigid motion.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "editor/viewport3d/orbit_camera.h"

namespace selvedge::editor {

enum class GizmoKind {
    MoveAxis,
    MovePlane,   // `axis` is the plane's normal
    MoveScreen,  // parallel to the image plane; starts from a drag of the panel itself, not from a handle
    Turn
};

struct GizmoHandle {
    GizmoKind kind = GizmoKind::MoveAxis;
    int axis = 0;  // 0 = x, 1 = y, 2 = z of the gizmo

    bool operator==(const GizmoHandle&) const = default;
};

struct Gizmo {
    Vec3f centre = Vec3f::Zero();                        // m
    Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();  // one axis per column; a rotation matrix
    float reach = 0.1F;                                  // m, length of an arrow from the centre
    bool is_turning_only = false;                        // it has rings only

    Vec3f axis(int i) const { return axes.col(i); }
};

// `reach_px`: length in px of an arrow that is perpendicular to the view direction.
Gizmo make_gizmo(const Viewing& viewing, const Vec3f& centre, const Eigen::Matrix3f& axes, float reach_px);

// Whether the handle is drawn and can be picked. Hides an arrow that points almost at the eye and a square seen almost
// edge-on. Rings are always shown.
bool is_shown(const Gizmo& gizmo, const Viewing& viewing, const GizmoHandle& handle);

inline constexpr float kArrowStart = 0.16F;                      // fraction of the reach
inline constexpr float kSquareNear = 0.26F, kSquareFar = 0.46F;  // fractions of the reach, from the centre
inline constexpr float kRingRadius = 1.22F;                      // fraction of the reach

std::array<Vec3f, 2> arrow_of(const Gizmo& gizmo, int axis);
std::array<Vec3f, 4> square_of(const Gizmo& gizmo, int normal_axis);

// The half of the ring that faces the eye; the whole ring if its axis points almost at the eye.
std::vector<Vec3f> ring_of(const Gizmo& gizmo, const Viewing& viewing, int axis);

// Returns the handle under the cursor, within `tolerance_px`. Never returns MoveScreen.
std::optional<GizmoHandle> pick_gizmo(const Gizmo& gizmo, const Viewing& viewing, const Vec2f& px, float tolerance_px);

// Drag of a handle.

// A rotation about the gizmo's centre, then a translation.
struct RigidMotion {
    Vec3d centre = Vec3d::Zero();  // m
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Vec3d shift = Vec3d::Zero();  // m
};

enum class DragSteps {
    Free,
    Whole  // steps of 1 cm, or of 5 degrees
};

class GizmoDrag {
 public:
    GizmoDrag(const Gizmo& gizmo, const GizmoHandle& handle, const Viewing& viewing, const Vec2f& px);

    const GizmoHandle& handle() const { return handle_; }
    const Gizmo& gizmo() const { return gizmo_; }

    // The gizmo at its current, dragged position.
    Gizmo moved_gizmo() const;

    void move(const Viewing& viewing, const Vec2f& px);
    void set_steps(DragSteps steps) { steps_ = steps; }

    // Typed numbers replace the cursor's motion: cm along the axis, degrees about it, or, for a plane, cm along its two
    // axes in the order x, y, z. An empty list gives control back to the cursor. MoveScreen ignores typed numbers.
    void type(std::vector<double> numbers) { typed_ = std::move(numbers); }

    RigidMotion motion() const;

    // The motion as text, for example "x 12.5 cm" or "y -15.0°".
    std::string readout() const;

 private:
    Vec3d amounts() const;  // translation along the gizmo's axes (m), or rotation about them (rad)
    double angle_of_cursor(const Viewing& viewing, const Vec2f& px) const;

    Gizmo gizmo_;
    GizmoHandle handle_;
    Vec3f start_ = Vec3f::Zero();  // m, the point where the drag started
    Vec3d way_ = Vec3d::Zero();    // m along the gizmo's axes, the cursor's motion
    double angle_ = 0;             // rad, the cursor's rotation
    double cursor_angle_ = 0;      // rad, at the last move
    bool is_on_edge_ = false;      // the ring is seen edge-on: the cursor's motion across its axis rotates it
    DragSteps steps_ = DragSteps::Free;
    std::vector<double> typed_;
};

}  // namespace selvedge::editor
