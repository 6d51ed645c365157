// Skirts that are wider than the arms reach, and seams that would close through a limb.
#include "sim/dress/limb_detour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/cloth/cloth_penetration.h"
#include "sim/collide/body_collider.h"
#include "sim/collide/collider.h"
#include "sim/collide/penetration.h"
#include "sim/dress/dressing.h"
#include "sim/dress/garment_sewing.h"
#include "sim/mesh/sew.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/garments.h"
#include "sim/pattern/pattern_file.h"
#include "sim/place/limbs.h"
#include "sim/place/openings.h"
#include "sim/session/dress.h"
#include "tests/sim/dress/shapes.h"
#include "tests/support/checkout.h"
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

TEST(RaisedArms, are_not_needed_for_a_narrow_skirt) {
    const auto plan = [](double hem) {
        const GarmentMesh unsewn = assemble(wide_skirt(hem));
        return plan_raised_arms(unsewn, unsewn, wide_skirt(hem), MeasuredBody(mannequin()));
    };
    EXPECT_EQ(plan(0.5), nullptr);
    EXPECT_NE(plan(2.2), nullptr);
}

TEST(RaisedArms, let_a_wide_skirt_hang_below_the_arms) {
    const DressedGarment dressed = dress(wide_skirt(2.2), mannequin(), {.max_seconds = 2, .self_collision = false});
    for (const DressFault& fault : dressed.report.faults) {
        EXPECT_NE(fault.kind, "limb_missed") << fault.place;
        EXPECT_NE(fault.kind, "through_body") << fault.place;
    }
    const auto widest = std::ranges::max(dressed.mesh.x, {}, [](const Vec3f& x) { return std::abs(x.x()); });
    EXPECT_LT(std::abs(widest.x()), 0.8) << "it spreads over the arms";
}

TEST(RaisedArms, can_be_interrupted_while_they_are_planned) {
    struct Stop {};
    const GarmentMesh unsewn = assemble(wide_skirt(2.2));
    EXPECT_THROW(plan_raised_arms(unsewn, unsewn, wide_skirt(2.2), MeasuredBody(mannequin()), [] { throw Stop(); }),
                 Stop);
}

// The mean height of the vertices when the seams are closed and the arms are back, m.
float height_when_sewn(bool has_gravity) {
    Dressing dressing;
    dressing.set_options({.has_gravity = has_gravity, .self_collision = false});
    dressing.set_body(std::shared_ptr<const Body>(std::shared_ptr<void>(), &mannequin()));
    dressing.set_pattern(wide_skirt(2.6));
    do {
        dressing.advance();
    } while (dressing.stage() == DressingStage::Sew);
    const Cloth& cloth = *dressing.cloth();
    float sum = 0;
    for (const VertexId v : cloth.mesh.leaf_vertices()) sum += cloth.x[v.value].y();
    return sum / static_cast<float>(cloth.mesh.leaf_vertices().size());
}

TEST(RaisedArms, let_cloth_fall_only_where_there_is_gravity) {
    const float fallen = height_when_sewn(true), floating = height_when_sewn(false);
    EXPECT_LT(fallen, floating - 0.05F);
    EXPECT_NEAR(floating, 0.77, 0.03) << "where the panels were placed";
}

// Sewn only: what it looks like under the skirt is decided then.
TEST(RaisedArms, leave_worn_sleeves_round_the_arms_when_a_garment_is_put_over) {
    const std::filesystem::path tshirt = std::filesystem::path(source_folder()) / "patterns" / "tshirt.json";
    Pattern pattern = load_pattern(tshirt).pattern;
    put_over(pattern, wide_skirt(2.6));
    const BodyCollider collider(mannequin());
    GarmentSewing sewing(assemble(pattern), garments_of(pattern), fabrics_of(pattern), collider, {},
                         [&](const GarmentMesh& next, const GarmentMesh& all) {
                             return plan_raised_arms(next, all, pattern, MeasuredBody(mannequin()));
                         });
    while (sewing.advance(collider)) continue;
    const Cloth cloth = make_cloth(std::move(sewing).result().sewn, fabrics_of(pattern), {.max_level = 0});
    const Penetration found = find_penetration(cloth, collider.surface(), {.depth = 0.003F});
    EXPECT_EQ(found.faces, 0) << found.deepest;
}

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

const BodyLimbs& limbs_of_mannequin() {
    static const BodyLimbs limbs = find_limbs(mannequin());
    return limbs;
}

SewingOptions options() {
    SewingOptions options;
    options.limbs = std::make_shared<const BodyLimbs>(limbs_of_mannequin());
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
        const BodyLimbs& limbs = limbs_of_mannequin();
        const std::vector<Opening> openings = find_openings(result.sewn);
        const LimbPassages passages = find_passages(result.sewn, result.sewn.x, openings, limbs);
        ASSERT_EQ(openings.size(), 2U);
        EXPECT_EQ(passages.through[0].count() + passages.through[1].count(), 5U) << "one limb one way, four the other";
        EXPECT_NE(passages.through[0][index_of(LimbKind::LeftLeg)], passages.through[0][index_of(LimbKind::RightLeg)]);
    }
}

TEST(SewingRun, closes_the_links_first_that_it_is_told_to) {
    const GarmentMesh unsewn = assemble(make({.x = 0.1}));
    SewingRun run(unsewn, fabrics(), options());
    std::vector<bool> first(unsewn.links.size());
    for (std::size_t i = 0; i < first.size(); ++i) first[i] = unsewn.links[i].seam == 0;
    run.close_first(first);
    const auto widest = [&](int seam) {
        double widest = 0;
        for (const SeamLink& link : run.links()) {
            const auto a = static_cast<std::size_t>(link.a), b = static_cast<std::size_t>(link.b);
            if (link.seam == seam) widest = std::max<double>(widest, (run.cloth().x[a] - run.cloth().x[b]).norm());
        }
        return widest;
    };
    const double open = widest(1);
    while (widest(0) > static_cast<double>(run.closed_gap())) ASSERT_TRUE(run.advance(collider()));
    EXPECT_GT(widest(1), open / 2);
    while (run.advance(collider())) EXPECT_LT(widest(0), 0.02) << "it stays closed";
    EXPECT_TRUE(run.is_closed());
}

// The tube closes behind the leg that it was placed round: no cloth is in the body, and no seam is open.
TEST(ThinLimbs, are_needed_where_a_limb_is_outside_of_its_tube) {
    Pattern pattern = make({.x = 0.1});
    pattern.panels[0].translation.z() = 0.12;
    pattern.panels[1].translation.z() = -0.9;
    SewingRun run(assemble(pattern), fabrics(), options());
    const SphereCollider nothing(Vec3f(9, 9, 9), 0.1F);
    while (run.advance(nothing)) continue;
    const SewingFaults faults = count_sewing_faults(run, collider(), limbs_of_mannequin());
    EXPECT_EQ(faults.missed_limbs, 1U);
    EXPECT_EQ(faults.places, 0U);
    EXPECT_NE(plan_thin_limbs(run, collider(), limbs_of_mannequin()), nullptr);
}

TEST(ThinLimbs, are_not_needed_where_the_seams_close_round_a_limb) {
    EXPECT_EQ(plan_thin_limbs(sewn_once(make({.x = 0.1})), collider(), limbs_of_mannequin()), nullptr);
}

}  // namespace
}  // namespace selvedge::sim::test
