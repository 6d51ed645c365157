#include "editor/ui/bars.h"

#include <imgui.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <utility>
#include <vector>

#include "editor/frame/item.h"
#include "editor/frame/keyboard.h"
#include "editor/tools/tool_host.h"
#include "editor/ui/actions.h"
#include "editor/ui/app_state.h"
#include "editor/ui/files.h"
#include "editor/ui/widgets.h"
#include "editor/viewport3d/viewport_overlay.h"

namespace selvedge::editor {
namespace {

void show_recent_files(AppState& state) {
    const std::vector<std::string> files = state.services.recent_files();
    if (!ImGui::BeginMenu("Open recent", !files.empty())) return;
    for (const std::string& file : files) {
        if (ImGui::MenuItem(file.c_str())) open_file(state, file);
    }
    ImGui::EndMenu();
}

void show_action(AppState& state, const Action& action) {
    if (action.begins_group) ImGui::Separator();
    const bool is_on = action.is_on && action.is_on(state);
    const bool can = !action.can || action.can(state);
    const std::string keys = chord_text(action);
    if (ImGui::MenuItem(action.title.c_str(), keys.c_str(), is_on, can)) run_action(state, action);
    note_widget(state.widgets, "menu." + action.id);
    show_tip(tip_for(action, state), kTipWidth);
    if (action.id == "file.open") show_recent_files(state);
}

std::string drape_text(const sim::SessionFrame& frame, bool shows_times) {
    const sim::SessionStatistics& statistics = frame.statistics;
    std::string text = stage_badge(frame) + "   " + std::to_string(statistics.leaf_triangles) + " triangles";
    if (!shows_times || statistics.times.frame == 0) return text;  // nothing was simulated yet
    char time[32];
    std::snprintf(time, sizeof time, "   %.1f ms", statistics.times.frame);
    return text + time;
}

void show_line(const sim::Rgb8& colour, const std::string& text, float width) {
    const std::string shown = elided(text, width, Elide::End);
    ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(colour[0], colour[1], colour[2], 255));
    ImGui::TextUnformatted(shown.c_str());
    ImGui::PopStyleColor();
    tip_of_whole(text, shown);
}

// Shows the message, or the tool's hint, on one line of `width` px.
void show_message(AppState& state, float width) {
    const Messages& messages = state.workspace.messages;
    if (const Message* message = messages.shown()) {
        const sim::Rgb8& colour = message->kind == MessageKind::Error     ? state.theme.error
                                  : message->kind == MessageKind::Warning ? state.theme.warning
                                                                          : state.theme.ink;
        return show_line(colour, message->text, width);
    }
    show_line(state.theme.faint, state.tools.hint(tool_host_context(state.workspace)), width);
    note_widget(state.widgets, "status.hint");
}

// px left for the question's text beside its answers.
float width_beside(const Question& question) {
    const ImGuiStyle& style = ImGui::GetStyle();
    float width = ImGui::GetContentRegionAvail().x;
    for (const Question::Answer& answer : question.answers) {
        width -= style.ItemSpacing.x + 2 * style.FramePadding.x + ImGui::CalcTextSize(answer.label.c_str()).x;
    }
    return std::max(0.0F, width);
}

void show_icon(AppState& state, const char* action, const char* icon, float side_px) {
    const Action* found = find_action(state.actions, action);
    if (found != nullptr) icon_button(state, *found, icon, side_px);
}

}  // namespace

void show_menu_bar(AppState& state) {
    if (!ImGui::BeginMainMenuBar()) return;
    for (const std::string& menu : menu_names()) {
        const bool is_open = ImGui::BeginMenu(menu.c_str());
        note_widget(state.widgets, "menu." + menu);
        if (!is_open) continue;
        for (const Action& action : state.actions) {
            if (action.menu == menu) show_action(state, action);
        }
        ImGui::EndMenu();
    }
    const std::string name =
        document_name(state) + (state.workspace.document->has_unsaved_changes() ? "  (unsaved)" : "");
    const float room = ImGui::GetWindowWidth() - ImGui::GetCursorPosX() - 3 * ImGui::GetFontSize();
    const std::string shown = elided(name, std::max(0.0F, room), Elide::Middle);
    ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::CalcTextSize(shown.c_str()).x - ImGui::GetFontSize());
    ImGui::TextDisabled("%s", shown.c_str());
    tip_of_whole(state.workspace.file.empty() ? shown : state.workspace.file, shown);
    ImGui::EndMainMenuBar();
}

float show_question(AppState& state) {
    if (state.questions.empty()) return 0;
    const float top = ImGui::GetFrameHeight();
    const float height = 2 * ImGui::GetFrameHeight();
    ImGui::SetNextWindowPos({0, top});
    ImGui::SetNextWindowSize({ImGui::GetIO().DisplaySize.x, height});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, colour_of(state.theme.question));
    ImGui::PushStyleColor(ImGuiCol_Border, colour_of(state.theme.warning, 120));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::Begin("##question", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    const Question question = state.questions.front();  // a copy: an answer may ask another question
    ImGui::AlignTextToFramePadding();
    const std::string shown = elided(question.text, width_beside(question), Elide::Middle);
    ImGui::TextUnformatted(shown.c_str());
    tip_of_whole(question.text, shown);
    const Question::Answer* given = nullptr;
    for (const Question::Answer& answer : question.answers) {
        ImGui::SameLine();
        if (button(state, "answer." + answer.label, answer.label)) given = &answer;
    }
    ImGui::End();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    if (given != nullptr) {
        state.questions.pop_front();
        given->run(state);
    }
    return height;
}

namespace {

constexpr std::array<std::pair<const char*, const char*>, 4> kViewSwitches{
    {{"view.body", "body"}, {"view.threads", "threads"}, {"view.points", "points"}, {"view.timeline", "motion"}}};

// What stands in each row of the bar over the 3D view: first the buttons of the simulation, then the list of what is
// shown, then the switches. In a narrow view each of them begins a new row; the switches fill as many as they need.
struct ViewportBar {
    float list = 0;  // px, width of the list
    bool has_list_below = false;
    bool has_switches_below = false;
    int switches_per_row = static_cast<int>(kViewSwitches.size());

    int rows() const {
        const int count = static_cast<int>(kViewSwitches.size());
        return 1 + (has_list_below ? 1 : 0) + (has_switches_below ? 1 : 0) +
               (count + switches_per_row - 1) / switches_per_row - 1;
    }
};

ViewportBar viewport_bar(float width) {
    const float unit = ImGui::GetFontSize(), gap = ImGui::GetStyle().ItemSpacing.x, side = ImGui::GetFrameHeight();
    const auto count = static_cast<float>(kViewSwitches.size());
    const float least = 6 * unit, most = 10 * unit, buttons = 2 * side + gap, switches = count * (side + gap);
    ViewportBar bar;
    const float beside = width - buttons - unit;
    bar.has_list_below = beside < least;
    const float row = bar.has_list_below ? width : beside;
    bar.has_switches_below = row - switches < least;
    bar.list = std::clamp(bar.has_switches_below ? row : row - switches, std::min(least, row), most);
    if (bar.has_switches_below) {
        const float narrow = ImGui::GetStyle().ItemInnerSpacing.x;
        const auto fit = static_cast<int>((width + narrow) / (side + narrow));
        bar.switches_per_row = std::clamp(fit, 1, static_cast<int>(kViewSwitches.size()));
    }
    return bar;
}

void show_mode_list(AppState& state, float width) {
    const Action* shown = nullptr;
    for (const Action& action : state.actions) {
        if (action.id.starts_with("view.") && action.title.starts_with("Show ") && action.is_on(state)) shown = &action;
    }
    const std::string whole = shown == nullptr ? "" : shown->title.substr(5);
    const ImGuiStyle& style = ImGui::GetStyle();
    const std::string preview = elided(whole, width - ImGui::GetFrameHeight() - 2 * style.FramePadding.x);
    ImGui::SetNextItemWidth(width);
    const bool is_open = ImGui::BeginCombo("##show", preview.c_str());
    note_widget(state.widgets, "view.modes");
    if (!is_open) return show_tip(preview == whole ? "What the cloth shows" : whole, kTipWidth);
    for (const Action& action : state.actions) {
        if (!action.title.starts_with("Show ")) continue;
        if (ImGui::Selectable(action.title.c_str() + 5, &action == shown)) run_action(state, action);
    }
    ImGui::EndCombo();
}

}  // namespace

float viewport_bar_height(float width) {
    const auto rows = static_cast<float>(viewport_bar(width).rows());
    return rows * ImGui::GetFrameHeight() + (rows - 1) * ImGui::GetStyle().ItemSpacing.y;
}

void show_viewport_bar(AppState& state) {
    const float side = ImGui::GetFrameHeight();
    const ViewportBar bar = viewport_bar(ImGui::GetContentRegionAvail().x);
    const bool is_running = state.workspace.drape.frame()->is_running;
    show_icon(state, "simulate.run", is_running ? "pause" : "play", side);
    ImGui::SameLine();
    show_icon(state, "simulate.reset", "reset", side);
    if (!bar.has_list_below) ImGui::SameLine(0, ImGui::GetFontSize());
    show_mode_list(state, bar.list);
    int at = 0;
    for (const auto& [action, icon] : kViewSwitches) {
        const bool begins_row = at % bar.switches_per_row == 0 && (at > 0 || bar.has_switches_below);
        if (!begins_row && bar.has_switches_below) ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
        if (!begins_row && !bar.has_switches_below) ImGui::SameLine();
        show_icon(state, action, icon, side);
        ++at;
    }
}

void show_status_bar(AppState& state) {
    const std::shared_ptr<const sim::SessionFrame> frame = state.workspace.drape.frame();
    const std::string text = drape_text(*frame, state.shows_times);
    const float width = ImGui::CalcTextSize(text.c_str()).x + ImGui::GetFontSize();
    show_message(state, ImGui::GetContentRegionAvail().x - width);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width + ImGui::GetFontSize());
    if (frame->problem.empty()) {
        ImGui::TextDisabled("%s", text.c_str());
    } else {
        coloured_text(state.theme.error, text);
        show_tip(frame->problem, kTipWidth);
    }
}

namespace {

constexpr const char* kName = "##sheet_menu";
constexpr std::array<std::string_view, 3> kMenus{"Edit", "Panel", "Seam"};

// A right click on an unselected object selects it. A seam has priority over the edge that it lies on.
void select_under_cursor(AppState& state) {
    const Hover& hover = state.workspace.hover;
    const Selection& selected = state.workspace.document->selection();
    Selection wanted;
    if (hover.seam && !selected.seams.contains(*hover.seam)) {
        wanted.seams.insert(*hover.seam);
    } else if (!hover.seam && !hover.panel.empty() && !selected.panels.contains(hover.panel) &&
               selected.edges.empty() && selected.vertices.empty()) {
        wanted.panels.insert(hover.panel);
    } else {
        return;
    }
    state.workspace.document->select(wanted);
}

void show_entry(AppState& state, const Action& action) {
    if (ImGui::MenuItem(action.title.c_str(), chord_text(action).c_str())) run_action(state, action);
    note_widget(state.widgets, "sheet_menu." + action.id);
    show_tip(action.tip, kTipWidth);
}

}  // namespace

void open_sheet_menu(AppState& state) {
    select_under_cursor(state);
    ImGui::OpenPopup(kName);
}

void show_sheet_menu(AppState& state) {
    if (!ImGui::BeginPopup(kName)) return;
    bool has_group = false;
    for (const std::string_view menu : kMenus) {
        bool has_any = false;
        for (const Action& action : state.actions) {
            if (action.menu != menu || (action.can && !action.can(state))) continue;
            if (!has_any && has_group) ImGui::Separator();
            has_any = true;
            show_entry(state, action);
        }
        has_group = has_group || has_any;
    }
    ImGui::EndPopup();
}

namespace {

// A line of the start page: the keys of actions, or a key of the views, and what they do.
struct KeyLine {
    std::vector<const char*> actions;
    const char* key = "";
    const char* what = "";
};

const std::array<KeyLine, 8> kKeyLines{
    {{.actions = {"simulate.run"}, .what = "start and pause the drape"},
     {.actions = {"tool.polygon", "tool.rectangle", "tool.ellipse"}, .what = "draw a polygon, rectangle, ellipse"},
     {.actions = {"tool.edit_point", "tool.add_point", "tool.curve_point"},
      .what = "move points, add points, bend edges"},
     {.actions = {"tool.segment_sewing", "tool.free_sewing"}, .what = "sew edges, sew freely"},
     {.actions = {"tool.select"}, .what = "select and move"},
     {.actions = {}, .key = "F", .what = "show what is selected, or all"},
     {.actions = {"edit.undo"}, .what = "undo, also while it drapes"},
     {.actions = {"help.find"}, .what = "find any action by its name"}}};

std::string keys_text(const AppState& state, const KeyLine& line) {
    std::string text = line.key;
    for (const char* id : line.actions) {
        const Action* action = find_action(state.actions, id);
        if (action != nullptr) text += (text.empty() ? "" : ", ") + chord_text(*action);
    }
    return text;
}

void show_examples(AppState& state) {
    const float unit = ImGui::GetFontSize();
    for (const Example& example : state.services.examples) {
        if (button(state, "example." + example.title, example.title)) open_example(state, example);
        ImGui::SameLine(9 * unit);
        ImGui::TextWrapped("%s", example.what.c_str());
    }
}

void show_recent(AppState& state) {
    const std::vector<std::string> files = state.services.recent_files();
    if (files.empty()) return;
    ImGui::Dummy({0, ImGui::GetFontSize() * 0.5F});
    ImGui::PushFont(state.fonts.bold);
    ImGui::TextUnformatted("Recent files");
    ImGui::PopFont();
    constexpr std::size_t kMaxShown = 5;
    for (std::size_t i = 0; i < std::min(kMaxShown, files.size()); ++i) {
        const std::string shown = elided(files[i], ImGui::GetContentRegionAvail().x, Elide::Middle);
        if (ImGui::Selectable((shown + "##" + std::to_string(i)).c_str())) open_file(state, files[i]);
        tip_of_whole(files[i], shown);
    }
}

void show_keys(AppState& state) {
    ImGui::Dummy({0, ImGui::GetFontSize() * 0.5F});
    ImGui::PushFont(state.fonts.bold);
    ImGui::TextUnformatted("Keys");
    ImGui::PopFont();
    for (const KeyLine& line : kKeyLines) {
        ImGui::TextUnformatted(keys_text(state, line).c_str());
        ImGui::SameLine(9 * ImGui::GetFontSize());
        ImGui::TextDisabled("%s", line.what);
    }
}

}  // namespace

void show_start_page(AppState& state) {
    if (&state.tools.info() != &default_tool()) state.shows_start_page = false;  // the user has started to work
    if (!state.shows_start_page || state.browser.is_open()) return;
    const float unit = ImGui::GetFontSize();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float width = std::min(38 * unit, display.x - 2 * unit);
    ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({width, 0});
    constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                            ImGuiWindowFlags_NoFocusOnAppearing;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {1.6F * unit, 1.4F * unit});
    if (ImGui::Begin("##start", nullptr, kFlags)) {
        ImGui::PushFont(state.fonts.large);
        ImGui::TextUnformatted("Selvedge");
        ImGui::PopFont();
        ImGui::TextDisabled("Draw panels, sew them, put them on a body, let them fall.");
        ImGui::Dummy({0, unit * 0.5F});
        ImGui::PushFont(state.fonts.bold);
        ImGui::TextUnformatted("Begin with");
        ImGui::PopFont();
        if (button(state, "start.empty", "Empty sheet")) state.shows_start_page = false;
        ImGui::SameLine();
        if (button(state, "start.open", "Open a file...")) browse_to_open(state);
        ImGui::SameLine();
        if (button(state, "start.tour", "First steps")) {
            state.help.tour_step = 0;
            state.shows_start_page = false;
        }
        show_examples(state);
        show_recent(state);
        show_keys(state);
        const bool is_over = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
        const bool is_left = !ImGui::IsWindowAppearing() && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !is_over;
        if (is_left || is_key_pressed(Key::Escape)) state.shows_start_page = false;
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace selvedge::editor
