// Many points at once: every kernel gives the bits that one point gives.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "sim/body/body_collider.h"
#include "sim/core/simd_level.h"
#include "tests/sim/body/shapes.h"

namespace selvedge {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

// Smooth, with edges and corners, and with thin parts that touch: an apple on a crate with a slit beside it.
Body still_life() {
    const Body apple = shapes::sphere({0.05, 0.17, 0.05}, 0.06, 12);
    const Body crate = shapes::box({0, 0, 0}, {0.1, 0.1, 0.1}, 4);
    return shapes::together(shapes::together(apple, crate), shapes::box({0.106, 0, 0}, {0.112, 0.1, 0.1}, 4));
}

// About the body, some far off and some that are no points at all.
std::vector<ContactBlock> random_points(std::size_t blocks) {
    std::mt19937 random(17);
    std::uniform_real_distribution<float> along(-0.06F, 0.26F);
    std::vector<ContactBlock> asked(blocks);
    for (ContactBlock& block : asked)
        for (std::size_t i = 0; i < kContactLanes; ++i) {
            block.x[i] = along(random);
            block.y[i] = along(random);
            block.z[i] = along(random);
        }
    asked[0].x[3] = kFar;
    asked[0].y[4] = -1e30F;
    asked[0].z[5] = std::nanf("");
    return asked;
}

std::vector<std::uint32_t> bits_of(const ContactBlock& block) {
    std::vector<std::uint32_t> bits;
    for (const ContactBlock::Lanes* row : {&block.distance, &block.nx, &block.ny, &block.nz})
        for (const float value : *row) bits.push_back(std::bit_cast<std::uint32_t>(value));
    return bits;
}

class ContactsAtLevel : public testing::TestWithParam<SimdLevel> {
 protected:
    void SetUp() override {
        if (GetParam() > detected_simd_level()) GTEST_SKIP() << "not on this processor";
    }
    std::vector<ContactBlock> ask(float reach) const {
        const SimdLimit limit(GetParam());
        std::vector<ContactBlock> blocks = random_points(700);
        collider_.contacts(blocks, reach);
        return blocks;
    }

    const Body body_ = still_life();
    const BodyCollider collider_{body_};
};

TEST_P(ContactsAtLevel, have_the_bits_of_one_contact) {
    for (const ContactBlock& block : ask(kFar)) {
        ContactBlock one_by_one = block;
        for (std::size_t i = 0; i < kContactLanes; ++i) one_by_one.set(i, collider_.contact(block.point(i)));
        ASSERT_EQ(bits_of(block), bits_of(one_by_one));
    }
}

TEST_P(ContactsAtLevel, within_the_reach_have_them_too_and_beyond_it_are_never_too_large) {
    constexpr float kReach = 0.003F;
    int near = 0;
    int too_small = 0;
    for (const ContactBlock& block : ask(kReach))
        for (std::size_t i = 0; i < kContactLanes; ++i) {
            const Contact one = collider_.contact(block.point(i));
            if (block.distance[i] < kReach) {
                ++near;
                EXPECT_EQ(block.distance[i], one.distance);
                EXPECT_EQ(Vec3f(block.nx[i], block.ny[i], block.nz[i]), one.normal);
                continue;
            }
            const auto exact = collider_.surface().closest(block.point(i), kFar);
            if (!exact) continue;
            EXPECT_LE(block.distance[i], exact->distance + collider_.max_error());
            too_small += block.distance[i] < one.distance;
        }
    EXPECT_GT(near, 500);
    EXPECT_GT(too_small, 0);  // else the reach spared nothing here
}

std::string level_name(const testing::TestParamInfo<SimdLevel>& info) {
    return std::string(name_of(info.param));
}
INSTANTIATE_TEST_SUITE_P(Kernels, ContactsAtLevel,
                         testing::Values(SimdLevel::Plain, SimdLevel::Avx2, SimdLevel::Avx512), level_name);

}  // namespace
}  // namespace selvedge
