// The biases of warp, weft and shear survive an adaptation, and bring cloth to the strain of its
// stiffness.
#include "sim/cloth/solver_state.h"
#include "sim/cloth/state_transfer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/cloth.h"
#include "sim/collide/collider.h"
#include "tests/sim/cloth/fixtures.h"

namespace selvedge::sim::test {
namespace {

struct BiasedLeaf {
    LeafTriangle leaf;
    Vec3f bias = Vec3f::Zero();
};

LeafTriangle leaf_of(const Cloth& cloth, std::uint32_t triangle) {
    const std::span<const LeafTriangle> leaves = cloth.mesh.leaf_triangles();
    return *std::find_if(leaves.begin(), leaves.end(),
                         [&](const LeafTriangle& t) { return t.triangle.value == triangle; });
}

// The leaves with the biases in the solver's blocks.
std::vector<BiasedLeaf> biases(const Cloth& cloth) {
    const Constraints& constraints = cloth.solver->constraints;
    std::vector<BiasedLeaf> found;
    for (std::size_t lane = 0; lane < constraints.triangle_of.size(); ++lane) {
        if (constraints.triangle_of[lane] == kNoBlockSlot) continue;
        const auto& b = constraints.stretch.blocks[lane / kBlock].bias;
        const std::size_t at = lane % kBlock;
        found.push_back({leaf_of(cloth, constraints.triangle_of[lane]), Vec3f(b[0][at], b[1][at], b[2][at])});
    }
    return found;
}

// Gives each leaf a different bias.
void accumulate(Cloth& cloth, float scale) {
    Constraints& constraints = cloth.solver->constraints;
    for (std::size_t lane = 0; lane < constraints.triangle_of.size(); ++lane) {
        if (constraints.triangle_of[lane] == kNoBlockSlot) continue;
        const LeafTriangle leaf = leaf_of(cloth, constraints.triangle_of[lane]);
        const float value = scale * (1 + static_cast<float>(leaf.triangle.value));
        auto& b = constraints.stretch.blocks[lane / kBlock].bias;
        b[0][lane % kBlock] = value;
        b[1][lane % kBlock] = 2 * value;
        b[2][lane % kBlock] = -value;
    }
}

Vec2f middle(const LeafTriangle& leaf) {
    return (leaf.u[0] + leaf.u[1] + leaf.u[2]) / 3;
}

bool is_inside(const Vec2f& p, const LeafTriangle& leaf) {
    return distance_to_triangle(p, leaf.u) <= 0;
}

constexpr CriteriaOptions kNone{.collision = false, .curvature = false, .length = false};

AdaptReport split_under_dab(Cloth& cloth) {
    return adapt_cloth(cloth, NoBody{}, {.criteria = kNone, .minimum_levels = {&kDab, 1}});
}
AdaptReport rejoin(Cloth& cloth) {
    return adapt_cloth(cloth, NoBody{}, {.criteria = kNone});
}

TEST(Bias, stays_with_triangles_that_stay_and_goes_to_the_children_of_those_that_are_refined) {
    Cloth cloth = make_patch(find_fabric("silk"));
    accumulate(cloth, 1e-4F);
    const std::vector<BiasedLeaf> before = biases(cloth);
    ASSERT_GT(split_under_dab(cloth).splits, 0);
    int kept = 0, handed_on = 0;
    for (const BiasedLeaf& now : biases(cloth)) {
        const auto from = std::find_if(before.begin(), before.end(),
                                       [&](const BiasedLeaf& old) { return is_inside(middle(now.leaf), old.leaf); });
        ASSERT_NE(from, before.end());
        EXPECT_EQ(now.bias, from->bias);
        ++(now.leaf.u == from->leaf.u ? kept : handed_on);
    }
    EXPECT_GT(kept, 0);
    EXPECT_GT(handed_on, 0);
}

TEST(Bias, of_a_triangle_that_comes_back_is_the_mean_of_what_was_inside_it) {
    Cloth cloth = make_patch(find_fabric("silk"));
    ASSERT_GT(split_under_dab(cloth).splits, 0);
    accumulate(cloth, 1e-4F);
    const std::vector<BiasedLeaf> before = biases(cloth);
    ASSERT_GT(rejoin(cloth).rejoins, 0);
    ASSERT_EQ(cloth.mesh.leaf_triangles().size(), cloth.mesh.base_triangle_count());
    for (const BiasedLeaf& now : biases(cloth)) {
        Vec3f sum = Vec3f::Zero();
        for (const BiasedLeaf& old : before) {
            if (is_inside(middle(old.leaf), now.leaf)) sum += old.bias * material_area(old.leaf.u);
        }
        const Vec3f mean = sum / material_area(now.leaf.u);
        EXPECT_LT((now.bias - mean).norm(), 1e-4F * mean.norm());
    }
}

TEST(Bias, of_children_that_come_again_is_the_one_that_their_parent_has_by_then) {
    Cloth cloth = make_patch(find_fabric("silk"));
    split_under_dab(cloth);
    accumulate(cloth, 1e-4F);
    rejoin(cloth);
    accumulate(cloth, -3e-4F);
    const std::vector<BiasedLeaf> before = biases(cloth);
    ASSERT_GT(split_under_dab(cloth).splits, 0);
    for (const BiasedLeaf& now : biases(cloth)) {
        const auto from = std::find_if(before.begin(), before.end(),
                                       [&](const BiasedLeaf& old) { return is_inside(middle(now.leaf), old.leaf); });
        ASSERT_NE(from, before.end());
        EXPECT_EQ(now.bias, from->bias);
    }
}

TEST(Bias, an_adaptation_that_changes_nothing_leaves_it_alone) {
    Cloth cloth = make_patch(find_fabric("silk"));
    accumulate(cloth, 1e-4F);
    ASSERT_FALSE(rejoin(cloth).changed());
    refresh_solver(cloth);
    for (const BiasedLeaf& leaf : biases(cloth)) {
        EXPECT_EQ(leaf.bias.x(), 1e-4F * (1 + static_cast<float>(leaf.leaf.triangle.value)));
    }
}

// At a depth below the clamp the strip bears the weight below: strain w (L - depth) / k.
TEST(Bias, brings_a_hanging_strip_to_the_strain_of_its_stiffness) {
    Fabric fabric = find_fabric("cotton_shirting");
    fabric.stretch_warp = 60;  // N/m
    fabric.strain_limit = 0.5;
    fabric.shear_hysteresis = 0;                                           // friction would bear a part of the load
    const float weight = static_cast<float>(fabric.area_density) * 9.81F;  // N/m^2
    for (const int level : {0, 1}) {
        Cloth cloth = make_strip(fabric, {.level = level});
        run(cloth, nothing_near(), {.extra_damping = 4, .contact = {.floor = kNoFloor}}, 5.0);
        const std::vector<TriangleStrain> strains = measure_strain(cloth);
        for (std::size_t i = 0; i < strains.size(); ++i) {
            const float hanging = 1 + middle(cloth.mesh.leaf_triangles()[i]).y();  // m, the upper edge is at y = 0
            const float expected = weight * hanging / static_cast<float>(fabric.stretch_warp);
            EXPECT_NEAR(strains[i].warp, expected, 0.1F * expected + 0.001F) << hanging << " m, level " << level;
        }
    }
}

double mean_warp_strain(const Cloth& cloth) {
    double strain = 0, area = 0;
    const std::vector<TriangleStrain> strains = measure_strain(cloth);
    for (std::size_t i = 0; i < strains.size(); ++i) {
        const double a = material_area(cloth.mesh.leaf_triangles()[i].u);
        strain += a * static_cast<double>(strains[i].warp);
        area += a;
    }
    return strain / area;
}

// The load is fifteen times the weight of the strip. Leaves of level 2 alone could bear only a fraction of it.
TEST(Bias, of_refined_triangles_brings_heavy_loads_to_the_strain_of_the_stiffness_at_each_level) {
    const Fabric fabric = find_fabric("cotton_shirting");
    const float g = 15 * 9.81F;                                                                        // m/s^2
    const double expected = fabric.area_density * static_cast<double>(g) / (2 * fabric.stretch_warp);  // mean over 1 m
    for (const int level : {0, 1, 2}) {
        Cloth cloth = make_strip(fabric, {.mesh_angle = 0.3, .level = level});
        move_to(cloth, Eigen::Matrix3f::Identity(), Vec3f(0, 1, 0));  // floats have the smallest steps at the free end
        run(cloth, nothing_near(), {.gravity = Vec3f(0, -g, 0), .extra_damping = 10, .contact = {.floor = kNoFloor}},
            5.0);
        EXPECT_NEAR(mean_warp_strain(cloth), expected, 0.1 * expected) << "level " << level;
    }
}

// Without rescaling, biases accumulated with 12 sub-steps per step would make the strip far too short with 48.
TEST(Bias, fits_sub_steps_of_another_length) {
    const Fabric fabric = find_fabric("cotton_shirting");
    const float g = 15 * 9.81F;  // m/s^2
    for (const int level : {0, 1, 2}) {
        Cloth cloth = make_strip(fabric, {.mesh_angle = 0.3, .level = level});
        move_to(cloth, Eigen::Matrix3f::Identity(), Vec3f(0, 1, 0));
        StepOptions stepping{.gravity = Vec3f(0, -g, 0), .extra_damping = 10, .contact = {.floor = kNoFloor}};
        run(cloth, nothing_near(), stepping, 5.0);
        const double accumulated = mean_warp_strain(cloth);
        constexpr int kTimes = 4;
        set_substep(cloth, cloth.substep / kTimes);
        stepping.substeps *= kTimes;
        run(cloth, nothing_near(), stepping, 0.1);
        EXPECT_NEAR(mean_warp_strain(cloth), accumulated, (level < 2 ? 0.2 : 0.7) * accumulated) << "level " << level;
    }
}

// The flat triangle through the corners of cloth that is bent obliquely to the yarns is longer than the cloth in some
// directions.
TEST(Bias, of_refined_triangles_comes_of_what_their_leaves_are_off_by_and_not_of_their_own_strain) {
    const float c = std::cos(0.5F), s = std::sin(0.5F), r = 0.06F;  // rad, m
    Cloth cloth = make_strip(find_fabric("silk"), {.width = 0.2, .length = 0.4, .level = 2});
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const Vec4f x = cloth.x[v.value];
        const float along = c * x.x() + s * x.y(), across = c * x.y() - s * x.x();
        cloth.x[v.value] = Vec4f(r * std::sin(along / r), across, r * std::cos(along / r), 0);
        cloth.is_pinned[v.value] = true;
    }
    cloth.x_prev = cloth.x;
    refresh_solver(cloth);
    run(cloth, nothing_near(), {.contact = {.floor = kNoFloor}}, 1.0);
    int looked_at = 0;
    for (const ParentLevel& level : cloth.solver->constraints.parents) {
        for (const LimitRecord& record : level.limits.records) {
            for (std::size_t at = 0; at < kBlock; ++at) {
                if (record.offset[at] == kNoOffset) continue;
                EXPECT_LT(std::max(record.bias[0][at], record.bias[1][at]), 1e-3F);
                ++looked_at;
            }
        }
    }
    EXPECT_GT(looked_at, 100);
}

TEST(Bias, of_a_leaf_is_what_it_goes_on_to_carry_with_as_a_refined_triangle) {
    Cloth cloth = make_patch(find_fabric("silk"));
    accumulate(cloth, 1e-4F);
    const std::vector<BiasedLeaf> before = biases(cloth);
    ASSERT_GT(split_under_dab(cloth).splits, 0);
    int refined = 0;
    for (const LimitRecord& record : cloth.solver->constraints.parents[0].limits.records) {
        for (std::size_t at = 0; at < kBlock; ++at) {
            if (record.offset[at] == kNoOffset) continue;
            const auto was = std::find_if(before.begin(), before.end(), [&](const BiasedLeaf& old) {
                return stress_offset(old.leaf.triangle) == record.offset[at];
            });
            ASSERT_NE(was, before.end());
            for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(record.bias[k][at], was->bias[static_cast<int>(k)]);
            ++refined;
        }
    }
    EXPECT_GT(refined, 0);
}

}  // namespace
}  // namespace selvedge::sim::test
