#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

#include "sim/adaptive/adapt.h"
#include "sim/adaptive/check.h"
#include "sim/adaptive/criteria.h"
#include "sim/mesh/square.h"
#include "tests/sim/adaptive/fixtures.h"

namespace selvedge::sim::test {
namespace {

// A flat sheet with a round hill in its middle; new vertices are placed on the surface and get its normal.
struct HillState {
    float height = 0.2F;
    std::vector<Vec3f> x;
    std::vector<Vec3f> normals;

    void on_capacity(std::size_t n) {
        x.resize(n, Vec3f::Zero());
        normals.resize(n, Vec3f::UnitY());
    }
    void on_split(VertexId c, VertexId a, VertexId b) { place(c, 0.5F * (x[a.value] + x[b.value])); }
    void on_rejoin(VertexId) {}

    void place(VertexId v, const Vec3f& at) {
        const float bump = height * std::exp(-20.0F * (at.x() * at.x() + at.z() * at.z()));
        x[v.value] = {at.x(), bump, at.z()};
        normals[v.value] = Vec3f(40.0F * at.x() * bump, 1.0F, 40.0F * at.z() * bump).normalized();
    }
};

// Only normals, which the test sets.
struct NormalState {
    std::vector<Vec3f>& normals;

    void on_capacity(std::size_t n) { normals.resize(n, Vec3f::UnitZ()); }
    void on_split(VertexId c, VertexId, VertexId) { normals[c.value] = Vec3f::UnitZ(); }
    void on_rejoin(VertexId) {}
};

HillState make_hill(const GarmentMesh& base, const AdaptiveMesh& mesh) {
    HillState state;
    state.on_capacity(mesh.vertex_capacity());
    for (std::uint32_t v = 0; v < base.x.size(); ++v) state.place(VertexId(v), base.x[v].cast<float>());
    return state;
}

int deepest_level_beyond(const AdaptiveMesh& mesh, const HillState& state, float radius) {
    int deepest = 0;
    for (const LeafTriangle& t : mesh.leaf_triangles()) {
        const auto is_beyond = [&](VertexId v) { return state.x[v.value].norm() > radius; };
        if (is_beyond(t.v[0]) && is_beyond(t.v[1]) && is_beyond(t.v[2])) deepest = std::max(deepest, int{t.level});
    }
    return deepest;
}

TEST(Curvature, refines_a_hill_and_leaves_the_plain_coarse) {
    const GarmentMesh base = sim::make_square({.columns = 8, .rows = 8, .width = 2.0, .depth = 2.0});
    AdaptiveMesh mesh(base);
    HillState state = make_hill(base, mesh);
    const CurvatureCriterion curvature(state.normals, {.split_angle = 0.15F, .rejoin_angle = 0.05F});
    adapt(mesh, state, {}, curvature);
    EXPECT_TRUE(check(mesh).empty()) << check(mesh).front();
    EXPECT_EQ(deepest_level_beyond(mesh, state, 0.0F), 3);
    EXPECT_EQ(deepest_level_beyond(mesh, state, 0.9F), 0);
    EXPECT_FALSE(adapt(mesh, state, {}, curvature).changed());
}

TEST(Curvature, comes_back_when_the_hill_is_gone) {
    const GarmentMesh base = sim::make_square({.columns = 8, .rows = 8, .width = 2.0, .depth = 2.0});
    AdaptiveMesh mesh(base);
    HillState state = make_hill(base, mesh);
    const CurvatureCriterion curvature(state.normals, {.split_angle = 0.15F, .rejoin_angle = 0.05F});
    adapt(mesh, state, {}, curvature);
    state.height = 0.0F;
    for (const VertexId v : mesh.leaf_vertices()) state.place(v, state.x[v.value]);
    adapt(mesh, state, {}, curvature);
    EXPECT_EQ(mesh.leaf_triangles().size(), base.triangles.size());
}

TEST(Curvature, does_not_flatten_a_symmetric_bump) {
    AdaptiveMesh mesh(two_triangles(), {.max_level = 1});
    std::vector<Vec3f> normals(mesh.vertex_capacity(), Vec3f::UnitZ());
    const EdgeId shared = edge_between(mesh, VertexId(1), VertexId(2));
    NormalState state{normals};
    adapt(mesh, state, {}, ChosenEdges{{shared}});
    normals[mesh.centre(shared).value] = Vec3f(0.3F, 0.0F, 1.0F).normalized();  // the ends stay parallel
    EXPECT_FALSE(CurvatureCriterion(normals).allows_rejoin(mesh, shared));
    normals[mesh.centre(shared).value] = Vec3f::UnitZ();
    EXPECT_TRUE(CurvatureCriterion(normals).allows_rejoin(mesh, shared));
}

TEST(Curvature, neither_splits_nor_rejoins_between_its_two_angles) {
    AdaptiveMesh mesh(two_triangles(), {.max_level = 1});
    std::vector<Vec3f> normals(mesh.vertex_capacity(), Vec3f::UnitZ());
    NormalState state{normals};
    const EdgeId shared = edge_between(mesh, VertexId(1), VertexId(2));
    const CurvatureCriterion criterion(normals, {.split_angle = 0.35F, .rejoin_angle = 0.10F});
    const auto bend = [&](float angle) { normals[1] = {std::sin(angle), 0.0F, std::cos(angle)}; };
    bend(0.36F);
    EXPECT_TRUE(criterion.wants_split(mesh, shared));
    bend(0.34F);
    EXPECT_FALSE(criterion.wants_split(mesh, shared));
    adapt(mesh, state, {}, ChosenEdges{{shared}});
    bend(0.11F);
    EXPECT_FALSE(criterion.allows_rejoin(mesh, shared));
    bend(0.09F);
    EXPECT_TRUE(criterion.allows_rejoin(mesh, shared));
}

TEST(Length, splits_what_is_compressed_and_rejoins_what_has_its_length_back) {
    const GarmentMesh base = two_triangles();
    AdaptiveMesh mesh(base);
    PositionState state(base, mesh);
    const EdgeId e = edge_between(mesh, VertexId(0), VertexId(1));  // 1 m long
    const LengthCriterion criterion(state.x, {.split_compression = 0.05F, .rejoin_compression = 0.02F});
    const auto stretch_to = [&](float length) { state.x[1] = {length, 0.0F, 0.0F}; };
    stretch_to(0.94F);
    EXPECT_TRUE(criterion.wants_split(mesh, e));
    EXPECT_FALSE(criterion.allows_rejoin(mesh, e));
    stretch_to(0.96F);
    EXPECT_FALSE(criterion.wants_split(mesh, e));
    EXPECT_FALSE(criterion.allows_rejoin(mesh, e));
    stretch_to(1.2F);
    EXPECT_FALSE(criterion.wants_split(mesh, e));
    EXPECT_TRUE(criterion.allows_rejoin(mesh, e));
}

TEST(Length, reads_positions_with_a_fourth_coefficient) {
    AdaptiveMesh mesh(one_triangle());
    std::vector<Eigen::Vector4f> x(mesh.vertex_capacity(), Eigen::Vector4f(0.0F, 0.0F, 0.0F, 7.0F));
    x[1].x() = 0.5F;
    EXPECT_TRUE(LengthCriterion(x).wants_split(mesh, edge_between(mesh, VertexId(0), VertexId(1))));
    x[1] = {1.0F, 0.0F, 0.0F, 99.0F};
    EXPECT_FALSE(LengthCriterion(x).wants_split(mesh, edge_between(mesh, VertexId(0), VertexId(1))));
}

// Straight folds along z: the mesh edges along z are never bent.
struct FoldedState {
    float slope = 1.0F;
    std::vector<float> x;
    std::vector<Vec3f> normals;

    FoldedState(const GarmentMesh& base, const AdaptiveMesh& mesh) {
        on_capacity(mesh.vertex_capacity());
        for (std::uint32_t v = 0; v < base.x.size(); ++v) place(VertexId(v), static_cast<float>(base.x[v].x()));
    }
    void on_capacity(std::size_t n) {
        x.resize(n, 0.0F);
        normals.resize(n, Vec3f::UnitY());
    }
    void on_split(VertexId c, VertexId a, VertexId b) { place(c, 0.5F * (x[a.value] + x[b.value])); }
    void on_rejoin(VertexId) {}

    void place(VertexId v, float at) {
        x[v.value] = at;
        normals[v.value] = Vec3f(-slope * std::cos(25.0F * at), 1.0F, 0.0F).normalized();
    }
};

int deepest(const AdaptiveMesh& mesh) {
    int level = 0;
    for (const LeafTriangle& t : mesh.leaf_triangles()) level = std::max(level, int{t.level});
    return level;
}

class Folds : public testing::Test {
 protected:
    // Adapts until nothing changes; returns false if it still changes after 10 adaptations.
    template <class Criterion>
    bool settle(const Criterion& criterion) {
        for (int i = 0; i < 10; ++i) {
            if (!adapt(mesh, state, {}, criterion).changed()) return true;
        }
        return false;
    }

    GarmentMesh base = sim::make_square({.columns = 8, .rows = 8});
    AdaptiveMesh mesh{base};
    FoldedState state{base, mesh};
    CurvatureCriterion<Vec3f> curvature{state.normals};
};

TEST_F(Folds, along_the_mesh_stay_coarse_without_look_ahead) {
    EXPECT_TRUE(settle(curvature));
    EXPECT_EQ(deepest(mesh), 1);
}

TEST_F(Folds, are_resolved_with_look_ahead_and_come_to_rest) {
    EXPECT_TRUE(settle(LookAheadCriterion(curvature)));
    EXPECT_EQ(deepest(mesh), 3);
    EXPECT_TRUE(check(mesh).empty()) << check(mesh).front();
    for (const LeafEdge& e : mesh.leaf_edges()) {
        EXPECT_FALSE(mesh.level(e.edge) < 3 && curvature.wants_split(mesh, e.edge));
    }
}

TEST_F(Folds, that_are_gone_let_the_mesh_come_back) {
    settle(LookAheadCriterion(curvature));
    state.slope = 0.0F;
    for (const VertexId v : mesh.leaf_vertices()) state.place(v, state.x[v.value]);
    EXPECT_TRUE(settle(LookAheadCriterion(curvature)));
    EXPECT_EQ(mesh.leaf_triangles().size(), base.triangles.size());
}

TEST_F(Folds, do_not_split_an_edge_for_finer_ones_that_are_too_short_to_be_split) {
    settle(curvature);
    const float longest = 2;  // m, longer than every edge
    int by_look_ahead = 0;
    for (const EdgeId e : mesh.unsplit_edges(0)) {
        const bool requests = curvature.wants_split(mesh, e);
        EXPECT_EQ(LookAheadCriterion(curvature, {.shortest_edge = longest}).wants_split(mesh, e), requests);
        EXPECT_EQ(LookAheadCriterion(curvature, {.max_level = 1}).wants_split(mesh, e), requests);
        by_look_ahead += LookAheadCriterion(curvature).wants_split(mesh, e) && !requests ? 1 : 0;
    }
    EXPECT_GT(by_look_ahead, 0) << "nothing was tested";
}

// Agrees to every rejoin and requests no split.
struct AlwaysRejoin {
    bool wants_split(const AdaptiveMesh&, EdgeId) const { return false; }
    bool allows_rejoin(const AdaptiveMesh&, EdgeId) const { return true; }
};

int coarsest_in(const AdaptiveMesh& mesh, const MinimumLevelDisc& disc) {
    int coarsest = kDeepestLevel;
    for (const LeafTriangle& t : mesh.leaf_triangles()) {
        if (t.panel == disc.panel && distance_to_triangle(disc.centre, t.u) <= disc.radius)
            coarsest = std::min(coarsest, int{t.level});
    }
    return coarsest;
}

TEST(DistanceToTriangle, is_nothing_inside_and_the_way_to_the_nearest_side_or_corner_outside) {
    const std::array<Vec2f, 3> t{Vec2f(0, 0), Vec2f(4, 0), Vec2f(0, 4)};
    EXPECT_EQ(distance_to_triangle({1, 1}, t), 0);
    EXPECT_FLOAT_EQ(distance_to_triangle({1, -2}, t), 2);
    EXPECT_FLOAT_EQ(distance_to_triangle({-3, -4}, t), 5);
    EXPECT_FLOAT_EQ(distance_to_triangle({3, 3}, t), std::sqrt(2.0F));
}

TEST(MinimumLevel, makes_every_leaf_that_touches_the_disc_fine_enough_and_leaves_the_rest_coarse) {
    const GarmentMesh base = sim::make_square({.columns = 8, .rows = 8});
    const Vec2f middle = (base.triangles[60].u[0]).cast<float>();
    for (const int level : {1, 2, 3}) {
        for (const float radius : {0.0F, 0.05F, 0.2F}) {
            AdaptiveMesh mesh(base);
            NoState state;
            const MinimumLevelDisc disc{.panel = 0, .centre = middle, .radius = radius, .level = level};
            const MinimumLevelCriterion criterion{{&disc, 1}};
            adapt(mesh, state, {}, criterion);
            EXPECT_TRUE(check(mesh).empty());
            EXPECT_EQ(coarsest_in(mesh, disc), level) << radius;
            EXPECT_LT(mesh.leaf_triangles().size(), base.triangles.size() * (std::size_t{1} << (2 * level)) * 3 / 4);
            EXPECT_FALSE(adapt(mesh, state, {}, criterion).changed());
        }
    }
}

TEST(MinimumLevel, holds_its_region_when_all_others_agree_to_rejoin) {
    AdaptiveMesh mesh(sim::make_square({.columns = 4, .rows = 4}));
    NoState state;
    set_uniform_level(mesh, state, 3);
    const MinimumLevelDisc disc{.panel = 0, .centre = Vec2f::Zero(), .radius = 0.1F, .level = 2};
    adapt(mesh, state, {}, AlwaysRejoin{}, MinimumLevelCriterion{{&disc, 1}});
    EXPECT_EQ(coarsest_in(mesh, disc), 2);
    EXPECT_LT(mesh.leaf_triangles().size(), 32U * 16U);
}

TEST(MinimumLevel, is_of_one_panel_only) {
    AdaptiveMesh mesh(front_and_back(6, 1.0));
    NoState state;
    const MinimumLevelDisc disc{.panel = 1, .centre = mesh.leaf_triangles().back().u[0], .radius = 0, .level = 2};
    adapt(mesh, state, {}, MinimumLevelCriterion{{&disc, 1}});
    const auto fine_in = [&](int panel) {
        const auto leaves = mesh.leaf_triangles();
        return std::count_if(leaves.begin(), leaves.end(),
                             [&](const LeafTriangle& t) { return t.panel == panel && t.level == 2; });
    };
    EXPECT_GT(fine_in(1), fine_in(0));
}

TEST(MinimumLevel, does_nothing_without_discs) {
    AdaptiveMesh mesh(sim::make_square());
    NoState state;
    EXPECT_FALSE(adapt(mesh, state, {}, MinimumLevelCriterion{}).changed());
}

struct NeverEver {
    static constexpr bool is_veto = true;
    bool vetoes(const AdaptiveMesh&, EdgeId) const { return true; }
};

TEST(OptionalCriterion, asks_while_it_is_on_and_holds_its_tongue_while_it_is_off) {
    for (const bool is_on : {false, true}) {
        AdaptiveMesh mesh(two_triangles());
        NoState state;
        const AlwaysSplit always;
        const AdaptReport report = adapt(mesh, state, {.max_level = 1}, OptionalCriterion(is_on, always));
        EXPECT_EQ(report.splits, is_on ? 5 : 0);
        EXPECT_EQ(adapt(mesh, state, {}, OptionalCriterion(false, always)).rejoins, report.splits)
            << "off, it agrees to all";
    }
}

TEST(OptionalCriterion, a_veto_stays_a_veto) {
    static_assert(VetoCriterion<OptionalCriterion<NeverEver>> && !VetoCriterion<OptionalCriterion<AlwaysSplit>>);
    AdaptiveMesh mesh(two_triangles());
    NoState state;
    const NeverEver never;
    EXPECT_EQ(adapt(mesh, state, {.max_level = 1}, AlwaysSplit{}, OptionalCriterion(true, never)).splits, 0);
    EXPECT_EQ(adapt(mesh, state, {.max_level = 1}, AlwaysSplit{}, OptionalCriterion(false, never)).splits, 5);
    EXPECT_EQ(adapt(mesh, state, {.max_level = 1}, AlwaysSplit{}, OptionalCriterion(true, never)).rejoins, 5);
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
}  // namespace selvedge::sim::test
