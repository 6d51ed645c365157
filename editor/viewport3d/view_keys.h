#pragma once
// The keys of the 3D view, for each key map.
#include <optional>
#include <span>

#include "editor/frame/frame.h"

namespace selvedge::editor {

enum class ViewCommand {
    Front,
    Back,
    Left,
    Right,
    Top,
    Bottom,
    Opposite,
    Lens,  // switches the long one on and off
    FrameAll,
    FrameSelected,
    Pin,
    UnpinAll
};

struct ViewKey {
    Key key = Key::None;
    Modifiers modifiers{};
    ViewCommand command = ViewCommand::Front;
};

std::span<const ViewKey> view_keys(KeyMap map);

// None: the 3D view has no such key.
std::optional<ViewCommand> view_command(KeyMap map, Key key, const Modifiers& modifiers);

}  // namespace selvedge::editor
