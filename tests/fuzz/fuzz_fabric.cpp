// A libFuzzer target. The input is a fabric file (patterns/FORMAT.md). The fuzzer stops at a sanitizer error, an
// exception other than InputError, a property out of its range, and a fabric that changes when it is written.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "sim/core/error.h"
#include "sim/pattern/fabric_file.h"

namespace selvedge::sim {
namespace {

void run(std::string_view text) {
    Fabric fabric;
    try {
        fabric = parse_fabric(text, "input.json");
    } catch (const InputError&) {
        return;
    }
    for (const FabricKey& key : fabric_keys()) {
        const double value = fabric.*key.value;
        if (!(value >= key.least && value <= key.most)) std::abort();
    }
    if (parse_fabric(write_fabric(fabric, "input.json", text), "input.json") != fabric) std::abort();
}

}  // namespace
}  // namespace selvedge::sim

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    selvedge::sim::run({reinterpret_cast<const char*>(data), size});
    return 0;
}
