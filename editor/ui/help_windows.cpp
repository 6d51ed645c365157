#include "editor/ui/help_windows.h"

#include <imgui.h>
#include <imgui_stdlib.h>
#include <algorithm>
#include <array>
#include <functional>
#include <sstream>

#include "editor/frame/item.h"
#include "editor/frame/keyboard.h"
#include "editor/inspectors/material_inspector.h"
#include "editor/tools/tool_host.h"
#include "editor/ui/actions.h"
#include "editor/ui/app_state.h"
#include "editor/ui/files.h"
#include "editor/ui/widgets.h"
#include "sim/core/trimmed.h"

namespace selvedge::editor {
namespace {

constexpr auto kFlags = ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse;

// One of the first steps. `show` does it for the user.
struct TourStep {
    const char* title;
    const char* text;
    const char* button;
    void (*show)(AppState&);
};

void run(AppState& state, std::string_view id) {
    if (const Action* action = find_action(state.actions, id)) run_action(state, *action);
}

void open_first_example(AppState& state) {
    if (!state.services.examples.empty()) open_example(state, state.services.examples.front());
}

const std::array<TourStep, kTourSteps> kTour{
    {{"Open a garment",
      "The sheet on the left has the panels, the 3D view shows them round the body. Lines of one colour are sewn to "
      "each "
      "other.",
      "Open the T-shirt", open_first_example},
     {"Look round",
      "On the sheet the wheel zooms and a middle or right drag pans. In the 3D view a right drag turns the body, a "
      "middle "
      "drag pans. F frames what is selected, or all.",
      "Show all of the sheet", [](AppState& state) { state.wants_whole_sheet = true; }},
     {"Let it fall",
      "Space sews the panels and lets the garment fall; again: it waits. The badge in the 3D view says how it fits: "
      "click "
      "it to see where it does not.",
      "Start", [](AppState& state) { run(state, "simulate.run"); }},
     {"Change it",
      "With Edit point (Z) drag a point of a panel, or type how far: the garment follows at once. Ctrl+Z takes it "
      "back, "
      "as often as you like.",
      "Choose Edit point", [](AppState& state) { run(state, "tool.edit_point"); }},
     {"Keep and print it",
      "Ctrl+S saves the garment. Ctrl+P writes the pattern at true size, with allowances and a test square. Ctrl+K "
      "finds "
      "any action by its name.",
      "Print the pattern...", [](AppState& state) { run(state, "file.print"); }}}};

// At the lower left of the window, over the sheet.
void show_tour(AppState& state) {
    if (!state.help.tour_step) return;
    const std::size_t step = std::min(*state.help.tour_step, kTourSteps - 1);
    const TourStep& shown = kTour[step];
    const float unit = ImGui::GetFontSize();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({6 * unit, display.y - 3 * unit}, ImGuiCond_Always, {0, 1});
    ImGui::SetNextWindowSize({std::min(24 * unit, display.x - 7 * unit), 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {unit, 0.8F * unit});
    bool is_open = true;
    const std::string title =
        "First steps: " + std::to_string(step + 1) + " of " + std::to_string(kTourSteps) + "###tour";
    if (ImGui::Begin(
            title.c_str(), &is_open,
            kFlags | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing)) {
        ImGui::PushFont(state.fonts.bold);
        ImGui::TextUnformatted(shown.title);
        ImGui::PopFont();
        ImGui::TextWrapped("%s", shown.text);
        if (button(state, "tour.show", shown.button)) shown.show(state);
        ImGui::SameLine();
        if (step > 0 && button(state, "tour.back", "Back")) state.help.tour_step = step - 1;
        if (step > 0) ImGui::SameLine();
        const bool is_last = step + 1 == kTourSteps;
        if (button(state, "tour.next", is_last ? "End" : "Next")) {
            state.help.tour_step = step + 1;
            if (is_last) is_open = false;
        }
    }
    ImGui::End();
    ImGui::PopStyleVar();
    if (!is_open) state.help.tour_step.reset();
}

bool begin_window(const char* title, bool& is_open, const ImVec2& size) {
    const float unit = ImGui::GetFontSize();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const ImVec2 fitting{std::min(size.x * unit, display.x - 2 * unit), std::min(size.y * unit, display.y - 4 * unit)};
    ImGui::SetNextWindowPos({(display.x - fitting.x) / 2, (display.y - fitting.y) / 2}, ImGuiCond_Appearing);
    ImGui::SetNextWindowSize(fitting, ImGuiCond_Appearing);
    const bool is_drawn = ImGui::Begin(title, &is_open, kFlags);
    const bool has_focus = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
    if (has_focus && is_key_pressed(Key::Escape)) is_open = false;
    return is_drawn;
}

// The keys that are no actions': of the sheet and of the 3D view.
struct FixedKey {
    const char* keys;
    const char* what;
};
constexpr std::array kSheetKeys{
    FixedKey{"F", "frames what is selected, or all"},
    FixedKey{"Tab, Shift+Tab", "selects the next or the last panel; with Edit point the next point"},
    FixedKey{"Arrows", "move what is selected by 1 mm, with Shift by 1 cm"},
    FixedKey{"Alt+arrows", "move the cursor by a step of the grid, with Shift by 1 mm"},
    FixedKey{"Alt+Enter", "clicks where the cursor is"},
    FixedKey{"12, 12 < 30, 5 x -8", "a length; with its angle; across x up: typed while a tool draws or drags"},
    FixedKey{"Shift, Ctrl", "while drawing or dragging: by 45 degrees, without snapping"},
    FixedKey{"Enter, Backspace", "ends what is drawn; takes its last point back"},
    FixedKey{"Escape", "cancels; then unselects; then goes back to Select and move"}};
constexpr std::array kViewKeys{FixedKey{"Right drag", "turns the view"}, FixedKey{"Middle drag, wheel", "pans, zooms"},
                               FixedKey{"Keypad 1, 3, 7", "from the front, the left, above; with Ctrl opposite"},
                               FixedKey{"Keypad 5, 9", "long lens; the opposite view"},
                               FixedKey{"P, Shift+P", "pins what is under the cursor; removes all pins"}};

void key_row(const std::string& keys, const std::string& what) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(keys.c_str());
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", what.c_str());
}

void key_heading(AppState& state, const std::string& title) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushFont(state.fonts.bold);
    ImGui::TextUnformatted(title.c_str());
    ImGui::PopFont();
}

void show_all_keys(AppState& state) {
    if (!state.help.has_keys) return;
    if (begin_window("Keys###keys", state.help.has_keys, {44, 38})) {
        constexpr auto kTable = ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp;
        if (ImGui::BeginTable("##keys", 2, kTable)) {
            ImGui::TableSetupColumn("keys", 0, 0.3F);
            ImGui::TableSetupColumn("what", 0, 0.7F);
            for (const std::string& menu : menu_names()) {
                bool has_heading = false;
                for (const Action& action : state.actions) {
                    if (action.menu != menu || action.chords.empty()) continue;
                    if (!has_heading) key_heading(state, menu);
                    has_heading = true;
                    std::string keys;
                    for (const Chord& chord : action.chords) keys += (keys.empty() ? "" : ", ") + text_of(chord);
                    key_row(keys, action.title);
                }
            }
            key_heading(state, "Sheet");
            for (const FixedKey& key : kSheetKeys) key_row(key.keys, key.what);
            key_heading(state, "3D view");
            for (const FixedKey& key : kViewKeys) key_row(key.keys, key.what);
            ImGui::EndTable();
        }
    }
    ImGui::End();
    note_widget(state.widgets, "help.keys");
}

bool has_words(const ManualChapter& chapter, const std::string& words) {
    std::string all = chapter.title;
    for (const ManualBlock& block : chapter.blocks) {
        for (const std::string& cell : block.cells) all += " " + cell;
    }
    return has_all_words(all, words);
}

void show_table(const std::vector<ManualBlock>& blocks, std::size_t from, std::size_t to) {
    const int columns = static_cast<int>(blocks[from].cells.size());
    const std::string id = "##table" + std::to_string(from);
    if (!ImGui::BeginTable(id.c_str(), columns, ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerH)) return;
    for (std::size_t i = from; i < to; ++i) {
        ImGui::TableNextRow();
        for (const std::string& cell : blocks[i].cells) {
            if (!ImGui::TableNextColumn()) continue;
            ImGui::TextWrapped("%s", cell.c_str());
        }
    }
    ImGui::EndTable();
}

void show_chapter(AppState& state, const ManualChapter& chapter) {
    ImGui::PushFont(state.fonts.large);
    ImGui::TextWrapped("%s", chapter.title.c_str());
    ImGui::PopFont();
    for (std::size_t i = 0; i < chapter.blocks.size(); ++i) {
        const ManualBlock& block = chapter.blocks[i];
        switch (block.kind) {
            case ManualBlock::Kind::Paragraph:
                ImGui::TextWrapped("%s", block.cells.front().c_str());
                ImGui::Spacing();
                break;
            case ManualBlock::Kind::Item:
                ImGui::Bullet();
                ImGui::TextWrapped("%s", block.cells.front().c_str());
                break;
            case ManualBlock::Kind::Code:
                ImGui::TextDisabled("%s", block.cells.front().c_str());
                break;
            case ManualBlock::Kind::Row: {
                std::size_t end = i + 1;
                while (end < chapter.blocks.size() && chapter.blocks[end].kind == ManualBlock::Kind::Row) ++end;
                show_table(chapter.blocks, i, end);
                i = end - 1;
                break;
            }
        }
    }
}

void show_manual(AppState& state) {
    HelpWindows& help = state.help;
    if (!help.has_manual) return;
    if (begin_window("Manual###manual", help.has_manual, {62, 40})) {
        const std::vector<ManualChapter> chapters = chapters_of(state.services.manual);
        const float unit = ImGui::GetFontSize();
        ImGui::BeginChild("##chapters", {16 * unit, 0}, true);
        ImGui::SetNextItemWidth(-1);
        ImGui::InputTextWithHint("##wanted", "Search", &help.wanted);
        note_widget(state.widgets, "manual.search");
        for (std::size_t i = 0; i < chapters.size(); ++i) {
            if (!help.wanted.empty() && !has_words(chapters[i], help.wanted)) continue;
            if (ImGui::Selectable(chapters[i].title.c_str(), help.chapter == i)) help.chapter = i;
            note_widget(state.widgets, "manual." + chapters[i].title);
        }
        ImGui::EndChild();
        ImGui::SameLine();
        ImGui::BeginChild("##text", {0, 0}, false);
        if (help.chapter < chapters.size()) show_chapter(state, chapters[help.chapter]);
        ImGui::EndChild();
    }
    ImGui::End();
}

}  // namespace

void show_help(AppState& state) {
    show_tour(state);
    show_all_keys(state);
    show_manual(state);
}

namespace {

// Without marks of code and emphasis; of a link its text.
std::string plain(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '`' || text[i] == '*') continue;
        if (text[i] == ']' && i + 1 < text.size() && text[i + 1] == '(') {
            i = std::min(text.find(')', i), text.size());
            continue;
        }
        if (text[i] == '[') continue;
        out += text[i];
    }
    return std::string(sim::trimmed(out));
}

std::vector<std::string> cells_of(std::string_view line) {
    std::vector<std::string> cells;
    line.remove_prefix(1);
    while (!line.empty()) {
        const std::size_t end = std::min(line.find('|'), line.size());
        cells.push_back(plain(line.substr(0, end)));
        line.remove_prefix(std::min(end + 1, line.size()));
    }
    if (!cells.empty() && cells.back().empty()) cells.pop_back();
    return cells;
}

bool is_rule(std::string_view line) {
    return line.find_first_not_of("|-: ") == std::string_view::npos;
}

}  // namespace

std::vector<ManualChapter> chapters_of(const std::string& markdown) {
    std::vector<ManualChapter> chapters;
    bool is_code = false, continues = false;
    std::istringstream lines(markdown);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```")) {
            is_code = !is_code;
            continues = false;
            continue;
        }
        if (!is_code && line.starts_with("#")) {
            chapters.push_back({.title = plain(line.substr(line.find_first_not_of('#')))});
            continues = false;
            continue;
        }
        if (chapters.empty()) continue;
        std::vector<ManualBlock>& blocks = chapters.back().blocks;
        using Kind = ManualBlock::Kind;
        if (is_code) {
            blocks.push_back({Kind::Code, {line}});
        } else if (sim::trimmed(line).empty()) {
            continues = false;
        } else if (line.starts_with("|")) {
            std::vector<std::string> cells = cells_of(line);
            if (!is_rule(line) && !cells.empty()) blocks.push_back({Kind::Row, std::move(cells)});
            continues = false;
        } else if (line.starts_with("- ")) {
            blocks.push_back({Kind::Item, {plain(line.substr(2))}});
            continues = true;
        } else if (continues && !blocks.empty()) {
            blocks.back().cells.front() += " " + plain(line);
        } else {
            blocks.push_back({Kind::Paragraph, {plain(line)}});
            continues = true;
        }
    }
    return chapters;
}

}  // namespace selvedge::editor
