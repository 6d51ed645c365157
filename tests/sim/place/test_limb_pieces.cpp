// Arms apart from the body, and the panels that must not close round them.
#include "sim/place/limb_pieces.h"

#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "sim/mannequin/mannequin.h"
#include "sim/mesh/sew.h"
#include "tests/sim/dress/shapes.h"
#include "tests/support/posed_body.h"

namespace selvedge::sim::test {
namespace {

const Body& mannequin() {
    static const Body body = make_mannequin({.subdivisions = 1}).body;
    return body;
}

const BodyLimbs& limbs() {
    static const BodyLimbs limbs = find_limbs(mannequin());
    return limbs;
}

bool is_closed(const Body& body) {
    std::map<std::pair<int, int>, int> uses;
    for (const auto& t : body.triangles) {
        for (std::size_t k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
    }
    for (const auto& [edge, count] : uses) {
        const auto other = uses.find({edge.second, edge.first});
        if (count != 1 || other == uses.end()) return false;
    }
    return !body.triangles.empty();
}

TEST(CutOffArms, gives_closed_parts_of_bodies_in_any_pose) {
    for (const Body& body : {mannequin(), shapes::in_t_pose(mannequin())}) {
        const BodyLimbs found = find_limbs(body);
        const auto parts = cut_off_arms(body, found);
        ASSERT_TRUE(parts.has_value());
        EXPECT_TRUE(is_closed(parts->trunk));
        for (std::size_t i = 0; i < kArms.size(); ++i) {
            EXPECT_TRUE(is_closed(parts->arms[i].surface));
            const std::vector<LimbJoint>& joints = found[kArms[i]].joints;
            EXPECT_LT((parts->arms[i].joint - joints[0].centre).norm(),
                      0.7 * (joints[1].centre - joints[0].centre).norm());
            for (const Vec3d& x : parts->trunk.x) EXPECT_GT((x - joints[2].centre).norm(), 0.2);
        }
    }
}

TEST(CutOffArms, needs_arms) {
    Body body = mannequin();
    EXPECT_FALSE(cut_off_arms(body, BodyLimbs{}).has_value());
}

// A skirt of this width at its hem, front and back, from the waist down.
Pattern skirt(double hem) {
    Pattern pattern = tube(0.4, 0.5, 0.6, 0.16);
    for (Panel& panel : pattern.panels) {
        panel.vertices[0].x() = -hem / 2;
        panel.vertices[1].x() = hem / 2;
    }
    return pattern;
}

std::vector<bool> without_arms(const Pattern& pattern) {
    return panels_without_arms(assemble(pattern), pattern, limbs());
}

TEST(PanelsWithoutArms, are_those_of_a_skirt_that_would_close_round_the_hands) {
    EXPECT_EQ(without_arms(skirt(0.5)), (std::vector<bool>{false, false}));
    EXPECT_EQ(without_arms(skirt(2.5)), (std::vector<bool>{true, true}));
}

// A poncho covers the arms and closes round them, but no arm passes through it.
TEST(PanelsWithoutArms, are_not_those_that_cover_the_chest) {
    Pattern pattern = skirt(2.5);
    for (Panel& panel : pattern.panels) panel.translation.y() = 1.0;
    EXPECT_EQ(without_arms(pattern), (std::vector<bool>{false, false}));
}

TEST(PanelsWithoutArms, are_told_by_their_labels) {
    Pattern pattern = skirt(2.5);
    pattern.panels.push_back(rectangle("high", {.width = 0.3, .height = 0.2, .y = 1.2, .z = 0.2}));
    EXPECT_EQ(without_arms(pattern), (std::vector<bool>{true, true, false}));
    pattern.panels.back().label = "leg";
    EXPECT_EQ(without_arms(pattern), (std::vector<bool>{true, true, true}));
    pattern.panels[0].label = pattern.panels[1].label = "arm";
    EXPECT_EQ(without_arms(pattern), (std::vector<bool>{false, false, false}));
}

}  // namespace
}  // namespace selvedge::sim::test
