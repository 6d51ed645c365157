// Thighs that touch are parted for cloth; others are left alone.
#include <gtest/gtest.h>

#include <limits>

#include "sim/body/landmarks.h"
#include "sim/body/parted_legs.h"
#include "sim/body/section.h"
#include "sim/repair/self_intersections.h"
#include "tests/support/bodies.h"
#include "tests/support/mannequin.h"
#include "tests/support/touching_thighs.h"

namespace selvedge::sim::test {
namespace {

// Between the legs at that height, m; negative where they overlap.
double gap_at(const Body& body, double y) {
    double left = std::numeric_limits<double>::infinity(), right = -left;
    for (const SectionLoop& loop : section(body, {.point = Vec3d(0, y, 0)})) {
        if (std::abs(loop.centre.x()) > 0.25) continue;  // a hand
        for (const Vec3d& x : loop.points) {
            if (loop.centre.x() > 0) left = std::min(left, x.x());
            if (loop.centre.x() < 0) right = std::max(right, x.x());
        }
    }
    return left - right;
}

TEST(PartedLegs, find_the_crotch_where_two_legs_join) {
    const double crotch = crotch_of(mannequin()).value();
    EXPECT_NEAR(crotch, find_landmarks(mannequin()).crotch.value(), 0.01);
    EXPECT_EQ(section(mannequin(), {.point = Vec3d(0, crotch - 0.003, 0)}).size(), 2U);
    EXPECT_FALSE(crotch_of(shapes::box({-0.2, 0, -0.1}, {0.2, 1.7, 0.1}, 4)).has_value());
}

TEST(PartedLegs, of_thighs_that_touch_or_overlap_leave_room_for_cloth) {
    const double crotch = crotch_of(mannequin()).value();
    for (const double overlap : {0.0, 0.005, 0.012}) {
        Body body = with_touching_thighs(mannequin(), crotch, overlap);
        ASSERT_LT(gap_at(body, crotch - 0.06), 0.006);
        const double moved = part_legs(body);
        EXPECT_GT(moved, (kRoomForCloth + overlap) / 2 - 0.002) << overlap;
        EXPECT_LT(moved, (kRoomForCloth + overlap) / 2 + 0.004) << overlap;
        for (double y = crotch - 0.045; y > 0.35; y -= 0.02) EXPECT_GT(gap_at(body, y), kRoomForCloth - 0.002) << y;
        EXPECT_TRUE(self_intersections(body).empty()) << overlap;
        EXPECT_LT(part_legs(body), 0.002) << "twice is once";
    }
}

TEST(PartedLegs, leave_a_body_with_room_and_one_without_legs_as_they_are) {
    for (const Body& body : {mannequin(), shapes::box({-0.2, 0, -0.1}, {0.2, 1.7, 0.1}, 4)}) {
        Body parted = body;
        EXPECT_LT(part_legs(parted), 1e-4);
    }
}

}  // namespace
}  // namespace selvedge::sim::test
