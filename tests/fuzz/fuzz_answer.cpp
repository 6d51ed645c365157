// A libFuzzer target. The input is what the child process that reads bodies sends back, which a malformed file may have
// corrupted. The fuzzer stops at a sanitizer error, an exception other than InputError, an answer that changes when it
// is written, and a body that is not finite.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "sim/core/error.h"
#include "sim/repair/guarded_import.h"
#include "sim/repair/load_body.h"

namespace selvedge::sim {
namespace {

void run(std::string_view bytes) {
    std::optional<ImportAnswer> answer = from_bytes(bytes);
    if (!answer) return;
    if (to_bytes(*answer) != bytes) std::abort();
    try {
        const BodyClips moving = body_of(scene_of(std::move(*answer), "input.glb", ImportKind::Surface), "input.glb");
        for (const Vec3d& x : moving.body.x) {
            if (!x.allFinite()) std::abort();
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
