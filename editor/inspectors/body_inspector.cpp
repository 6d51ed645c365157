#include "editor/inspectors/body_inspector.h"

#include <imgui.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <utility>

#include "editor/inspectors/controls.h"
#include "editor/inspectors/material_inspector.h"
#include "editor/inspectors/motion_names.h"
#include "editor/inspectors/number_box.h"
#include "sim/core/error.h"
#include "sim/dress/anchor.h"
#include "sim/place/placement.h"

namespace selvedge::editor {
namespace {

constexpr int kGivenUpAfter = 3;  // frames without a running build and without the body: the build has failed

// The text of the body that the pattern is for.
std::string body_text(const sim::Pattern& pattern) {
    return pattern.body.empty() ? kDefaultBody : pattern.body;
}

void commit_body(InspectorContext& context) {
    BodyState& state = context.state.body;
    const CurrentBody& current = context.workspace.drape.current_body();
    const sim::Pattern& pattern = context.pattern();
    // If the body that the garment was drafted for was never built, the panels are not moved.
    const SetBody command = state.pattern_body != nullptr && state.pattern_body_text == body_text(pattern)
                                ? set_body_command(pattern, current.made().source, *state.pattern_body, *current.body())
                                : SetBody{.body = current.made().source};
    context.workspace.run(command);
    cancel_body_request(context);
}

}  // namespace

void request_body(InspectorContext& context, const std::string& text, BodyRequest request) {
    BodyState& state = context.state.body;
    state.wrong = wrong_with_body(text);
    if (!state.wrong.empty()) return;
    state.pending = text;
    state.is_commit = request == BodyRequest::Commit;
    state.idle_frames = 0;
    context.workspace.drape.show_body(text);
}

void cancel_body_request(InspectorContext& context) {
    BodyState& state = context.state.body;
    state.pending.clear();
    state.wrong.clear();
    state.is_commit = false;
    context.workspace.drape.show_body({});
}

void update_body_request(InspectorContext& context) {
    BodyState& state = context.state.body;
    const Drape& drape = context.workspace.drape;
    const std::string of_pattern = body_text(context.pattern());
    if (drape.current_body().body() != nullptr && drape.current_body().made().source == of_pattern) {
        state.pattern_body_text = of_pattern;
        state.pattern_body = drape.current_body().body();
    }
    if (state.pending.empty()) return;
    if (drape.current_body().body() != nullptr && drape.current_body().made().source == state.pending) {
        if (state.is_commit) commit_body(context);
        return;
    }
    state.idle_frames = drape.is_making_body() ? 0 : state.idle_frames + 1;
    if (state.idle_frames >= kGivenUpAfter) cancel_body_request(context);
}

// The body inspector: sex, measurements, stance, or a body from a file.

namespace {

constexpr double kDefaultStance = 0.9 * std::numbers::pi / 180;  // rad, the mannequin's default
constexpr double kMaxStance = 10 * std::numbers::pi / 180;

sim::MannequinOptions read_mannequin(const std::string& text) {
    try {
        return sim::parse_mannequin(text);
    } catch (const sim::InputError&) {
        return {};
    }
}

void apply_body_edit(InspectorContext& context, const NumberEdit& edit, const sim::MannequinOptions& wanted) {
    switch (edit.phase) {
        case EditPhase::None:
            break;
        case EditPhase::Preview:
            request_body(context, mannequin_text(wanted), BodyRequest::Preview);
            break;
        case EditPhase::Commit:
            request_body(context, mannequin_text(wanted), BodyRequest::Commit);
            break;
        case EditPhase::Rollback:
            cancel_body_request(context);
            break;
    }
}

void draw_sex(InspectorContext& context, const sim::MannequinOptions& options) {
    ButtonRow row(context);
    sim::MannequinOptions wanted = options;
    const auto choose = [&](sim::Sex sex, const char* name, const char* title) {
        if (!row.button({.name = name,
                         .title = title,
                         .tip = "What is not measured follows the proportions of this body.",
                         .is_on = options.sex == sex})) {
            return;
        }
        wanted.sex = sex;
        request_body(context, mannequin_text(wanted), BodyRequest::Commit);
    };
    choose(sim::Sex::Female, "body.female", "Female");
    choose(sim::Sex::Male, "body.male", "Male");
    if (row.button({.name = "body.plain",
                    .title = "Clear measures",
                    .tip = "All measures follow the proportions again.",
                    .is_enabled = mannequin_text(options) != mannequin_text({.sex = options.sex})})) {
        request_body(context, mannequin_text({.sex = options.sex}), BodyRequest::Commit);
    }
}

// The measured value on the current body.
std::optional<double> reading(const std::optional<sim::MannequinReadings>& read, std::string_view name) {
    if (!read) return std::nullopt;
    for (const sim::MeasureReading& entry : read->readings) {
        if (entry.name == name) return entry.measured;
    }
    return std::nullopt;
}

void draw_measures(InspectorContext& context, const sim::MannequinOptions& options) {
    const std::optional<sim::MannequinReadings> read = context.workspace.drape.current_body().made().readings;
    for (const std::string_view name : sim::measure_names()) {
        sim::MannequinOptions wanted = options;
        std::optional<double>* value = find_measure(wanted.measures, name);
        const std::string box = "body." + std::string(name);
        const std::string label = measure_label(name, options.sex);
        const NumberEdit edit =
            number_row(context,
                       {.name = box.c_str(),
                        .value = *value,
                        .tip = std::string(measure_tip(name)) +
                               " Empty: it follows the other measures; what the tape reads is grey.",
                        .may_be_empty = true,
                        .standing_for = reading(read, name)},
                       label.c_str());
        *value = edit.value;
        apply_body_edit(context, edit, wanted);
    }
    sim::MannequinOptions wanted = options;
    const NumberEdit stance = number_row(context,
                                         {.name = "body.stance",
                                          .value = options.stance,
                                          .unit = Unit::Degrees,
                                          .tip = "How far each leg stands outward. Thick thighs open it by themselves.",
                                          .least = 0,
                                          .most = kMaxStance,
                                          .may_be_empty = true,
                                          .standing_for = read ? read->stance.made : kDefaultStance},
                                         "Stance");
    wanted.stance = stance.value;
    apply_body_edit(context, stance, wanted);
}

// Poses and motions: of the body while the garment hangs on it, not of the document.
void draw_activity(InspectorContext& context) {
    Drape& drape = context.workspace.drape;
    const std::shared_ptr<const sim::SessionFrame> frame = drape.frame();
    const CurrentBody& current = drape.current_body();
    if (current.body() != nullptr && current.body()->skin.empty())
        return paragraph(context, "It has no bones: it stands as it is.");
    const auto choose = [&](const char* name, const char* label, const MotionChoices& choices, const std::string& tip) {
        row_label(context, label, tip);
        const int newly = choice_box(context, {.name = name,
                                               .shown = choices.shown,
                                               .items = choices.titles,
                                               .chosen = choices.chosen,
                                               .tip = tip,
                                               .width_px = field_width()});
        return newly < 0 ? std::optional<std::string>() : choices.texts[static_cast<std::size_t>(newly)];
    };
    const auto pose = choose("body.pose", "Pose", pose_choices(drape),
                             "The body goes there once the garment hangs, and carries it along.");
    if (pose) drape.choose_pose(*pose);
    const auto motion =
        choose("body.motion", "Motion", motion_choices(drape), "Played on the timeline under the 3D view.");
    if (motion) {
        drape.choose_motion(*motion);
        if (context.show_timeline) context.show_timeline();
    }
    ButtonRow row(context);
    if (row.button({.name = "body.play",
                    .title = frame->motion.is_playing ? "Pause" : "Play",
                    .tip = with_key(context, "The body moves once the garment hangs", "motion.play"),
                    .is_enabled = drape.can_play()})) {
        frame->motion.is_playing ? drape.pause_motion() : drape.play();
        if (context.show_timeline) context.show_timeline();
    }
    if (row.button({.name = "body.start",
                    .title = "Back to start",
                    .tip = with_key(context, "The body and the garment are as they were dressed", "motion.start"),
                    .is_enabled = !frame->motion.is_at_rest})) {
        drape.back_to_start();
    }
    if (context.open_motion && row.button({.name = "body.open_motion",
                                           .title = "Motion from file...",
                                           .tip = "A BVH, FBX, GLB or glTF file, or one in the shipped format"})) {
        context.open_motion();
    }
    if (frame->motion.is_waiting) paragraph(context, "It waits until the garment hangs.");
}

// Joints turned by hand.

// A list of the joints of a person, or of the other bones.
void choose_joint(InspectorContext& context, const char* name, const char* label, bool is_of_person) {
    const std::vector<BodyJoint>& joints = context.workspace.drape.current_body().joints;
    std::vector<std::string> titles;
    std::vector<int> bones;
    int chosen = -1;
    for (const BodyJoint& joint : joints) {
        if (joint.joint.has_value() != is_of_person) continue;
        if (joint.bone == context.workspace.joint.bone) chosen = static_cast<int>(bones.size());
        titles.push_back(joint.title);
        bones.push_back(joint.bone);
    }
    if (titles.empty()) return;
    const std::string tip = is_of_person ? "The joint to turn: choose it here, or click its dot in the 3D view."
                                         : "Bones that are no joint of a person, by their own names.";
    row_label(context, label, tip);
    const int newly = choice_box(context, {.name = name,
                                           .shown = chosen < 0 ? "Choose..." : titles[static_cast<std::size_t>(chosen)],
                                           .items = titles,
                                           .chosen = chosen,
                                           .tip = tip,
                                           .width_px = field_width()});
    if (newly >= 0) context.workspace.joint.bone = bones[static_cast<std::size_t>(newly)];
}

void draw_angles(InspectorContext& context, const BodyJoint& joint) {
    constexpr std::array kBoxes{"joint.bend", "joint.spread", "joint.twist"};
    constexpr double kHalfTurn = std::numbers::pi;
    Drape& drape = context.workspace.drape;
    const sim::PoseAngles* now = drape.angles();
    if (now == nullptr) return paragraph(context, "The pose is being looked for...");
    const Vec3d angles = angles_of(*now, joint);
    const std::array<AngleLabel, 3> labels = angle_labels(joint);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        const NumberEdit edit = number_row(context,
                                           {.name = kBoxes[i],
                                            .value = std::remainder(angles[axis], 2 * kHalfTurn),
                                            .unit = Unit::Degrees,
                                            .tip = labels[i].tip,
                                            .least = -kHalfTurn,
                                            .most = kHalfTurn},
                                           labels[i].title);
        if (!edit) continue;
        Vec3d wanted = angles;
        wanted[axis] = (edit.phase == EditPhase::Rollback ? edit.before : edit.value).value_or(0);
        sim::PoseAngles turned = *drape.angles();
        set_angles(turned, joint, wanted, context.workspace.joint.has_both_sides);
        drape.turn(turned);
    }
}

void draw_joint_buttons(InspectorContext& context, const BodyJoint* joint) {
    Drape& drape = context.workspace.drape;
    const bool is_turned = drape.activity().turned.has_value();
    ButtonRow row(context);
    if (row.button({.name = "joint.reset",
                    .title = "Reset joint",
                    .tip = "Its angles are as they were before a joint was turned.",
                    .is_enabled = is_turned && joint != nullptr})) {
        drape.reset_angles(*joint, context.workspace.joint.has_both_sides);
    }
    if (row.button({.name = "joint.reset_all",
                    .title = "Reset all",
                    .tip = "The body goes back into the pose that was chosen from the list.",
                    .is_enabled = is_turned})) {
        drape.reset_angles();
    }
    if (context.save_pose && row.button({.name = "joint.save",
                                         .title = "Save pose...",
                                         .tip = "A file that the list of poses and selvedge animate --motion take.",
                                         .is_enabled = !drape.current_body().joints.empty()})) {
        context.save_pose();
    }
    if (context.open_pose && row.button({.name = "joint.open",
                                         .title = "Pose from file...",
                                         .tip = "A pose that was saved, or the end of a motion"})) {
        context.open_pose();
    }
}

void draw_joints(InspectorContext& context) {
    Workspace& workspace = context.workspace;
    if (workspace.drape.current_body().joints.empty())
        return paragraph(context, "It has no bones: its joints cannot be turned.");
    if (check_box(context, "joint.show", "Show joints in the 3D view", workspace.look.has_joints,
                  with_key(context, "A click on a dot chooses the joint; its rings turn it", "view.joints")))
        workspace.look.has_joints = !workspace.look.has_joints;
    choose_joint(context, "joint.list", "Joint", true);
    choose_joint(context, "joint.others", "Other bones", false);
    const BodyJoint* joint = chosen_joint(workspace);
    if (joint != nullptr) draw_angles(context, *joint);
    const bool has_other_side = joint != nullptr && joint->joint && mirrored(*joint->joint) != *joint->joint;
    if (has_other_side && check_box(context, "joint.both", "Both sides", workspace.joint.has_both_sides,
                                    "The joint of the other side turns likewise."))
        workspace.joint.has_both_sides = !workspace.joint.has_both_sides;
    draw_joint_buttons(context, joint);
}

void draw_state(InspectorContext& context) {
    const BodyState& state = context.state.body;
    const sim::MadeBody& made = context.workspace.drape.current_body().made();
    if (!state.wrong.empty()) message_text(context.theme.error, state.wrong);
    if (context.workspace.drape.is_making_body()) paragraph(context, "The body is being made...");
    if (!made.readings) return;
    for (const std::string& message : made.notes) message_text(context.theme.warning, message);
}

void draw_file_body(InspectorContext& context, const std::string& file, bool is_of_pattern) {
    fact(context, "From file", readable_name(file), file);
    const Drape& drape = context.workspace.drape;
    ButtonRow row(context);
    const bool is_ready = drape.current_body().body() != nullptr && drape.current_body().made().source == file;
    if (!is_of_pattern &&
        row.button({.name = "body.adopt",
                    .title = "Use for this garment",
                    .tip = "The garment is placed about this body from now on, and its file names it.",
                    .is_enabled = is_ready})) {
        request_body(context, file, BodyRequest::Commit);
    }
    if (row.button({.name = "body.mannequin",
                    .title = is_of_pattern ? "Use a mannequin" : "Back to the garment's body",
                    .tip = is_of_pattern ? "A body from measures takes its place." : "Takes this body off."})) {
        if (is_of_pattern) {
            request_body(context, kDefaultBody, BodyRequest::Commit);
        } else {
            cancel_body_request(context);
        }
    }
}

void draw_shape(InspectorContext& context) {
    const BodyState& state = context.state.body;
    const std::string of_pattern = body_text(context.pattern());
    const std::string current = context.workspace.drape.current_body().made().source;
    const bool has_foreign = state.pending.empty() && !is_mannequin(current) && current != of_pattern;
    const std::string shown = !state.pending.empty() ? state.pending : has_foreign ? current : of_pattern;
    if (is_mannequin(shown)) {
        const sim::MannequinOptions options = read_mannequin(shown);
        draw_sex(context, options);
        draw_state(context);
        draw_measures(context, options);
    } else {
        draw_file_body(context, shown, shown == of_pattern);
        draw_state(context);
    }
    ButtonRow row(context);
    if (context.open_body &&
        row.button({.name = "body.open",
                    .title = "Body from file...",
                    .tip = with_key(context, "An OBJ, GLB or glTF file, in any unit", "file.body")})) {
        context.open_body();
    }
}

}  // namespace

void draw_body(InspectorContext& context) {
    ImGui::PushID("body");
    if (folding("Pose and motion", Fold::Open)) draw_activity(context);
    if (folding("Joints", Fold::Open)) draw_joints(context);
    if (folding("Body and measures", Fold::Open)) draw_shape(context);
    ImGui::PopID();
}

namespace {

constexpr std::array<std::pair<std::string_view, const char*>, 20> kTips{{
    {"height", "Floor to crown."},
    {"inseam", "Floor to the crotch, inside the leg."},
    {"waist_height", "From the floor to the waist."},
    {"shoulder", "Across, from shoulder joint to shoulder joint."},
    {"arm", "From the shoulder joint over the elbow to the wrist."},
    {"bust", "Level round the fullest part."},
    {"underbust", "Level round the ribs, below the bust."},
    {"waist", "Level round the narrowest part."},
    {"high_hip", "Level, halfway from hip to waist."},
    {"hip", "Level round the fullest part of the seat."},
    {"neck", "Round the neck, lower in front."},
    {"biceps", "Round the upper arm, halfway."},
    {"elbow", "Round the elbow."},
    {"forearm", "Round the forearm, below the elbow."},
    {"wrist", "Round the wrist."},
    {"thigh", "Level round the thigh, 3 cm below the crotch."},
    {"mid_thigh", "Round the thigh, above the knee."},
    {"knee", "Round the knee."},
    {"calf", "Round the fullest part of the calf."},
    {"ankle", "Round the ankle."},
}};

}  // namespace

bool is_mannequin(std::string_view body) {
    return !sim::is_body_file(body);
}

std::string mannequin_text(const sim::MannequinOptions& options) {
    std::string text = options.sex == sim::Sex::Female ? "mannequin:sex=female" : "mannequin:sex=male";
    sim::MannequinMeasures measures = options.measures;
    for (const std::string_view name : sim::measure_names()) {
        const std::optional<double>* value = find_measure(measures, name);
        if (*value) text += "," + std::string(name) + "=" + quantity_number(**value, Unit::Centimetres);
    }
    if (options.stance) text += ",stance=" + quantity_number(*options.stance, Unit::Degrees);
    return text;
}

std::string wrong_with_body(const std::string& text) {
    if (!is_mannequin(text)) return "";
    try {
        sim::parse_mannequin(text.empty() ? kDefaultBody : text);
        return "";
    } catch (const sim::InputError& error) {
        return error.place() + ": " + error.problem();
    }
}

std::string measure_label(std::string_view name, sim::Sex sex) {
    if (name == "bust" && sex == sim::Sex::Male) return "Chest";
    std::string text(name);
    std::replace(text.begin(), text.end(), '_', ' ');
    if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

const char* measure_tip(std::string_view name) {
    const auto* const found =
        std::find_if(kTips.begin(), kTips.end(), [&](const auto& entry) { return entry.first == name; });
    return found == kTips.end() ? "" : found->second;
}

SetBody set_body_command(const sim::Pattern& pattern, const std::string& text, const sim::Body& from,
                         const sim::Body& onto) {
    sim::Pattern moved = pattern;
    raise_panels(moved, from.lift);
    anchor_panels(moved, sim::MeasuredBody(from), sim::MeasuredBody(onto));
    raise_panels(moved, -onto.lift);
    SetBody command{.body = onto.file.empty() ? text : onto.file};
    for (std::size_t i = 0; i < pattern.panels.size(); ++i) {
        command.shifts.push_back(moved.panels[i].translation - pattern.panels[i].translation);
    }
    return command;
}

}  // namespace selvedge::editor
