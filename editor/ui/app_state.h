#pragma once
// The editor's whole state: the workspace, window layout, open dialogs, and resources such as fonts and actions.
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/document/command.h"
#include "editor/frame/frame.h"
#include "editor/frame/theme.h"
#include "editor/inspectors/inspectors.h"
#include "editor/sheet/sheet_pen.h"
#include "editor/tools/tool_host.h"
#include "editor/ui/action.h"
#include "editor/ui/files.h"
#include "editor/ui/help_windows.h"
#include "editor/ui/services.h"
#include "editor/ui/underlay_pictures.h"
#include "editor/workspace/workspace.h"

namespace selvedge::editor {

// A question in a bar above the views. It is not modal: the editor stays usable.
struct Question {
    struct Answer {
        std::string label;
        std::function<void(AppState&)> run;
    };
    std::string text;
    std::vector<Answer> answers;
};

enum class InspectorTab { Properties, Seams, Cloth, Body, Drape, History, Objects };

// The visible parts of the window and their sizes.
struct WindowLayout {
    bool has_sheet = true;
    bool has_viewport = true;
    bool has_inspectors = true;
    bool has_tools = true;
    bool has_timeline = false;      // under the 3D view
    float sheet_share = 0.5F;       // fraction of the width of both views
    float inspector_width = 22.5F;  // font heights
    InspectorTab tab = InspectorTab::Properties;
    std::optional<InspectorTab> wanted_tab{};  // is opened in the next frame
    bool focuses_inspector = false;            // it gets the keyboard in the next frame
};

// A drag on the timeline.
struct TimelineDrag {
    bool plays_on = false;           // the motion played when the drag began
    std::optional<double> sought{};  // s, by the last frame of it
};

// What the 3D view shows, for export.
struct ShownViewport {
    std::shared_ptr<const render::Scene> scene{};  // null: nothing
    render::Camera camera{};
    render::Light light{};
};

struct AppState {
    AppState(Services given, sim::SessionDrive drive);

    Services services;
    Workspace workspace;
    ToolHost tools;
    std::vector<Action> actions;  // in the key map of `actions_map`
    KeyMap actions_map = KeyMap::Selvedge;
    Theme theme;
    bool is_dark = false;  // the theme follows with the next frame
    SheetVisibility sheet_shows;
    HelpWindows help;
    Fonts fonts;
    WindowLayout layout;
    ActionFinder finder;
    FileBrowser browser;
    std::deque<Question> questions;
    // SHA-256 of what the document's file held when it was last read or written; none: there is no file, or it is not
    // known.
    std::optional<std::string> file_hash{};
    AddPanels clipboard;  // the copied panels, with the seams among them
    UnderlayPictures underlays;
    WidgetMap widgets;
    ShownViewport viewport;
    ExportThickness export_thickness;   // of the next export from the menu
    sim::ImportOptions import_options;  // of the next import from the menu
    sim::PrintSettings print_settings;  // of the next print
    TimelineDrag timeline;
    InspectorState inspectors;
    std::string journal_problem;  // that was told last; empty: none
    bool shows_start_page = true;
    bool wants_to_close = false;
    bool shows_times = true;         // what a frame took, which differs from run to run
    float user_scale = 1;            // of the interface, multiplied by the screen's scale
    bool wants_whole_sheet = false;  // the sheet's view is to show all of it in the next frame
    int documents_opened = 0;        // so far: the views are reset with each one
};

// Starts a new journal that records the document's changes from now on. If that is not possible, a message says so.
void begin_journal(AppState& state);

// Tells the user when the journal begins to lack changes, and when it has them all again.
void report_journal_problem(AppState& state);

}  // namespace selvedge::editor
