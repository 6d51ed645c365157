#include "sim/core/simd_level.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "sim/core/error.h"

namespace selvedge::sim {
namespace {

TEST(SimdLevel, in_use_is_never_more_than_the_processor_has) {
    EXPECT_LE(simd_level(), detected_simd_level());
}

TEST(SimdLevel, is_limited_for_a_while_and_the_strictest_limit_counts) {
    const SimdLevel before = simd_level();
    {
        const SimdLimit plain(SimdLevel::Plain);
        const SimdLimit more(SimdLevel::Avx512);
        EXPECT_EQ(simd_level(), SimdLevel::Plain);
    }
    EXPECT_EQ(simd_level(), before);
}

// Each test runs in its own process, because the variable is read once per process.
TEST(SimdLevelDeathTest, is_held_by_the_environment) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(
        {
            setenv("SELVEDGE_SIMD", "plain", 1);
            std::exit(simd_level() == SimdLevel::Plain ? 0 : 1);
        },
        testing::ExitedWithCode(0), "");
}

TEST(SimdLevelDeathTest, that_nobody_knows_is_refused) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(
        {
            setenv("SELVEDGE_SIMD", "turbo", 1);
            try {
                simd_level();
            } catch (const InputError&) {
                std::exit(3);
            }
            std::exit(0);
        },
        testing::ExitedWithCode(3), "");
}

}  // namespace
}  // namespace selvedge::sim
