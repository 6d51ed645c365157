// Gains of the triangles that bend, and how often they are visited: a part of triangle_bending.h.
#include <algorithm>
#include <span>

#include "sim/cloth/block_lanes.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/kernels.h"
#include "sim/cloth/triangle_bending.h"

namespace selvedge {
namespace {

void hand_up(SolverLanes& lanes, const std::vector<BendRecord>& records) {
    for (const BendRecord& record : records) {
        for (std::size_t at = 0; at < kBlock; ++at) {
            lanes.asked[record.parent[at] / 4] += record.of_area[at] * record.handed_up[at];
        }
    }
}

void weigh_dirty(SolverState& solver, const Kernels& loops) {
    solver.lanes.dirty_bend.for_runs([&](std::size_t first, std::size_t count) {
        loops.weigh_bend(std::span(solver.blocks.bend).subspan(first, count),
                         std::span(solver.blocks.bend_records).subspan(first, count),
                         solver.lanes.inverse_masses.data());
    });
    solver.lanes.dirty_bend.clear();
}

}  // namespace

void weigh_bending(Cloth& cloth, const Kernels& loops) {
    SolverState& solver = cloth.solver;
    weigh_dirty(solver, loops);
    std::fill(solver.lanes.asked.begin(), solver.lanes.asked.end(), 0.0F);
    hand_up(solver.lanes, solver.blocks.bend_records);
}

// A refined triangle that begins to bend does so without friction's pull: its anchors did not follow it before, and are
// 0 as long as it does not.
void weigh_coarse_bending(Cloth& cloth, const Kernels& loops, int level) {
    SolverState& solver = cloth.solver;
    ParentLevel& parents = solver.blocks.parents[static_cast<std::size_t>(level)];
    std::vector<std::uint32_t>& idle = solver.lanes.idle_bends;
    idle.clear();
    for (const TriangleId t : cloth.mesh.refined_triangles(level)) {
        const std::uint32_t slot = solver.lanes.bend_of[t.value];
        parents.bend_records[slot / kBlock].asked[slot % kBlock] = solver.lanes.asked[place_of(t) / 4];
        if (parents.bend[slot / kBlock].realised[slot % kBlock] <= 0) idle.push_back(slot);
    }
    loops.weigh_coarse_bend(parents.bend, parents.bend_records,
                            solver.lanes.masses[static_cast<std::size_t>(level)].data());
    solver.lanes.dirty_coarse_bend[static_cast<std::size_t>(level)].clear();
    for (const std::uint32_t slot : idle) {
        CoarseBendBlock& block = parents.bend[slot / kBlock];
        const std::size_t at = slot % kBlock;
        if (block.realised[at] > 0) set_lane(block.anchor, at, curvature_now(cloth, block, at));
    }
    parents.bends = parents.bends_each = false;
    for (const TriangleId t : cloth.mesh.refined_triangles(level)) {
        const std::uint32_t slot = solver.lanes.bend_of[t.value];
        CoarseBendBlock& block = parents.bend[slot / kBlock];
        const bool bends = block.realised[slot % kBlock] > 0;
        if (!bends) set_lane(block.anchor, slot % kBlock, Vec3f::Zero());
        parents.bends = parents.bends || bends;
        parents.bends_each = parents.bends_each || block.is_each[slot % kBlock] > 0;
    }
    hand_up(solver.lanes, parents.bend_records);
}

}  // namespace selvedge
