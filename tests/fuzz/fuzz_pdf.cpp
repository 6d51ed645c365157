// A libFuzzer target. The input is what the child process that reads PDF sends back, which a malformed file may have
// corrupted: poppler itself is not tried, it may fail in its process. Pages are put together and become panels. The
// fuzzer stops at a sanitizer error, an exception other than InputError, an answer that changes when it is written, and
// a number that is not finite.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "sim/core/error.h"
#include "sim/paper/make_panels.h"
#include "sim/paper/pdf_drawing.h"

namespace selvedge::sim {
namespace {

void run(std::string_view bytes) {
    const std::optional<PdfAnswer> answer = pdf_answer_of(bytes);
    if (!answer) return;
    if (bytes_of_pdf_answer(*answer) != bytes) std::abort();
    try {
        const PanelsOfDrawing made = make_panels(drawing_of_pdf(answer->file, "input.pdf"), "input.pdf");
        for (const Panel& panel : made.pattern.panels) {
            for (const Vec2d& v : panel.vertices) {
                if (!v.allFinite()) std::abort();
            }
        }
    } catch (const InputError&) {
    }
}

}  // namespace
}  // namespace selvedge::sim

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    selvedge::sim::run({reinterpret_cast<const char*>(data), size});
    return 0;
}
