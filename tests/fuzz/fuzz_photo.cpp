// A libFuzzer target. The input is a PNG or JPEG picture. The fuzzer stops at a sanitizer error, an exception other
// than InputError, and a size of a pixel that is not a length.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "render/image/photo.h"
#include "sim/core/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const std::string_view bytes(reinterpret_cast<const char*>(data), size);
        const selvedge::render::Photo photo = selvedge::render::decode_photo(bytes, "input");
        if (photo.pixel_size && !(std::isfinite(*photo.pixel_size) && *photo.pixel_size > 0)) std::abort();
    } catch (const selvedge::sim::InputError&) {
    }
    return 0;
}
