// Sewing round thin limbs where seams would close through them.
#include "sim/dress/thin_limbs.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "sim/collide/body_collider.h"
#include "sim/collide/penetration.h"
#include "sim/dress/garment_sewing.h"
#include "sim/mesh/sew.h"
#include "sim/pattern/fabric.h"
#include "sim/place/limbs.h"
#include "sim/place/openings.h"
#include "tests/sim/dress/shapes.h"
#include "tests/support/mannequin.h"

namespace selvedge::sim::test {
namespace {

const BodyCollider& collider() {
    static const BodyCollider collider(mannequin());
    return collider;
}

std::vector<Fabric> fabrics() {
    return {find_fabric("denim"), find_fabric("denim")};
}

// Edges of the sewn mesh that enter and leave the body on opposite sides.
std::size_t passing_edges(const GarmentMesh& sewn) {
    std::vector<Vec3f> x;
    for (const Vec3d& point : sewn.x) x.push_back(point.cast<float>());
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const GarmentTriangle& t : sewn.triangles) {
        std::array<std::uint32_t, 3>& corners = triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) corners[k] = static_cast<std::uint32_t>(t.vertices[k]);
    }
    const auto found = find_penetration(x, triangles, collider().surface(), {.depth = 0.003F});
    return found.passing.size();
}

SewingOptions options() {
    SewingOptions options;
    options.simulation.self_contact.emplace();
    return options;
}

// Front and back of a straight leg, wide enough for the foot, far before and behind it. It stands as far to the side as
// for a body with its feet apart.
struct TrouserLeg {
    double width = 0.3;  // m
    double height = 0.75;
    double y = 0;
    double x = 0.1;
};

Pattern make(const TrouserLeg& leg) {
    Pattern pattern = tube(leg.width, leg.height, leg.y, 0.2);
    for (Panel& panel : pattern.panels) panel.translation.x() = leg.x;
    return pattern;
}

SewingRun sewn_once(const Pattern& pattern) {
    SewingRun run(assemble(pattern), fabrics(), options());
    while (run.advance(collider())) continue;
    return run;
}

TEST(ThinLimbs, keep_an_ankle_in_a_trouser_leg_that_stands_beside_it) {
    for (const TrouserLeg& leg : {TrouserLeg{.width = 0.3, .y = -0.06, .x = 0.21},
                                  TrouserLeg{.width = 0.35, .height = 0.6, .y = 0.05, .x = 0.23},
                                  TrouserLeg{.width = 0.35, .y = 0, .x = 0.23}}) {
        const Pattern pattern = make(leg);
        EXPECT_GT(passing_edges(std::move(sewn_once(pattern)).result().sewn), 0U) << "does not need thin limbs";
        GarmentSewing sewing(assemble(pattern), garments_of(pattern), fabrics(), collider(), options());
        while (sewing.advance(collider())) continue;
        const SewingResult result = std::move(sewing).result();
        EXPECT_EQ(passing_edges(result.sewn), 0U) << "at x " << leg.x;
        EXPECT_TRUE(result.open.empty());
        const BodyLimbs limbs = find_limbs(mannequin());
        const std::vector<Opening> openings = find_openings(result.sewn);
        const LimbPassages passages = find_passages(result.sewn, result.sewn.x, openings, limbs);
        ASSERT_EQ(openings.size(), 2U);
        EXPECT_EQ(passages.through[0].count() + passages.through[1].count(), 5U) << "one limb one way, four the other";
        EXPECT_NE(passages.through[0][index_of(LimbKind::LeftLeg)], passages.through[0][index_of(LimbKind::RightLeg)]);
    }
}

TEST(ThinLimbs, are_not_needed_where_the_seams_close_round_a_limb) {
    EXPECT_EQ(ThinLimbs::plan(sewn_once(make({.x = 0.1})), collider()), nullptr);
}

}  // namespace
}  // namespace selvedge::sim::test
