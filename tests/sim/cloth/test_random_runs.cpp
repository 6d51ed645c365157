// Random runs of a cloth (random_run.h): it stays valid whatever happens. test_long_random_runs.cpp has longer runs.
#include <gtest/gtest.h>

#include "tests/sim/cloth/random_run.h"

namespace selvedge::sim::test {
namespace {

TEST(RandomRuns, stay_sound_over_200_adaptations) {
    long changes = 0;
    for (unsigned seed = 0; seed < 8; ++seed) changes += run_seed(seed);
    EXPECT_GT(changes, 500) << "hardly anything was split or rejoined, so nothing was tested";
}

// Seeds with strict strain limits on stiff cloth, contacts after much longer sub-steps, or coarsening into the body.
TEST(RandomRuns, stay_sound_where_pushes_are_hardest) {
    for (const unsigned seed : {25U, 29U, 56U, 96U, 131U, 147U}) run_seed(seed);
}

// Tests the check itself: it must detect added kinetic energy.
TEST(RandomRuns, would_see_speed_that_comes_from_nowhere) {
    RandomChoices choices(0);
    RandomRun run(choices);
    ASSERT_FALSE(run.act().has_value());
    run.kick(100);
    const auto fault = run.act();
    ASSERT_TRUE(fault.has_value());
    EXPECT_NE(fault->find("kinetic"), std::string::npos) << *fault;
}

}  // namespace
}  // namespace selvedge::sim::test
