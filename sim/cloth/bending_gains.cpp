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

// A refined triangle that begins to bend does so without friction's pull: its anchors did not follow it before, and are
// 0 as long as it does not.
void weigh_coarse_bending(Cloth& cloth, const Kernels& loops, int level) {
    SolverState& solver = cloth.solver;
    ParentLevel& parents = solver.constraints.parents[static_cast<std::size_t>(level)];
    auto& bend = parents.bend;
    std::vector<std::uint32_t>& idle = solver.lists.idle_bends;
    idle.clear();
    for (const TriangleId t : cloth.mesh.refined_triangles(level)) {
        const std::uint32_t lane = bend.lane_of(t);
        bend.records[lane / kBlock].asked[lane % kBlock] = solver.lists.asked[place_of(t) / 4];
        if (bend.blocks[lane / kBlock].realised[lane % kBlock] <= 0) idle.push_back(lane);
    }
    loops.weigh_coarse_bend(bend.blocks, bend.records, solver.lists.masses[static_cast<std::size_t>(level)].data());
    bend.dirty.clear();
    for (const std::uint32_t lane : idle) {
        CoarseBendBlock& block = bend.blocks[lane / kBlock];
        const std::size_t at = lane % kBlock;
        if (block.realised[at] > 0) set_lane(block.anchor, at, curvature_now(cloth, block, at));
    }
    parents.bends = parents.bends_each = false;
    for (const TriangleId t : cloth.mesh.refined_triangles(level)) {
        const std::uint32_t lane = bend.lane_of(t);
        CoarseBendBlock& block = bend.blocks[lane / kBlock];
        const bool bends = block.realised[lane % kBlock] > 0;
        if (!bends) set_lane(block.anchor, lane % kBlock, Vec3f::Zero());
        parents.bends = parents.bends || bends;
        parents.bends_each = parents.bends_each || block.is_each[lane % kBlock] > 0;
    }
    hand_up(solver.lists, bend.records);
}

}  // namespace selvedge
