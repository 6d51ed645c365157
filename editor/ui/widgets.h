#pragma once
// Small controls that several parts of the interface share. Those that have a name note where they stand.
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "editor/frame/frame.h"
#include "editor/workspace/workspace.h"
#include "sim/core/math.h"
#include "sim/tartan/sett.h"

namespace selvedge::editor {

struct Action;
struct AppState;

// Notes where the last item stands.
void note_widget(WidgetMap& widgets, const std::string& name);

// A tooltip for the last item.
void tip(const std::string& words);

bool button(AppState& desk, const std::string& name, const std::string& label);

// A square with the action's picture; pressed in while it is on.
void icon_button(AppState& desk, const Action& action, const std::string& icon, float side_px);

// One action in a list: its title, its menu, its key.
bool action_row(AppState& desk, const Action& action, bool is_chosen);

void coloured_text(const sim::Rgb8& colour, const std::string& words);

// Text that is longer than its place: a part of it makes room for three dots.

// What is left out. Of a sentence its end; of one with a file's path in it, the middle.
enum class Elide { Middle, End };

// The longest that is at most `width` px wide, by `width_of`; the text itself where it fits. Letters stay whole
// (UTF-8).
std::string elided(std::string_view text, float width, Elide what,
                   const std::function<float(std::string_view)>& width_of);

// With the present font.
std::string elided(std::string_view text, float width, Elide what);

// A tip with the whole text over the last item, where `shown` is not all of it.
void tip_of_whole(const std::string& text, const std::string& shown);

}  // namespace selvedge::editor

// The pictures on buttons: lines in a square of 16 by 16, drawn at any size, so that they are sharp at every scale.

struct ImDrawList;

namespace selvedge::editor {

// By a tool's id or an action's; nothing is drawn for a name that has none.
void draw_icon(ImDrawList& list, std::string_view name, const Vec2f& low, float side_px, const sim::Rgb8& colour);

bool has_icon(std::string_view name);

// How long words stay in the status line: notes a while, warnings twice as long, errors until something else is done.

class MessageClock {
 public:
    // Once per frame; `seconds` since the last one. Takes the message away when its time is over.
    void follow(Messages& messages, double seconds);

 private:
    std::size_t count_ = 0;  // of the message whose time runs
    double shown_for_ = 0;   // s
};

}  // namespace selvedge::editor
