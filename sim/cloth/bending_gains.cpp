// Gains of the triangles that bend, and how often they are visited: a part of triangle_bending.h.
#include <algorithm>
#include <span>

#include "sim/cloth/block_lanes.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/kernels.h"
#include "sim/cloth/triangle_bending.h"

namespace selvedge {
namespace {

void hand_up(SolverLists& lists, const std::vector<BendRecord>& records) {
    for (const BendRecord& record : records) {
        for (std::size_t at = 0; at < kBlock; ++at) {
            lists.asked[record.parent[at] / 4] += record.of_area[at] * record.handed_up[at];
        }
    }
}

}  // namespace

void weigh_bending(Cloth& cloth, const Kernels& loops) {
    SolverState& solver = cloth.solver;
    solver.constraints.bend.weigh_dirty(
        [&](auto blocks, auto records) { loops.weigh_bend(blocks, records, solver.lists.inverse_masses.data()); });
    std::fill(solver.lists.asked.begin(), solver.lists.asked.end(), 0.0F);
    hand_up(solver.lists, solver.constraints.bend.records);
}

// A refined triangle that begins to bend does so without friction's pull, from its present curvature. The anchors of
// one that does not bend mean nothing, for a visit of its block may write them; they are cleared, so that blocks hold
// the same bits whatever came before.
void weigh_coarse_bending(Cloth& cloth, const Kernels& loops, int level) {
    SolverState& solver = cloth.solver;
    ParentLevel& parents = solver.constraints.parents[static_cast<std::size_t>(level)];
    auto& bend = parents.bend;
    std::vector<std::uint32_t>& idle = solver.lists.idle_bends;
    idle.clear();
    for (const TriangleId t : cloth.mesh.refined_triangles(level)) {
        const std::uint32_t slot = bend.slot_of(t);
        float& asked = bend.records[slot / kBlock].asked[slot % kBlock];
        const float now = solver.lists.asked[place_of(t) / 4];
        if (asked != now) bend.dirty.mark_slot(slot);
        asked = now;
        if (bend.blocks[slot / kBlock].realised[slot % kBlock] <= 0) idle.push_back(slot);
    }
    const float* const masses = solver.lists.masses[static_cast<std::size_t>(level)].data();
    bend.weigh_dirty([&](auto blocks, auto records) { loops.weigh_coarse_bend(blocks, records, masses); });
    for (const std::uint32_t slot : idle) {
        CoarseBendBlock& block = bend.blocks[slot / kBlock];
        const std::size_t at = slot % kBlock;
        if (block.realised[at] > 0) set_lane(block.anchor, at, curvature_now(cloth, block, at));
    }
    parents.interval = kNeverVisited;
    for (const TriangleId t : cloth.mesh.refined_triangles(level)) {
        const std::uint32_t slot = bend.slot_of(t);
        CoarseBendBlock& block = bend.blocks[slot / kBlock];
        if (block.realised[slot % kBlock] <= 0) set_lane(block.anchor, slot % kBlock, Vec3f::Zero());
        parents.interval = std::min(parents.interval, block.interval[slot % kBlock]);
    }
    hand_up(solver.lists, bend.records);
}

}  // namespace selvedge
