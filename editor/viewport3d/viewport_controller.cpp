#include "editor/viewport3d/viewport_controller.h"

#include <algorithm>
#include <utility>

#include "sim/pattern/outline.h"

namespace selvedge::editor {
namespace {

// px at interface scale 1
constexpr float kGizmoReach = 82, kJointReach = 52, kClickSlack = 4;

bool is_sewn_up(sim::SessionStage stage) {
    return stage == sim::SessionStage::Sewing || stage == sim::SessionStage::Draping ||
           stage == sim::SessionStage::Moving || stage == sim::SessionStage::Settled;
}

Selection only_panel(const std::string& name) {
    Selection selection;
    selection.panels.insert(name);
    return selection;
}

template <class T>
void toggle(std::set<T>& chosen, const T& what) {
    if (chosen.erase(what) == 0) chosen.insert(what);
}

std::vector<Vec3f> placed_points(const std::vector<sim::Panel>& panels) {
    std::vector<Vec3f> points;
    for (const sim::Panel& panel : panels) {
        const std::vector<Vec3f> outline = placed_outline(panel);
        points.insert(points.end(), outline.begin(), outline.end());
    }
    return points;
}

}  // namespace

void ViewportController::update(Workspace& workspace, const ViewportInput& input, ClothChoice choice) {
    size_px_ = input.size_px.cwiseMax(1);
    orbit_.advance(input.seconds);
    update_garment(workspace);
    follow_body();
    find_joints(workspace);
    place_gizmo(workspace, input.scale);
    if (gesture_ == Gesture::None) {
        pick(workspace, input, choice);
        press(workspace, input);
    }
    move(workspace, input);
    release(workspace, input);
    use_keys(workspace, input);
    update_garment(workspace);  // apply this frame's changes before drawing
    pulled_at_ = pulled_to_ ? place_of(garment_.mesh(), pulled_panel_, pulled_u_) : std::nullopt;
    place_gizmo(workspace, input.scale);
    find_ghosts(workspace);
    last_px_ = input.cursor_px;
}

void ViewportController::update_garment(const Workspace& workspace) {
    garment_.update(workspace.document->pattern(), workspace.document->revision(), workspace.drape.frame(),
                    workspace.look.as_placed ? GarmentState::AsPlaced : GarmentState::AsItIs);
}

// The camera goes with a body that walks.
void ViewportController::follow_body() {
    const Vec3f way = garment_.body_way();
    if (way == followed_) return;
    orbit_.shift(way - followed_);
    followed_ = way;
}

// Those of a person have dots; all bones if none is one.
void ViewportController::find_joints(const Workspace& workspace) {
    joints_.clear();
    joint_dots_ = 0;
    const CurrentBody& current = workspace.drape.current_body();
    const std::shared_ptr<const sim::Pose> pose = workspace.drape.shown_pose();
    if (!workspace.look.has_joints || !workspace.look.has_body || !pose) return;
    const bool is_elsewhere = garment_.body_positions() != nullptr;
    joints_ = joint_places(*current.body(), is_elsewhere ? *pose : rest_pose(*current.body()), current.joints);
    while (joint_dots_ < joints_.size() && current.joints[joint_dots_].joint) ++joint_dots_;
    if (joint_dots_ == 0) joint_dots_ = joints_.size();
}

std::optional<Gizmo> ViewportController::joint_gizmo(const Workspace& workspace, float scale) const {
    const BodyJoint* joint = joints_.empty() ? nullptr : chosen_joint(workspace);
    const sim::PoseAngles* angles = joint ? workspace.drape.angles() : nullptr;
    if (!angles) return std::nullopt;
    const auto i = static_cast<std::size_t>(joint - workspace.drape.current_body().joints.data());
    const Eigen::Quaterniond own = axes_of(workspace.drape, *joint) * rotation_of(*joint, angles_of(*angles, *joint));
    Gizmo gizmo = make_gizmo(viewing(), joints_[i], own.toRotationMatrix().cast<float>(), kJointReach * scale);
    gizmo.is_turning_only = true;
    return gizmo;
}

void ViewportController::pick(Workspace& workspace, const ViewportInput& input, ClothChoice choice) {
    const CurrentBody& current = workspace.drape.current_body();
    const auto positions = garment_.body_positions();
    if (current.body() != body_ || positions != body_positions_) {
        body_ = current.body();
        body_positions_ = positions;
        surface_ = body_ ? body_surface(*body_) : BodySurface{};
        if (positions && positions->size() == surface_.x.size()) surface_.x = *positions;
    }
    under_ = {};
    if (input.is_over) {
        const Document& document = *workspace.document;
        std::set<std::string> passed = undrawn_panels(document.pattern(), workspace.look, document.panel_states());
        passed.insert(document.panel_states().locked.begin(), document.panel_states().locked.end());
        under_ = find_under(viewing(), input.cursor_px,
                            {.pattern = document.pattern(),
                             .garment = garment_,
                             .body = workspace.look.has_body ? &surface_ : nullptr,
                             .points = shows_points_ ? &current.points : nullptr,
                             .joints = std::span(joints_).first(joint_dots_),
                             .gizmo = gizmo_ ? &*gizmo_ : nullptr,
                             .choice = choice,
                             .scale = input.scale,
                             .passed = std::move(passed)});
    }
    if (input.is_over || has_set_hover_) workspace.hover = under_.hover;
    has_set_hover_ = input.is_over;
}

void ViewportController::place_gizmo(const Workspace& workspace, float scale) {
    const sim::Pattern& pattern = workspace.document->pattern();
    const sim::SessionFrame& frame = garment_.frame();
    const std::vector<sim::Panel> panels = panels_of(pattern, workspace.document->changeable().panels);
    const bool can_place = !panels.empty() && !frame.is_running;
    shows_points_ = can_place && workspace.look.has_points && (garment_.is_placed() || !is_sewn_up(frame.stage));
    gizmo_.reset();
    if (drag_) {
        gizmo_ = drag_->moved_gizmo();
    } else if (std::optional<Gizmo> of_joint = joint_gizmo(workspace, scale)) {
        gizmo_ = std::move(of_joint);
    } else if (can_place) {
        Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();
        if (workspace.look.own_axes && panels.size() == 1) axes = panels.front().rotation.cast<float>();
        gizmo_ = make_gizmo(viewing(), placed_centre(panels).cast<float>(), axes, kGizmoReach * scale);
    }
}

void ViewportController::find_ghosts(const Workspace& workspace) {
    ghosts_.clear();
    std::vector<sim::Panel> panels = panels_of(workspace.document->pattern(), workspace.document->changeable().panels);
    const bool is_apart = gizmo_ && !garment_.is_placed() && is_sewn_up(garment_.frame().stage);
    const std::vector<sim::ArrangementPoint>& points = workspace.drape.current_body().points;
    const bool would_go = under_.point && *under_.point < points.size() && gesture_ == Gesture::None;
    if (!is_apart && !would_go) return;
    for (sim::Panel& panel : panels) {
        if (would_go) arrange(panel, points[*under_.point]);
        ghosts_.push_back(placed_outline(panel));
    }
}

sim::ClothPoint ViewportController::cloth_point(const MeshHit& hit) const {
    return {.frame = garment_.frame().number, .triangle = hit.triangle, .weights = hit.weights};
}

void ViewportController::hold_material(const MeshHit& hit) {
    const sim::DrawMesh& mesh = garment_.mesh();
    if (hit.triangle >= mesh.u.size()) return;
    const auto& [a, b, c] = mesh.u[hit.triangle];
    pulled_u_ = hit.weights[0] * a + hit.weights[1] * b + hit.weights[2] * c;
    pulled_panel_ = sim::panel_of(mesh, hit.triangle);
}

// Camera navigation.

void ViewportController::frame_all(const Workspace& workspace) {
    std::vector<Vec3f> points = garment_.mesh().x;
    if (workspace.look.has_body && workspace.drape.current_body().body()) {
        for (const Vec3d& x : workspace.drape.current_body().body()->x)
            points.push_back(x.cast<float>() + garment_.body_way());
    }
    orbit_.frame(points, size_px_.x() / size_px_.y());
}

void ViewportController::frame_selection(const Workspace& workspace) {
    std::vector<Vec3f> points;
    const sim::Pattern& pattern = workspace.document->pattern();
    const std::set<std::string>& chosen = workspace.document->selection().panels;
    for (std::size_t p = 0; p < garment_.outlines().size() && p < pattern.panels.size(); ++p) {
        if (!chosen.contains(pattern.panels[p].name) || garment_.outlines()[p].is_empty()) continue;
        const std::vector<Vec3f> path = whole_path(garment_.outlines()[p], garment_.mesh().x);
        points.insert(points.end(), path.begin(), path.end());
    }
    if (points.empty()) points = placed_points(panels_of(pattern, chosen));
    if (points.empty()) return frame_all(workspace);
    orbit_.frame(points, size_px_.x() / size_px_.y());
}

void ViewportController::run(Workspace& workspace, ViewCommand command) {
    switch (command) {
        case ViewCommand::Front:
            return look_from(StandardView::Front);
        case ViewCommand::Back:
            return look_from(StandardView::Back);
        case ViewCommand::Left:
            return look_from(StandardView::Left);
        case ViewCommand::Right:
            return look_from(StandardView::Right);
        case ViewCommand::Top:
            return look_from(StandardView::Top);
        case ViewCommand::Bottom:
            return look_from(StandardView::Bottom);
        case ViewCommand::Opposite:
            return orbit_.turn_opposite();
        case ViewCommand::Lens:
            return orbit_.change_lens();
        case ViewCommand::FrameAll:
            return frame_all(workspace);
        case ViewCommand::FrameSelected:
            return frame_selection(workspace);
        case ViewCommand::Pin:
            return pin_under(workspace);
        case ViewCommand::UnpinAll:
            return workspace.drape.session().unpin_all();
    }
}

// Keyboard.

void ViewportController::use_keys(Workspace& workspace, const ViewportInput& input) {
    if (drag_) return type(workspace, input);
    for (const Key key : input.keys) {
        const std::optional<ViewCommand> command = view_command(input.key_map, key, input.modifiers);
        if (command) run(workspace, *command);
    }
}

// Numbers typed during a drag: they apply until the button is released or Enter is pressed. Esc cancels the drag.
void ViewportController::type(Workspace& workspace, const ViewportInput& input) {
    if (!input.text.empty()) typed_.add(input.text);
    const auto was_pressed = [&](Key key) {
        return std::find(input.keys.begin(), input.keys.end(), key) != input.keys.end();
    };
    if (was_pressed(Key::Backspace)) typed_.remove_last();
    if (was_pressed(Key::Escape)) return end_drag(workspace, false);
    drag_->type(typed_.numbers().value_or(std::vector<double>{}));
    if (!typed_.is_empty() || was_pressed(Key::Backspace)) apply_drag(workspace);
    if (was_pressed(Key::Enter) || was_pressed(Key::KeypadEnter)) end_drag(workspace, true);
}

void ViewportController::pin_under(Workspace& workspace) {
    if (under_.cloth) workspace.drape.session().pin(cloth_point(*under_.cloth));
}

// Mouse.

void ViewportController::press(Workspace& workspace, const ViewportInput& input) {
    pressed_px_ = input.cursor_px;
    if (!input.is_over) return;
    const bool is_left = input.button(MouseButton::Left).was_pressed;
    if (input.wheel != 0) {
        orbit_.zoom(input.wheel,
                    under_.surface.value_or(in_picture_plane(viewing(), input.cursor_px, orbit_.standpoint().target)));
    }
    if (input.button(MouseButton::Right).was_pressed || (is_left && input.modifiers.alt)) {
        gesture_ = Gesture::Orbit;
    } else if (input.button(MouseButton::Middle).was_pressed) {
        gesture_ = Gesture::Pan;
    } else if (is_left && under_.handle && gizmo_) {
        begin_drag(workspace, *gizmo_, *under_.handle, input.cursor_px);
    } else if (is_left && under_.point) {
        const std::vector<sim::Panel> panels =
            panels_of(workspace.document->pattern(), workspace.document->changeable().panels);
        if (!panels.empty())
            workspace.run(arrange_command(panels, workspace.drape.current_body().points[*under_.point]));
    } else if (is_left && under_.joint) {
        workspace.joint.bone = workspace.drape.current_body().joints[*under_.joint].bone;
    } else if (is_left) {
        pressed_ = under_;
        if (under_.cloth) {
            pressed_point_ = cloth_point(*under_.cloth);
            hold_material(*under_.cloth);
        }
        gesture_ = Gesture::Pressed;
    }
}

void ViewportController::move(Workspace& workspace, const ViewportInput& input) {
    const Vec2f by = input.cursor_px - last_px_;
    switch (gesture_) {
        case Gesture::None:
            return;
        case Gesture::Orbit:
            if (by != Vec2f::Zero()) orbit_.orbit(by / input.scale);
            return;
        case Gesture::Pan:
            if (by != Vec2f::Zero()) orbit_.pan(by, size_px_);
            return;
        case Gesture::Pressed:
            if ((input.cursor_px - pressed_px_).norm() > kClickSlack * input.scale) begin_from_cloth(workspace);
            return;
        case Gesture::Pull:
            pulled_to_ = in_picture_plane(viewing(), input.cursor_px, *pulled_from_);
            workspace.drape.session().pull_to(*pulled_to_);
            return;
        case Gesture::Gizmo: {
            const bool is_whole = input.modifiers.ctrl || input.modifiers.shift;
            drag_->set_steps(is_whole ? DragSteps::Whole : DragSteps::Free);
            drag_->move(viewing(), input.cursor_px);
            if ((input.cursor_px - pressed_px_).norm() > 0 && by != Vec2f::Zero()) apply_drag(workspace);
            return;
        }
    }
}

void ViewportController::begin_drag(Workspace& workspace, const Gizmo& gizmo, const GizmoHandle& handle,
                                    const Vec2f& px) {
    turned_from_.reset();
    if (gizmo.is_turning_only) {
        const BodyJoint* joint = chosen_joint(workspace);
        const sim::PoseAngles* angles = workspace.drape.angles();
        if (!joint || !angles) return;
        turned_from_ = *angles;
        turning_axes_ = axes_of(workspace.drape, *joint);
    } else {
        dragged_ = panels_of(workspace.document->pattern(), workspace.document->changeable().panels);
        if (dragged_.empty()) return;
    }
    typed_.clear();
    drag_.emplace(gizmo, handle, viewing(), px);
    pressed_px_ = px;
    gesture_ = Gesture::Gizmo;
}

void ViewportController::apply_drag(Workspace& workspace) {
    if (!turned_from_) {
        workspace.preview(move_command(dragged_, drag_->motion()));
        return;
    }
    const BodyJoint* joint = chosen_joint(workspace);
    if (!joint) return;
    sim::PoseAngles angles = *turned_from_;
    const Vec3d to =
        turned_angles(*joint, angles_of(angles, *joint), turning_axes_, Eigen::Quaterniond(drag_->motion().turn));
    set_angles(angles, *joint, to, workspace.joint.has_both_sides);
    workspace.drape.turn(angles);
}

void ViewportController::end_drag(Workspace& workspace, bool is_kept) {
    gesture_ = Gesture::None;
    drag_.reset();
    typed_.clear();
    if (turned_from_ && !is_kept) workspace.drape.turn(*turned_from_);
    turned_from_.reset();
    if (!workspace.document->is_previewing()) return;
    is_kept ? workspace.document->commit() : workspace.document->rollback();
}

// The button was pressed and the cursor has moved beyond the click tolerance: pulls sewn cloth, or moves a panel that
// is not sewn yet.
void ViewportController::begin_from_cloth(Workspace& workspace) {
    gesture_ = Gesture::None;
    if (!pressed_.cloth) return;
    const std::string& panel = pressed_.hover.panel;
    if (is_sewn_up(garment_.frame().stage) && !garment_.is_placed()) {
        pulled_from_ = pressed_.surface;
        pulled_to_ = pressed_.surface;
        workspace.drape.session().pull(pressed_point_, *pulled_to_);
        gesture_ = Gesture::Pull;
        return;
    }
    if (garment_.frame().is_running || panel.empty()) return;
    if (!workspace.document->selection().panels.contains(panel)) workspace.document->select(only_panel(panel));
    Gizmo here = make_gizmo(viewing(), *pressed_.surface, Eigen::Matrix3f::Identity(), kGizmoReach);
    begin_drag(workspace, here, {GizmoKind::MoveScreen, 0}, pressed_px_);
}

void ViewportController::release(Workspace& workspace, const ViewportInput& input) {
    const bool is_left = input.button(MouseButton::Left).was_released;
    const bool is_over = gesture_ == Gesture::Orbit ? is_left || input.button(MouseButton::Right).was_released
                         : gesture_ == Gesture::Pan ? input.button(MouseButton::Middle).was_released
                                                    : is_left;
    if (!is_over) return;
    if (gesture_ == Gesture::Gizmo) return end_drag(workspace, true);
    if (gesture_ == Gesture::Pull) {
        workspace.drape.session().let_go();
        pulled_from_.reset();
        pulled_to_.reset();
    }
    if (gesture_ == Gesture::Pressed) click(workspace, input);
    gesture_ = Gesture::None;
}

void ViewportController::click(Workspace& workspace, const ViewportInput& input) {
    const bool is_adding = input.modifiers.shift;
    const Hover& on = pressed_.hover;
    if (input.modifiers.ctrl && pressed_.cloth) {
        workspace.drape.session().pin(pressed_point_);
        return;
    }
    Selection selection = is_adding ? workspace.document->selection() : Selection{};
    if (on.vertex) {
        toggle(selection.vertices, *on.vertex);
    } else if (on.edge) {
        toggle(selection.edges, *on.edge);
    } else if (!on.panel.empty()) {
        toggle(selection.panels, on.panel);
    }
    workspace.document->select(std::move(selection));
}

namespace {

Command place_command(const std::vector<sim::Panel>& panels) {
    PlacePanels all;
    for (const sim::Panel& panel : panels) {
        all.places.push_back({.panel = panel.name,
                              .translation = panel.translation,
                              .rotation = panel.rotation,
                              .wrap_radius = panel.wrap_radius});
    }
    if (all.places.size() > 1) return all;
    PanelPlacement& one = all.places.front();
    return PlacePanel{.panel = std::move(one.panel),
                      .translation = one.translation,
                      .rotation = one.rotation,
                      .wrap_radius = one.wrap_radius};
}

}  // namespace

std::vector<sim::Panel> panels_of(const sim::Pattern& pattern, const std::set<std::string>& names) {
    std::vector<sim::Panel> panels;
    for (const sim::Panel& panel : pattern.panels) {
        if (names.contains(panel.name)) panels.push_back(panel);
    }
    return panels;
}

std::vector<Vec3f> placed_outline(const sim::Panel& panel) {
    constexpr double kChordError = 0.001;  // m
    constexpr double kLongestPart = 0.03;  // m: a straight edge of a bent panel is a curve in 3D
    std::vector<Vec3f> path;
    for (const sim::OutlineEdge& edge : panel.edges) {
        const std::vector<Vec2d> line = outline_polyline(panel, edge, kChordError);
        for (std::size_t i = 1; i < line.size(); ++i) {
            const int parts = 1 + static_cast<int>((line[i] - line[i - 1]).norm() / kLongestPart);
            for (int part = 0; part < parts; ++part) {
                const Vec2d u = line[i - 1] + (line[i] - line[i - 1]) * (double(part) / parts);
                path.push_back(panel.place(u).cast<float>());
            }
        }
    }
    if (!path.empty()) path.push_back(path.front());
    return path;
}

Vec3d placed_centre(const std::vector<sim::Panel>& panels) {
    Eigen::AlignedBox3d box;
    for (const sim::Panel& panel : panels) {
        for (const Vec3f& x : placed_outline(panel)) box.extend(x.cast<double>());
    }
    return box.isEmpty() ? panels.front().translation : Vec3d(box.center());
}

Command move_command(const std::vector<sim::Panel>& panels, const RigidMotion& motion) {
    std::vector<sim::Panel> moved = panels;
    for (sim::Panel& panel : moved) {
        panel.translation = motion.centre + motion.turn * (panel.translation - motion.centre) + motion.shift;
        panel.rotation = Eigen::Quaterniond(motion.turn * panel.rotation).normalized().toRotationMatrix();
    }
    return place_command(moved);
}

Command arrange_command(std::vector<sim::Panel> panels, const sim::ArrangementPoint& point) {
    for (sim::Panel& panel : panels) arrange(panel, point);
    return place_command(panels);
}

}  // namespace selvedge::editor
