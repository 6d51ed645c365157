// Skirts that are wider than the arms reach.
#include "sim/dress/limbs_aside.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "sim/dress/dress.h"
#include "sim/mesh/sew.h"
#include "tests/sim/dress/shapes.h"
#include "tests/support/mannequin.h"

namespace selvedge::sim::test {
namespace {

// Front and back, from the waist down; their sides run out over the hands.
Pattern wide_skirt(double hem) {
    Pattern pattern = tube(0.39, 0.5, 0.58, 0.16);
    pattern.body = "mannequin:sex=female";
    for (Panel& panel : pattern.panels) {
        panel.label = "leg";
        panel.vertices[0].x() = -hem / 2;
        panel.vertices[1].x() = hem / 2;
    }
    return pattern;
}

TEST(LimbsAside, are_not_needed_for_a_narrow_skirt) {
    const auto plan = [](double hem) {
        const GarmentMesh unsewn = assemble(wide_skirt(hem));
        return LimbsAside::plan(unsewn, unsewn, wide_skirt(hem), mannequin());
    };
    EXPECT_EQ(plan(0.5), nullptr);
    EXPECT_NE(plan(2.2), nullptr);
}

TEST(LimbsAside, let_a_wide_skirt_hang_below_the_arms) {
    const DressedGarment dressed = dress(wide_skirt(2.2), mannequin(), {.max_seconds = 2, .self_collision = false});
    for (const DressFault& fault : dressed.report.faults) {
        EXPECT_NE(fault.kind, "limb_missed") << fault.place;
        EXPECT_NE(fault.kind, "through_body") << fault.place;
    }
    const auto widest = std::ranges::max(dressed.mesh.x, {}, [](const Vec3f& x) { return std::abs(x.x()); });
    EXPECT_LT(std::abs(widest.x()), 0.8) << "it spreads over the arms";
}

}  // namespace
}  // namespace selvedge::sim::test
