#pragma once
// The text on screen that is not the editor's own: names in the garment, of files, bodies and motions, and messages.
#include <functional>
#include <string_view>

namespace selvedge::editor {

struct AppState;

// Calls `visit` with each of these texts. Texts that a control holds while they are typed are not among them.
void visit_shown_text(const AppState& state, const std::function<void(std::string_view)>& visit);

}  // namespace selvedge::editor
