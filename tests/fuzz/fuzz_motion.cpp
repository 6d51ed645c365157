// A libFuzzer target. The input is a motion of ours (JSON), or a BVH file as far as it is checked before assimp reads
// it. The fuzzer stops at a sanitizer error, an exception other than InputError, and a key that is not finite.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "sim/core/error.h"
#include "sim/motion/motion_file.h"
#include "sim/repair/bvh_text.h"
#include "sim/repair/guarded_import.h"

namespace selvedge::sim {
namespace {

void run(std::string_view text) {
    if (!text.starts_with('{')) return check_bvh(text, "input", {});
    for (const Clip& clip : parse_motion(text, "input").clips) {
        for (const Track& track : clip.tracks) {
            for (const Eigen::Quaterniond& rotation : track.rotation.values) {
                if (!rotation.coeffs().allFinite()) std::abort();
            }
        }
    }
}

}  // namespace
}  // namespace selvedge::sim

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        selvedge::sim::run({reinterpret_cast<const char*>(data), size});
    } catch (const selvedge::sim::InputError&) {
    }
    return 0;
}
