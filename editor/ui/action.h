#pragma once
// An action: a command of the editor with its menu entry and keys. The table of all actions serves menus, keys, scripts
// and the action finder (Ctrl+K), which is declared here too.
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/frame/frame.h"

namespace selvedge::editor {

struct AppState;

struct Chord {
    Key key = Key::None;
    Modifiers modifiers{};

    bool operator==(const Chord&) const = default;
};

struct Action {
    std::string id{};     // used by scripts: "file.save"
    std::string menu{};   // for example "File"
    std::string title{};  // for example "Save"
    std::string tip{};    // one sentence; empty: the title is enough
    std::string needs{};  // what must be there for it: "a selected seam"; shown where `can` says no
    std::vector<Chord> chords{};
    bool begins_group = false;  // separator above it in the menu
    std::function<void(AppState&)> run{};
    std::function<bool(const AppState&)> can{};    // unset: always enabled
    std::function<bool(const AppState&)> is_on{};  // unset: not a toggle
};

// Its tip, with what it needs if that is not there.
std::string tip_for(const Action& action, const AppState& state);

// For example "Ctrl+Shift+S"; empty: no key.
std::string text_of(const Chord& chord);
std::string chord_text(const Action& action);

// Returns nullptr if there is no such action.
const Action* find_action(const std::vector<Action>& actions, std::string_view id);

// Parses "ctrl+shift+s", "space", "f1". Returns none if it is not a key.
std::optional<Chord> parse_chord(std::string_view text);

// The actions whose title or menu contains the letters of `wanted` in order, best match first; then those that have all
// its words, also in the tip. Runs of letters and starts of words score higher.
std::vector<const Action*> search(const std::vector<Action>& actions, std::string_view wanted);

// Finds and runs an action by some of its letters (Ctrl+K).

class ActionFinder {
 public:
    void open();
    bool is_open() const { return is_open_; }
    void show(AppState& state);

 private:
    bool is_open_ = false;
    bool takes_focus_ = false;
    std::string wanted_;
    int chosen_ = 0;
};

}  // namespace selvedge::editor
