// What is much too small for a body is known before it is sewn.
#include "sim/place/placed_fit.h"

#include <gtest/gtest.h>

#include "sim/mesh/sew.h"
#include "sim/place/body_girths.h"
#include "tests/sim/dress/shapes.h"
#include "tests/sim/place/support.h"

namespace selvedge::sim::test {
namespace {

constexpr double kLevel = 1.0;  // m, of a tube's middle: above the hips

// Two panels before and behind the trunk, which seams make a tube of this girth.
GarmentMesh tube_of(double girth, double height = 0.3) {
    return assemble(tube(girth / 2, height, kLevel - height / 2, 0.3));
}

double trunk_at(const MeasuredBody& body, double y) {
    return trunk_girth(body, y)->length();
}

TEST(TooSmallAsPlaced, is_a_tube_that_cannot_close_round_the_trunk_anywhere_near) {
    const MeasuredBody body(mannequin());
    const auto found = too_small_as_placed(tube_of(0.4), body);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->garment_girth, 0.4, 0.001);
    EXPECT_NEAR(found->body_girth, trunk_at(body, found->y), 1e-9);
    EXPECT_GT(found->y, kLevel - 0.3);
    EXPECT_LT(found->y, kLevel + 0.3);
}

TEST(TooSmallAsPlaced, is_nothing_that_stretches_enough) {
    const MeasuredBody body(mannequin());
    EXPECT_FALSE(too_small_as_placed(tube_of(0.4), body, {.strain_limits = {1.5, 1.5}}));
}

TEST(TooSmallAsPlaced, is_nothing_that_fits_a_little_higher) {
    constexpr double kHips = 0.92;  // m, where the trunk still narrows upward
    const MeasuredBody body(mannequin());
    const GarmentMesh band = assemble(tube(trunk_at(body, kHips + 0.08) / 2, 0.04, kHips - 0.02, 0.3));
    EXPECT_FALSE(too_small_as_placed(band, body));
    EXPECT_TRUE(too_small_as_placed(band, body, {.slide = 0, .excess = 0.1}));
}

TEST(TooSmallAsPlaced, is_nothing_without_a_loop) {
    const MeasuredBody body(mannequin());
    Pattern open = tube(0.2, 0.3, kLevel - 0.15, 0.3);
    open.seams.resize(1);
    EXPECT_FALSE(too_small_as_placed(assemble(open), body));
}

TEST(DepthBelowFloor, is_how_much_too_long_a_garment_is) {
    const MeasuredBody body(mannequin());
    EXPECT_EQ(depth_below_floor(tube_of(1), body), 0);
    EXPECT_NEAR(depth_below_floor(assemble(tube(0.5, 1, -0.3, 0.3)), body), 0.3, 1e-9);
}

}  // namespace
}  // namespace selvedge::sim::test
