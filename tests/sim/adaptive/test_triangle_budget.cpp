// The triangle budget on a wavy sheet that does not move: the number of leaves follows the target.
#include "sim/adaptive/triangle_budget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "sim/adaptive/adapt.h"
#include "sim/adaptive/check.h"
#include "sim/mesh/square.h"

namespace selvedge::sim::test {
namespace {

// A sheet with waves that grow steeper to one side. A new vertex gets the mean of its neighbours' normals, as in cloth,
// and the true normal at the next adaptation.
struct WavySheet {
    AdaptiveMesh mesh{sim::make_square({.columns = 12, .rows = 12, .width = 2.0, .depth = 2.0})};
    TriangleBudget budget;
    std::vector<Vec3f> x, normals;
    std::size_t max_vertices = 0;  // the maximum at any time, also during an adaptation

    explicit WavySheet(const BudgetOptions& options) : budget(options) {
        on_capacity(mesh.vertex_capacity());
        const GarmentMesh base = sim::make_square({.columns = 12, .rows = 12, .width = 2.0, .depth = 2.0});
        for (std::size_t v = 0; v < base.x.size(); ++v) x[v] = base.x[v].cast<float>();
    }

    void on_capacity(std::size_t n) {
        x.resize(n, Vec3f::Zero());
        normals.resize(n, Vec3f::UnitY());
    }
    void on_split(VertexId c, VertexId a, VertexId b) {
        x[c.value] = 0.5F * (x[a.value] + x[b.value]);
        normals[c.value] = (normals[a.value] + normals[b.value]).normalized();
        budget.on_split();
        max_vertices = std::max(max_vertices, mesh.vertices().size());
    }
    void on_rejoin(VertexId) { budget.on_rejoin(); }

    void adapt_once() {
        for (const VertexId v : mesh.leaf_vertices()) {
            const Vec3f p = x[v.value];
            const float slope = (0.6F + 0.4F * p.x()) * std::cos(7 * p.x() + 2 * p.z());
            normals[v.value] = Vec3f(-slope, 1, -0.5F * slope * std::sin(5 * p.z())).normalized();
        }
        budget.start(mesh);
        const CurvatureCriterion curvature(normals, scaled(CurvatureOptions{}, budget.scale()));
        adapt(mesh, *this, {}, curvature, BudgetCriterion{&budget}, BudgetVeto{&budget});
    }

    double miss() const {
        const double target = static_cast<double>(budget.target());
        return std::abs(static_cast<double>(mesh.leaf_triangles().size()) - target) / target;
    }
};

// A batch criterion that requests every split and agrees to every rejoin.
struct EagerBatch {
    static constexpr bool is_batch = true;
    mutable std::vector<EdgeId> noted{};
    mutable std::vector<EdgeId> looked_at{};

    void note(EdgeId e) const { noted.push_back(e); }
    std::span<const EdgeId> look(const AdaptiveMesh&) const {
        looked_at = std::exchange(noted, {});
        return looked_at;
    }
    bool wants_split(const AdaptiveMesh&, EdgeId) const { return true; }
    bool allows_rejoin(const AdaptiveMesh&, EdgeId) const { return true; }
};

constexpr int kAdaptationsPerSecond = 30;

// A batch decides after the budget was evaluated for every edge, so adapt() must evaluate the budget again.
TEST(TriangleBudget, holds_a_batch_that_asks_for_all) {
    WavySheet sheet({.target = 1500});
    for (int i = 0; i < kAdaptationsPerSecond; ++i) {
        sheet.budget.start(sheet.mesh);
        adapt(sheet.mesh, sheet, {}, EagerBatch{}, BudgetCriterion{&sheet.budget}, BudgetVeto{&sheet.budget});
    }
    EXPECT_LT(sheet.miss(), 0.05);
    EXPECT_LT(sheet.max_vertices, 1000U) << "1,500 triangles have some 800";
}

TEST(TriangleBudget, meets_a_target_within_a_second_and_keeps_it) {
    for (const std::size_t target : {600U, 1500U, 4000U, 9000U}) {
        WavySheet sheet({.target = target});
        for (int i = 0; i < kAdaptationsPerSecond; ++i) sheet.adapt_once();
        for (int i = 0; i < 2 * kAdaptationsPerSecond; ++i) {
            EXPECT_LT(sheet.miss(), 0.05) << target << " in adaptation " << kAdaptationsPerSecond + i;
            sheet.adapt_once();
        }
        EXPECT_TRUE(check(sheet.mesh).empty());
    }
}

TEST(TriangleBudget, follows_a_target_that_steps_up_and_down) {
    WavySheet sheet({.target = 1500});
    for (const std::size_t target : {1500U, 6000U, 800U, 5000U, 2500U}) {
        sheet.budget.set_target(target);
        for (int i = 0; i < kAdaptationsPerSecond; ++i) sheet.adapt_once();
        for (int i = 0; i < kAdaptationsPerSecond; ++i) {
            EXPECT_LT(sheet.miss(), 0.05) << target << " in adaptation " << kAdaptationsPerSecond + i;
            sheet.adapt_once();
        }
    }
}

TEST(TriangleBudget, leaves_a_sheet_that_stands_still_alone_once_it_has_what_it_wants) {
    WavySheet sheet({.target = 3000});
    for (int i = 0; i < 3 * kAdaptationsPerSecond; ++i) sheet.adapt_once();
    const std::size_t before = sheet.mesh.leaf_triangles().size();
    for (int i = 0; i < kAdaptationsPerSecond; ++i) sheet.adapt_once();
    const double change = static_cast<double>(sheet.mesh.leaf_triangles().size()) / static_cast<double>(before) - 1;
    EXPECT_LT(std::abs(change), 0.04);
}

TEST(TriangleBudget, a_target_below_what_any_threshold_leaves_is_met_all_the_same) {
    struct Demanding {
        bool wants_split(const AdaptiveMesh&, EdgeId) const { return true; }
        bool allows_rejoin(const AdaptiveMesh&, EdgeId) const { return false; }
    };
    WavySheet sheet({.target = 9000});
    for (int i = 0; i < kAdaptationsPerSecond; ++i) sheet.adapt_once();
    sheet.budget.set_target(1000);
    for (int i = 0; i < kAdaptationsPerSecond; ++i) {
        sheet.budget.start(sheet.mesh);
        adapt(sheet.mesh, sheet, {}, Demanding{}, BudgetCriterion{&sheet.budget}, BudgetVeto{&sheet.budget});
    }
    EXPECT_LT(sheet.miss(), 0.05);
}

TEST(TriangleBudget, a_flat_sheet_stays_coarse_however_great_the_target) {
    WavySheet sheet({.target = 5000});
    for (int i = 0; i < kAdaptationsPerSecond; ++i) {
        sheet.budget.start(sheet.mesh);
        adapt(sheet.mesh, sheet, {},
              CurvatureCriterion(sheet.normals, scaled(CurvatureOptions{}, sheet.budget.scale())),
              BudgetVeto{&sheet.budget});
    }
    EXPECT_EQ(sheet.mesh.leaf_triangles().size(), sheet.mesh.base_triangle_count());
}

TEST(Scaled, thresholds_keep_their_order_and_stay_possible) {
    for (const float scale : {0.01F, 1.0F, 8.0F, 100.0F}) {
        const CurvatureOptions curvature = scaled(CurvatureOptions{}, scale);
        EXPECT_LT(curvature.rejoin_angle, curvature.split_angle);
        EXPECT_LT(curvature.split_angle, 3.1416F);
        const LengthOptions length = scaled(LengthOptions{}, scale);
        EXPECT_LT(length.rejoin_compression, length.split_compression);
        EXPECT_LT(length.split_compression, 1);
        const BucklingOptions buckling = scaled(BucklingOptions{}, scale);
        EXPECT_LT(buckling.rejoin_ratio, buckling.split_ratio);
        EXPECT_GT(buckling.rejoin_ratio, 1);
    }
    EXPECT_EQ(scaled(CurvatureOptions{}, 1).split_angle, CurvatureOptions{}.split_angle);
}

}  // namespace
}  // namespace selvedge::sim::test
