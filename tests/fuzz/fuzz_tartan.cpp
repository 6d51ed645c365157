// A libFuzzer target. The input is a tartan file, or a name or a threadcount. The fuzzer stops at a sanitizer error and
// at an exception other than InputError.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "sim/core/error.h"
#include "sim/tartan/tartan_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        if (text.starts_with('{')) {
            selvedge::sim::parse_tartan(text, "input");
        } else {
            selvedge::sim::find_tartan(std::string(text));
        }
    } catch (const selvedge::sim::InputError&) {
    }
    return 0;
}
