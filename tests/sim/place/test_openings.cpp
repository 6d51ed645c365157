// Openings of garments, and the limbs that leave through them.
#include "sim/place/openings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/sim/place/support.h"

namespace selvedge::sim::test {
namespace {

struct End {
    Vec3d centre;
    double radius;  // m
};

// A tube about the line from `from` to `to`, right side outward, of one panel.
GarmentMesh tube_mesh(const End& from, const End& to) {
    constexpr int kColumns = 24, kRows = 8;
    GarmentMesh mesh;
    mesh.panel_names = {"tube"};
    const Vec3d axis = (to.centre - from.centre).normalized();
    const Vec3d first = axis.unitOrthogonal(), second = axis.cross(first);
    for (int row = 0; row <= kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            const double t = double(row) / kRows, angle = 2 * std::numbers::pi * column / kColumns;
            mesh.x.push_back((1 - t) * from.centre + t * to.centre +
                             std::lerp(from.radius, to.radius, t) *
                                 (std::cos(angle) * first + std::sin(angle) * second));
        }
    }
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            const int a = row * kColumns + column, b = row * kColumns + (column + 1) % kColumns;
            mesh.triangles.push_back({.vertices = {a, b, b + kColumns}});
            mesh.triangles.push_back({.vertices = {a, b + kColumns, a + kColumns}});
        }
    }
    return mesh;
}

LimbSet set_of(std::initializer_list<LimbKind> kinds) {
    LimbSet set;
    for (const LimbKind kind : kinds) set.set(index_of(kind));
    return set;
}

const LimbSet kBothLegs = set_of({LimbKind::LeftLeg, LimbKind::RightLeg});

// Through the opening at `from`, then through that at `to`.
std::vector<LimbSet> through(const End& from, const End& to, const PassageOptions& options = {}) {
    const GarmentMesh mesh = tube_mesh(from, to);
    const std::vector<Opening> openings = find_openings(mesh);
    EXPECT_EQ(openings.size(), 2U);
    const LimbPassages passages = find_passages(mesh, mesh.x, openings, mannequin_limbs(), options);
    EXPECT_TRUE(passages.known.all());
    return passages.through;
}

Vec3d at(double y) {
    return {0, y, 0.03};
}

TEST(Openings, of_a_tube_are_its_two_ends) {
    const GarmentMesh mesh = tube_mesh({at(1.0), 0.3}, {at(0.6), 0.3});
    const std::vector<Opening> openings = find_openings(mesh);
    ASSERT_EQ(openings.size(), 2U);
    for (const Opening& opening : openings) {
        EXPECT_EQ(opening.vertices.size(), 24U);
        EXPECT_EQ(opening.panels, std::vector<int>{0});
    }
}

TEST(Openings, of_a_skirt_hold_the_legs_below_and_the_rest_above) {
    const auto sets = through({at(1.02), 0.2}, {at(0.5), 0.3});
    EXPECT_EQ(sets[0], ~kBothLegs);
    EXPECT_EQ(sets[1], kBothLegs);
}

TEST(Openings, of_a_sleeve_hold_its_arm_wherever_it_was_pushed) {
    for (const LimbKind arm : {LimbKind::LeftArm, LimbKind::RightArm}) {
        const std::vector<LimbJoint>& joints = mannequin_limbs()[arm].joints;
        for (const double share : {0.1, 0.9}) {
            const Vec3d middle = joints[1].centre + share * (joints[2].centre - joints[1].centre);
            const Vec3d half = 0.05 * (joints[2].centre - joints[1].centre).normalized();
            const auto sets = through({middle - half, 0.07}, {middle + half, 0.07});
            EXPECT_EQ(sets[1], set_of({arm}));
            EXPECT_EQ(sets[0], ~set_of({arm}));
        }
    }
}

TEST(Openings, of_a_tube_beside_the_body_hold_nothing) {
    const Vec3d aside(0.2, 0, 0.9);
    for (const LimbSet& set : through({at(1.3) + aside, 0.2}, {at(0.6) + aside, 0.3})) EXPECT_TRUE(set.none());
}

TEST(Openings, of_a_tube_below_the_arms_that_hang_over_it_hold_the_legs_only) {
    const auto sets = through({at(0.7), 0.25}, {at(0.1), 1.6});  // the lines of the arms go on through it
    EXPECT_EQ(sets[1], kBothLegs);
}

TEST(Openings, of_a_skirt_that_swallowed_the_hands_hold_them) {
    const auto sets = through({at(1.06), 0.2}, {at(0.75), 1.2});
    EXPECT_EQ(sets[0], ~kBothLegs);
    EXPECT_EQ(sets[1], kBothLegs | set_of({LimbKind::LeftArm, LimbKind::RightArm}));
}

TEST(Openings, of_a_skirt_placed_round_the_hands_were_meant_for_the_legs) {
    const auto sets = through({at(1.06), 0.2}, {at(0.75), 1.2}, {.ends_at_cloth = true});
    EXPECT_EQ(sets[0], ~kBothLegs);
    EXPECT_EQ(sets[1], kBothLegs);
}

TEST(Openings, of_a_poncho_hold_the_head_above_and_all_else_below) {
    const auto sets = through({at(1.40), 0.12}, {at(1.2), 1.0});
    EXPECT_EQ(sets[0], set_of({LimbKind::Head}));
    EXPECT_EQ(sets[1], ~set_of({LimbKind::Head}));
}

TEST(Openings, of_a_garment_do_not_hold_what_the_body_lacks) {
    BodyLimbs lacking = mannequin_limbs();
    lacking.limbs[index_of(LimbKind::LeftArm)] = {};
    const GarmentMesh mesh = tube_mesh({at(1.02), 0.2}, {at(0.5), 0.3});
    const LimbPassages passages = find_passages(mesh, mesh.x, find_openings(mesh), lacking);
    EXPECT_EQ(passages.known, ~set_of({LimbKind::LeftArm}));
    EXPECT_EQ(passages.through[0], set_of({LimbKind::Head, LimbKind::RightArm}));
}

}  // namespace
}  // namespace selvedge::sim::test
