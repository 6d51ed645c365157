#include "sim/adaptive/switched.h"

#include <gtest/gtest.h>

#include "sim/adaptive/buckling.h"
#include "sim/adaptive/uniform.h"
#include "tests/sim/adaptive/fixtures.h"

namespace selvedge::test {
namespace {

struct NeverEver {
    static constexpr bool is_veto = true;
    bool vetoes(const AdaptiveMesh&, EdgeId) const { return true; }
};

TEST(Switched, asks_while_it_is_on_and_holds_its_tongue_while_it_is_off) {
    for (const bool is_on : {false, true}) {
        AdaptiveMesh mesh(two_triangles());
        NoState state;
        const AlwaysSplit always;
        const AdaptReport report = adapt(mesh, state, {.max_level = 1}, Switched(is_on, always));
        EXPECT_EQ(report.splits, is_on ? 5 : 0);
        EXPECT_EQ(adapt(mesh, state, {}, Switched(false, always)).rejoins, report.splits) << "off, it agrees to all";
    }
}

TEST(Switched, a_veto_stays_a_veto) {
    static_assert(VetoCriterion<Switched<NeverEver>> && !VetoCriterion<Switched<AlwaysSplit>>);
    AdaptiveMesh mesh(two_triangles());
    NoState state;
    const NeverEver never;
    EXPECT_EQ(adapt(mesh, state, {.max_level = 1}, AlwaysSplit{}, Switched(true, never)).splits, 0);
    EXPECT_EQ(adapt(mesh, state, {.max_level = 1}, AlwaysSplit{}, Switched(false, never)).splits, 5);
    EXPECT_EQ(adapt(mesh, state, {.max_level = 1}, AlwaysSplit{}, Switched(true, never)).rejoins, 5);
}

TEST(Buckling, splits_what_is_shorter_than_its_material_and_rejoins_what_has_its_length_back) {
    const GarmentMesh base = two_triangles();
    AdaptiveMesh mesh(base);
    PositionState state(base, mesh);
    const EdgeId e = edge_between(mesh, VertexId(0), VertexId(1));  // 1 m long
    const BucklingCriterion criterion(state.x, {.split_ratio = 1.02F, .rejoin_ratio = 1.01F});
    const auto ratio = [&](float r) { state.x[1] = {1 / r, 0.0F, 0.0F}; };
    ratio(1.021F);
    EXPECT_TRUE(criterion.wants_split(mesh, e));
    EXPECT_FALSE(criterion.allows_rejoin(mesh, e));
    ratio(1.015F);
    EXPECT_FALSE(criterion.wants_split(mesh, e));
    EXPECT_FALSE(criterion.allows_rejoin(mesh, e));
    ratio(1.009F);
    EXPECT_FALSE(criterion.wants_split(mesh, e));
    EXPECT_TRUE(criterion.allows_rejoin(mesh, e));
    ratio(0.5F);  // twice as long as at rest
    EXPECT_FALSE(criterion.wants_split(mesh, e));
    EXPECT_TRUE(criterion.allows_rejoin(mesh, e));
}

}  // namespace
}  // namespace selvedge::test
