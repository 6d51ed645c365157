// Who wears it: sex, measures, stance, or a body from a file.
#include <imgui.h>

#include <numbers>

#include "editor/inspectors/body_change.h"
#include "editor/inspectors/body_text.h"
#include "editor/inspectors/controls.h"
#include "editor/inspectors/fabric_text.h"
#include "editor/inspectors/number_box.h"
#include "editor/inspectors/vector_row.h"
#include "sim/core/error.h"

namespace selvedge {
namespace {

constexpr double kUsualStance = 0.9 * std::numbers::pi / 180;  // rad, of the mannequin
constexpr double kMostStance = 10 * std::numbers::pi / 180;

std::string drafted_body(const InspectorContext& context) {
    const std::string& body = context.pattern().body;
    return body.empty() ? kUsualBody : body;
}

MannequinOptions read_mannequin(const std::string& text) {
    try {
        return parse_mannequin(text);
    } catch (const InputError&) {
        return {};
    }
}

void carry_body(InspectorContext& context, const NumberEdit& edit, const MannequinOptions& wanted) {
    switch (edit.phase) {
        case EditPhase::None:
            break;
        case EditPhase::Trying:
            wish_body(context, mannequin_text(wanted), BodyWish::Try);
            break;
        case EditPhase::Kept:
            wish_body(context, mannequin_text(wanted), BodyWish::Keep);
            break;
        case EditPhase::Dropped:
            drop_body_wish(context);
            break;
    }
}

void draw_sex(InspectorContext& context, const MannequinOptions& options) {
    ButtonRow row(context);
    MannequinOptions wanted = options;
    const auto choose = [&](Sex sex, const char* name, const char* title) {
        if (!row.button({.name = name,
                         .title = title,
                         .tip = "What is not measured follows the proportions of this body.",
                         .is_on = options.sex == sex})) {
            return;
        }
        wanted.sex = sex;
        wish_body(context, mannequin_text(wanted), BodyWish::Keep);
    };
    choose(Sex::Female, "body.female", "Female");
    choose(Sex::Male, "body.male", "Male");
    if (row.button({.name = "body.plain",
                    .title = "Clear measures",
                    .tip = "All measures follow the proportions again.",
                    .is_enabled = mannequin_text(options) != mannequin_text({.sex = options.sex})})) {
        wish_body(context, mannequin_text({.sex = options.sex}), BodyWish::Keep);
    }
}

// What the tape reads on the body that is worn.
std::optional<double> reading(const WornBody& worn, std::string_view name) {
    if (!worn.measures) return std::nullopt;
    for (const MeasureReading& entry : worn.measures->readings) {
        if (entry.name == name) return entry.measured;
    }
    return std::nullopt;
}

void draw_measures(InspectorContext& context, const MannequinOptions& options) {
    const WornBody worn{.text = {}, .body = {}, .measures = context.workspace.drape.worn().measures, .points = {}};
    for (const std::string_view name : measure_names()) {
        MannequinOptions wanted = options;
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
                        .standing_for = reading(worn, name)},
                       label.c_str());
        *value = edit.value;
        carry_body(context, edit, wanted);
    }
    MannequinOptions wanted = options;
    const NumberEdit stance = number_row(context,
                                         {.name = "body.stance",
                                          .value = options.stance,
                                          .unit = Unit::Degrees,
                                          .tip = "How far each leg stands outward. Thick thighs open it by themselves.",
                                          .least = 0,
                                          .most = kMostStance,
                                          .may_be_empty = true,
                                          .standing_for = worn.measures ? worn.measures->stance.made : kUsualStance},
                                         "Stance");
    wanted.stance = stance.value;
    carry_body(context, stance, wanted);
}

void draw_state(InspectorContext& context) {
    const BodyState& state = context.state.body;
    const WornBody& worn = context.workspace.drape.worn();
    if (!state.wrong.empty()) complaint(context.theme.error, state.wrong);
    if (context.workspace.drape.is_making_body()) paragraph(context, "The body is being made...");
    if (!worn.measures) return;
    for (const std::string& message : worn.measures->messages) complaint(context.theme.warning, message);
}

void draw_file_body(InspectorContext& context, const std::string& file, bool is_drafted) {
    fact(context, "From file", readable_name(file), file);
    const Drape& drape = context.workspace.drape;
    ButtonRow row(context);
    const bool is_ready = drape.worn().body != nullptr && drape.worn().text == file;
    if (!is_drafted && row.button({.name = "body.adopt",
                                   .title = "Use for this garment",
                                   .tip = "The garment is placed about this body from now on, and its file names it.",
                                   .is_enabled = is_ready})) {
        wish_body(context, file, BodyWish::Keep);
    }
    if (row.button({.name = "body.mannequin",
                    .title = is_drafted ? "Use a mannequin" : "Back to the garment's body",
                    .tip = is_drafted ? "A body from measures takes its place." : "Takes this body off."})) {
        if (is_drafted) {
            wish_body(context, kUsualBody, BodyWish::Keep);
        } else {
            drop_body_wish(context);
        }
    }
}

}  // namespace

void draw_body(InspectorContext& context) {
    ImGui::PushID("body");
    const BodyState& state = context.state.body;
    const std::string drafted = drafted_body(context);
    const std::string worn = context.workspace.drape.worn().text;
    const bool has_foreign = state.pending.empty() && !is_mannequin(worn) && worn != drafted;
    const std::string shown = !state.pending.empty() ? state.pending : has_foreign ? worn : drafted;
    if (is_mannequin(shown)) {
        const MannequinOptions options = read_mannequin(shown);
        draw_sex(context, options);
        draw_state(context);
        draw_measures(context, options);
    } else {
        draw_file_body(context, shown, shown == drafted);
        draw_state(context);
    }
    ButtonRow row(context);
    if (context.open_body &&
        row.button({.name = "body.open",
                    .title = "Body from file...",
                    .tip = with_key(context, "An OBJ, GLB, FBX or STL file in metres, y up", "file.body")})) {
        context.open_body();
    }
    ImGui::PopID();
}

}  // namespace selvedge
