// A libFuzzer target. The input is a script of the editor. Its commands are done to a document; pointer, keys and
// windows are left out. The fuzzer stops at a sanitizer error, an exception of another kind than a script may meet, and
// a command that changes when it is written.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "editor/document/command.h"
#include "editor/document/document.h"
#include "editor/document/script_steps.h"
#include "editor/geometry/draft.h"
#include "sim/core/error.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::editor {
namespace {

constexpr const char* kSquares =
    R"({"pattern": {"panels": {
        "front": {"vertices": [[0, 0], [40, 0], [40, 50], [0, 50]], "edges": [{"endpoints": [0, 1]},
            {"endpoints": [1, 2], "curvature": [0.5, 0.1]}, {"endpoints": [2, 3]}, {"endpoints": [3, 0]}]},
        "back": {"vertices": [[0, 0], [40, 0], [40, 50], [0, 50]], "translation": [0, 0, -30], "edges": [
            {"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, 0]}]}},
        "stitches": [[{"panel": "front", "edge": 1}, {"panel": "back", "edge": 1}]]}})";

void run(std::string_view text) {
    constexpr std::size_t kMostSteps = 40;
    std::size_t count = 0;
    try {
        const std::vector<ScriptStep> steps = parse_script(text, "input");
        Document document(sim::parse_pattern(kSquares, "squares"));
        for (const ScriptStep& step : steps) {
            if (step.verb != "do" || ++count > kMostSteps) continue;
            const sim::Json json = sim::parse_json(step.rest, "input");
            const Command command = parse_command(sim::JsonView(json, "input"));
            const sim::Json written = to_json(command);
            if (write_json(to_json(parse_command(sim::JsonView(written, "written")))) != write_json(written))
                std::abort();
            try {
                document.run(command);
            } catch (const sim::InputError&) {
            } catch (const GeometryError&) {
            }
        }
        sim::parse_pattern(document.text("squares"), "squares");
    } catch (const sim::InputError& error) {
        if (error.file() == "written" || error.file() == "squares") std::abort();
    }
}

}  // namespace
}  // namespace selvedge::editor

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    selvedge::editor::run({reinterpret_cast<const char*>(data), size});
    return 0;
}
