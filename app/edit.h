#pragma once
// Plays a script in the editor without a window, with the same pictures.
#include <filesystem>
#include <optional>
#include <string>

#include "render/image/image.h"

namespace selvedge::app {

struct EditorScript {
    std::string file{};                            // garment to open at the start; empty: none
    std::string text{};                            // the steps (editor/ui/script.h); empty: none
    std::string name{};                            // of the script, in error messages
    std::optional<std::filesystem::path> state{};  // folder for journals; none: nothing is kept
    int width_px = 1280;
    int height_px = 800;
    float scale = 1;  // of letters and buttons
};

// Returns what is seen at the end. Throws InputError for an invalid file or script, or at the first step that fails.
render::Image play_script(const EditorScript& script);

}  // namespace selvedge::app
