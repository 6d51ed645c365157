// Internal friction in bending and shear: hysteresis loops of the measured width, residual bends, no gain of energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/kernels.h"
#include "sim/cloth/solver_blocks.h"
#include "sim/cloth/solver_state.h"
#include "sim/cloth/triangle_bending.h"
#include "tests/sim/cloth/fixtures.h"

namespace selvedge::sim::test {
namespace {

// A fabric with friction, equal along warp and weft, without damping.
Fabric rubbing(double bending_hysteresis, double shear_hysteresis = 0) {
    Fabric fabric = undamped();
    fabric.bending_warp = fabric.bending_weft = 1e-5;  // N m
    fabric.bending_hysteresis = bending_hysteresis;
    fabric.shear_hysteresis = shear_hysteresis;
    return fabric;
}

// Rolls the flat cloth about a horizontal axis without stretch, with zero velocity. curvature: 1/m.
void roll(Cloth& cloth, const std::vector<Vec4f>& flat, float curvature) {
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const Vec4f& p = flat[v.value];
        const float angle = curvature * p.y();
        if (angle == 0) {
            cloth.x[v.value] = p;
        } else {
            cloth.x[v.value] = Vec4f(p.x(), std::sin(angle) / curvature, (1 - std::cos(angle)) / curvature, 0);
        }
    }
    cloth.x_prev = cloth.x;
}

double area_of(const Cloth& cloth) {
    double area = 0;
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) area += static_cast<double>(material_area(leaf.u));
    return area;
}

// A strip that is rolled to given curvatures, and the forces that it then has.
struct Roll {
    Cloth cloth;
    std::vector<Vec4f> flat;

    explicit Roll(const Fabric& fabric)
        : cloth(make_strip(fabric, {.width = 0.2, .length = 0.2, .mesh_angle = 0.3, .level = 2})), flat(cloth.x) {
        const Vec4f middle = with_zero_w(centre_of_mass(cloth).cast<float>());
        for (Vec4f& p : flat) p -= middle;
        roll(cloth, flat, 0);
        cloth.is_pinned.assign(cloth.is_pinned.size(), false);
        refresh_solver(cloth);
    }
    Roll(const Roll&) = delete;
    Roll& operator=(const Roll&) = delete;

    // The displacements by one iteration over all triangles.
    std::vector<Vec4f> visit() {
        std::vector<Vec4f> points = solver_points(cloth, cloth.x);
        kernels(simd_level()).solve_bend(cloth.solver->constraints.bend.blocks, floats(points), 2);
        return points;
    }
    // The bending moment per width, N, from the virtual work of a small change of curvature.
    double moment_at(float curvature) {
        constexpr float kLittle = 0.1F;  // 1/m
        roll(cloth, flat, curvature + kLittle);
        const std::vector<Vec4f> further = cloth.x;
        roll(cloth, flat, curvature);
        const std::vector<Vec4f> moved = visit();
        double work = 0;
        for (const VertexId v : cloth.mesh.leaf_vertices()) {
            const Vec3d way = (further[v.value] - cloth.x[v.value]).head<3>().cast<double>() / double(kLittle);
            const Vec3d move = (moved[v.value] - cloth.x[v.value]).head<3>().cast<double>();
            work -= move.dot(way) / double(cloth.inverse_mass[v.value]);
        }
        const double time = double(cloth.substep) * double(cloth.substep) * interval();
        return work / time / area_of(cloth);
    }
    // The number of sub-steps between two solves; the same for all leaves, because they are large.
    double interval() const {
        const std::vector<BendBlock>& blocks = cloth.solver->constraints.bend.blocks;
        float least = kNeverSolved, most = 0;
        for (const BendBlock& block : blocks) {
            for (const float interval : block.interval) {
                if (interval == kNeverSolved) continue;
                least = std::min(least, interval);
                most = std::max(most, interval);
            }
        }
        EXPECT_EQ(least, most);
        return static_cast<double>(least);
    }
    // Mean curvature along the strip, 1/m, over triangles that are not at its edges.
    double curvature() const {
        double sum = 0, area = 0;
        for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
            const BendSlot slot = bend_slot(cloth, leaf.triangle);
            if (values_at(slot.block->own, slot.at).minCoeff() <= 0) continue;
            const double a = double(material_area(leaf.u));
            sum += a * double(curvature_now(cloth, *slot.block, slot.at).x());
            area += a;
        }
        return sum / area;
    }
};

// So heavy that one iteration corrects only 1 % of an angle: the impulses are then proportional to the moment.
Fabric heavy(Fabric fabric) {
    fabric.area_density = 1;  // kg/m^2
    return fabric;
}

constexpr float kMaxCurvature = 20;  // 1/m

void bend_slowly(Roll& strip, float from, float to) {
    constexpr int kSteps = 40;
    for (int i = 0; i <= kSteps; ++i) strip.moment_at(from + (to - from) * static_cast<float>(i) / kSteps);
}

double loop_width(double hysteresis) {
    Roll strip(heavy(rubbing(hysteresis)));
    bend_slowly(strip, 0, kMaxCurvature);
    bend_slowly(strip, kMaxCurvature, -kMaxCurvature);
    bend_slowly(strip, -kMaxCurvature, 0);
    const double going_up = strip.moment_at(0);
    bend_slowly(strip, 0, kMaxCurvature);
    bend_slowly(strip, kMaxCurvature, 0);
    return going_up - strip.moment_at(0);
}

TEST(FrictionInside, makes_a_loop_of_moment_against_curvature_that_is_2hb_wide) {
    for (const double hysteresis : {5e-5, 1e-4}) {
        EXPECT_NEAR(loop_width(hysteresis), hysteresis, 0.25 * hysteresis);
    }
}

TEST(FrictionInside, leaves_the_slope_of_the_loop_to_the_rigidity) {
    Roll strip(heavy(rubbing(1e-4)));
    bend_slowly(strip, 0, kMaxCurvature);
    const double before = strip.moment_at(kMaxCurvature);
    EXPECT_NEAR((strip.moment_at(kMaxCurvature + 2) - before) / 2, 1e-5, 0.3e-5);
}

// Not exactly: chords of a roll are shorter than its arcs, and forces use the heights at rest.
TEST(FrictionInside, leaves_the_moment_of_sharp_folds_in_proportion_to_their_angle) {
    Roll strip(heavy(rubbing(1e-4)));
    const double slip = 2 * 1e-4 / 1e-5;  // 1/m, far beyond where friction slips
    const float start = static_cast<float>(slip);
    bend_slowly(strip, 0, start);
    const double at_start = strip.moment_at(start), a_little_on = strip.moment_at(start + 2);
    bend_slowly(strip, start, 3 * start);
    const double slope = (a_little_on - at_start) / 2;
    EXPECT_NEAR((strip.moment_at(3 * start) - at_start) / double(2 * start), slope, 0.12 * slope);
}

TEST(FrictionInside, costs_nothing_where_the_fabric_has_none) {
    const auto is_any = [](const BlockFloats& row) { return std::ranges::any_of(row, [](float f) { return f > 0; }); };
    const auto remember = [&](const Cloth& cloth) {
        return std::ranges::any_of(cloth.solver->constraints.bend.blocks,
                                   [&](const BendBlock& b) { return is_any(b.has_friction); }) ||
               std::ranges::any_of(cloth.solver->constraints.stretch.blocks,
                                   [&](const StretchBlock& b) { return is_any(b.stick); });
    };
    EXPECT_FALSE(remember(make_strip(rubbing(0), {.level = 2})));
    EXPECT_TRUE(remember(make_strip(rubbing(1e-4), {.level = 2})));
    EXPECT_TRUE(remember(make_strip(rubbing(0, 2), {.level = 2})));
}

TEST(FrictionInside, does_not_hold_bent_cloth_back_from_turning) {
    Roll strip(heavy(rubbing(1e-4)));
    bend_slowly(strip, 0, kMaxCurvature);
    const auto size = [&] {
        const std::vector<Vec4f> moved = strip.visit();
        double sum = 0;
        for (const VertexId v : strip.cloth.mesh.leaf_vertices()) {
            sum += double((moved[v.value] - strip.cloth.x[v.value]).head<3>().norm());
        }
        return sum;
    };
    const double before = size();
    move_to(strip.cloth, Eigen::AngleAxisf(2.0F, Vec3f(1, 2, 3).normalized()).toRotationMatrix(), Vec3f::Zero());
    EXPECT_NEAR(size(), before, 0.02 * before);
}

TEST(FrictionInside, does_nothing_in_limp_cloth) {
    Fabric fabric = rubbing(1e-4);
    fabric.bending_warp = fabric.bending_weft = 0;
    Cloth cloth = make_patch(fabric, {.height = 1});
    std::mt19937 random(6);
    shake(cloth, 0.01F, random);
    run(cloth, nothing_near(), {.contact = {.floor = kNoFloor}}, 0.1);
    EXPECT_FALSE(find_bad_vertex(cloth).has_value());
}

const StepOptions kFree{.gravity = Vec3f::Zero(), .extra_damping = 5, .contact = {.floor = kNoFloor}};

// The residual curvature, 1/m, of a strip that was made flat, bent and released.
double residual(Roll& strip, double seconds) {
    run(strip.cloth, nothing_near(), kFree, seconds);
    return strip.curvature();
}

TEST(FrictionInside, keeps_a_bend_that_was_let_go_in_proportion_to_2hb) {
    std::vector<double> kept;
    for (const double hysteresis : {0.0, 5e-5, 1e-4}) {
        Roll strip(rubbing(hysteresis));
        roll(strip.cloth, strip.flat, kMaxCurvature);
        kept.push_back(residual(strip, 3));
    }
    EXPECT_NEAR(kept[0], 0, 0.2);
    const double balanced = 0.5 * 1e-4 / 1e-5;  // 1/m, where the moments of rigidity and friction are equal
    EXPECT_GT(kept[2], 0.4 * balanced);
    EXPECT_LT(kept[2], 1.3 * balanced);
    EXPECT_NEAR(kept[1] / kept[2], 0.5, 0.15);
}

TEST(FrictionInside, brings_cloth_to_rest_and_does_not_let_it_creep) {
    Roll strip(rubbing(1e-4));
    roll(strip.cloth, strip.flat, kMaxCurvature);
    const double soon = residual(strip, 3);
    EXPECT_NEAR(residual(strip, 6), soon, 0.02 * soon);
}

Fabric immovable(Fabric fabric) {
    fabric.area_density = 1e6;  // kg/m^2
    return fabric;
}

// Shears all leaves equally in a loop of slow steps; measures the stress, N/m, to which the biases have converged.
struct Shearing {
    Cloth cloth = make_patch(immovable(rubbing(0, 2.5)), {.height = 0});
    std::vector<Vec4f> flat = cloth.x;

    double stress_at(float shear) {
        for (const VertexId v : cloth.mesh.leaf_vertices()) {
            cloth.x[v.value] = flat[v.value] + Vec4f(shear * flat[v.value].z(), 0, 0, 0);
        }
        Constraints& constraints = cloth.solver->constraints;
        const Kernels& loops = kernels(simd_level());
        std::vector<Vec4f> points = solver_points(cloth, cloth.x);
        std::vector<Vec4f> before = points;
        const StressSums sums{.above = floats(constraints.stress.above),
                              .below = floats(constraints.stress.below),
                              .off = floats(constraints.stress.off)};
        for (int i = 0; i < 20; ++i) {
            loops.solve_stretch(constraints.stretch.blocks, constraints.stretch.records.data(), floats(points),
                                cloth.solver->lists.over.data(), cloth.solver->lists.dummy);
            loops.update_bias(constraints.stretch.blocks, constraints.stretch.records, floats(points), floats(before),
                              {.shear = 1}, sums);
        }
        const StretchRecord& record = constraints.stretch.records.front();
        return -double(record.multiplier[2][0] * record.compliance[2][0]) * cloth.material.fabrics.front().shear;
    }
};

TEST(FrictionInside, makes_a_loop_of_stress_against_shear_that_is_2hg_wide) {
    Shearing patch;
    constexpr float kShear = 0.1F;  // rad
    patch.stress_at(kShear);
    const double down = patch.stress_at(0);
    patch.stress_at(-kShear);
    EXPECT_NEAR(std::abs(patch.stress_at(0) - down), 2.5, 0.05);
}

// Flat strips that oscillate without damping: for each half second the maximum kinetic energy, relative to the initial
// one.
std::vector<double> swing(double hysteresis) {
    constexpr float kSpeed = 40;               // 1/(m s), of the parabola about the middle
    constexpr float kMean = 0.2F * 0.2F / 12;  // m^2, so that the strip as a whole stays
    constexpr int kWindows = 8;
    const StepOptions options{.gravity = Vec3f::Zero(), .internal_damping = 0, .contact = {.floor = kNoFloor}};
    Roll strip(rubbing(hysteresis));
    Cloth& cloth = strip.cloth;
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const float y = cloth.x[v.value].y() - static_cast<float>(centre_of_mass(cloth).y());
        cloth.x_prev[v.value].z() -= kSpeed * (y * y - kMean) * cloth.substep;
    }
    const double given = double(speed_now(cloth));
    std::vector<double> shares(kWindows, 0.0);
    for (double& share : shares) {
        for (int i = 0; i < 50; ++i) {
            run(cloth, nothing_near(), options, 0.01);
            share = std::max(share, std::pow(double(speed_now(cloth)) / given, 2));
        }
    }
    return shares;
}

TEST(FrictionInside, takes_energy_and_never_gives_any) {
    // The strip oscillates in several modes, so the share of kinetic energy at a given time differs between types of
    // processor.
    constexpr double kExchanged = 0.01;
    const std::vector<double> elastic = swing(0), damped = swing(1e-4);
    for (std::size_t i = 0; i < damped.size(); ++i) EXPECT_LT(damped[i], i == 0 ? 1.001 : damped[i - 1] + kExchanged);
    EXPECT_LT(damped.back(), 0.5 * elastic.back() + kExchanged);
}

// Displaces the vertices at random and updates the anchors of friction.
void bend_at_random(Cloth& cloth, unsigned seed) {
    std::mt19937 random(seed);
    shake(cloth, 0.01F, random);
    std::vector<Vec4f> points = solver_points(cloth, cloth.x);
    kernels(simd_level()).solve_bend(cloth.solver->constraints.bend.blocks, floats(points), 2);
}

// The anchor of friction of a leaf or a refined triangle.
Vec3f anchor_of(const Cloth& cloth, TriangleId t) {
    const BendSlot slot = bend_slot(cloth, t);
    return values_at(slot.block->anchor, slot.at);
}

struct AnchoredLeaf {
    LeafTriangle leaf;
    Vec3f anchor = Vec3f::Zero();
};
std::vector<AnchoredLeaf> anchors(const Cloth& cloth) {
    std::vector<AnchoredLeaf> found;
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles())
        found.push_back({leaf, anchor_of(cloth, leaf.triangle)});
    return found;
}
bool has_inside(const LeafTriangle& outer, const LeafTriangle& inner) {
    return distance_to_triangle((inner.u[0] + inner.u[1] + inner.u[2]) / 3, outer.u) <= 0;
}

const AdaptClothOptions kCoarse{.criteria = {.collision = false, .curvature = false, .length = false}};
const AdaptClothOptions kFine{.criteria = {.collision = false, .curvature = false, .length = false},
                              .minimum_levels = {&kDab, 1}};

TEST(FrictionInside, goes_on_where_triangles_stay_and_in_what_they_are_split_into) {
    Cloth cloth = make_patch(rubbing(1e-4), {.height = 0});
    bend_at_random(cloth, 3);
    const std::vector<AnchoredLeaf> before = anchors(cloth);
    ASSERT_GT(adapt_cloth(cloth, nothing_near(), kFine).splits, 0);
    int kept = 0, handed_on = 0;
    for (const AnchoredLeaf& now : anchors(cloth)) {
        const auto from =
            std::ranges::find_if(before, [&](const AnchoredLeaf& old) { return has_inside(old.leaf, now.leaf); });
        ASSERT_NE(from, before.end());
        EXPECT_EQ(now.anchor, from->anchor);
        ++(now.leaf.u == from->leaf.u ? kept : handed_on);
    }
    EXPECT_GT(kept, 10);
    EXPECT_GT(handed_on, 10);
}

TEST(FrictionInside, of_a_triangle_that_comes_back_is_the_mean_of_what_was_inside_it) {
    Cloth cloth = make_patch(rubbing(1e-4), {.height = 0});
    ASSERT_GT(adapt_cloth(cloth, nothing_near(), kFine).splits, 0);
    bend_at_random(cloth, 4);
    const std::vector<AnchoredLeaf> before = anchors(cloth);
    ASSERT_GT(adapt_cloth(cloth, nothing_near(), kCoarse).rejoins, 0);
    int differ = 0;
    for (const AnchoredLeaf& now : anchors(cloth)) {
        Vec3f sum = Vec3f::Zero();
        for (const AnchoredLeaf& old : before) {
            if (has_inside(now.leaf, old.leaf)) sum += old.anchor * material_area(old.leaf.u);
        }
        const Vec3f mean = sum / material_area(now.leaf.u);
        EXPECT_LT((now.anchor - mean).norm(), 1e-4F * (mean.norm() + 1));
        differ += now.anchor.norm() > 0.1F;
    }
    EXPECT_GT(differ, 10);
}

TEST(FrictionInside, outlives_blocks_that_are_made_anew) {
    Cloth cloth = make_patch(rubbing(1e-4), {.height = 0});
    bend_at_random(cloth, 5);
    const std::vector<AnchoredLeaf> before = anchors(cloth);
    shake(cloth, 0.01F, *std::make_unique<std::mt19937>(6));
    refresh_solver(cloth);
    for (const AnchoredLeaf& old : before) EXPECT_EQ(anchor_of(cloth, old.leaf.triangle), old.anchor);
}

}  // namespace
}  // namespace selvedge::sim::test
