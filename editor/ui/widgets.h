#pragma once
// Small controls that several parts of the interface share, icons, and the timing of status messages. Named controls
// record their position for scripts and tests.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "editor/frame/frame.h"
#include "editor/workspace/workspace.h"
#include "sim/core/math.h"
#include "sim/tartan/sett.h"

struct ImDrawList;

namespace selvedge::editor {

struct Action;
struct AppState;

constexpr float kTipWidth = 24;  // font heights, of tooltips outside the inspectors

bool button(AppState& state, const std::string& name, const std::string& label);

// A square button with the action's icon; drawn pressed while the action is on.
void icon_button(AppState& state, const Action& action, const std::string& icon, float side_px);

// One action in a list: its title, menu and key.
bool action_row(AppState& state, const Action& action, bool is_chosen);

std::uint32_t colour_of(const sim::Rgb8& rgb, int alpha = 255);  // as ImGui packs it

void coloured_text(const sim::Rgb8& colour, const std::string& text);

// Shows the whole text as a tooltip of the last item if `shown` is not all of it.
void tip_of_whole(const std::string& text, const std::string& shown);

// Button icons: line drawings in a 16 x 16 square, drawn at any size, so that they are sharp at every scale.

// `name`: a tool's or an action's id. Draws nothing if it has no icon.
void draw_icon(ImDrawList& list, std::string_view name, const Vec2f& low, float side_px, const sim::Rgb8& colour);

// How long a message stays in the status line: notes 6 s, warnings 12 s, errors until the next action.

class MessageClock {
 public:
    // Call once per frame; `seconds` since the last one. Dismisses the message when its time is over.
    void update(Messages& messages, double seconds);

 private:
    std::size_t count_ = 0;  // number of the message that is being timed
    double shown_for_ = 0;   // s
};

}  // namespace selvedge::editor
