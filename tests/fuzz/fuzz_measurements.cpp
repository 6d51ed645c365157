// A libFuzzer target. The input is a file of body measurements: YAML, JSON or XML. The fuzzer stops at a sanitizer
// error, an exception other than InputError, and a length that is not finite.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "sim/core/error.h"
#include "sim/paper/measurement_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const std::string_view text(reinterpret_cast<const char*>(data), size);
        for (const auto& one : selvedge::sim::parse_measurements(text, "input").lengths) {
            if (!std::isfinite(one.value) || one.value < 0) std::abort();
        }
    } catch (const selvedge::sim::InputError&) {
    }
    return 0;
}
