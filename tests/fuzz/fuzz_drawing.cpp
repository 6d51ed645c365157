// A libFuzzer target. The input is a drawing of another program: SVG, DXF or FreeSewing's data. What is read becomes
// panels, and these are written and read again if they have few vertices, for that takes most of the time. The fuzzer
// stops at a sanitizer error, an exception other than InputError, and a number that is not finite.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "sim/core/error.h"
#include "sim/paper/drawing_file.h"
#include "sim/paper/make_panels.h"
#include "sim/print/dxf_file.h"

namespace selvedge::sim {
namespace {

void run(std::string_view text) {
    constexpr std::size_t kMostWritten = 100;  // vertices
    try {
        const PanelsOfDrawing made = make_panels(parse_drawing(text, "input"), "input");
        std::size_t vertices = 0;
        for (const Panel& panel : made.pattern.panels) {
            vertices += panel.vertices.size();
            for (const Vec2d& v : panel.vertices) {
                if (!v.allFinite()) std::abort();
            }
        }
        if (vertices <= kMostWritten) parse_drawing(dxf_of(made.pattern), "written");
    } catch (const InputError&) {
    }
}

}  // namespace
}  // namespace selvedge::sim

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    selvedge::sim::run({reinterpret_cast<const char*>(data), size});
    return 0;
}
