#include "editor/sheet/sett_tile.h"

#include <gtest/gtest.h>

#include "sim/tartan/tartan_file.h"

namespace selvedge {
namespace {

constexpr Rgba8 kBlack{0, 0, 0, 255}, kWhite{255, 255, 255, 255};

Sett checks() {
    return parse_threadcount("A=#000000; B=#FFFFFF; A16 B16");
}

TEST(SettPicture, one_repeat_shows_each_stripe_where_it_crosses_itself) {
    const Image picture = sett_tile(checks(), 64);
    ASSERT_EQ(picture.width_px, 64);
    ASSERT_EQ(picture.height_px, 64);
    EXPECT_EQ(picture.at(8, 8), kBlack);
    EXPECT_EQ(picture.at(40, 40), kWhite);
}

TEST(SettPicture, threads_of_both_are_seen_where_they_cross_and_mix_from_afar) {
    const Image near = sett_tile(checks(), 64);
    bool has_black = false, has_white = false;
    for (int y = 4; y < 20; ++y) {
        for (int x = 40; x < 56; ++x) {
            has_black |= near.at(x, y) == kBlack;
            has_white |= near.at(x, y) == kWhite;
        }
    }
    EXPECT_TRUE(has_black && has_white);
    const Rgba8 mixed = sett_tile(checks(), 32).at(24, 8);
    EXPECT_NEAR(mixed[0], 188, 1) << "half the light, in sRGB";
}

TEST(SettPicture, has_the_proportions_of_warp_and_weft) {
    const Sett sett = parse_threadcount("K24 W8 weft: K8 W8");
    EXPECT_EQ(sett_tile(sett, 64).height_px, 32);
}

TEST(SettPicture, sizes_are_powers_of_two_that_the_screen_has_use_for) {
    EXPECT_EQ(sett_tile_side(3), 32);
    EXPECT_EQ(sett_tile_side(100), 128);
    EXPECT_EQ(sett_tile_side(1e9), 1024);
}

}  // namespace
}  // namespace selvedge
