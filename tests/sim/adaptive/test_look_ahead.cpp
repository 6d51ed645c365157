#include "sim/adaptive/look_ahead.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/adaptive/check.h"
#include "sim/adaptive/criteria.h"
#include "sim/adaptive/square.h"
#include "tests/sim/adaptive/fixtures.h"

namespace selvedge::test {
namespace {

// Straight folds along z, so that the edges of a square mesh that run along z are never bent.
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
    // Adapts until nothing changes any more; false if it does not come to rest.
    template <class Criterion>
    bool settle(const Criterion& criterion) {
        for (int i = 0; i < 10; ++i) {
            if (!adapt(mesh, state, {}, criterion).changed()) return true;
        }
        return false;
    }

    GarmentMesh base = make_square({.columns = 8, .rows = 8});
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
    const float longest = 2;  // m, no edge is as long
    int spoken_for = 0;
    for (const EdgeId e : mesh.unsplit_edges(0)) {
        const bool asks = curvature.wants_split(mesh, e);
        EXPECT_EQ(LookAheadCriterion(curvature, {.shortest_edge = longest}).wants_split(mesh, e), asks);
        EXPECT_EQ(LookAheadCriterion(curvature, {.max_level = 1}).wants_split(mesh, e), asks);
        spoken_for += LookAheadCriterion(curvature).wants_split(mesh, e) && !asks ? 1 : 0;
    }
    EXPECT_GT(spoken_for, 0) << "nothing was tested";
}

}  // namespace
}  // namespace selvedge::test
