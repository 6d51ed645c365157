// Elastics of garments.
#include <gtest/gtest.h>
#include <memory>

#include "sim/adaptive/panel_lines.h"
#include "sim/dress/dressing.h"
#include "sim/session/dress.h"
#include "tests/sim/dress/shapes.h"
#include "tests/sim/dress/support.h"
#include "tests/support/bodies.h"
#include "tests/support/mannequin.h"

namespace selvedge::sim::test {
namespace {

Body column() {
    return shapes::box(Vec3d(-0.1, 0, -0.06), Vec3d(0.1, 1.4, 0.06), 12);
}

TEST(Dressing, follows_an_elastic_that_is_changed_on_a_garment_that_hangs) {
    Pattern pattern = tube(0.4, 0.3, 0.8, 0.15);
    Dressing dressing;
    dressing.set_options({.max_level = 1, .max_seconds = 60});
    dressing.set_body(std::make_shared<const Body>(column()));
    dressing.set_pattern(pattern);
    while (!dressing.is_hanging()) dressing.advance();
    for (Panel& panel : pattern.panels) panel.edges[2].elastic = Elastic{.share = 0.5, .stiffness = 20};
    dressing.set_pattern(pattern);
    EXPECT_TRUE(dressing.is_hanging()) << "it goes on from where it hangs";
    while (dressing.stage() != DressingStage::Done) dressing.advance();
    const Cloth& cloth = *dressing.cloth();
    double round = 0;
    for (const LeafEdge& leaf : cloth.mesh.leaf_edges()) {
        for (const auto& line : lines_of(cloth.mesh, leaf.edge))
            if (line && line->edge == 2) round += double((cloth.x[leaf.a.value] - cloth.x[leaf.b.value]).norm());
    }
    EXPECT_LT(round, 0.68) << "the body's girth is 0.64 m, and the tube's 0.8 m";
}

// A tube that is wider than the hips, placed with its upper edge at the waist.
Pattern wide_skirt(bool has_elastic) {
    Pattern pattern = tube(0.54, 0.5, 0.54, 0.25);
    for (Panel& panel : pattern.panels)
        if (has_elastic) panel.edges[2].elastic = Elastic{.share = 0.55, .stiffness = 20};
    return pattern;
}

TEST(Dress, a_wide_skirt_stays_up_by_the_elastic_of_its_waist) {
    const DressedGarment loose = dress(wide_skirt(false), mannequin(), {.max_level = 1});
    const DressedGarment held = dress(wide_skirt(true), mannequin(), {.max_level = 1});
    EXPECT_EQ(loose.report.stopped_because, "slips down");
    EXPECT_TRUE(held.report.settled) << held.report.stopped_because << "\n" << list_faults(held.report);
    for (const DressFault& fault : held.report.faults) EXPECT_NE(fault.kind, "slipped") << fault.place;
}

}  // namespace
}  // namespace selvedge::sim::test
