// Random runs of a cloth (random_run.h) over 10,000 adaptations.
#include <gtest/gtest.h>

#include "tests/sim/cloth/random_run.h"

namespace selvedge::sim::test {
namespace {

TEST(LongRandomRuns, stay_sound_over_10000_adaptations) {
    for (unsigned seed = 1000; seed < 1400; ++seed) run_seed(seed);
}

// Regression: strain limits solved one after the other drove a cloth with five pins to strains of 40 %.
TEST(LongRandomRuns, stay_sound_where_limits_undo_each_others_work) {
    run_seed(600);
}

}  // namespace
}  // namespace selvedge::sim::test
