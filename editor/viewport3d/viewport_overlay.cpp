#include "editor/viewport3d/viewport_overlay.h"

#include <imgui.h>
#include <algorithm>
#include <cmath>
#include <set>

#include "sim/core/printable.h"

namespace selvedge::editor {
namespace {

ImU32 ink(const sim::Rgb8& colour, int alpha = 255) {
    return IM_COL32(colour[0], colour[1], colour[2], alpha);
}

// Draws in px of the view.
class Overlay {
 public:
    Overlay(ImDrawList& list, const OverlayFrame& place, const Viewing& viewing, const ViewportColours& colours)
        : list_(list), place_(place), viewing_(viewing), colours_(colours) {}

    const Viewing& viewing() const { return viewing_; }
    const ViewportColours& colours() const { return colours_; }
    float scale() const { return place_.scale; }

    ImVec2 at(const Vec2f& px) const { return {place_.low_px.x() + px.x(), place_.low_px.y() + px.y()}; }

    // Draws a path given in 3D (m); draws nothing if any part is behind the eye.
    void path(const std::vector<Vec3f>& points, ImU32 colour, float width) {
        std::vector<ImVec2> line;
        for (const Vec3f& point : points) {
            const std::optional<Vec2f> px = px_of(viewing_, point);
            if (!px) return;
            line.push_back(at(*px));
        }
        list_.AddPolyline(line.data(), static_cast<int>(line.size()), colour, 0, width * scale());
    }

    // Adds a pale rim, so that the line is visible on any cloth.
    void rimmed_path(const std::vector<Vec3f>& points, ImU32 colour, float width) {
        path(points, rim_of(colour), width + 2.4F);
        path(points, colour, width);
    }
    ImU32 rim_of(ImU32 colour) const {
        const auto alpha = static_cast<int>((colour & IM_COL32_A_MASK) >> IM_COL32_A_SHIFT);
        return ink(colours_.badge, alpha * 3 / 4);
    }

    void dashes(const std::vector<Vec3f>& points, ImU32 colour, float width);
    void badge(const Vec2f& low, const std::string& text, const sim::Rgb8& colour);
    Vec2f badge_size(const std::string& text) const {
        const ImVec2 size = ImGui::CalcTextSize(text.c_str());
        return {size.x + 14 * scale(), size.y + 8 * scale()};
    }

    ImDrawList& list() { return list_; }

 private:
    ImDrawList& list_;
    OverlayFrame place_;
    Viewing viewing_;
    const ViewportColours& colours_;
};

// Dashes have equal length on the screen, independent of the points' spacing.
void Overlay::dashes(const std::vector<Vec3f>& points, ImU32 colour, float width) {
    const float dash = 6 * scale(), gap = 4 * scale();
    float phase = 0;  // px, position in the current dash and gap
    for (std::size_t i = 1; i < points.size(); ++i) {
        const std::optional<Vec2f> from = px_of(viewing_, points[i - 1]), to = px_of(viewing_, points[i]);
        if (!from || !to) continue;
        const float length = (*to - *from).norm();
        if (!(length > 0) || length > 10000) continue;
        for (float way = 0; way < length;) {
            const float left = phase < dash ? dash - phase : dash + gap - phase;
            const float end = std::min(length, way + left);
            const Vec2f a = *from + (*to - *from) * (way / length), b = *from + (*to - *from) * (end / length);
            if (phase < dash) list_.AddLine(at(a), at(b), colour, width * scale());
            phase = std::fmod(phase + end - way + 1e-3F, dash + gap);
            way = end + 1e-3F;
        }
    }
}

void Overlay::badge(const Vec2f& low, const std::string& text, const sim::Rgb8& colour) {
    const Vec2f size = badge_size(text);
    const float round = 4 * scale();
    list_.AddRectFilled(at(low), at(low + size), ink(colours_.badge, 236), round);
    list_.AddRect(at(low), at(low + size), ink(colours_.badge_line), round);
    list_.AddText(at(low + Vec2f(7, 4) * scale()), ink(colour), text.c_str());
}

void draw_ghosts(Overlay& overlay, const ViewportController& controller) {
    for (const std::vector<Vec3f>& ghost : controller.ghosts()) {
        overlay.path(ghost, ink(overlay.colours().badge, 120), 3);
        overlay.dashes(ghost, ink(overlay.colours().selected, 230), 1.6F);
    }
}

struct HandleLook {
    ImU32 colour = 0;
    float width = 2;
    bool is_held = false;
};

HandleLook look_of(const Overlay& overlay, const ViewportController& controller, const GizmoHandle& handle) {
    const bool is_held =
        controller.drag() ? controller.drag()->handle() == handle : controller.under().handle == handle;
    const bool is_aside = controller.drag() && !is_held;
    const sim::Rgb8& axis = overlay.colours().axes[static_cast<std::size_t>(handle.axis)];
    return {.colour = ink(is_held ? overlay.colours().held_axis : axis, is_aside ? 70 : 235),
            .width = is_held ? 3.6F : 2.6F,
            .is_held = is_held};
}

void draw_arrow(Overlay& overlay, const Gizmo& gizmo, int axis, const HandleLook& look) {
    const std::array<Vec3f, 2> arrow = arrow_of(gizmo, axis);
    const std::optional<Vec2f> from = px_of(overlay.viewing(), arrow[0]), to = px_of(overlay.viewing(), arrow[1]);
    if (!from || !to || (*to - *from).norm() < 2) return;
    const float head = 10 * overlay.scale();
    const Vec2f along = (*to - *from).normalized(), across(-along.y(), along.x());
    const Vec2f base = *to - head * along;
    const float width = look.width * overlay.scale(), rim = 1.3F * overlay.scale();
    const Vec2f left = base + 0.42F * head * across, right = base - 0.42F * head * across;
    overlay.list().AddLine(overlay.at(*from), overlay.at(base), overlay.rim_of(look.colour), width + 2 * rim);
    overlay.list().AddTriangle(overlay.at(*to), overlay.at(left), overlay.at(right), overlay.rim_of(look.colour),
                               2 * rim);
    overlay.list().AddLine(overlay.at(*from), overlay.at(base), look.colour, width);
    overlay.list().AddTriangleFilled(overlay.at(*to), overlay.at(left), overlay.at(right), look.colour);
    constexpr std::array<const char*, 3> kNames{"x", "y", "z"};
    const ImVec2 size = ImGui::CalcTextSize(kNames[static_cast<std::size_t>(axis)]);
    const Vec2f name = *to + 10 * overlay.scale() * along - Vec2f(size.x, size.y) / 2;
    const ImVec2 low = overlay.at(name), high(low.x + size.x, low.y + size.y);
    const float pad = 2.5F * overlay.scale();
    overlay.list().AddRectFilled({low.x - pad, low.y - 0.5F * pad}, {high.x + pad, high.y + 0.5F * pad},
                                 overlay.rim_of(look.colour), 3 * overlay.scale());
    overlay.list().AddText(low, look.colour, kNames[static_cast<std::size_t>(axis)]);
}

void draw_square(Overlay& overlay, const Gizmo& gizmo, int axis, const HandleLook& look) {
    std::vector<Vec3f> corners;
    std::array<ImVec2, 4> filled;
    for (const Vec3f& corner : square_of(gizmo, axis)) {
        const std::optional<Vec2f> px = px_of(overlay.viewing(), corner);
        if (!px) return;
        filled[corners.size()] = overlay.at(*px);
        corners.push_back(corner);
    }
    corners.push_back(corners.front());
    const ImU32 faint = (look.colour & ~IM_COL32_A_MASK) | (ImU32(look.is_held ? 170 : 110) << IM_COL32_A_SHIFT);
    overlay.list().AddQuadFilled(filled[0], filled[1], filled[2], filled[3], faint);
    overlay.rimmed_path(corners, look.colour, 1);
}

void draw_gizmo(Overlay& overlay, const ViewportController& controller) {
    if (!controller.gizmo()) return;
    const Gizmo& gizmo = *controller.gizmo();
    const bool is_free = controller.drag() && controller.drag()->handle().kind == GizmoKind::MoveScreen;
    for (int axis = 0; axis < 3 && !is_free; ++axis) {
        const HandleLook look = look_of(overlay, controller, {GizmoKind::Turn, axis});
        overlay.rimmed_path(ring_of(gizmo, overlay.viewing(), axis), look.colour, look.is_held ? 3.0F : 2.0F);
    }
    if (gizmo.is_turning_only) return;
    for (const GizmoKind kind : {GizmoKind::MovePlane, GizmoKind::MoveAxis}) {
        for (int axis = 0; axis < 3 && !is_free; ++axis) {
            const GizmoHandle handle{kind, axis};
            if (!is_shown(gizmo, overlay.viewing(), handle)) continue;
            const HandleLook look = look_of(overlay, controller, handle);
            if (kind == GizmoKind::MoveAxis) draw_arrow(overlay, gizmo, axis, look);
            if (kind == GizmoKind::MovePlane) draw_square(overlay, gizmo, axis, look);
        }
    }
    const std::optional<Vec2f> centre = px_of(overlay.viewing(), gizmo.centre);
    if (!centre) return;
    overlay.list().AddCircleFilled(overlay.at(*centre), 3.5F * overlay.scale(), ink(overlay.colours().badge));
    overlay.list().AddCircle(overlay.at(*centre), 3.5F * overlay.scale(), ink(overlay.colours().ink, 160));
}

void draw_name(Overlay& overlay, const std::string& name, const Vec2f& px) {
    const Vec2f size = overlay.badge_size(name);
    Vec2f low = px + Vec2f(14 * overlay.scale(), -size.y() - 6 * overlay.scale());
    low = low.cwiseMin(overlay.viewing().size_px - size - Vec2f(6, 6)).cwiseMax(Vec2f(6, 6));
    overlay.badge(low, name, overlay.colours().ink);
}

// The skeleton: lines between joints, and a dot at each, over body and cloth.
void draw_joints(Overlay& overlay, const Workspace& workspace, const ViewportController& controller) {
    constexpr float kDot = 4, kChosenDot = 5.5F;  // px
    const std::vector<BodyJoint>& joints = workspace.drape.current_body().joints;
    const std::vector<Vec3f>& places = controller.joints();
    const std::size_t dots = controller.joint_dots();
    if (joints.size() != places.size()) return;
    for (std::size_t i = 0; i < dots; ++i)
        if (joints[i].above)
            overlay.path({places[*joints[i].above], places[i]}, ink(overlay.colours().badge, 150), 1.6F);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const bool is_chosen = joints[i].bone == workspace.joint.bone, is_hovered = controller.under().joint == i;
        const std::optional<Vec2f> px = px_of(overlay.viewing(), places[i]);
        if (!px || (i >= dots && !is_chosen)) continue;
        const sim::Rgb8& colour = is_hovered  ? overlay.colours().hovered_point
                                  : is_chosen ? overlay.colours().selected
                                              : overlay.colours().point;
        const float radius = (is_chosen || is_hovered ? kChosenDot : kDot) * overlay.scale();
        overlay.list().AddCircleFilled(overlay.at(*px), radius + 1.5F * overlay.scale(), ink(overlay.colours().badge));
        overlay.list().AddCircleFilled(overlay.at(*px), radius, ink(colour));
    }
    const std::optional<std::size_t> under = controller.under().joint;
    if (!under || *under >= places.size()) return;
    if (const std::optional<Vec2f> px = px_of(overlay.viewing(), places[*under]))
        draw_name(overlay, joints[*under].title, *px);
}

// "Left elbow: bend 42, spread 0, twist 3" in degrees.
std::string turning_text(const Workspace& workspace) {
    const BodyJoint* joint = chosen_joint(workspace);
    const sim::PoseAngles* angles = workspace.drape.angles();
    if (!joint || !angles) return "";
    constexpr double kDegrees = 180 / 3.14159265358979323846;
    const std::array<AngleLabel, 3> labels = angle_labels(*joint);
    std::string text = joint->title;
    for (std::size_t k = 0; k < 3; ++k) {
        const long degrees =
            std::lround(std::remainder(kDegrees * angles_of(*angles, *joint)[static_cast<Eigen::Index>(k)], 360));
        text += (k == 0 ? ": " : "   ") + std::string(labels[k].title) + " " + std::to_string(degrees) + "\u00B0";
    }
    return text;
}

// Draws a line from the grabbed cloth point to the pull target.
void draw_pull(Overlay& overlay, const ViewportController& controller) {
    if (!controller.pulled_to() || !controller.pulled_at()) return;
    overlay.rimmed_path({*controller.pulled_at(), *controller.pulled_to()}, ink(overlay.colours().pull), 1.8F);
    const std::optional<Vec2f> at = px_of(overlay.viewing(), *controller.pulled_at());
    if (at) overlay.list().AddCircleFilled(overlay.at(*at), 3.5F * overlay.scale(), ink(overlay.colours().pull));
}

// Draws the readout beside the cursor, inside the view.
void draw_readout(Overlay& overlay, const Workspace& workspace, const ViewportController& controller) {
    std::string text;
    sim::Rgb8 colour = overlay.colours().ink;
    if (controller.drag()) {
        text = controller.is_turning_joint() ? turning_text(workspace) : controller.drag()->readout();
        if (!controller.typed().empty()) text += "   = " + controller.typed();
    }
    if (text.empty()) return;
    const Vec2f size = overlay.badge_size(text);
    Vec2f low = controller.cursor_px() + Vec2f(18, 18) * overlay.scale();
    low = low.cwiseMin(overlay.viewing().size_px - size - Vec2f(6, 6)).cwiseMax(Vec2f(6, 6));
    overlay.badge(low, text, colour);
}

void draw_point_name(Overlay& overlay, const std::vector<sim::ArrangementPoint>& points,
                     const ViewportController& controller) {
    if (!controller.under().point || *controller.under().point >= points.size()) return;
    const sim::ArrangementPoint& point = points[*controller.under().point];
    const std::optional<Vec2f> px = px_of(overlay.viewing(), point.position.cast<float>());
    if (!px) return;
    draw_name(overlay, point.name, *px);
}

// The place of a finding about the drape, through what is before it.
void draw_lit_cloth(Overlay& overlay, const Workspace& workspace, const ViewportController& controller) {
    if (workspace.lit.is_empty() || controller.garment().is_placed()) return;
    const ImU32 colour = ink(overlay.colours().error);
    for (const auto& [from, to] : lit_cloth(workspace.lit, controller.garment().mesh()).in_space) {
        if (from != to) {
            overlay.path({from, to}, colour, 2.4F);
            continue;
        }
        const std::optional<Vec2f> px = px_of(overlay.viewing(), from);
        if (!px) continue;
        overlay.list().AddCircle(overlay.at(*px), 14 * overlay.scale(), overlay.rim_of(colour), 0, 5 * overlay.scale());
        overlay.list().AddCircle(overlay.at(*px), 14 * overlay.scale(), colour, 0, 2.6F * overlay.scale());
        overlay.list().AddCircleFilled(overlay.at(*px), 3 * overlay.scale(), colour);
    }
}

// At the lower left. Draws the axis that points most towards the eye last.
void draw_axis_cross(Overlay& overlay) {
    const float reach = 24 * overlay.scale();
    const Vec2f centre(38 * overlay.scale(), overlay.viewing().size_px.y() - 38 * overlay.scale());
    const Eigen::Matrix4f view = view_matrix(overlay.viewing().camera);
    std::array<int, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int a, int b) { return view(2, a) < view(2, b); });
    constexpr std::array<const char*, 3> kNames{"x", "y", "z"};
    for (const int axis : order) {
        const auto a = static_cast<std::size_t>(axis);
        const Vec2f along(view(0, axis), -view(1, axis));
        const ImU32 colour = ink(overlay.colours().axes[a], view(2, axis) < -0.2F ? 130 : 255);
        overlay.list().AddLine(overlay.at(centre), overlay.at(centre + reach * along), colour, 2 * overlay.scale());
        const ImVec2 size = ImGui::CalcTextSize(kNames[a]);
        const Vec2f name = centre + (reach + 8 * overlay.scale()) * along - Vec2f(size.x, size.y) / 2;
        overlay.list().AddText(overlay.at(name), colour, kNames[a]);
    }
}

sim::Rgb8 verdict_colour(const sim::SessionFrame& frame, const ViewportColours& colours) {
    if (!frame.report && frame.motion.faults.empty()) return colours.faint;  // it was not looked at yet
    switch (verdict_of(frame).verdict) {
        case Verdict::Good:
            return colours.good;
        case Verdict::Tight:
            return colours.busy;
        case Verdict::Wrong:
            break;
    }
    return colours.error;
}

sim::Rgb8 stage_colour(const sim::SessionFrame& frame, const ViewportColours& colours) {
    switch (frame.stage) {
        case sim::SessionStage::Settled:
            return verdict_colour(frame, colours);
        case sim::SessionStage::Draping:
            if (frame.report) return verdict_colour(frame, colours);
            [[fallthrough]];
        case sim::SessionStage::Sewing:
            return frame.is_running ? colours.busy : colours.faint;
        case sim::SessionStage::Moving:
            if (!frame.motion.faults.empty()) return colours.error;
            return frame.is_running ? colours.busy : colours.faint;
        case sim::SessionStage::Failed:
            return colours.error;
        case sim::SessionStage::Empty:
        case sim::SessionStage::Placed:
            return colours.faint;
    }
    return colours.faint;
}

std::string stage_text(const Workspace& workspace, const ViewportController& controller) {
    const sim::SessionFrame& frame = controller.garment().frame();
    std::string text = stage_badge(frame);
    const bool is_sewn = frame.stage == sim::SessionStage::Draping || frame.stage == sim::SessionStage::Moving ||
                         frame.stage == sim::SessionStage::Settled;
    if (is_sewn && controller.garment().is_placed()) text += " \u00B7 shown as placed";
    if (workspace.drape.is_making_body()) text += text.empty() ? "Making the body" : " \u00B7 making the body";
    return text;
}

void draw_stage(Overlay& overlay, const Workspace& workspace, const ViewportController& controller) {
    const std::string text = stage_text(workspace, controller);
    if (text.empty()) return;
    const float scale = overlay.scale();
    const auto [low, size] = stage_badge_box(workspace, controller, scale);
    overlay.list().AddRectFilled(overlay.at(low), overlay.at(low + size), ink(overlay.colours().badge, 236), 4 * scale);
    overlay.list().AddRect(overlay.at(low), overlay.at(low + size), ink(overlay.colours().badge_line), 4 * scale);
    overlay.list().AddCircleFilled(overlay.at(low + Vec2f(12 * scale, size.y() / 2)), 4 * scale,
                                   ink(stage_colour(controller.garment().frame(), overlay.colours())));
    overlay.list().AddText(overlay.at(low + Vec2f(21, 4) * scale), ink(overlay.colours().ink), text.c_str());
}

std::string with_verdict(const std::string& stage, const sim::SessionFrame& frame) {
    const std::string wrong = verdict_of(frame).text;
    return wrong.empty() ? stage : stage + ", " + wrong;
}

}  // namespace

std::string stage_badge(const sim::SessionFrame& frame) {
    switch (frame.stage) {
        case sim::SessionStage::Empty:
            return frame.problem.empty() ? "" : "Cannot be cut yet";
        case sim::SessionStage::Placed:
            return "Placed";
        case sim::SessionStage::Sewing: {
            const auto open = std::set<int>(frame.seam_line_seams.begin(), frame.seam_line_seams.end()).size();
            const std::string verb = frame.is_running ? "Sewing" : "Sewing, paused";
            return open == 0 ? verb : verb + " \u00B7 " + sim::count_text(open, "seam");
        }
        case sim::SessionStage::Draping:
            return with_verdict(frame.is_running ? "Draping" : "Paused", frame);
        case sim::SessionStage::Moving:
            if (!frame.motion.faults.empty()) return with_verdict(frame.is_running ? "Moving" : "Paused", frame);
            return frame.is_running ? "Moving" : "Paused";
        case sim::SessionStage::Settled:
            return with_verdict("Settled", frame);
        case sim::SessionStage::Failed:
            return "Failed";
    }
    return "";
}

BadgeBox stage_badge_box(const Workspace& workspace, const ViewportController& controller, float scale) {
    const std::string text = stage_text(workspace, controller);
    if (text.empty()) return {};
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    return {.low = Vec2f(10, 10) * scale, .size = Vec2f(size.x, size.y) + Vec2f(28, 8) * scale};
}

void draw_overlay(ImDrawList& list, const OverlayFrame& place, const Workspace& workspace,
                  const ViewportController& controller, const ViewportColours& colours) {
    Overlay overlay(list, place, controller.viewing(), colours);
    draw_ghosts(overlay, controller);
    draw_joints(overlay, workspace, controller);
    draw_gizmo(overlay, controller);
    draw_pull(overlay, controller);
    draw_point_name(overlay, workspace.drape.current_body().points, controller);
    draw_axis_cross(overlay);
    draw_lit_cloth(overlay, workspace, controller);
    draw_stage(overlay, workspace, controller);
    draw_readout(overlay, workspace, controller);
}

}  // namespace selvedge::editor
