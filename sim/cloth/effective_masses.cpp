#include "sim/cloth/effective_masses.h"

#include <algorithm>
#include <cstring>

#include "sim/cloth/cloth.h"
#include "sim/cloth/kernels.h"
#include "sim/cloth/limit_lists.h"
#include "sim/cloth/triangle_bending.h"

namespace selvedge {
namespace {

// Calls visit(v) for each vertex whose value changed, and keeps the new values.
template <class Visit>
void for_changed(const std::vector<float>& now, std::vector<float>& kept, const Visit& visit) {
    constexpr std::size_t kChunk = 16;
    kept.resize(now.size(), 0.0F);
    for (std::size_t first = 0; first < now.size(); first += kChunk) {
        const std::size_t count = std::min(kChunk, now.size() - first);
        if (std::memcmp(&now[first], &kept[first], count * sizeof(float)) == 0) continue;
        for (std::size_t v = first; v < first + count; ++v) {
            if (now[v] != kept[v]) visit(VertexId(static_cast<std::uint32_t>(v)));
            kept[v] = now[v];
        }
    }
}

void mark(DirtyBlocks& dirty, std::uint32_t slot) {
    if (slot != kSpare) dirty.mark_slot(slot);
}

// Of a leaf vertex: the leaves round it, and those beyond them, of whose bending it is an apex.
void mark_leaves_round(Cloth& cloth, VertexId v) {
    SolverLanes& lanes = cloth.solver.lanes;
    for (const TriangleId t : cloth.mesh.triangles_at(v)) {
        mark(lanes.dirty_stretch, lanes.stretch_of[t.value]);
        mark(lanes.dirty_bend, lanes.bend_of[t.value]);
        const AdaptiveTriangle& triangle = cloth.mesh.triangle(t);
        const EdgeId opposite = triangle.edges[(corner_at(triangle, v) + 1) % 3];
        for (const int side : {0, 1}) {
            const TriangleId beyond = cloth.mesh.leaf_at(opposite, side);
            if (beyond) mark(lanes.dirty_bend, lanes.bend_of[beyond.value]);
        }
    }
}

// The refined triangles of a level that have a corner whose mass changed: coarse corners carry all that is below them,
// so that a few changes reach many, and looking at all is cheaper than going from vertex to vertex.
void mark_limits(Cloth& cloth, std::size_t level, const std::vector<std::uint8_t>& is_changed) {
    SolverLanes& lanes = cloth.solver.lanes;
    const ParentLevel& parents = cloth.solver.blocks.parents[level];
    for (std::size_t i = 0; i < parents.triangles.size(); ++i) {
        unsigned changed = 0;
        for (const BlockPoints& corners : parents.triangles[i].vertices) {
            for (const std::uint32_t offset : corners) changed |= is_changed[offset / 4];
        }
        if (changed != 0) lanes.dirty_limits[level].mark_block(i);
    }
}

void mark_round_changed_masses(Cloth& cloth) {
    SolverLanes& lanes = cloth.solver.lanes;
    lanes.inverse_masses.resize(cloth.inverse_mass.size());
    for_changed(cloth.inverse_mass, lanes.inverse_masses, [&](VertexId v) {
        if (cloth.inverse_mass[v.value] > 0) mark_leaves_round(cloth, v);  // else it is gone, or all round it is new
    });
    lanes.inverse_masses.push_back(0.0F);  // of the spare point
    for (std::size_t level = 0; level < lanes.masses.size(); ++level) {
        bool has_changed = false;
        lanes.is_changed.assign(lanes.masses_now[level].size(), 0);
        for_changed(lanes.masses_now[level], lanes.masses[level], [&](VertexId v) {
            lanes.is_changed[v.value] = 1;
            has_changed = true;
        });
        if (has_changed) mark_limits(cloth, level, lanes.is_changed);
    }
}

}  // namespace

void update_effective_masses(Cloth& cloth) {
    const Kernels& loops = kernels(simd_level());
    SolverState& solver = cloth.solver;
    list_limit_masses(cloth);
    mark_round_changed_masses(cloth);
    solver.lanes.dirty_stretch.for_runs([&](std::size_t first, std::size_t count) {
        loops.weigh_stretch(std::span(solver.blocks.stretch).subspan(first, count),
                            std::span(solver.blocks.records).subspan(first, count), solver.lanes.inverse_masses.data());
    });
    solver.lanes.dirty_stretch.clear();
    weigh_bending(cloth, loops);
    for (int level = cloth.mesh.max_level(); level-- > 0;) weigh_coarse_bending(cloth, loops, level);
    weigh_limits(cloth, loops);
    solver.blocks.over.resize(solver.blocks.stretch.size());
    solver.blocks.over_counts.resize(solver.lanes.stretch.runs().size());
}

void mark_all_dirty(Cloth& cloth) {
    SolverState& solver = cloth.solver;
    SolverLanes& lanes = solver.lanes;
    lanes.dirty_stretch.mark_all(solver.blocks.stretch.size());
    lanes.dirty_bend.mark_all(solver.blocks.bend.size());
    for (std::size_t level = 0; level < solver.blocks.parents.size(); ++level) {
        lanes.dirty_limits[level].mark_all(solver.blocks.parents[level].triangles.size());
    }
}

}  // namespace selvedge
