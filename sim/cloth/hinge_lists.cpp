#include "sim/cloth/hinge_lists.h"

#include <algorithm>
#include <cmath>

#include "sim/cloth/bias.h"
#include "sim/cloth/block_lists.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/kernels.h"

namespace selvedge {
namespace {

using BendLists = BlockLists<BendBlock, BendRecord>;

BendLists bend_lists(SolverState& solver) {
    return {solver.blocks.bend, solver.blocks.bend_records, solver.lanes.bend, solver.lanes.dirty_bend};
}

// Rigidity against folding about an edge: the cloth bends across it.
float hinge_rigidity(const Fabric& fabric, const Vec2f& along, float grain_angle) {
    const float across_warp = weft_direction(grain_angle).dot(along);  // edge along the weft: the warp bends
    const float share = across_warp * across_warp;
    return static_cast<float>(fabric.bending_warp) * share + static_cast<float>(fabric.bending_weft) * (1 - share);
}

// With cotangent weights of the unfolded rest state the sum of q_i x_i is the mean curvature vector about the hinge.
std::array<float, 4> hinge_weights(const Hinge& hinge) {
    const Vec2f a(-0.5F * hinge.rest_length, 0);
    const Vec2f b(0.5F * hinge.rest_length, 0);
    const auto cotangent = [](const Vec2f& p, const Vec2f& q) {
        return p.dot(q) / std::abs(p.x() * q.y() - p.y() * q.x());
    };
    const float left_a = cotangent(b - a, hinge.left_at - a);
    const float right_a = cotangent(b - a, hinge.right_at - a);
    const float left_b = cotangent(a - b, hinge.left_at - b);
    const float right_b = cotangent(a - b, hinge.right_at - b);
    return {left_b + right_b, left_a + right_a, -left_a - left_b, -right_a - right_b};
}

// What belongs to the fabric and the shape of a hinge.
struct HingeFabric {
    float rigidity = 0;    // N m
    float hysteresis = 0;  // N, KES 2HB
};
HingeFabric hinge_fabric(const Cloth& cloth, const Hinge& hinge) {
    HingeFabric mean;
    const AdaptiveEdge& edge = cloth.mesh.edge(hinge.edge);
    for (std::size_t side = 0; side < 2; ++side) {
        const std::uint16_t panel = cloth.mesh.triangle(edge.sides[side]).panel;
        const Fabric& fabric = cloth.fabrics[panel];
        mean.rigidity += 0.5F * hinge_rigidity(fabric, hinge.along[side], cloth.grain_angles[panel]);
        mean.hysteresis += 0.5F * static_cast<float>(fabric.bending_hysteresis);
    }
    return mean;
}

// Where nothing was kept of an edge, friction starts from how the cloth is bent.
void set_memory(Cloth& cloth, EdgeId edge, std::uint32_t lane) {
    BendBlock& block = cloth.solver.blocks.bend[lane / kBlock];
    const std::size_t at = lane % kBlock;
    const KeptBend kept = kept_bend(cloth, edge);
    block.pull[at] = kept.pull;
    block.anchor[at] = kept.anchor;
    if (kept.corners != corners_at(block, at)) cloth.solver.lanes.held.push_back({lane, kept.held});
}

// All but the gains. Energy 1/2 B / (A_left + A_right) |sum q x|^2.
//
// A moment is the derivative of energy by sum q x where the cloth bends across the edge alone. Bent elsewhere, the
// three edges of a triangle share it, and their frictions add up to 1 to 1.7 times as much, 1.44 on an average.
void set_bend(Cloth& cloth, const Hinge& hinge, std::uint32_t lane) {
    constexpr float kFrictionShare = 1 / 1.44F;
    constexpr float kLeast = 1e-12F;  // N m: what bends more easily is limp, and has no spring for friction to act on
    const std::array<std::uint32_t, 4> corners = indices(hinge);
    const std::array<float, 4> q = hinge_weights(hinge);
    const float area = 0.5F * hinge.rest_length * (hinge.left_at.y() - hinge.right_at.y());
    const float time = cloth.substep * cloth.substep;
    const HingeFabric fabric = hinge_fabric(cloth, hinge);
    BendBlock& block = cloth.solver.blocks.bend[lane / kBlock];
    BendRecord& record = cloth.solver.blocks.bend_records[lane / kBlock];
    const std::size_t at = lane % kBlock;
    for (std::size_t i = 0; i < 4; ++i) {
        block.vertices[i][at] = 4 * corners[i];
        block.q[i][at] = q[i];
    }
    block.bow[at] = 0.25F / (hinge.rest_length * hinge.rest_length);
    record.compliance[0][at] = area / (std::max(fabric.rigidity, kLeast) * time);
    record.friction[at] = fabric.rigidity > kLeast ? 0.5F * fabric.hysteresis * time * kFrictionShare : 0.0F;
    record.length[at] = hinge.rest_length;
    set_memory(cloth, hinge.edge, lane);
    cloth.solver.lanes.bend_of[hinge.edge.value] = lane;
}

// Where more than one hinge of so many gets less than half of its stiffness from a visit now and then, all are visited
// in each sub-step, until far fewer do; what others miss their pull makes up for.
int chosen_interval(const Cloth& cloth) {
    constexpr std::size_t kFew = 20, kFewer = 40;
    if (cloth.bend_interval == 1) return 1;
    const std::size_t count = cloth.solver.lanes.short_hinge_count;
    const bool is_each = cloth.solver.blocks.bend_interval == 1;
    return (is_each ? kFewer : kFew) * count < cloth.mesh.hinges().size() ? cloth.bend_interval : 1;
}

// Those of each block are kept, so that only dirty ones are counted anew.
void count_short_hinges(Cloth& cloth, const Kernels& loops) {
    SolverLanes& lanes = cloth.solver.lanes;
    const SolverBlocks& blocks = cloth.solver.blocks;
    lanes.short_hinges.resize(blocks.bend.size(), 0);
    lanes.dirty_bend.for_runs([&](std::size_t first, std::size_t count) {
        for (std::size_t i = first; i < first + count; ++i) {
            lanes.short_hinge_count -= lanes.short_hinges[i];
            lanes.short_hinges[i] = static_cast<std::uint8_t>(loops.count_short_hinges(
                {&blocks.bend[i], 1}, {&blocks.bend_records[i], 1}, cloth.bend_interval, lanes.inverse_masses.data()));
            lanes.short_hinge_count += lanes.short_hinges[i];
        }
    });
}

}  // namespace

void make_hinges(Cloth& cloth) {
    SolverState& solver = cloth.solver;
    solver.lanes.bend_of.assign(cloth.mesh.edges().capacity(), kSpare);
    solver.lanes.short_hinges.clear();
    solver.lanes.short_hinge_count = 0;
    bend_lists(solver).make(
        cloth.mesh.hinges(), solver.lanes.vertices, [](const Hinge& hinge) { return indices(hinge); },
        [&](const Hinge& hinge, std::uint32_t lane) { set_bend(cloth, hinge, lane); });
}

void change_hinges(Cloth& cloth, const LeafChanges& changes) {
    SolverState& solver = cloth.solver;
    BendLists lists = bend_lists(solver);
    solver.lanes.bend_of.resize(cloth.mesh.edges().capacity(), kSpare);
    const auto take_out = [&](EdgeId e) {
        std::uint32_t& lane = solver.lanes.bend_of[e.value];
        if (lane != kSpare) lists.give_back(lane, solver.lanes.vertices);
    };
    const auto put_in = [&](EdgeId e) {
        const Hinge* hinge = cloth.mesh.hinge(e);
        if (hinge != nullptr) set_bend(cloth, *hinge, lists.take(indices(*hinge), solver.lanes.vertices));
    };
    for (const EdgeId e : changes.edges_come) keep_bend(cloth, e);  // it may have gone and come again
    for (const EdgeId e : changes.hinges_changed) keep_bend(cloth, e);
    for (const EdgeId e : changes.edges_gone) take_out(e);
    for (const EdgeId e : changes.hinges_changed) take_out(e);
    for (const EdgeId e : changes.edges_come) put_in(e);
    for (const EdgeId e : changes.hinges_changed) put_in(e);
}

void weigh_hinges(Cloth& cloth, const Kernels& loops) {
    SolverBlocks& blocks = cloth.solver.blocks;
    SolverLanes& lanes = cloth.solver.lanes;
    if (cloth.bend_interval > 1) count_short_hinges(cloth, loops);
    blocks.bend_interval = chosen_interval(cloth);
    const float time = cloth.substep * cloth.substep * static_cast<float>(blocks.bend_interval);
    const float scale = blocks.bend_time > 0 ? time / blocks.bend_time : 1.0F;
    if (time != blocks.bend_time) lanes.dirty_bend.mark_all(blocks.bend.size());
    lanes.dirty_bend.for_runs([&](std::size_t first, std::size_t count) {
        loops.weigh_bend(std::span(blocks.bend).subspan(first, count),
                         std::span(blocks.bend_records).subspan(first, count),
                         {.interval = blocks.bend_interval, .pull_scale = scale}, lanes.inverse_masses.data());
    });
    lanes.dirty_bend.clear();
    blocks.bend_time = time;
    for (const auto& [lane, held] : lanes.held) {
        BendBlock& block = blocks.bend[lane / kBlock];
        const std::size_t at = lane % kBlock;
        block.anchor[at] = bending_now(cloth, block, at) - held * block.slip[at];
    }
    lanes.held.clear();
}

std::uint32_t bend_lane(const Cloth& cloth, EdgeId e) {
    const SolverState& solver = cloth.solver;
    if (e.value >= solver.lanes.bend_of.size()) return kSpare;
    const std::uint32_t lane = solver.lanes.bend_of[e.value];
    if (lane == kSpare) return kSpare;
    const std::array<VertexId, 2>& ends = cloth.mesh.edge(e).ends;
    const std::array<std::uint32_t, 4> corners = corners_at(solver.blocks.bend[lane / kBlock], lane % kBlock);
    return corners[0] == ends[0].value && corners[1] == ends[1].value ? lane : kSpare;
}

}  // namespace selvedge
