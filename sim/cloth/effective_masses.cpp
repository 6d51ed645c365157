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

template <class Set>
void mark(Set& set, TriangleId t) {
    const std::uint32_t slot = set.slot_of(t);
    if (slot != kSpare) set.dirty.mark_slot(slot);
}

// Of a leaf vertex: the leaves round it, and those beyond them, of whose bending it is an apex.
void mark_leaves_round(Cloth& cloth, VertexId v) {
    Constraints& constraints = cloth.solver.constraints;
    for (const TriangleId t : cloth.mesh.triangles_at(v)) {
        mark(constraints.stretch, t);
        mark(constraints.bend, t);
        const AdaptiveTriangle& triangle = cloth.mesh.triangle(t);
        const EdgeId opposite = triangle.edges[(corner_at(triangle, v) + 1) % 3];
        for (const int side : {0, 1}) {
            const TriangleId beyond = cloth.mesh.leaf_at(opposite, side);
            if (beyond) mark(constraints.bend, beyond);
        }
    }
}

// Of refined triangles of a level: the blocks that hold a vertex whose mass changed. Coarse corners carry all that is
// below them, so that a few changes reach many, and looking at all is cheaper than going from vertex to vertex.
template <class Set>
void mark_blocks_with(Set& set, const std::vector<std::uint8_t>& is_changed) {
    for (std::size_t i = 0; i < set.blocks.size(); ++i) {
        unsigned changed = 0;
        for (const BlockPoints& points : set.blocks[i].vertices) {
            for (const std::uint32_t offset : points) changed |= is_changed[offset / 4];
        }
        if (changed != 0) set.dirty.mark_block(i);
    }
}

void mark_round_changed_masses(Cloth& cloth) {
    SolverLists& lists = cloth.solver.lists;
    lists.inverse_masses.resize(cloth.inverse_mass.size());
    for_changed(cloth.inverse_mass, lists.inverse_masses, [&](VertexId v) {
        if (cloth.inverse_mass[v.value] > 0) mark_leaves_round(cloth, v);  // else it is gone, or all round it is new
    });
    lists.inverse_masses.push_back(0.0F);  // of the spare point
    for (std::size_t level = 0; level < lists.masses.size(); ++level) {
        bool has_changed = false;
        lists.is_changed.assign(lists.masses_now[level].size(), 0);
        for_changed(lists.masses_now[level], lists.masses[level], [&](VertexId v) {
            lists.is_changed[v.value] = 1;
            has_changed = true;
        });
        if (!has_changed) continue;
        ParentLevel& parents = cloth.solver.constraints.parents[level];
        mark_blocks_with(parents.limits, lists.is_changed);
        mark_blocks_with(parents.bend, lists.is_changed);
    }
}

}  // namespace

void update_effective_masses(Cloth& cloth) {
    const Kernels& loops = kernels(simd_level());
    SolverState& solver = cloth.solver;
    list_limit_masses(cloth);
    mark_round_changed_masses(cloth);
    Constraints& constraints = solver.constraints;
    constraints.stretch.weigh_dirty(
        [&](auto blocks, auto records) { loops.weigh_stretch(blocks, records, solver.lists.inverse_masses.data()); });
    weigh_bending(cloth, loops);
    for (int level = cloth.mesh.max_level(); level-- > 0;) weigh_coarse_bending(cloth, loops, level);
    weigh_limits(cloth, loops);
    solver.lists.over.resize(constraints.stretch.blocks.size());
    solver.lists.over_counts.resize(constraints.stretch.coloring.runs().size());
}

}  // namespace selvedge
