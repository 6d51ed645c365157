#include "editor/ui/action.h"

#include <imgui.h>
#include <imgui_stdlib.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <utility>

#include "editor/frame/keyboard.h"
#include "editor/ui/actions.h"
#include "editor/ui/app_state.h"
#include "editor/ui/widgets.h"

namespace selvedge::editor {
namespace {

constexpr std::array<std::pair<Key, std::string_view>, 20> kKeyNames{{{Key::Space, "Space"},
                                                                      {Key::Escape, "Esc"},
                                                                      {Key::Enter, "Enter"},
                                                                      {Key::Tab, "Tab"},
                                                                      {Key::Backspace, "Backspace"},
                                                                      {Key::Insert, "Insert"},
                                                                      {Key::Delete, "Del"},
                                                                      {Key::Right, "Right"},
                                                                      {Key::Left, "Left"},
                                                                      {Key::Down, "Down"},
                                                                      {Key::Up, "Up"},
                                                                      {Key::PageUp, "PageUp"},
                                                                      {Key::PageDown, "PageDown"},
                                                                      {Key::Home, "Home"},
                                                                      {Key::End, "End"},
                                                                      {Key::KeypadDecimal, "Num."},
                                                                      {Key::KeypadAdd, "Num+"},
                                                                      {Key::KeypadSubtract, "Num-"},
                                                                      {Key::KeypadMultiply, "Num*"},
                                                                      {Key::KeypadEnter, "NumEnter"}}};

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

std::string key_text(Key key) {
    for (const auto& [known, name] : kKeyNames) {
        if (known == key) return std::string(name);
    }
    const int code = static_cast<int>(key);
    if (key >= Key::F1 && key <= Key::F12) return "F" + std::to_string(code - static_cast<int>(Key::F1) + 1);
    if (key >= Key::Keypad0 && key <= Key::Keypad9) {
        return "Num" + std::to_string(code - static_cast<int>(Key::Keypad0));
    }
    return std::string(1, static_cast<char>(code));
}

Key parse_key(const std::string& name) {
    if (name.size() == 1) return key_of(static_cast<char>(std::toupper(static_cast<unsigned char>(name[0]))));
    for (const auto& [key, known] : kKeyNames) {
        if (lower(known) == name) return key;
    }
    if (name == "escape") return Key::Escape;
    if (name == "return") return Key::Enter;
    if (name == "delete") return Key::Delete;
    for (int i = static_cast<int>(Key::F1); i <= static_cast<int>(Key::KeypadEnter); ++i) {
        if (lower(key_text(static_cast<Key>(i))) == name) return static_cast<Key>(i);
    }
    return Key::None;
}

// The match score, larger is better; none: a letter is missing. Favours runs of letters and starts of words.
std::optional<int> score(const std::string& text, const std::string& wanted) {
    int total = 0, run = 0;
    std::size_t at = 0;
    for (const char c : wanted) {
        const std::size_t found = text.find(c, at);
        if (found == std::string::npos) return std::nullopt;
        const bool begins_word = found == 0 || text[found - 1] == ' ';
        run = found == at && at > 0 ? run + 1 : 0;
        total += 1 + 3 * run + (begins_word ? 4 : 0) - static_cast<int>(std::min<std::size_t>(found - at, 5));
        at = found + 1;
    }
    return total;
}

// Whether all words are in what is written of an action, also in its tip.
bool has_words(const Action& action, const std::string& words) {
    const std::string all = lower(action.menu + " " + action.title + " " + action.tip);
    std::istringstream rest(words);
    int count = 0;
    for (std::string word; rest >> word; ++count) {
        if (all.find(word) == std::string::npos) return false;
    }
    return count > 0;
}

}  // namespace

std::string text_of(const Chord& chord) {
    if (chord.key == Key::None) return "";
    return std::string(chord.modifiers.ctrl ? "Ctrl+" : "") + (chord.modifiers.shift ? "Shift+" : "") +
           (chord.modifiers.alt ? "Alt+" : "") + key_text(chord.key);
}

std::string tip_for(const Action& action, const AppState& state) {
    if (action.needs.empty() || !action.can || action.can(state)) return action.tip;
    return action.tip + (action.tip.empty() ? "" : "\n") + "It needs " + action.needs;
}

std::string chord_text(const Action& action) {
    return action.chords.empty() ? "" : text_of(action.chords.front());
}

const Action* find_action(const std::vector<Action>& actions, std::string_view id) {
    const auto found =
        std::find_if(actions.begin(), actions.end(), [&](const Action& action) { return action.id == id; });
    return found == actions.end() ? nullptr : &*found;
}

std::optional<Chord> parse_chord(std::string_view text) {
    Chord chord;
    std::string rest = lower(text);
    const auto take = [&](const char* prefix, bool& is_held) {
        if (!rest.starts_with(prefix)) return false;
        rest.erase(0, std::string_view(prefix).size());
        is_held = true;
        return true;
    };
    while (take("ctrl+", chord.modifiers.ctrl) || take("shift+", chord.modifiers.shift) ||
           take("alt+", chord.modifiers.alt)) {
    }
    chord.key = parse_key(rest);
    return chord.key == Key::None ? std::nullopt : std::optional(chord);
}

std::vector<const Action*> search(const std::vector<Action>& actions, std::string_view wanted) {
    std::vector<std::pair<int, const Action*>> found;
    const std::string letters = lower(wanted);
    for (const Action& action : actions) {
        const auto in_title = score(lower(action.title), letters);
        const auto in_both = score(lower(action.menu + " " + action.title), letters);
        constexpr int kLast = -100;
        if (in_title || in_both || has_words(action, letters))
            found.emplace_back(std::max(in_title.value_or(kLast) + 2, in_both.value_or(kLast)), &action);
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<const Action*> sorted;
    sorted.reserve(found.size());
    for (const auto& [points, action] : found) sorted.push_back(action);
    return sorted;
}

namespace {

constexpr std::size_t kMostFound = 12;

}  // namespace

void ActionFinder::open() {
    is_open_ = true;
    takes_focus_ = true;
    wanted_.clear();
    chosen_ = 0;
}

void ActionFinder::show(AppState& state) {
    if (!is_open_) return;
    const float unit = ImGui::GetFontSize();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float width = std::min(34 * unit, display.x - 2 * unit);
    ImGui::SetNextWindowPos({(display.x - width) / 2, 5 * unit});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::SetNextWindowFocus();
    constexpr auto kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                            ImGuiWindowFlags_NoSavedSettings;
    ImGui::Begin("##find", nullptr, kFlags);
    if (takes_focus_) ImGui::SetKeyboardFocusHere();
    takes_focus_ = false;
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputTextWithHint("##wanted", "What do you want to do?", &wanted_)) chosen_ = 0;
    std::vector<const Action*> found = search(state.actions, wanted_);
    if (found.size() > kMostFound) found.resize(kMostFound);
    const int count = static_cast<int>(found.size());
    if (is_key_repeated(Key::Down)) ++chosen_;
    if (is_key_repeated(Key::Up)) --chosen_;
    chosen_ = count == 0 ? 0 : (chosen_ + count) % count;
    const Action* wants = nullptr;
    for (int i = 0; i < count; ++i) {
        const Action& action = *found[static_cast<std::size_t>(i)];
        if (action_row(state, action, i == chosen_)) wants = &action;
    }
    if (count == 0) ImGui::TextDisabled("No action has this name.");
    const bool is_confirmed = is_key_repeated(Key::Enter) || is_key_repeated(Key::KeypadEnter);
    if (is_confirmed && count > 0) wants = found[static_cast<std::size_t>(chosen_)];
    if (is_key_repeated(Key::Escape) || wants != nullptr) is_open_ = false;
    ImGui::End();
    if (wants != nullptr && !run_action(state, *wants)) {
        state.workspace.messages.warn("'" + wants->title + "' cannot be done now");
    }
}

}  // namespace selvedge::editor
