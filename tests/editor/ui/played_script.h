#pragma once
// A script of the editor, played on an editor of a test in a window of 1280 x 800 pixels.
#include <string>
#include <vector>

#include "editor/ui/editor.h"
#include "editor/ui/script.h"

namespace selvedge::editor {

// name: of the script, in messages.
inline void play_script(Editor& editor, const std::string& script, const std::string& name) {
    const auto step = [&](const std::vector<InputEvent>& events) {
        editor.frame(events, {.width_px = 1280, .height_px = 800}, 1.0 / 30);
    };
    ScriptPlayer(editor, {.step = step, .screenshot = {}, .say = {}}, name).play(parse_script(script, name));
}

}  // namespace selvedge::editor
