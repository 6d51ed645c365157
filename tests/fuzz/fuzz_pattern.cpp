// A libFuzzer target. The input is a garment specification (patterns/FORMAT.md). What is read is written and read
// again, and its panels are meshed coarsely. The fuzzer stops at a sanitizer error, an exception other than InputError,
// a number that is not finite, a pattern that changes when it is written, and a file that is refused without a fault.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "sim/core/error.h"
#include "sim/mesh/sew.h"
#include "sim/pattern/fault.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::sim {
namespace {

void mesh(const Pattern& pattern) {
    constexpr std::size_t kMostPanels = 8, kMostEdges = 64;
    if (pattern.panels.size() > kMostPanels) return;
    for (const Panel& panel : pattern.panels) {
        if (panel.edges.size() > kMostEdges) return;
    }
    const GarmentMesh garment = assemble(pattern, {.target_edge = 0.5, .chord_error = 0.1, .max_triangles = 500});
    for (const Vec3d& x : garment.x) {
        if (!x.allFinite()) std::abort();
    }
}

void run(std::string_view text) {
    const bool is_sound = !has_error(check_pattern_text(text, "input"));
    try {
        const PatternDocument document = parse_pattern(text, "input");
        if (!is_sound) std::abort();
        const std::string written = write_pattern(document, "input");
        if (write_pattern(parse_pattern(written, "input"), "input") != written) std::abort();
        try {
            mesh(document.pattern);
        } catch (const InputError&) {
        }
    } catch (const InputError&) {
        if (is_sound) std::abort();
    }
}

}  // namespace
}  // namespace selvedge::sim

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    selvedge::sim::run({reinterpret_cast<const char*>(data), size});
    return 0;
}
