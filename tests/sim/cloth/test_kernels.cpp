// Internal constraints conserve linear and angular momentum, and kernels of all SIMD levels agree.
#include "sim/cloth/kernels.h"
#include "sim/cloth/solver_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/cloth.h"
#include "tests/sim/cloth/fixtures.h"

namespace selvedge::sim::test {
namespace {

using Points = std::vector<Vec4f>;

bool have_same_bits(const Points& a, const Points& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec4f)) == 0;
}

// The change of linear and angular momentum by a change of positions, and the sum of the magnitudes over the vertices.
struct Push {
    Vec3d linear = Vec3d::Zero();
    Vec3d angular = Vec3d::Zero();
    double size = 0;  // sum of |m dx|
};
Push push_between(const Cloth& cloth, const Points& before, const Points& after) {
    Push push;
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        if (cloth.inverse_mass[v.value] <= 0) continue;
        const Vec3d x = before[v.value].head<3>().cast<double>();
        const Vec3d impulse = (after[v.value].head<3>().cast<double>() - x) / double(cloth.inverse_mass[v.value]);
        push.linear += impulse;
        push.angular += x.cross(impulse);
        push.size += impulse.norm();
    }
    return push;
}

// Angular momentum is taken at the positions from which a constraint was solved. So blocks are solved one by one:
// within a block no two constraints share a vertex.
template <class Block>
void expect_no_push(const Cloth& cloth, std::vector<Block> blocks,
                    const std::function<void(std::span<Block>, Points&)>& solve, double torque_share) {
    double size = 0;
    Vec3d linear = Vec3d::Zero();
    Points points = solver_points(cloth, cloth.x);
    for (Block& block : blocks) {
        const Points before = points;
        solve(std::span(&block, 1), points);
        const Push push = push_between(cloth, before, points);
        EXPECT_LT(push.linear.norm(), 1e-3 * push.size + 1e-10);
        EXPECT_LT(push.angular.norm(), torque_share * push.size + 1e-10);
        size += push.size;
        linear += push.linear;
    }
    EXPECT_GT(size, 1e-5) << "nothing was corrected, so nothing was tested";
    EXPECT_LT(linear.norm(), 1e-4 * size);
}

// Near the origin and stiff in bending, so that the rounding of positions is small against the corrections.
Cloth flat_patch(int level) {
    Fabric fabric = find_fabric("denim");
    fabric.bending_warp = 0.2;  // N m
    fabric.bending_weft = 0.1;
    fabric.bending_hysteresis = 0.5;  // N
    fabric.shear_hysteresis = 4;      // N/m
    Cloth cloth = make_patch(fabric, {.height = 0});
    refine(cloth, level);
    return cloth;
}

Cloth shaken_patch(std::mt19937& random, float reach) {
    Cloth cloth = flat_patch(1);
    shake(cloth, reach, random);
    return cloth;
}

void centre_split_edges(Cloth& cloth) {
    for (int level = 0; level < cloth.mesh.max_level(); ++level) {
        for (const EdgeId e : cloth.mesh.split_edges(level)) {
            cloth.x[cloth.mesh.centre(e).value] =
                (cloth.x[cloth.mesh.end(e, 0).value] + cloth.x[cloth.mesh.end(e, 1).value]) / 2;
        }
    }
}

// Solves blocks of refined triangles of one level and moves the vertices that follow their corners.
void limit_and_prolong(const Cloth& cloth, const Kernels& loops, std::span<const LimitBlock> blocks, std::size_t level,
                       Points& points, LimitRecord* records = nullptr, std::span<CoarseBendBlock> bend = {}) {
    Points stress = points;
    loops.solve_coarse_limits(blocks, records, floats(points));
    loops.solve_coarse_bend(bend, floats(points), 2);
    for (std::size_t below = level; below < cloth.solver->constraints.parents.size(); ++below) {
        loops.prolong_centres(cloth.solver->constraints.parents[below].centres, floats(stress), floats(points));
    }
}

class KernelsAtLevel : public testing::TestWithParam<SimdLevel> {
 protected:
    void SetUp() override {
        if (GetParam() > detected_simd_level()) GTEST_SKIP() << "not on this processor";
    }
    const Kernels& loops() const { return kernels(GetParam()); }
};

// The same blocks with a third of the constraints marked as gathered by a seam.
std::vector<StretchBlock> with_gathers(std::vector<StretchBlock> blocks) {
    for (StretchBlock& block : blocks) {
        for (std::size_t at = 0; at < kBlock; at += 3) block.push[at] = 0;
    }
    return blocks;
}

// Shear uses unit vectors of warp and weft, so its torque vanishes only to the order of their strain, about 20 % here.
// A wrong gradient would cause a torque of at least 0.05 m (the arm) times the force.
TEST_P(KernelsAtLevel, stretch_and_shear_push_and_turn_nothing_as_a_whole) {
    std::mt19937 random(11);
    const Cloth cloth = shaken_patch(random, 0.01F);
    expect_no_push<StretchBlock>(
        cloth, with_gathers(cloth.solver->constraints.stretch.blocks),
        [&](auto one, Points& points) {
            std::vector<OverBlock> over(one.size());
            loops().solve_stretch(one, nullptr, floats(points), over.data(), cloth.solver->lists.dummy);
        },
        0.01);
}

// Forces use the heights at rest, so their torque vanishes to the order of the strain, which is nearly 0 in a roll.
Cloth rolled_patch(int level) {
    constexpr float kCurvature = 8;  // 1/m
    Cloth cloth = flat_patch(level);
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const Vec4f p = cloth.x[v.value];
        const float s = 0.8F * p.x() + 0.6F * p.z(), t = 0.8F * p.z() - 0.6F * p.x();
        const float along = std::sin(kCurvature * s) / kCurvature;
        cloth.x[v.value] =
            Vec4f(0.8F * along - 0.6F * t, (1 - std::cos(kCurvature * s)) / kCurvature, 0.6F * along + 0.8F * t, 0);
    }
    cloth.x_prev = cloth.x;
    return cloth;
}

TEST_P(KernelsAtLevel, bending_pushes_nothing_and_turns_nothing) {
    const auto expect = [&](const Cloth& cloth, double torque_share) {
        expect_no_push<BendBlock>(
            cloth, cloth.solver->constraints.bend.blocks,
            [&](auto one, Points& points) { loops().solve_bend(one, floats(points), 2); }, torque_share);
    };
    std::mt19937 random(12);
    expect(rolled_patch(1), 0.001);
    expect(shaken_patch(random, 0.01F), 0.05);
}

TEST_P(KernelsAtLevel, bending_of_refined_triangles_pushes_nothing_and_turns_little) {
    Cloth cloth = rolled_patch(2);
    for (const std::size_t level : {0U, 1U}) {
        expect_no_push<CoarseBendBlock>(
            cloth, cloth.solver->constraints.parents[level].bend.blocks,
            [&](auto one, Points& points) {
                Points stress = points;
                loops().solve_coarse_bend(one, floats(points), 2);
                for (std::size_t below = level; below < cloth.solver->constraints.parents.size(); ++below) {
                    loops().prolong_centres(cloth.solver->constraints.parents[below].centres, floats(stress),
                                            floats(points));
                }
            },
            0.02);
    }
}

// Half of the mass of each centre counts at each end of its edge. This conserves linear momentum. It conserves angular
// momentum only if each centre is in the middle of its edge, and here vertices are displaced by 0.03 m.
TEST_P(KernelsAtLevel, limits_of_refined_triangles_push_nothing_and_turn_little) {
    std::mt19937 random(13);
    Cloth cloth = flat_patch(2);
    shake(cloth, 0.03F, random);
    centre_split_edges(cloth);
    for (const std::size_t level : {0U, 1U}) {
        expect_no_push<LimitBlock>(
            cloth, cloth.solver->constraints.parents[level].limits.blocks,
            [&](auto one, Points& points) { limit_and_prolong(cloth, loops(), one, level, points); }, 0.02);
    }
}

TEST_P(KernelsAtLevel, bending_leaves_a_flat_patch_flat_however_it_lies) {
    Cloth cloth = make_patch(find_fabric("denim"), {.height = 0});
    refine(cloth, 2);
    move_to(cloth, Eigen::AngleAxisf(1.0F, Vec3f(1, 2, 3).normalized()).toRotationMatrix(), Vec3f(0.1F, 0.2F, 0.3F));
    Points points = solver_points(cloth, cloth.x);
    loops().solve_bend(cloth.solver->constraints.bend.blocks, floats(points), 2);
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        EXPECT_LT((points[v.value] - with_zero_w(cloth.x[v.value].head<3>())).head<3>().norm(), 1e-6F);
    }
}

float thread_length(const LimitBlock& block, std::size_t at, const std::array<BlockFloats, 2>& along,
                    const Points& points) {
    const auto corner = [&](std::size_t i) { return Vec3f(points[block.vertices[i][at] / 4].head<3>()); };
    return (along[0][at] * (corner(1) - corner(0)) + along[1][at] * (corner(2) - corner(0))).norm();
}

TEST_P(KernelsAtLevel, a_limit_takes_back_what_is_longer_and_touches_nothing_shorter) {
    std::mt19937 random(14);
    const Cloth cloth = shaken_patch(random, 0.01F);
    int longer = 0, shorter = 0;
    for (const LimitBlock& block : cloth.solver->constraints.parents[0].limits.blocks) {
        const Points before = solver_points(cloth, cloth.x);
        Points after = before;
        loops().solve_coarse_limits(std::span(&block, 1), nullptr, floats(after));
        for (std::size_t at = 0; at < kBlock; ++at) {
            if (block.vertices[0][at] / 4 + 1 == before.size()) continue;
            const float warp = thread_length(block, at, block.a, before);
            const float weft = thread_length(block, at, block.b, before);
            const bool is_warp = warp > block.longest_warp[at], is_weft = weft > block.longest_weft[at];
            if (!is_warp && !is_weft) {
                for (const BlockPoints& v : block.vertices) EXPECT_EQ(after[v[at] / 4], before[v[at] / 4]);
                ++shorter;
            } else if (!is_weft) {
                const float now = thread_length(block, at, block.a, after);
                EXPECT_LT(now, warp);
                EXPECT_GT(now, block.longest_warp[at] - 1e-5F) << "half is taken back at most";
                ++longer;
            }
        }
    }
    EXPECT_GT(longer, 0);
    EXPECT_GT(shorter, 0);
}

// Calls every kernel once, on a randomly displaced patch with two pinned vertices.
struct Sweep {
    Points points, before, lost, query_point, plane;
    std::vector<StretchRecord> records;
    std::vector<StretchBlock> stretch;
    std::vector<BendBlock> bend;
    std::vector<ParentLevel> parents;
    std::vector<std::uint32_t> over, found;
};
void move_biases(const Kernels& loops, Sweep& s, LevelStress stress) {
    const BiasGains gains{.stretch = 0.1F, .shear = 0.05F};
    const StressSums sums{.above = floats(stress.above), .below = floats(stress.below), .off = floats(stress.off)};
    for (const ParentLevel& level : s.parents) loops.prolong_stress(level.limits.records, floats(stress.above));
    loops.update_bias(s.stretch, s.records, floats(s.points), floats(s.before), gains, sums);
    for (std::size_t i = s.parents.size(); i-- > 0;) {
        loops.update_limit_biases(s.parents[i].limits.blocks, s.parents[i].limits.records, gains, sums);
    }
    for (const std::vector<Vec4f>* scratch : {&stress.below, &stress.off}) {
        for (const Vec4f& sum : *scratch) EXPECT_EQ(sum, Vec4f(Vec4f::Zero()));
    }
}

Sweep swept(const Kernels& loops) {
    std::mt19937 random(15);
    Cloth cloth = flat_patch(2);
    shake(cloth, 0.004F, random);
    cloth.is_pinned[0] = cloth.is_pinned[7] = true;
    refresh_solver(cloth);
    const Constraints& constraints = cloth.solver->constraints;
    Sweep s;
    s.points = s.before = solver_points(cloth, cloth.x);
    s.lost.assign(s.points.size(), Vec4f::Zero());
    s.query_point.assign(s.points.size(), Vec4f(0, 0, 0, 0.1F));
    s.plane.assign(s.points.size(), Vec4f(0, 1, 0, -0.002F));
    for (std::size_t v = 0; v < s.points.size(); v += 3) {
        s.query_point[v] = s.points[v];  // the point lies on the body
        s.query_point[v].w() = 0;
    }
    s.records = constraints.stretch.records;
    s.stretch = with_gathers(constraints.stretch.blocks);
    s.bend = constraints.bend.blocks;
    s.parents = constraints.parents;
    loops.predict(floats(s.points), floats(s.before), floats(s.lost), cloth.x.size(),
                  {.keep = 0.9F, .fall = {1e-4F, -1e-3F, 2e-4F}});
    for (std::size_t level = 0; level < constraints.parents.size(); ++level) {
        limit_and_prolong(cloth, loops, constraints.parents[level].limits.blocks, level, s.points,
                          s.parents[level].limits.records.data(), s.parents[level].bend.blocks);
    }
    loops.solve_bend(s.bend, floats(s.points), 2);
    for (const BlockColoring::Run& run : cloth.solver->constraints.stretch.coloring.runs()) {
        const std::span<StretchBlock> some = std::span(s.stretch).subspan(run.first, run.count);
        std::vector<OverBlock> over(run.count);
        over.resize(
            loops.solve_stretch(some, &s.records[run.first], floats(s.points), over.data(), cloth.solver->lists.dummy));
        loops.limit_stretch(over, floats(s.points));
        for (const OverBlock& block : over)
            s.over.insert(s.over.end(), block.vertices[0].begin(), block.vertices[0].end());
    }
    move_biases(loops, s, constraints.stress);
    loops.apply_internal_damping(s.stretch, floats(s.points), floats(s.before), 0.2F);
    s.found.resize(s.points.size() + kBlock);
    const std::vector<float> friction(s.points.size(), 0.4F);
    s.found.resize(loops.project_vertices(floats(s.points), floats(s.before), {floats(s.query_point), floats(s.plane)},
                                          friction.data(), cloth.x.size(), {.longest_move = 0.003F, .floor = -0.01F},
                                          s.found.data()));
    return s;
}

TEST_P(KernelsAtLevel, never_move_what_is_pinned) {
    std::mt19937 random(15);
    Cloth cloth = flat_patch(2);
    shake(cloth, 0.004F, random);
    const Sweep s = swept(loops());
    for (const std::size_t v : {0U, 7U}) EXPECT_EQ(s.points[v].head<3>(), cloth.x[v].head<3>());
    EXPECT_NE(s.points[1].head<3>(), cloth.x[1].head<3>());
}

INSTANTIATE_TEST_SUITE_P(Simd, KernelsAtLevel, testing::Values(SimdLevel::Plain, SimdLevel::Avx2, SimdLevel::Avx512),
                         [](const auto& instance) { return std::string(name_of(instance.param)); });

bool have_same_bits(const std::vector<StretchBlock>& a, const std::vector<StretchBlock>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const StretchBlock& p, const StretchBlock& q) {
        return p.bias == q.bias && p.anchor == q.anchor;
    });
}
template <class Block>
bool have_same_anchors(const std::vector<Block>& a, const std::vector<Block>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Block& p, const Block& q) { return p.anchor == q.anchor; });
}

bool have_same_bits(const std::vector<ParentLevel>& a, const std::vector<ParentLevel>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const ParentLevel& p, const ParentLevel& q) {
        return have_same_anchors(p.bend.blocks, q.bend.blocks) &&
               std::equal(p.limits.records.begin(), p.limits.records.end(), q.limits.records.begin(),
                          q.limits.records.end(),
                          [](const LimitRecord& r, const LimitRecord& t) { return r.bias == t.bias; });
    });
}

bool has_learnt(const std::vector<ParentLevel>& parents) {
    const auto accumulated = [](const LimitRecord& record) { return record.bias != LimitRecord{}.bias; };
    return std::ranges::all_of(
        parents, [&](const ParentLevel& p) { return std::ranges::any_of(p.limits.records, accumulated); });
}

TEST(Kernels, of_avx2_and_avx512_give_the_same_bits) {
    if (detected_simd_level() < SimdLevel::Avx512) GTEST_SKIP() << "no AVX-512 on this processor";
    const Sweep narrow = swept(kernels(SimdLevel::Avx2)), wide = swept(kernels(SimdLevel::Avx512));
    EXPECT_TRUE(have_same_bits(narrow.points, wide.points));
    EXPECT_TRUE(have_same_bits(narrow.before, wide.before));
    EXPECT_TRUE(have_same_bits(narrow.stretch, wide.stretch));
    EXPECT_TRUE(have_same_anchors(narrow.bend, wide.bend));
    EXPECT_TRUE(have_same_bits(narrow.parents, wide.parents));
    EXPECT_TRUE(has_learnt({narrow.parents[0], narrow.parents[1]}));
    EXPECT_EQ(narrow.over, wide.over);
    EXPECT_EQ(narrow.found, wide.found);
    EXPECT_FALSE(narrow.over.empty());
    EXPECT_FALSE(narrow.found.empty());
}

TEST(Kernels, of_avx2_and_avx512_weigh_bending_with_the_same_bits) {
    if (detected_simd_level() < SimdLevel::Avx512) GTEST_SKIP() << "no AVX-512 on this processor";
    const Cloth cloth = flat_patch(2);
    const SolverLists& lists = cloth.solver->lists;
    Constraints narrow = cloth.solver->constraints, wide = narrow;
    std::vector<float> inverse_masses = lists.inverse_masses;  // differ from those that the gains were made for
    for (float& w : inverse_masses) w *= 2;
    const auto update_masses = [&](const Kernels& loops, Constraints& constraints) {
        loops.update_bend_masses(constraints.bend.blocks, constraints.bend.records, inverse_masses.data());
        loops.update_coarse_bend_masses(constraints.parents[1].bend.blocks, constraints.parents[1].bend.records,
                                        lists.masses[1].data());
    };
    update_masses(kernels(SimdLevel::Avx2), narrow);
    update_masses(kernels(SimdLevel::Avx512), wide);
    EXPECT_EQ(
        std::memcmp(narrow.bend.blocks.data(), wide.bend.blocks.data(), narrow.bend.blocks.size() * sizeof(BendBlock)),
        0);
    const std::vector<CoarseBendBlock>&a = narrow.parents[1].bend.blocks, &b = wide.parents[1].bend.blocks;
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(CoarseBendBlock)), 0);
    EXPECT_NE(std::memcmp(narrow.bend.blocks.data(), cloth.solver->constraints.bend.blocks.data(), sizeof(BendBlock)),
              0);
}

TEST(Kernels, without_fused_multiplication_are_off_by_rounding_only) {
    if (detected_simd_level() < SimdLevel::Avx2) GTEST_SKIP() << "no AVX2 on this processor";
    constexpr float kFewUlps = 4 * 1.2e-7F;  // of a metre
    const Sweep plain = swept(kernels(SimdLevel::Plain)), fused = swept(kernels(SimdLevel::Avx2));
    ASSERT_EQ(plain.points.size(), fused.points.size());
    for (std::size_t v = 0; v < plain.points.size(); ++v) {
        EXPECT_LT((plain.points[v] - fused.points[v]).head<3>().norm(), kFewUlps);
        EXPECT_LT((plain.before[v] - fused.before[v]).head<3>().norm(), kFewUlps);
    }
    EXPECT_EQ(plain.over, fused.over);
    EXPECT_EQ(plain.found, fused.found);
}

// A patch dropped on the ball, with adaptation, contacts and friction.
Points dropped(SimdLevel level) {
    const SimdLimit limit(level);
    Cloth cloth = make_patch(find_fabric("silk"), {.side = 0.5, .quads = 6, .height = 1.16});
    for (int i = 0; i < 60; ++i) {
        if (i % 4 == 0) adapt_cloth(cloth, ball());
        step(cloth, ball(), {});
    }
    EXPECT_GT(cloth.mesh.leaf_triangles().size(), cloth.mesh.base_triangle_count());
    return cloth.x;
}

TEST(Kernels, of_avx2_and_avx512_dress_a_ball_with_the_same_bits) {
    if (detected_simd_level() < SimdLevel::Avx512) GTEST_SKIP() << "no AVX-512 on this processor";
    EXPECT_TRUE(have_same_bits(dropped(SimdLevel::Avx2), dropped(SimdLevel::Avx512)));
}

}  // namespace
}  // namespace selvedge::sim::test
