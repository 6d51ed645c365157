#pragma once
// All that the editor holds: what is worked on, the views onto it, and what lies open about them.
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/frame/frame.h"
#include "editor/frame/theme.h"
#include "editor/tools/tool_host.h"
#include "editor/ui/action.h"
#include "editor/ui/files.h"
#include "editor/ui/services.h"
#include "editor/workspace/workspace.h"

namespace selvedge::editor {

// Asked in a bar above the views: nothing waits for the answer.
struct Question {
    struct Answer {
        std::string label;
        std::function<void(AppState&)> run;
    };
    std::string words;
    std::vector<Answer> answers;
};

enum class InspectorTab { Properties, Seams, Cloth, Body, Drape, History };
enum class FocusedView { Sheet, Fitting };

// Which parts of the window are there, and how large.
struct WindowLayout {
    bool has_sheet = true;
    bool has_viewport = true;
    bool has_inspectors = true;
    bool has_tools = true;
    float sheet_share = 0.5F;       // of the width that both views have
    float inspector_width = 21.5F;  // in heights of the font
    InspectorTab tab = InspectorTab::Properties;
};

// What the 3D view shows, to be exported.
struct ShownFitting {
    std::shared_ptr<const render::Scene> scene{};  // null: nothing
    render::Camera camera{};
    render::Light light{};
};

struct AppState {
    AppState(Services given, sim::SessionDrive drive);

    Services services;
    Workspace workspace;
    ToolHost tools;
    std::vector<Action> actions;
    Theme theme;
    Fonts fonts;
    WindowLayout layout;
    ActionFinder finder;
    FileBrowser browser;
    std::deque<Question> questions;
    std::vector<sim::Panel> clipboard;
    WidgetMap widgets;
    ShownFitting fitting;
    FocusedView focused = FocusedView::Sheet;
    bool shows_start_page = true;
    bool wants_to_close = false;
    float user_scale = 1;      // of the interface, on top of the screen's
    int documents_opened = 0;  // so far: views begin anew with each
};

// Makes the document's changes go to the journal, beginning now.
void begin_journal(AppState& desk);

}  // namespace selvedge::editor
