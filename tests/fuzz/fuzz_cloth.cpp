// A libFuzzer target. The input bytes choose what happens to a small cloth: fabric, levels, criteria, pins, steps and
// the body. The fuzzer stops at a fault that RandomRun detects, a failed assertion or a sanitizer error.
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <span>

#include "tests/sim/cloth/random_run.h"

namespace selvedge::test {
namespace {

// Uses one byte per choice; returns 0 when there are no bytes left.
class ByteChoices final : public sim::test::Choices {
 public:
    explicit ByteChoices(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    std::uint32_t next(std::uint32_t below) override {
        if (is_empty()) return 0;
        const std::uint32_t value = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return value % below;
    }
    bool is_empty() const { return bytes_.empty(); }

 private:
    std::span<const std::uint8_t> bytes_;
};

void run(std::span<const std::uint8_t> bytes) {
    constexpr int kMaxActs = 40;
    ByteChoices choices(bytes);
    sim::test::RandomRun cloth(choices);
    for (int i = 0; i < kMaxActs && !choices.is_empty(); ++i) {
        const auto fault = cloth.act();
        if (!fault) continue;
        std::fprintf(stderr, "act %d: %s\n", i, fault->c_str());
        std::abort();
    }
}

}  // namespace
}  // namespace selvedge::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    selvedge::test::run({data, size});
    return 0;
}
