#pragma once
// Everything that can be done besides drawing: one table for menus, keys, the palette and scripts.
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
    std::string id{};     // for scripts: "file.save"
    std::string menu{};   // "File"
    std::string title{};  // "Save"
    std::string tip{};    // a sentence; empty: the title says it
    std::vector<Chord> chords{};
    bool begins_group = false;  // a line above it in its menu
    std::function<void(AppState&)> run{};
    std::function<bool(const AppState&)> can{};    // unset: always
    std::function<bool(const AppState&)> is_on{};  // unset: no switch
};

// "Ctrl+Shift+S"; empty: no key.
std::string text_of(const Chord& chord);
std::string chord_text(const Action& action);

// nullptr: there is none.
const Action* find_action(const std::vector<Action>& actions, std::string_view id);

// "ctrl+shift+s", "space", "f1". None: it is no key.
std::optional<Chord> parse_chord(std::string_view text);

// Those whose title or menu has the letters of `wanted` in that order, the best first: whole words before parts.
std::vector<const Action*> search(const std::vector<Action>& actions, std::string_view wanted);

// Finding an action by typing some of its letters (Ctrl+K).

struct AppState;

class ActionFinder {
 public:
    void open();
    bool is_open() const { return is_open_; }
    void show(AppState& desk);

 private:
    bool is_open_ = false;
    bool takes_focus_ = false;
    std::string wanted_;
    int chosen_ = 0;
};

}  // namespace selvedge::editor
