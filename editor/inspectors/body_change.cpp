#include "editor/inspectors/body_change.h"

#include "editor/inspectors/body_text.h"

namespace selvedge {
namespace {

constexpr int kGivenUpAfter = 3;  // frames in which nothing was being made and the body is not there: it failed

std::string drafted_text(const Pattern& pattern) {
    return pattern.body.empty() ? kUsualBody : pattern.body;
}

void keep_body(InspectorContext& context) {
    BodyState& state = context.state.body;
    const WornBody& worn = context.workspace.drape.worn();
    const Pattern& pattern = context.pattern();
    // Where the body that it was drafted for was never made, panels stay where they are.
    const SetBody command = state.drafted_body != nullptr && state.drafted == drafted_text(pattern)
                                ? set_body_command(pattern, worn.text, *state.drafted_body, *worn.body)
                                : SetBody{.body = worn.text};
    context.workspace.run(command);
    drop_body_wish(context);
}

}  // namespace

void wish_body(InspectorContext& context, const std::string& text, BodyWish wish) {
    BodyState& state = context.state.body;
    state.wrong = wrong_with_body(text);
    if (!state.wrong.empty()) return;
    state.pending = text;
    state.is_kept = wish == BodyWish::Keep;
    state.idle_frames = 0;
    context.workspace.drape.wear(text);
}

void drop_body_wish(InspectorContext& context) {
    BodyState& state = context.state.body;
    state.pending.clear();
    state.wrong.clear();
    state.is_kept = false;
    context.workspace.drape.wear({});
}

void follow_body_wish(InspectorContext& context) {
    BodyState& state = context.state.body;
    const Drape& drape = context.workspace.drape;
    const std::string drafted = drafted_text(context.pattern());
    if (drape.worn().body != nullptr && drape.worn().text == drafted) {
        state.drafted = drafted;
        state.drafted_body = drape.worn().body;
    }
    if (state.pending.empty()) return;
    if (drape.worn().body != nullptr && drape.worn().text == state.pending) {
        if (state.is_kept) keep_body(context);
        return;
    }
    state.idle_frames = drape.is_making_body() ? 0 : state.idle_frames + 1;
    if (state.idle_frames >= kGivenUpAfter) drop_body_wish(context);
}

}  // namespace selvedge
