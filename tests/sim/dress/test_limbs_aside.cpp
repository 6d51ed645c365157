// Skirts that are wider than the arms reach.
#include "sim/dress/limbs_aside.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "sim/cloth/cloth_penetration.h"
#include "sim/collide/body_collider.h"
#include "sim/dress/dressing.h"
#include "sim/dress/garment_sewing.h"
#include "sim/mesh/sew.h"
#include "sim/pattern/garments.h"
#include "sim/pattern/pattern_file.h"
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

TEST(LimbsAside, are_not_needed_for_a_narrow_skirt) {
    const auto plan = [](double hem) {
        const GarmentMesh unsewn = assemble(wide_skirt(hem));
        return LimbsAside::plan(unsewn, unsewn, wide_skirt(hem), MeasuredBody(mannequin()));
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

TEST(LimbsAside, can_be_interrupted_while_they_are_planned) {
    struct Stop {};
    const GarmentMesh unsewn = assemble(wide_skirt(2.2));
    EXPECT_THROW(LimbsAside::plan(unsewn, unsewn, wide_skirt(2.2), MeasuredBody(mannequin()), [] { throw Stop(); }),
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

TEST(LimbsAside, let_cloth_fall_only_where_there_is_gravity) {
    const float fallen = height_when_sewn(true), floating = height_when_sewn(false);
    EXPECT_LT(fallen, floating - 0.05F);
    EXPECT_NEAR(floating, 0.77, 0.03) << "where the panels were placed";
}

// Sewn only: what it looks like under the skirt is decided then.
TEST(LimbsAside, leave_the_sleeves_of_what_is_worn_round_the_arms) {
    const std::filesystem::path tshirt = std::filesystem::path(source_folder()) / "patterns" / "tshirt.json";
    Pattern pattern = load_pattern(tshirt).pattern;
    put_over(pattern, wide_skirt(2.6));
    const BodyCollider collider(mannequin());
    GarmentSewing sewing(assemble(pattern), garments_of(pattern), fabrics_of(pattern), collider, {},
                         [&](const GarmentMesh& next, const GarmentMesh& all) {
                             return LimbsAside::plan(next, all, pattern, MeasuredBody(mannequin()));
                         });
    while (sewing.advance(collider)) continue;
    const Cloth cloth = make_cloth(std::move(sewing).result().sewn, fabrics_of(pattern), {.max_level = 0});
    const Penetration found = find_penetration(cloth, collider.surface(), {.depth = 0.003F});
    EXPECT_EQ(found.faces, 0) << found.deepest;
}

}  // namespace
}  // namespace selvedge::sim::test
