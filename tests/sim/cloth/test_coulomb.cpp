// Friction at a contact against Coulomb's law, written plainly and in double precision.
#include "sim/cloth/coulomb.h"

#include <gtest/gtest.h>

#include <random>

namespace selvedge::sim::test {
namespace {

Vec3f random_vector(std::mt19937& random, float reach) {
    std::uniform_real_distribution<float> along(-reach, reach);
    const float x = along(random), y = along(random);
    return {x, y, along(random)};
}

// Sticks where the sliding is at most what friction can hold; else it is shortened by that.
Vec3d left_by_coulomb(const Vec3d& motion, const Vec3d& normal, double held) {
    const Vec3d rising = normal * normal.dot(motion);
    const Vec3d sliding = motion - rising;
    if (sliding.norm() <= held) return rising;
    return rising + sliding.normalized() * (sliding.norm() - held);
}

TEST(Coulomb, friction_leaves_what_coulombs_law_leaves_of_a_motion) {
    std::mt19937 random(5);
    int stuck = 0;
    for (int i = 0; i < 1000; ++i) {
        const Vec3f motion = random_vector(random, 0.001F), normal = random_vector(random, 1).normalized();
        const float held = std::abs(random_vector(random, 0.001F).x());
        const Vec3d left = (motion - taken_by_friction<OnePoint>(motion, normal, held)).cast<double>();
        const Vec3d expected = left_by_coulomb(motion.cast<double>(), normal.cast<double>().normalized(), double(held));
        EXPECT_LT((left - expected).norm(), 1e-9);
        stuck += (expected - normal.cast<double>() * normal.cast<double>().dot(expected)).norm() < 1e-9 ? 1 : 0;
    }
    EXPECT_GT(stuck, 100);
    EXPECT_LT(stuck, 900);
}

TEST(Coulomb, friction_takes_nothing_of_a_point_that_does_not_slide) {
    const Vec3f rising(0, 0.001F, 0);
    EXPECT_EQ(taken_by_friction<OnePoint>(rising, Vec3f::UnitY(), 1.0F), Vec3f(0, 0, 0));
    EXPECT_EQ(taken_by_friction<OnePoint>(Vec3f::UnitX(), Vec3f::UnitY(), 0.0F), Vec3f(0, 0, 0));
}

}  // namespace
}  // namespace selvedge::sim::test
