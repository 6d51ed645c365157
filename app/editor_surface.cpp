#include "app/editor_surface.h"

#include "app/find_font.h"
#include "sim/core/file.h"

namespace selvedge {

FrameOutput EditorSurface::frame(const FrameInput& input) {
    const FrameSize size{.width_px = input.width_px, .height_px = input.height_px, .scale = input.scale};
    return editor_.frame(input.events, size, input.seconds);
}

FontBytes read_fonts() {
    constexpr std::size_t kLargestFont = 64U << 20U;
    const FontFiles files = find_fonts();
    const auto read = [](const std::filesystem::path& path) {
        return path.empty() ? std::string() : read_file(path, kLargestFont);
    };
    return {.regular = read(files.regular), .bold = read(files.medium)};
}

}  // namespace selvedge
