// Bending has the fabric's rigidity on every mesh, at every level and for every number of sub-steps.
#include "sim/cloth/solver_state.h"
#include "sim/cloth/triangle_bending.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <set>

#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/kernels.h"
#include "sim/cloth/solver_blocks.h"
#include "tests/sim/cloth/fixtures.h"

namespace selvedge::sim::test {
namespace {

bool bends(const ParentLevel& level) {
    return level.interval < kNeverSolved;
}

Fabric springy(double rigidity) {
    Fabric fabric = undamped();
    fabric.bending_warp = fabric.bending_weft = rigidity;  // N m
    fabric.bending_hysteresis = fabric.shear_hysteresis = 0;
    return fabric;
}

// Rolls a cloth from the plane z = 0 along a direction in that plane, with zero velocity.
void roll_strip(Cloth& cloth, float curvature, float angle) {
    const Vec2f along(std::cos(angle), std::sin(angle)), across(-std::sin(angle), std::cos(angle));
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const Vec2f p = cloth.x[v.value].head<2>();
        const float s = p.dot(along);
        const Vec2f q = along * std::sin(curvature * s) / curvature + across * p.dot(across);
        cloth.x[v.value] = Vec4f(q.x(), q.y(), (1 - std::cos(curvature * s)) / curvature, 0);
    }
    cloth.x_prev = cloth.x;
}

bool is_inner(const BendSlot& slot) {
    return values_at(slot.block->own, slot.at).minCoeff() > 0;
}

// Twice the bending energy per area over B k^2, computed from curvatures and rigidities along warp, weft and of twist;
// over all leaves with three hinges.
double stored_share(const Cloth& cloth, float curvature) {
    const Fabric& fabric = cloth.material.fabrics.front();
    const Vec3d rigidity(fabric.bending_warp, fabric.bending_weft,
                         0.5 * std::sqrt(fabric.bending_warp * fabric.bending_weft));
    double energy = 0, area = 0;
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
        const BendSlot slot = bend_slot(cloth, leaf.triangle);
        if (!is_inner(slot)) continue;
        const Vec3d k = curvature_now(cloth, *slot.block, slot.at).cast<double>();
        energy += double(material_area(leaf.u)) * k.dot(rigidity.cwiseProduct(k));
        area += double(material_area(leaf.u));
    }
    return energy / area / rigidity[0] / double(curvature) / double(curvature);
}

TEST(TriangleBending, stores_half_b_k_squared_of_a_roll_in_whatever_direction_and_at_every_level) {
    constexpr float kCurvature = 8;  // 1/m
    for (const double mesh_angle : {0.0, 0.3}) {
        for (const int level : {1, 2}) {
            for (const float angle : {0.0F, 0.5F, 1.2F}) {
                Cloth cloth =
                    make_strip(springy(1e-5), {.width = 0.2, .length = 0.2, .mesh_angle = mesh_angle, .level = level});
                roll_strip(cloth, kCurvature, angle);
                EXPECT_NEAR(stored_share(cloth, kCurvature), 1, level == 1 ? 0.05 : 0.015)
                    << "mesh " << mesh_angle << " level " << level << " roll " << angle;
            }
        }
    }
}

const MinimumLevelDisc kWideDab{.panel = 0, .centre = Vec2f(0.0F, 0.0F), .radius = 0.12F, .level = 2};
const AdaptClothOptions kGraded{.criteria = {.collision = false, .curvature = false, .length = false},
                                .minimum_levels = {&kWideDab, 1},
                                .shortest_edge = 0};

// The area-weighted mean over all leaves with three hinges.
Vec3d mean_curvature(const Cloth& cloth) {
    Vec3d sum = Vec3d::Zero();
    double area = 0;
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
        const BendSlot slot = bend_slot(cloth, leaf.triangle);
        if (!is_inner(slot)) continue;
        sum += double(material_area(leaf.u)) * curvature_now(cloth, *slot.block, slot.at).cast<double>();
        area += double(material_area(leaf.u));
    }
    return sum / area;
}

TEST(TriangleBending, sees_the_curvature_of_a_roll_on_average_across_transitions_between_levels) {
    constexpr float kCurvature = 4;  // 1/m
    Cloth cloth = make_patch(springy(1e-5), {.side = 0.4, .quads = 8, .height = 0});
    ASSERT_GT(adapt_cloth(cloth, nothing_near(), kGraded).splits, 0);
    move_to(cloth, Eigen::AngleAxisf(std::numbers::pi_v<float> / 2, Vec3f::UnitX()).toRotationMatrix(), Vec3f::Zero());
    const float kAngle = 0.4F;  // rad, from the panel's x; its warp runs along y
    roll_strip(cloth, kCurvature, kAngle);
    const double c = std::cos(double(kAngle)), s = std::sin(double(kAngle));
    const Vec3d expected = double(kCurvature) * Vec3d(s * s, c * c, -2 * c * s);
    EXPECT_LT((mean_curvature(cloth) - expected).norm(), 0.04 * double(kCurvature)) << mean_curvature(cloth);
}

// Two triangles folded about their common edge: the displacement of an apex by one iteration.
double push_of_fold(double degrees) {
    GarmentMesh mesh;
    mesh.x = {Vec3d(0, 0, 0), Vec3d(0.1, 0, 0), Vec3d(0.05, 0.1, 0), Vec3d(0.05, -0.1, 0)};
    const auto u = [&](std::size_t v) { return Vec2d(mesh.x[v].head<2>()); };
    mesh.triangles = {{.vertices = {0, 1, 2}, .u = {u(0), u(1), u(2)}},
                      {.vertices = {1, 0, 3}, .u = {u(1), u(0), u(3)}}};
    mesh.panel_names = {"pair"};
    mesh.panel_grain_angles = {0};
    Cloth cloth = make_cloth(mesh, {springy(1e-5)});
    const double angle = degrees * std::numbers::pi / 180;
    cloth.x[3] =
        Vec4f(0.05F, -0.1F * static_cast<float>(std::cos(angle)), 0.1F * static_cast<float>(std::sin(angle)), 0);
    std::vector<Vec4f> points = solver_points(cloth, cloth.x);
    kernels(simd_level()).solve_bend(cloth.solver->constraints.bend.blocks, floats(points), 2);
    return double((points[3] - solver_points(cloth, cloth.x)[3]).norm());
}

TEST(TriangleBending, pushes_a_fold_open_the_harder_the_sharper_it_is_nearly_to_a_half_turn) {
    double before = 0;
    for (const double degrees : {10, 45, 90, 120, 150}) {
        const double push = push_of_fold(degrees);
        EXPECT_GT(push, before) << degrees;
        before = push;
    }
    EXPECT_GT(push_of_fold(176), 0.5 * before);
    EXPECT_NEAR(push_of_fold(60) / push_of_fold(30), 2, 0.1);
}

// Three triangles about one vertex: two hinges of each triangle have the same apex.
TEST(TriangleBending, moves_no_point_twice_where_three_triangles_meet_alone) {
    GarmentMesh mesh;
    mesh.x = {Vec3d(0, 0, 0.02), Vec3d(0.1, 0, 0), Vec3d(-0.05, 0.08, 0), Vec3d(-0.05, -0.08, 0)};
    const auto u = [&](std::size_t v) { return Vec2d(mesh.x[v].head<2>()); };
    for (const auto& [a, b] : {std::pair(1, 2), std::pair(2, 3), std::pair(3, 1)}) {
        mesh.triangles.push_back({.vertices = {0, a, b}, .u = {u(0), u(std::size_t(a)), u(std::size_t(b))}});
    }
    mesh.panel_names = {"cap"};
    mesh.panel_grain_angles = {0};
    Cloth cloth = make_cloth(mesh, {springy(0.1)});
    std::vector<Vec4f> points = solver_points(cloth, cloth.x);
    kernels(simd_level()).solve_bend(cloth.solver->constraints.bend.blocks, floats(points), 2);
    Vec3d push = Vec3d::Zero();
    double size = 0;
    for (std::size_t v = 0; v < 4; ++v) {
        const Vec3d one = (points[v] - cloth.x[v]).head<3>().cast<double>() / double(cloth.inverse_mass[v]);
        push += one;
        size += one.norm();
    }
    EXPECT_GT(size, 0);
    EXPECT_LT(push.norm(), 1e-3 * size);
}

// The share of the rigidity that leaves, and leaves and refined triangles together, apply; weighted by area.
struct Realised {
    double leaves = 0, all = 0;
};
Realised realised(const Cloth& cloth) {
    Realised sum;
    double area = 0;
    const auto share = [&](TriangleId t) {
        const BendSlot slot = bend_slot(cloth, t);
        return double(slot.block->realised[slot.at]) * double(material_area(cloth.mesh.triangle(t).u));
    };
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
        sum.leaves += share(leaf.triangle);
        area += double(material_area(leaf.u));
    }
    sum.all = sum.leaves;
    for (int level = 0; level < cloth.mesh.max_level(); ++level) {
        for (const TriangleId t : cloth.mesh.refined_triangles(level)) sum.all += share(t);
    }
    return {sum.leaves / area, sum.all / area};
}

TEST(TriangleBending, hands_what_leaves_cannot_make_to_refined_triangles_and_nothing_where_they_can) {
    Cloth soft = make_patch(springy(1e-7));
    refine(soft, 2);
    EXPECT_NEAR(realised(soft).leaves, 1, 1e-6);
    EXPECT_TRUE(std::ranges::none_of(soft.solver->constraints.parents, bends));

    Cloth stiff = make_patch(springy(1e-3));
    refine(stiff, 3);
    EXPECT_LT(realised(stiff).leaves, 0.6);
    EXPECT_NEAR(realised(stiff).all, 1, 0.03);
    ASSERT_GT(adapt_cloth(stiff, nothing_near(), kGraded).rejoins, 0);
    EXPECT_NEAR(realised(stiff).all, 1, 0.03);
}

// A leaf is solved every second sub-step only if it can apply its full rigidity that way.
TEST(TriangleBending, is_visited_more_seldom_where_that_makes_all_of_it) {
    std::set<float> seen;
    for (const double bending : {1e-6, 1e-5, 1e-4, 3e-4, 1e-3, 3e-3}) {
        Cloth cloth = make_patch(springy(bending));
        refine(cloth, 2);
        ASSERT_GT(adapt_cloth(cloth, nothing_near(), kGraded).rejoins, 0);
        for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
            const BendSlot slot = bend_slot(cloth, leaf.triangle);
            const float interval = slot.block->interval[slot.at], realised = slot.block->realised[slot.at];
            seen.insert(interval);
            if (interval > 1) {
                EXPECT_EQ(realised, 1);
            }
            if (realised < 1) {
                EXPECT_EQ(interval, 1);
            }
        }
    }
    EXPECT_EQ(seen, (std::set<float>{1, 2}));
}

// Triangles with an interval of 2 keep their bits in a sub-step in which others of the same blocks are solved.
TEST(TriangleBending, of_slow_triangles_waits_for_its_turn) {
    Fabric fabric = springy(3e-4);
    fabric.bending_hysteresis = 1e-3;
    Cloth cloth = make_patch(fabric);
    refine(cloth, 2);
    ASSERT_GT(adapt_cloth(cloth, nothing_near(), kGraded).rejoins, 0);
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const Vec4f& p = cloth.x[v.value];
        cloth.x[v.value].y() += 0.004F * std::sin(20 * p.x()) * std::cos(15 * p.z());
    }
    std::vector<Vec4f> points = cloth.x;
    for (const VertexId v : cloth.mesh.leaf_vertices()) points[v.value].w() = cloth.inverse_mass[v.value];
    points.emplace_back(Vec4f::Zero());
    const std::vector<Vec4f> before = points;
    auto& bend = cloth.solver->constraints.bend;
    const std::vector<BendBlock> blocks = bend.blocks;
    kernels(simd_level()).solve_bend(bend.blocks, floats(points), 1);
    std::set<std::uint32_t> quick;  // vertices that a triangle with an interval of 1 may move
    std::size_t slow = 0, mixed = 0;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        std::size_t slow_here = 0;
        for (std::size_t at = 0; at < kBlock; ++at) {
            if (blocks[i].interval[at] > 1) {
                EXPECT_EQ(values_at(bend.blocks[i].anchor, at), values_at(blocks[i].anchor, at));
                slow_here += blocks[i].interval[at] < kNeverSolved ? 1U : 0U;
            } else {
                for (const BlockPoints& corner : blocks[i].vertices) quick.insert(corner[at] / 4);
            }
        }
        slow += slow_here;
        mixed += slow_here > 0 && std::ranges::min(blocks[i].interval) == 1 ? 1U : 0U;
    }
    EXPECT_GT(slow, 10U);
    EXPECT_GT(mixed, 0U);
    std::size_t moved = 0;
    for (std::uint32_t v = 0; v < points.size(); ++v) {
        const bool stays = std::memcmp(&points[v], &before[v], sizeof(Vec4f)) == 0;
        moved += stays ? 0U : 1U;
        EXPECT_TRUE(stays || quick.contains(v)) << v;
    }
    EXPECT_GT(moved, 0U);
}

// A horizontal cantilever of 4 cm: the deflection of its free end, m.
double droop(int level, float substep) {
    Fabric fabric = springy(2e-5);
    Cloth cloth = make_strip(fabric, {.width = 0.04, .length = 0.04});
    float top = 0;
    for (const VertexId v : cloth.mesh.leaf_vertices()) top = std::max(top, cloth.x[v.value].y());
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const Vec4f p = cloth.x[v.value];
        cloth.x[v.value] = Vec4f(p.x(), 0, top - p.y(), 0);
        cloth.is_pinned[v.value] = top - p.y() < 0.001F;
    }
    cloth.x_prev = cloth.x;
    refine(cloth, level);
    set_substep(cloth, substep);
    run(cloth, nothing_near(), {.extra_damping = 4, .contact = {.floor = kNoFloor}}, 1.5);
    float lowest = 0;
    for (const VertexId v : cloth.mesh.leaf_vertices()) lowest = std::min(lowest, cloth.x[v.value].y());
    return double(-lowest);
}

// The leaves of level 3 can apply only a small part of the rigidity within such a sub-step.
TEST(TriangleBending, lets_a_strip_droop_alike_at_every_level_and_substep) {
    const double expected = droop(1, 1.0F / 1440);
    EXPECT_GT(expected, 0.002);
    for (const int level : {2, 3}) {
        for (const float substep : {1.0F / 480, 1.0F / 1440}) {
            EXPECT_NEAR(droop(level, substep), expected, 0.12 * expected)
                << "level " << level << ", " << substep << " s";
        }
    }
}

// Waves without gravity or damping, with few sub-steps, so that refined triangles apply bending.
TEST(TriangleBending, gives_no_energy) {
    for (const float substep : {1.0F / 240, 1.0F / 960}) {
        Cloth cloth = make_patch(springy(1e-3), {.height = 0, .substep = substep});
        refine(cloth, 2);
        for (const VertexId v : cloth.mesh.leaf_vertices()) {
            const Vec4f& p = cloth.x[v.value];
            cloth.x[v.value].y() = 0.004F * std::sin(20 * p.x()) * std::cos(15 * p.z());
        }
        cloth.x_prev = cloth.x;
        ASSERT_TRUE(std::ranges::any_of(cloth.solver->constraints.parents, bends) || substep < 1.0F / 500);
        const StepOptions free{.gravity = Vec3f::Zero(), .internal_damping = 0, .contact = {.floor = kNoFloor}};
        std::vector<float> most(4, 0.0F);
        for (float& speed : most) {
            for (int i = 0; i < 10; ++i) {
                run(cloth, nothing_near(), free, 0.05);
                speed = std::max(speed, speed_now(cloth));
            }
        }
        EXPECT_GT(most[0], 0.01F);
        for (std::size_t i = 1; i < most.size(); ++i) EXPECT_LT(most[i], 1.05F * most[i - 1]) << i << ", " << substep;
    }
}

// The anchors of a refined triangle that starts to apply rigidity are at its present curvature.
TEST(TriangleBending, of_refined_triangles_begins_without_friction) {
    Fabric fabric = springy(1e-3);
    fabric.bending_hysteresis = 1e-3;
    Cloth cloth = make_patch(fabric, {.height = 0, .substep = 1e-5F});
    refine(cloth, 3);
    const auto refined = [&] { return cloth.mesh.refined_triangles(2)[5]; };
    ASSERT_EQ(bend_slot(cloth, refined()).block->realised[bend_slot(cloth, refined()).at], 0);
    roll_strip(cloth, 5, 0);
    set_substep(cloth, 1.0F / 480);
    const BendSlot slot = bend_slot(cloth, refined());
    ASSERT_GT(slot.block->realised[slot.at], 0);
    const Vec3f now = curvature_now(cloth, *slot.block, slot.at);
    EXPECT_LT((values_at(slot.block->anchor, slot.at) - now).norm(), 1e-3F);
}

}  // namespace
}  // namespace selvedge::sim::test
