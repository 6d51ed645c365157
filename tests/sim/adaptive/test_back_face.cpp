// Back-face coarsening on a ball of cloth: the visible side stays as fine as without it.
#include "sim/adaptive/back_face.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "sim/adaptive/check.h"
#include "sim/adaptive/criteria.h"
#include "tests/sim/adaptive/fixtures.h"

namespace selvedge::sim::test {
namespace {

// A cloth on the unit sphere: new vertices are placed on the sphere and get its normal.
struct BallState {
    std::vector<Vec3f> x;
    std::vector<Vec3f> normals;
    Visibility* visibility = nullptr;

    void on_capacity(std::size_t n) {
        x.resize(n, Vec3f::UnitZ());
        normals.resize(n, Vec3f::UnitZ());
        if (visibility != nullptr) visibility->on_capacity(n);
    }
    void on_split(VertexId c, VertexId a, VertexId b) {
        x[c.value] = (x[a.value] + x[b.value]).normalized();
        normals[c.value] = x[c.value];
        if (visibility != nullptr) visibility->on_split(c, a, b);
    }
    void on_rejoin(VertexId) {}
};

// The leaves of an octahedron at level 2 as a base mesh: 128 triangles.
GarmentMesh ball_of_cloth() {
    const GarmentMesh octa = octahedron();
    AdaptiveMesh mesh(octa);
    BallState state;
    state.on_capacity(mesh.vertex_capacity());
    for (std::size_t v = 0; v < octa.x.size(); ++v) state.x[v] = octa.x[v].cast<float>();
    set_uniform_level(mesh, state, 2);
    GarmentMesh ball;
    ball.panel_names = octa.panel_names;
    ball.panel_grain_angles = octa.panel_grain_angles;
    for (std::uint32_t v = 0; v < mesh.vertices().size(); ++v) ball.x.push_back(state.x[v].cast<double>());
    for (const LeafTriangle& leaf : mesh.leaf_triangles()) {
        GarmentTriangle& t = ball.triangles.emplace_back();
        t.panel = leaf.panel;
        for (std::size_t k = 0; k < 3; ++k) {
            t.vertices[k] = static_cast<int>(leaf.v[k].value);
            t.u[k] = leaf.u[k].cast<double>();
        }
    }
    return ball;
}

class BackFace : public testing::TestWithParam<ViewPoint> {
 protected:
    const GarmentMesh base_ = ball_of_cloth();
    AdaptiveMesh mesh_{base_};
    BallState state_;
    Visibility visibility_{GetParam()};

    void SetUp() override {
        state_.on_capacity(mesh_.vertex_capacity());
        for (std::size_t v = 0; v < base_.x.size(); ++v) state_.x[v] = base_.x[v].cast<float>();
        state_.normals = state_.x;
    }

    void adapt_unseen(int passes) {
        for (int i = 0; i < passes; ++i) adapt(mesh_, state_, {}, CurvatureCriterion(state_.normals, bent_));
    }
    AdaptReport adapt_seen() {
        visibility_.look(mesh_, state_.x, state_.normals);
        state_.visibility = &visibility_;
        const CurvatureCriterion curvature(state_.normals, bent_);
        const AdaptReport report = adapt(mesh_, state_, {}, curvature, BackFaceCriterion{&visibility_});
        EXPECT_TRUE(check(mesh_).empty()) << check(mesh_).front();
        return report;
    }

    bool faces(const LeafTriangle& t, const ViewPoint& view) const {
        const Vec3f a = state_.x[t.v[0].value], b = state_.x[t.v[1].value], c = state_.x[t.v[2].value];
        const Vec3f toward = view.is_orthographic ? view.eye : Vec3f(view.eye - a);
        return (b - a).cross(c - a).dot(toward) > 0;
    }

    // The leaves that face the viewer, each as the set of its corner positions.
    std::set<std::set<std::array<float, 3>>> seen_triangles(const ViewPoint& view) const {
        std::set<std::set<std::array<float, 3>>> seen;
        for (const LeafTriangle& t : mesh_.leaf_triangles()) {
            if (!faces(t, view)) continue;
            std::set<std::array<float, 3>> corners;
            for (const VertexId v : t.v)
                corners.insert({state_.x[v.value].x(), state_.x[v.value].y(), state_.x[v.value].z()});
            seen.insert(corners);
        }
        return seen;
    }

    const CurvatureOptions bent_{.split_angle = 0.08F, .rejoin_angle = 0.02F};  // requests level 3 everywhere
};

TEST_P(BackFace, leaves_what_is_seen_as_fine_as_without_it) {
    adapt_unseen(2);
    const auto wanted = seen_triangles(GetParam());
    const std::size_t everywhere = mesh_.leaf_triangles().size();
    EXPECT_EQ(everywhere, base_.triangles.size() * 64);
    for (int i = 0; i < 4; ++i) adapt_seen();
    EXPECT_EQ(seen_triangles(GetParam()), wanted);
    EXPECT_LT(mesh_.leaf_triangles().size(), everywhere * 4 / 5) << "hardly anything was coarsened";
}

TEST_P(BackFace, refines_from_a_coarse_start_to_the_same) {
    adapt_unseen(2);
    const auto wanted = seen_triangles(GetParam());
    struct Coarse {
        BallState& state;
        void on_capacity(std::size_t n) { state.on_capacity(n); }
        void on_split(VertexId, VertexId, VertexId) {}
        void on_rejoin(VertexId) {}
    } coarse{state_};
    set_uniform_level(mesh_, coarse, 0);
    for (int i = 0; i < 3; ++i) adapt_seen();
    EXPECT_EQ(seen_triangles(GetParam()), wanted);
}

TEST_P(BackFace, does_not_flicker_while_nothing_moves) {
    for (int i = 0; i < 4; ++i) adapt_seen();
    EXPECT_FALSE(adapt_seen().changed());
}

// What one side of the sway makes fine stays fine on its other side: it is hidden there, but by less than the margin of
// rejoins.
TEST_P(BackFace, keeps_every_edge_while_the_viewer_sways_by_less_than_the_margins_differ) {
    constexpr float sway = 0.1F;  // rad
    ViewPoint aside = GetParam();
    aside.eye = Eigen::AngleAxisf(sway, aside.eye.unitOrthogonal()) * aside.eye;
    // Splits and rejoins of further sways, once both sides have been seen.
    const auto changes = [&](const BackFaceOptions& options) {
        visibility_ = Visibility(GetParam(), options);
        for (int i = 0; i < 4; ++i) adapt_seen();
        visibility_.move_to(aside);
        for (int i = 0; i < 4; ++i) adapt_seen();
        int sum = 0;
        for (const ViewPoint& view : {GetParam(), aside, GetParam(), aside}) {
            visibility_.move_to(view);
            const AdaptReport report = adapt_seen();
            sum += report.splits + report.rejoins;
        }
        return sum;
    };
    EXPECT_EQ(changes({.split_margin = 0.10F, .rejoin_margin = 0.25F}), 0);
    EXPECT_GT(changes({.split_margin = 0.10F, .rejoin_margin = 0.101F}), 0) << "the sway shows nothing new";
}

TEST_P(BackFace, follows_a_viewer_who_walks_round) {
    for (int i = 0; i < 3; ++i) adapt_seen();
    const auto before = seen_triangles(GetParam());
    ViewPoint behind = GetParam();
    behind.eye = -behind.eye;
    visibility_.move_to(behind);
    for (int i = 0; i < 3; ++i) adapt_seen();
    const auto now = seen_triangles(behind);
    EXPECT_EQ(now.size(), before.size()) << "the ball looks alike from both sides";
    visibility_.move_to(GetParam());
    for (int i = 0; i < 3; ++i) adapt_seen();
    EXPECT_EQ(seen_triangles(GetParam()), before);
}

INSTANTIATE_TEST_SUITE_P(from, BackFace,
                         testing::Values(ViewPoint{.eye = Vec3f(0, 0, 1), .is_orthographic = true},
                                         ViewPoint{.eye = Vec3f(0.48F, -0.6F, 0.64F), .is_orthographic = true},
                                         ViewPoint{.eye = Vec3f(3, 1, 2)}, ViewPoint{.eye = Vec3f(0, 1.5F, 0)}));

}  // namespace
}  // namespace selvedge::sim::test
