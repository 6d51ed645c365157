// Statistics of garments dressed by the whole pipeline. The small folds of a drape differ between CPUs, and the
// tolerances allow for that. For each tolerance, a test shows that a fault exceeds it.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/golden/drape_numbers.h"
#include "tests/golden/golden.h"

namespace selvedge::test {
namespace {

class DrapeGolden : public testing::TestWithParam<const char*> {};

TEST_P(DrapeGolden, numbers_are_as_they_were) {
    const std::string garment = GetParam();
    EXPECT_TRUE(matches_numbers(drape_numbers(dress_shipped(garment)), "drape_" + garment));
}

INSTANTIATE_TEST_SUITE_P(Numbers, DrapeGolden, testing::Values("tshirt", "two_squares"),
                         [](const auto& tested) { return std::string(tested.param); });

DrapeNumbers read_numbers(const std::string& name) {
    const auto path = reference_path(name + ".json");
    const sim::Json json = sim::read_json(path);
    return parse_drape_numbers(sim::JsonView(json, path.string()));
}

// The difference that a fault makes against the reference, in one line.
std::string what_tells(void (*mutate)(DrapeNumbers&)) {
    const DrapeNumbers reference = read_numbers("drape_tshirt");
    DrapeNumbers spoilt = reference;
    mutate(spoilt);
    const auto found = differences(reference, spoilt);
    return found.size() == 1 ? found.front().substr(0, found.front().find(':')) : "not one thing alone";
}

TEST(DrapeNumbers, each_is_seen_to_change) {
    EXPECT_EQ(what_tells([](DrapeNumbers& now) { ++now.base_triangles; }), "base triangles");
    EXPECT_EQ(what_tells([](DrapeNumbers& now) { now.leaf_triangles = now.leaf_triangles * 8 / 9; }), "leaf triangles");
    EXPECT_EQ(what_tells([](DrapeNumbers& now) { now.settled = false; }), "settled");
    EXPECT_EQ(what_tells([](DrapeNumbers& now) { now.faults = {"inside_body"}; }), "faults");
    EXPECT_EQ(what_tells([](DrapeNumbers& now) { now.warp_weft_p99 += 0.011; }), "warp_weft_p99");
    EXPECT_EQ(what_tells([](DrapeNumbers& now) { now.warp_weft_p99 = std::nan(""); }), "warp_weft_p99");
    EXPECT_EQ(what_tells([](DrapeNumbers& now) { now.hem_height -= 0.011; }), "height of the hem, m");
    EXPECT_EQ(what_tells([](DrapeNumbers& now) { now.centre.z() += 0.011; }), "centre, m");
}

TEST(DrapeNumbers, another_garment_is_seen_and_both_values_are_told) {
    const auto result = matches_numbers(read_numbers("drape_two_squares"), "drape_tshirt");
    ASSERT_FALSE(result);
    const std::string message = result.message();
    for (const char* name : {"drape_tshirt", "drape_two_squares"}) {
        const std::string value = std::to_string(read_numbers(name).base_triangles);
        EXPECT_NE(message.find(value), std::string::npos) << message;
    }
}

TEST(DrapeNumbers, survive_being_written_and_read) {
    const DrapeNumbers numbers{.base_triangles = 5,
                               .leaf_triangles = 70,
                               .settled = true,
                               .faults = {"open_seam"},
                               .warp_weft_p99 = 0.012,
                               .hem_height = 0.71,
                               .centre = Vec3d(0.01, 1.1, -0.02)};
    const sim::Json json = to_json(numbers);
    const DrapeNumbers again = parse_drape_numbers(sim::JsonView(json, "numbers"));
    EXPECT_TRUE(differences(numbers, again, {.leaf_share = 0, .strain = 0, .length = 0}).empty());
}

TEST(DrapeNumbers, a_missing_reference_fails) {
    EXPECT_FALSE(matches_numbers({}, "there_are_no_such_numbers"));
}

}  // namespace
}  // namespace selvedge::test
