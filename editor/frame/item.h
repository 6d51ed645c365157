#pragma once
// What every part of the interface does with an item of ImGui: record its position for scripts and tests, show its
// tooltip, shorten its text.
#include <functional>
#include <string>
#include <string_view>

#include "editor/frame/frame.h"

namespace selvedge::editor {

// Records the position of the last item under this name.
void note_widget(WidgetMap& widgets, const std::string& name);

// Tooltip of the last item, also if the item is disabled. `width`: of its lines, font heights.
void show_tip(const std::string& text, float width = 22);

// An area of this size in px that is pressed as a button is, by any mouse button; with ByLaterItems, those that lie
// over it are pressed instead.
enum class Cover { Never, ByLaterItems };
void press_area(const char* id, const Vec2f& size_px, Cover cover);

// An area of this size in px that the mouse drags. Tab passes over it.
void drag_area(const char* id, const Vec2f& size_px);

// Text that does not fit: an ellipsis replaces a part of it.

// The part that is omitted: the end of a sentence, or the middle of a text with a file path.
enum class Elide { Middle, End };

// The longest elided text that is at most `width` px wide, as measured by `width_of`; the text itself if it fits. Never
// cuts a UTF-8 character.
std::string elided(std::string_view text, float width, Elide what,
                   const std::function<float(std::string_view)>& width_of);

// Measured with the current font.
std::string elided(std::string_view text, float width, Elide what = Elide::End);

}  // namespace selvedge::editor
