#include "editor/inspectors/body_inspector.h"

#include <imgui.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <numbers>
#include <utility>

#include "editor/inspectors/controls.h"
#include "editor/inspectors/material_inspector.h"
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
                                ? set_body_command(pattern, current.text, *state.pattern_body, *current.body)
                                : SetBody{.body = current.text};
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
    if (drape.current_body().body != nullptr && drape.current_body().text == of_pattern) {
        state.pattern_body_text = of_pattern;
        state.pattern_body = drape.current_body().body;
    }
    if (state.pending.empty()) return;
    if (drape.current_body().body != nullptr && drape.current_body().text == state.pending) {
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
std::optional<double> reading(const CurrentBody& current, std::string_view name) {
    if (!current.measures) return std::nullopt;
    for (const sim::MeasureReading& entry : current.measures->readings) {
        if (entry.name == name) return entry.measured;
    }
    return std::nullopt;
}

void draw_measures(InspectorContext& context, const sim::MannequinOptions& options) {
    const CurrentBody current{
        .text = {}, .body = {}, .measures = context.workspace.drape.current_body().measures, .points = {}};
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
                        .standing_for = reading(current, name)},
                       label.c_str());
        *value = edit.value;
        apply_body_edit(context, edit, wanted);
    }
    sim::MannequinOptions wanted = options;
    const NumberEdit stance =
        number_row(context,
                   {.name = "body.stance",
                    .value = options.stance,
                    .unit = Unit::Degrees,
                    .tip = "How far each leg stands outward. Thick thighs open it by themselves.",
                    .least = 0,
                    .most = kMaxStance,
                    .may_be_empty = true,
                    .standing_for = current.measures ? current.measures->stance.made : kDefaultStance},
                   "Stance");
    wanted.stance = stance.value;
    apply_body_edit(context, stance, wanted);
}

void draw_state(InspectorContext& context) {
    const BodyState& state = context.state.body;
    const CurrentBody& current = context.workspace.drape.current_body();
    if (!state.wrong.empty()) message_text(context.theme.error, state.wrong);
    if (context.workspace.drape.is_making_body()) paragraph(context, "The body is being made...");
    if (!current.measures) return;
    for (const std::string& message : current.measures->messages) message_text(context.theme.warning, message);
}

void draw_file_body(InspectorContext& context, const std::string& file, bool is_of_pattern) {
    fact(context, "From file", readable_name(file), file);
    const Drape& drape = context.workspace.drape;
    ButtonRow row(context);
    const bool is_ready = drape.current_body().body != nullptr && drape.current_body().text == file;
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

}  // namespace

void draw_body(InspectorContext& context) {
    ImGui::PushID("body");
    const BodyState& state = context.state.body;
    const std::string of_pattern = body_text(context.pattern());
    const std::string current = context.workspace.drape.current_body().text;
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
    ImGui::PopID();
}

namespace {

constexpr std::array<std::pair<std::string_view, const char*>, 19> kTips{{
    {"height", "Floor to crown."},
    {"inseam", "Floor to the crotch, inside the leg."},
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
    anchor_panels(moved, from, onto);
    raise_panels(moved, -onto.lift);
    SetBody command{.body = onto.file.empty() ? text : onto.file};
    for (std::size_t i = 0; i < pattern.panels.size(); ++i) {
        command.shifts.push_back(moved.panels[i].translation - pattern.panels[i].translation);
    }
    return command;
}

}  // namespace selvedge::editor
