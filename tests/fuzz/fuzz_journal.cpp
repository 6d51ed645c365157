// A libFuzzer target. The input is the journal of a document, as a crash may leave it. The fuzzer stops at a sanitizer
// error, an exception, and a recovered garment that cannot be opened.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "editor/document/journal.h"
#include "sim/pattern/pattern_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto recovery = selvedge::editor::recover({reinterpret_cast<const char*>(data), size});
    if (recovery) selvedge::sim::parse_pattern(recovery->text, "recovered");
    return 0;
}
