// A libFuzzer target. The input is a .gltf or .glb file, as far as our own code reads it: the checks before assimp, and
// the data of a garment's panels after it. The fuzzer stops at a sanitizer error and an exception other than
// InputError.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "sim/core/error.h"
#include "sim/exchange/mesh_file.h"
#include "sim/repair/gltf_skins.h"
#include "sim/repair/plain_gltf.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try {
        selvedge::sim::check_gltf_skins("input.glb", bytes);
    } catch (const selvedge::sim::InputError&) {
    }
    try {
        selvedge::sim::plain_gltf("input.glb", bytes);
    } catch (const selvedge::sim::InputError&) {
    }
    try {
        selvedge::sim::mesh_format_of("input.glb").panel_data(bytes, "input.glb");
    } catch (const selvedge::sim::InputError&) {
    }
    return 0;
}
