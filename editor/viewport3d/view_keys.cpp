#include "editor/viewport3d/view_keys.h"

#include <algorithm>
#include <array>

namespace selvedge::editor {
namespace {

constexpr Modifiers kPlain{}, kCtrl{.ctrl = true}, kShift{.shift = true};

constexpr Key keypad(int digit) {
    return static_cast<Key>(static_cast<int>(Key::Keypad0) + digit);
}

constexpr std::array kSelvedge{ViewKey{keypad(1), kPlain, ViewCommand::Front},
                               ViewKey{keypad(1), kCtrl, ViewCommand::Back},
                               ViewKey{keypad(3), kPlain, ViewCommand::Left},
                               ViewKey{keypad(3), kCtrl, ViewCommand::Right},
                               ViewKey{keypad(7), kPlain, ViewCommand::Top},
                               ViewKey{keypad(7), kCtrl, ViewCommand::Bottom},
                               ViewKey{keypad(9), kPlain, ViewCommand::Opposite},
                               ViewKey{keypad(5), kPlain, ViewCommand::Lens},
                               ViewKey{Key::Home, kPlain, ViewCommand::FrameAll},
                               ViewKey{Key::KeypadDecimal, kPlain, ViewCommand::FrameSelected},
                               ViewKey{key_of('F'), kPlain, ViewCommand::FrameSelected},
                               ViewKey{key_of('P'), kPlain, ViewCommand::Pin},
                               ViewKey{key_of('P'), kShift, ViewCommand::UnpinAll}};

constexpr std::array kMarvelousDesigner{ViewKey{key_of('2'), kPlain, ViewCommand::Front},
                                        ViewKey{key_of('8'), kPlain, ViewCommand::Back},
                                        ViewKey{key_of('4'), kPlain, ViewCommand::Left},
                                        ViewKey{key_of('6'), kPlain, ViewCommand::Right},
                                        ViewKey{key_of('5'), kPlain, ViewCommand::Top},
                                        ViewKey{key_of('0'), kPlain, ViewCommand::Bottom},
                                        ViewKey{keypad(2), kPlain, ViewCommand::Front},
                                        ViewKey{keypad(8), kPlain, ViewCommand::Back},
                                        ViewKey{keypad(4), kPlain, ViewCommand::Left},
                                        ViewKey{keypad(6), kPlain, ViewCommand::Right},
                                        ViewKey{keypad(5), kPlain, ViewCommand::Top},
                                        ViewKey{keypad(0), kPlain, ViewCommand::Bottom},
                                        ViewKey{keypad(9), kPlain, ViewCommand::Opposite},
                                        ViewKey{keypad(7), kPlain, ViewCommand::Lens},
                                        ViewKey{Key::Home, kPlain, ViewCommand::FrameAll},
                                        ViewKey{Key::KeypadDecimal, kPlain, ViewCommand::FrameSelected},
                                        ViewKey{key_of('F'), kPlain, ViewCommand::FrameSelected},
                                        ViewKey{key_of('W'), kPlain, ViewCommand::Pin},
                                        ViewKey{key_of('W'), kCtrl, ViewCommand::UnpinAll}};

}  // namespace

std::span<const ViewKey> view_keys(KeyMap map) {
    return map == KeyMap::Selvedge ? std::span<const ViewKey>(kSelvedge) : std::span<const ViewKey>(kMarvelousDesigner);
}

std::optional<ViewCommand> view_command(KeyMap map, Key key, const Modifiers& modifiers) {
    const std::span<const ViewKey> keys = view_keys(map);
    const auto found = std::ranges::find_if(
        keys, [&](const ViewKey& known) { return known.key == key && known.modifiers == modifiers; });
    return found == keys.end() ? std::nullopt : std::optional(found->command);
}

}  // namespace selvedge::editor
