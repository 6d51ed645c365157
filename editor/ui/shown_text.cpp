#include "editor/ui/shown_text.h"

#include <string>
#include <type_traits>

#include "editor/ui/app_state.h"
#include "sim/pattern/field_visit.h"
#include "sim/pattern/pattern_fields.h"

namespace selvedge::editor {
namespace {

using Visit = std::function<void(std::string_view)>;

void visit_pattern(const sim::Pattern& pattern, const Visit& visit) {
    visit_values(pattern, [&]<class T>(const auto&, const T& value) {
        if constexpr (std::is_same_v<T, std::string>) visit(value);
    });
}

void visit_drape(const Drape& drape, const Visit& visit) {
    const CurrentBody& body = drape.current_body();
    visit(body.made().source);
    for (const std::string& note : body.made().notes) visit(note);
    for (const sim::Clip& clip : body.made().clips) visit(clip.name);
    for (const BodyJoint& joint : body.joints) visit(joint.title);
    for (const std::string& file : drape.pose_files()) visit(file);
    visit(drape.activity().motion);
    visit(drape.frame()->problem);
}

}  // namespace

void visit_shown_text(const AppState& state, const Visit& visit) {
    visit_pattern(state.workspace.document->pattern(), visit);
    visit_drape(state.workspace.drape, visit);
    visit(state.workspace.file);
    for (const std::string& file : state.workspace.fabrics.files()) visit(file);
    if (const Message* message = state.workspace.messages.shown()) visit(message->text);
    for (const Question& question : state.questions) visit(question.text);
    state.browser.visit_text(visit);
    if (!state.shows_start_page) return;
    for (const std::string& file : state.services.recent_files()) visit(file);
}

}  // namespace selvedge::editor
