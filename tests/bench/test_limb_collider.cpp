// The thesis' cylinders and spheres as a collider, against the exact surface of a mannequin in a stride.
#include "bench/thesis/limb_collider.h"

#include <gtest/gtest.h>
#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "sim/body/skin.h"
#include "sim/collide/moving_body.h"
#include "sim/motion/grounding.h"
#include "sim/motion/motion_file.h"
#include "tests/support/mannequin.h"

namespace selvedge::bench {
namespace {

class LimbColliderOfStride : public ::testing::Test {
 protected:
    LimbColliderOfStride() {
        std::vector<Vec3f> x;
        sim::SkinnedSurface(body_).positions(body_, stride_, x);
        limbs_.move_to(body_, stride_, x);
        exact_.place(x);
    }

    // Up to `height` above or below some place of the skin.
    Vec3f random_point(float height) {
        std::uniform_real_distribution<float> share(0, 1), above(-height, height);
        const auto t = static_cast<std::uint32_t>(random_() % body_.triangles.size());
        const auto [a, b, c] = exact_.surface().triangles()[t];
        const std::span<const Vec3f> x = exact_.surface().points();
        const float u = share(random_), v = (1 - u) * share(random_);
        return x[a] + u * (x[b] - x[a]) + v * (x[c] - x[a]) + above(random_) * exact_.surface().face_normal(t);
    }

    const sim::Body& body_ = sim::test::mannequin();
    const sim::Pose stride_ = sample(body_, sim::find_motion("walk", body_), 0.35);
    LimbCollider limbs_{body_};
    sim::MovingBodyCollider exact_{body_};
    std::mt19937 random_{3};
};

TEST_F(LimbColliderOfStride, gives_the_signed_distance_and_the_direction_of_the_exact_surface) {
    int inside = 0, differ = 0;
    constexpr int kPoints = 4000;
    for (int i = 0; i < kPoints; ++i) {
        const Vec3f p = random_point(0.9F * limbs_.band());
        const sim::Contact found = limbs_.contact(p);
        const auto nearest = exact_.surface().closest(p, 1);
        inside += found.distance < 0 ? 1 : 0;
        differ += std::abs(found.distance - nearest->distance) > 1e-4F ? 1 : 0;
        if (std::abs(found.distance) >= limbs_.band() || std::abs(found.distance) < 1e-3F) continue;
        EXPECT_NEAR(found.normal.norm(), 1, 1e-3F);
        EXPECT_NEAR(exact_.surface().closest(p - found.distance * found.normal, 1)->distance, 0, 1e-4F);
        EXPECT_GT(exact_.surface().face_normal(nearest->triangle).dot(found.normal), 0) << "out of the body";
    }
    EXPECT_GT(inside, kPoints / 4);
    EXPECT_LE(differ, kPoints / 1000);
}

TEST_F(LimbColliderOfStride, is_outside_at_the_band_where_no_skin_is_near) {
    EXPECT_EQ(limbs_.contact({0, 5, 0}).distance, limbs_.band());
    const Vec3f far = exact_.surface().points()[0] + Vec3f(0, 0, 1);
    EXPECT_EQ(limbs_.contact(far).distance, limbs_.band());
}

TEST_F(LimbColliderOfStride, counts_what_is_deeper_than_its_reach_as_outside) {
    const Vec3f chest = sim::hips_of(body_, stride_).cast<float>() + Vec3f(0, 0.3F, 0);
    ASSERT_LT(exact_.surface().closest(chest, 1)->distance, -2 * limbs_.band());
    EXPECT_EQ(limbs_.contact(chest).distance, limbs_.band());
}

TEST_F(LimbColliderOfStride, on_the_skin_its_direction_is_that_of_the_triangle) {
    for (const std::uint32_t t : {100U, 4000U, 9000U}) {
        const auto [a, b, c] = exact_.surface().triangles()[t];
        const std::span<const Vec3f> x = exact_.surface().points();
        const sim::Contact found = limbs_.contact((x[a] + x[b] + x[c]) / 3);
        EXPECT_NEAR(found.distance, 0, 1e-6F);
        EXPECT_GT(found.normal.dot(exact_.surface().face_normal(t)), 0.999F);
    }
}

TEST_F(LimbColliderOfStride, first_hits_are_those_of_the_exact_surface) {
    int hits = 0, differ = 0;
    for (int i = 0; i < 500; ++i) {
        const Vec3f from = random_point(0.08F), to = random_point(0.01F);
        const auto found = limbs_.first_hit(from, to), exact = exact_.first_hit(from, to);
        hits += exact ? 1 : 0;
        const bool agree = found.has_value() == exact.has_value() &&
                           (!found || std::abs(found->fraction - exact->fraction) * (to - from).norm() < 1e-4F);
        differ += agree ? 0 : 1;
    }
    EXPECT_GT(hits, 250);
    EXPECT_LE(differ, 2);
}

}  // namespace
}  // namespace selvedge::bench
