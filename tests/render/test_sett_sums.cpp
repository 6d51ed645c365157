#include "render/sett_sums.h"

#include <gtest/gtest.h>

#include "render/colour.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge {
namespace {

TEST(SettSums, the_mean_over_any_stretch_is_that_of_its_threads) {
    const Sett sett = find_tartan("royal_stewart");
    const SettSums table = sum_warp(sett);
    const std::vector<Rgb8> colours = thread_colours(sett);
    ASSERT_EQ(table.sums.size(), colours.size() + 1);
    for (const auto& [first, last] : {std::pair<std::size_t, std::size_t>{0, 424}, {3, 4}, {100, 190}, {420, 424}}) {
        Vec3f expected = Vec3f::Zero();
        for (std::size_t i = first; i < last; ++i) expected += to_linear(colours[i]);
        expected /= float(last - first);
        const Vec3f mean = table.mean + (table.sums[last] - table.sums[first]) / float(last - first);
        EXPECT_LT((mean - expected).norm(), 1e-5F) << first << ".." << last;
    }
}

TEST(SettSums, begin_and_end_at_nothing_so_that_they_repeat_with_the_sett) {
    const SettSums table = sum_warp(find_tartan("buchanan"));
    EXPECT_EQ(table.sums.front(), Vec3f(0, 0, 0));
    EXPECT_EQ(table.sums.back(), Vec3f(0, 0, 0));
}

TEST(SettSums, a_weft_of_its_own_has_its_own_table_and_else_the_warps) {
    Sett sett = find_tartan("buchanan");
    EXPECT_EQ(sum_weft(sett).sums, sum_warp(sett).sums);
    sett.weft_stripes = parse_threadcount("K/3 W5 R/2").stripes;
    EXPECT_EQ(sum_weft(sett).threads(), 15) << "both halves: 3 5 2 5";
    EXPECT_EQ(sum_warp(sett).sums, sum_warp(find_tartan("buchanan")).sums);
}

TEST(Colour, srgb_bytes_become_linear_light) {
    EXPECT_FLOAT_EQ(to_linear(std::uint8_t{0}), 0);
    EXPECT_FLOAT_EQ(to_linear(std::uint8_t{255}), 1);
    EXPECT_NEAR(to_linear(std::uint8_t{188}), 0.5029F, 1e-3F);
}

}  // namespace
}  // namespace selvedge
