#pragma once
// Maps mouse and keyboard input in the 3D view to actions: navigate the camera, select panels, place them with the
// gizmo or with arrangement points, pull and pin cloth, turn joints of the body. Does not depend on ImGui.
#include <array>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editor/document/command.h"
#include "editor/frame/frame.h"
#include "editor/tools/tool.h"
#include "editor/viewport3d/gizmo.h"
#include "editor/viewport3d/orbit_camera.h"
#include "editor/viewport3d/pick.h"
#include "editor/viewport3d/view_keys.h"
#include "editor/viewport3d/viewport_marks.h"
#include "editor/workspace/workspace.h"
#include "sim/core/math.h"
#include "sim/place/placement.h"

namespace selvedge::editor {

// Mouse and keyboard input of the 3D view in one frame. Positions are px from the upper left corner of the view.

struct ButtonInput {
    bool is_down = false;
    bool was_pressed = false;   // in this frame, over the view
    bool was_released = false;  // in this frame, anywhere
};

struct ViewportInput {
    Vec2f size_px{1, 1};  // size of the view
    float scale = 1;      // interface scale factor
    float seconds = 0;    // s, since the last frame
    Vec2f cursor_px{0, 0};
    bool is_over = false;                  // the cursor is over the view and no other widget covers it
    std::array<ButtonInput, 3> buttons{};  // indexed by MouseButton
    float wheel = 0;                       // notches, over the view
    Modifiers modifiers{};
    KeyMap key_map = KeyMap::Selvedge;
    std::vector<Key> keys{};  // pressed in this frame; empty while another widget takes text
    std::string text{};       // typed in this frame; empty while another widget takes text

    const ButtonInput& button(MouseButton which) const { return buttons[static_cast<std::size_t>(which)]; }
};

class ViewportController {
 public:
    // Call once per frame.
    void update(Workspace& workspace, const ViewportInput& input, ClothChoice choice);

    const OrbitCamera& orbit() const { return orbit_; }
    Viewing viewing() const { return {orbit_.camera(), size_px_}; }
    const DisplayedGarment& garment() const { return garment_; }
    const UnderCursor& under() const { return under_; }
    const Vec2f& cursor_px() const { return last_px_; }

    // The gizmo; none: no panel can be placed now.
    const std::optional<Gizmo>& gizmo() const { return gizmo_; }
    const std::optional<GizmoDrag>& drag() const { return drag_; }
    const std::string& typed() const { return typed_.text(); }
    bool shows_points() const { return shows_points_; }

    // Where the body's joints are, m, in the order of CurrentBody::joints; empty: they are not shown. The first ones
    // have dots.
    const std::vector<Vec3f>& joints() const { return joints_; }
    std::size_t joint_dots() const { return joint_dots_; }
    bool is_turning_joint() const { return drag_ && turned_from_; }

    // Panel outlines in 3D (m) that differ from what is shown: the panels as arranged at the hovered point, or the
    // placement of the selected panels while the garment is shown sewn.
    const std::vector<std::vector<Vec3f>>& ghosts() const { return ghosts_; }

    // While cloth is pulled: the target point, and the current position of the grabbed material point (m).
    const std::optional<Vec3f>& pulled_to() const { return pulled_to_; }
    const std::optional<Vec3f>& pulled_at() const { return pulled_at_; }

    // Frame everything that is shown, or the selected panels.
    void frame_all(const Workspace& workspace);
    void frame_selection(const Workspace& workspace);
    void look_from(StandardView view) { orbit_.look_from(view); }

 private:
    enum class Gesture { None, Orbit, Pan, Pressed, Gizmo, Pull };

    void update_garment(const Workspace& workspace);
    void follow_body();
    void place_gizmo(const Workspace& workspace, float scale);
    void find_joints(const Workspace& workspace);
    std::optional<Gizmo> joint_gizmo(const Workspace& workspace, float scale) const;
    void apply_drag(Workspace& workspace);
    void find_ghosts(const Workspace& workspace);
    void pick(Workspace& workspace, const ViewportInput& input, ClothChoice choice);

    void use_keys(Workspace& workspace, const ViewportInput& input);
    void run(Workspace& workspace, ViewCommand command);
    void type(Workspace& workspace, const ViewportInput& input);
    void pin_under(Workspace& workspace);
    sim::ClothPoint cloth_point(const MeshHit& hit) const;
    void hold_material(const MeshHit& hit);

    void press(Workspace& workspace, const ViewportInput& input);
    void move(Workspace& workspace, const ViewportInput& input);
    void release(Workspace& workspace, const ViewportInput& input);
    void begin_drag(Workspace& workspace, const Gizmo& gizmo, const GizmoHandle& handle, const Vec2f& px);
    void end_drag(Workspace& workspace, bool is_kept);
    void begin_from_cloth(Workspace& workspace);
    void click(Workspace& workspace, const ViewportInput& input);

    OrbitCamera orbit_;
    Vec2f size_px_{1, 1};
    DisplayedGarment garment_;
    std::shared_ptr<const sim::Body> body_;
    std::shared_ptr<const std::vector<Vec3f>> body_positions_;
    BodySurface surface_;             // of body_, where it is
    Vec3f followed_ = Vec3f::Zero();  // m, way of the body that the camera has gone with
    UnderCursor under_;
    bool has_set_hover_ = false;
    bool shows_points_ = false;

    Gesture gesture_ = Gesture::None;
    Vec2f last_px_{0, 0};
    Vec2f pressed_px_{0, 0};
    UnderCursor pressed_;            // what was under the cursor when the button was pressed
    sim::ClothPoint pressed_point_;  // the cloth point there, in the frame that was shown then

    std::optional<Gizmo> gizmo_;
    std::optional<GizmoDrag> drag_;
    std::vector<sim::Panel> dragged_;  // copies from before the drag
    // Of a joint that is dragged: the angles before, and the axes about which they count.
    std::optional<sim::PoseAngles> turned_from_;
    Eigen::Quaterniond turning_axes_ = Eigen::Quaterniond::Identity();
    std::vector<Vec3f> joints_;  // m
    std::size_t joint_dots_ = 0;
    TypedInput typed_;
    std::vector<std::vector<Vec3f>> ghosts_;
    std::optional<Vec3f> pulled_from_;  // m, the point where the cloth was grabbed
    std::optional<Vec3f> pulled_to_;
    std::optional<Vec3f> pulled_at_;
    std::uint16_t pulled_panel_ = 0;  // panel index in the mesh
    Vec2f pulled_u_{0, 0};            // m, material coordinates of the grabbed point
};

// Commands that place panels.

// Returns copies of the named panels, in the pattern's order.
std::vector<sim::Panel> panels_of(const sim::Pattern& pattern, const std::set<std::string>& names);

// Centre of the bounding box of the placed panels in 3D, m. Pre: not empty.
Vec3d placed_centre(const std::vector<sim::Panel>& panels);

// The panel's outline in 3D, m: a closed polyline, chord error at most 1 mm in the pattern plane.
std::vector<Vec3f> placed_outline(const sim::Panel& panel);

// Applies the motion to the panels' placement; the wrap radius does not change. Pre: not empty.
Command move_command(const std::vector<sim::Panel>& panels, const RigidMotion& motion);

// Wraps each panel at the arrangement point. Pre: not empty.
Command arrange_command(std::vector<sim::Panel> panels, const sim::ArrangementPoint& point);

}  // namespace selvedge::editor
