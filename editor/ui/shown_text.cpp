#include "editor/ui/shown_text.h"

#include "editor/ui/app_state.h"

namespace selvedge::editor {
namespace {

using Visit = std::function<void(std::string_view)>;

void visit_pattern(const sim::Pattern& pattern, const Visit& visit) {
    for (const std::string* text : {&pattern.name, &pattern.fabric, &pattern.tartan, &pattern.body, &pattern.size})
        visit(*text);
    for (const sim::Panel& panel : pattern.panels) {
        visit(panel.name);
        visit(panel.fabric);
        visit(panel.garment);
        for (const std::string& interlining : panel.interlinings) visit(interlining);
        for (const sim::OutlineEdge& edge : panel.edges) visit(edge.label);
        for (const sim::InternalLine& line : panel.internal_lines) visit(line.name);
    }
    for (const sim::Seam& seam : pattern.seams) {
        visit(seam.name);
        visit(seam.sewing);
    }
}

void visit_drape(const Drape& drape, const Visit& visit) {
    const CurrentBody& body = drape.current_body();
    visit(body.text);
    for (const std::string& note : body.notes) visit(note);
    for (const sim::Clip& clip : body.clips) visit(clip.name);
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
