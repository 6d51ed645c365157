#include "sim/core/region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace selvedge::sim {
namespace {

Vec3f random_point(std::mt19937& random, float far) {
    std::uniform_real_distribution<float> at(-far, far);
    const float x = at(random), y = at(random);
    return {x, y, at(random)};
}

// Along each axis, m: the least over the points of the largest over the axes.
float distance_to(const std::vector<Vec3f>& points, const Vec3f& p) {
    float least = std::numeric_limits<float>::max();
    for (const Vec3f& each : points) least = std::min(least, (p - each).cwiseAbs().maxCoeff());
    return least;
}

TEST(Region, holds_what_is_near_its_points_and_nothing_far_from_them) {
    std::mt19937 random(1);
    std::vector<Vec3f> points;
    for (int i = 0; i < 20; ++i) points.push_back(random_point(random, 0.5F));
    const Region region(points, 0.06F);
    int inside = 0, outside = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3f p = random_point(random, 0.8F);
        const float distance = distance_to(points, p);
        if (distance < 0.06F) {
            ASSERT_TRUE(region.contains(p)) << p.transpose();
            ++inside;
        } else if (distance > 0.0901F) {
            ASSERT_FALSE(region.contains(p)) << p.transpose();
            ++outside;
        }
    }
    EXPECT_GT(inside, 100);
    EXPECT_GT(outside, 100);
}

TEST(Region, meets_a_box_if_it_holds_a_point_of_it) {
    const std::vector<Vec3f> points{Vec3f(0, 0, 0), Vec3f(1, 0, 0)};
    const Region region(points, 0.06F);
    EXPECT_TRUE(region.meets({Vec3f(-5, -5, -5), Vec3f(5, 5, 5)}));
    EXPECT_TRUE(region.meets({Vec3f(0.05F, -5, -0.01F), Vec3f(0.3F, 5, 0.01F)}));
    EXPECT_FALSE(region.meets({Vec3f(0.3F, -5, -5), Vec3f(0.7F, 5, 5)})) << "between both points";
    EXPECT_FALSE(region.meets({Vec3f(-5, -5, -5), Vec3f(-0.2F, 5, 5)}));
    EXPECT_TRUE(region.grown(0.25F).meets({Vec3f(0.3F, -5, -5), Vec3f(0.7F, 5, 5)}));
}

TEST(Region, is_all_of_space_unless_it_has_points) {
    const Vec3f far(1e9F, -1e9F, 0);
    EXPECT_TRUE(Region().contains(far));
    EXPECT_TRUE(Region().grown(1).contains(far));
    EXPECT_FALSE(Region({}, 0.1F).contains(Vec3f::Zero()));
}

TEST(Region, takes_points_that_spread_widely_and_leaves_out_those_that_are_not_finite) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<Vec3f> points{Vec3f(-40, 0, 0), Vec3f(40, 3, -20), Vec3f(nan, 0, 0)};
    const Region region(points, 0.06F);
    EXPECT_TRUE(region.contains(Vec3f(-40.05F, 0.05F, 0)));
    EXPECT_TRUE(region.contains(Vec3f(40.05F, 3, -20.05F)));
    EXPECT_FALSE(region.contains(Vec3f::Zero()));
    EXPECT_FALSE(Region(std::vector<Vec3f>{Vec3f(nan, 0, 0)}, 0.1F).contains(Vec3f::Zero()));
}

}  // namespace
}  // namespace selvedge::sim
