#include "sim/adaptive/criteria.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/adaptive/adapt.h"
#include "sim/adaptive/check.h"
#include "sim/adaptive/square.h"
#include "tests/sim/adaptive/fixtures.h"

namespace selvedge::test {
namespace {

// A sheet that lies flat but for a round hill in its middle; splits land on the surface, with its normal.
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

// Normals alone, which the test sets.
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
    const GarmentMesh base = make_square({.columns = 8, .rows = 8, .width = 2.0, .depth = 2.0});
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
    const GarmentMesh base = make_square({.columns = 8, .rows = 8, .width = 2.0, .depth = 2.0});
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

}  // namespace
}  // namespace selvedge::test
