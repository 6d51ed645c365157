#pragma once
// Random runs by number.
#include <gtest/gtest.h>

#include <random>

#include "tests/sim/cloth/random_run.h"

namespace selvedge::test {

class RandomChoices final : public Choices {
 public:
    explicit RandomChoices(unsigned seed) : random_(seed) {}
    std::uint32_t next(std::uint32_t below) override { return static_cast<std::uint32_t>(random_() % below); }

 private:
    std::mt19937 random_;
};

// 25 adaptions; how much was split and rejoined. Fails where something breaks.
inline long run_seed(unsigned seed) {
    RandomChoices choices(seed);
    RandomRun run(choices);
    for (int i = 0; i < 25; ++i) {
        const auto fault = run.act();
        EXPECT_FALSE(fault.has_value()) << "seed " << seed << ", act " << i << ": " << *fault;
        if (fault) break;
    }
    return run.changes();
}

}  // namespace selvedge::test
