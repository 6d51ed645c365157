#include "sim/core/morton.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

namespace selvedge::sim {
namespace {

// By code and, where two have the same one, by index: points are given in the order of their indices.
bool is_sorted(const std::vector<CodedPoint>& points) {
    return std::ranges::is_sorted(points, [](const CodedPoint& a, const CodedPoint& b) {
        return a.code != b.code ? a.code < b.code : a.index < b.index;
    });
}

TEST(Morton, near_points_have_near_codes) {
    const std::uint64_t here = morton_code({0.5F, 1.2F, 0.1F});
    EXPECT_EQ(morton_code({0.501F, 1.2F, 0.1F}), here) << "within one cell of 4 mm";
    const auto way_to = [&](const Vec3f& p) {
        const std::uint64_t code = morton_code(p);
        return code > here ? code - here : here - code;
    };
    EXPECT_LT(way_to({0.51F, 1.2F, 0.1F}), way_to({0.9F, 1.2F, 0.1F}));
    EXPECT_LT(way_to({0.51F, 1.2F, 0.1F}), way_to({0.5F, -1.2F, 0.1F}));
}

TEST(Morton, points_are_sorted_by_code_and_equal_ones_keep_their_order) {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> near(-0.2F, 0.2F), far(-90, 90);
    for (const bool is_far : {false, true}) {
        std::vector<CodedPoint> points;
        for (std::uint32_t i = 0; i < 5000; ++i) {
            auto& along = is_far ? far : near;
            const float x = along(random), y = along(random);
            points.push_back({morton_code({x, y, along(random)}), i});
        }
        ASSERT_FALSE(is_sorted(points));
        sort_by_code(points);
        EXPECT_TRUE(is_sorted(points));
        std::vector<bool> is_there(points.size(), false);
        for (const CodedPoint& point : points) is_there[point.index] = true;
        EXPECT_EQ(std::ranges::count(is_there, true), 5000) << "none is lost";
    }
}

TEST(Morton, few_points_and_those_of_one_cell_are_sorted_too) {
    std::vector<CodedPoint> none;
    sort_by_code(none);
    EXPECT_TRUE(none.empty());
    std::vector<CodedPoint> same(40, {.code = 7});
    for (std::uint32_t i = 0; i < 40; ++i) same[i].index = i;
    sort_by_code(same);
    EXPECT_TRUE(is_sorted(same));
    std::vector<CodedPoint> two{{.code = std::uint64_t{1} << 47, .index = 0}, {.code = 1, .index = 1}};
    sort_by_code(two);
    EXPECT_EQ(two[0].index, 1U) << "the highest bit counts";
}

}  // namespace
}  // namespace selvedge::sim
