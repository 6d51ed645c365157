#include "render/scene/views.h"

#include <gtest/gtest.h>

namespace selvedge {
namespace {

// A tube from y = 0.5 to y = 1.4 with a radius of 0.25.
std::vector<Vec3f> tube() {
    std::vector<Vec3f> points;
    for (int j = 0; j <= 30; ++j) {
        for (int i = 0; i < 36; ++i) {
            const float angle = 0.17453293F * float(i);
            points.emplace_back(0.25F * std::sin(angle), 0.5F + 0.03F * float(j), 0.25F * std::cos(angle));
        }
    }
    return points;
}

TEST(Views, close_holds_the_upper_edge_and_hem_the_lower_one_at_the_front) {
    for (const View view : {View::Close, View::Hem}) {
        const std::vector<Vec3f> patch = detail_patch(tube(), view);
        float low = 1e9F, high = -1e9F;
        for (const Vec3f& x : patch) {
            EXPECT_NEAR(x.z(), 0.25F, 1e-4F);
            low = std::min(low, x.y());
            high = std::max(high, x.y());
        }
        EXPECT_NEAR(high - low, kDetailSize, 1e-4F);
        const float edge = view == View::Close ? 1.4F : 0.5F;
        EXPECT_LT(low, edge);
        EXPECT_GT(high, edge);
    }
}

TEST(Views, a_garment_smaller_than_the_patch_is_still_framed) {
    const std::vector<Vec3f> patch = detail_patch({Vec3f(1, 1, 1)}, View::Close);
    ASSERT_EQ(patch.size(), 4U);
    for (const Vec3f& x : patch) EXPECT_TRUE(x.allFinite());
}

TEST(Views, only_close_and_hem_are_details) {
    EXPECT_TRUE(is_detail(View::Close) && is_detail(View::Hem));
    EXPECT_FALSE(is_detail(View::Front) || is_detail(View::Top));
}

}  // namespace
}  // namespace selvedge
