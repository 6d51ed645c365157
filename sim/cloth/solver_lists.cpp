#include "sim/cloth/solver_lists.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

#include "sim/cloth/cloth.h"
#include "sim/cloth/kernels.h"
#include "sim/cloth/solver_state.h"
#include "sim/cloth/state_transfer.h"
#include "sim/cloth/triangle_bending.h"
#include "sim/mesh/sew.h"

namespace selvedge::sim {
namespace {

// Whether the rest length of a seam edge is more than kSeamEase below its length in the triangle's own panel: there the
// cloth is gathered, in puckers finer than the mesh.  (rest lengths of seams: thesis 4.3.1)
bool has_gathered_side(const AdaptiveMesh& mesh, const AdaptiveTriangle& triangle) {
    constexpr float kShortest = 1 - static_cast<float>(kSeamEase);
    for (std::size_t k = 0; k < 3; ++k) {
        const float own = (triangle.u[(k + 1) % 3] - triangle.u[k]).squaredNorm();
        const float rest = mesh.rest_length(triangle.edges[k]);
        if (rest * rest < kShortest * kShortest * own) return true;
    }
    return false;
}

bool has_gathers(const AdaptiveMesh& mesh) {
    for (std::uint32_t t = 0; t < mesh.base_triangle_count(); ++t) {
        if (has_gathered_side(mesh, mesh.triangle(TriangleId{t}))) return true;
    }
    return false;
}

// Triangles that touch a gathered side only by a corner count as gathered too. If they resisted compression, their
// sides would be too long for the triangles between them, whose third side is gathered, and would stretch those.
bool is_gathered(const AdaptiveMesh& mesh, const AdaptiveTriangle& leaf) {
    for (const VertexId corner : leaf.vertices) {
        for (const TriangleId t : mesh.triangles_at(corner)) {
            const AdaptiveTriangle& other = mesh.triangle(t);
            if (other.panel == leaf.panel && has_gathered_side(mesh, other)) return true;
        }
    }
    return false;
}

// Fills everything but the gains. t: a leaf.
void set_stretch(Cloth& cloth, TriangleId t, std::uint32_t slot) {
    const AdaptiveTriangle& leaf = cloth.mesh.triangle(t);
    Constraints& constraints = cloth.solver->constraints;
    StretchBlock& block = constraints.stretch.blocks[slot / kBlock];
    StretchRecord& record = constraints.stretch.records[slot / kBlock];
    const std::size_t at = slot % kBlock;
    const Fabric& fabric = cloth.material.fabrics[leaf.panel];
    const MaterialFrame frame = material_frame(leaf.u, cloth.material.grain_angles[leaf.panel]);
    set_frame(block, at, leaf.vertices, frame);
    block.longest[at] = 1 + static_cast<float>(fabric.strain_limit);
    block.push[at] = cloth.solver->lists.has_gathers && is_gathered(cloth.mesh, leaf) ? 0.0F : 1.0F;
    block.slip[at] = static_cast<float>(fabric.shear_hysteresis / (2 * fabric.shear)) / kStick;
    const SavedBias kept = saved_bias_of(cloth, t);
    set_values(block.bias, at, kept.value);
    block.anchor[at] = kept.anchor;
    record.compliance[0][at] = compliance_of(cloth, frame, fabric.stretch_warp);
    record.compliance[1][at] = compliance_of(cloth, frame, fabric.stretch_weft);
    record.compliance[2][at] = compliance_of(cloth, frame, fabric.shear);
    const ParentOf& parent = cloth.solver->lists.parent_of[t.value];
    record.parent[at] = parent.offset;
    record.of_area[at] = parent.of_area;
    constraints.triangle_of.resize(constraints.stretch.blocks.size() * kBlock, kNoBlockSlot);
    constraints.thirds.resize(constraints.stretch.blocks.size() * kBlock, 0.0F);
    constraints.triangle_of[slot] = t.value;
    constraints.thirds[slot] = third_of_mass(cloth, leaf.u, leaf.panel);
}

void make_stretch(Cloth& cloth) {
    SolverState& solver = *cloth.solver;
    solver.constraints.triangle_of.clear();
    solver.constraints.thirds.clear();
    solver.constraints.stretch.make(
        cloth.mesh.leaf_triangles(), solver.lists.vertices, [](const LeafTriangle& leaf) { return leaf.triangle; },
        [](const LeafTriangle& leaf) { return indices(leaf.v); },
        [&](const LeafTriangle& leaf, std::uint32_t slot) { set_stretch(cloth, leaf.triangle, slot); });
}

void change_stretch(Cloth& cloth, const LeafChanges& changes) {
    Constraints& constraints = cloth.solver->constraints;
    const std::size_t dummy_vertex = cloth.solver->lists.vertices;
    for (const TriangleId t : changes.triangles_removed) {
        save_bias(cloth, t);
        constraints.triangle_of[constraints.stretch.slot_of(t)] = kNoBlockSlot;
        constraints.stretch.remove(t, dummy_vertex);
    }
    for (const TriangleId t : changes.triangles_added) {
        constraints.stretch.insert(t, indices(cloth.mesh.triangle(t).vertices), dummy_vertex,
                                   [&](std::uint32_t slot) { set_stretch(cloth, t, slot); });
    }
}

void size_triangles(Cloth& cloth) {
    SolverState& solver = *cloth.solver;
    const std::size_t capacity = cloth.mesh.triangles().capacity();
    solver.lists.parent_of.resize(capacity);
    solver.lists.bearable_shear.resize(capacity + 1, 0.0F);
    LevelStress& stress = solver.constraints.stress;
    for (std::vector<Vec4f>* sums : {&stress.above, &stress.below, &stress.off}) {
        sums->resize(capacity + 1, Vec4f::Zero());
    }
}

void forget_triangles(SolverState& solver) {
    solver.lists.parent_of.clear();
    solver.constraints.stretch.forget();
    solver.constraints.bend.forget();
    for (ParentLevel& level : solver.constraints.parents) {
        level.limits.forget();
        level.bend.forget();
    }
    LevelStress& stress = solver.constraints.stress;
    for (std::vector<Vec4f>* sums : {&stress.above, &stress.below, &stress.off}) sums->clear();
}

// The coarse strain limits of refined triangles.

// The free length of a coarse strain limit: yarns may stretch as the fabric does under a usual load.
float longest_of(double stiffness, const Fabric& fabric) {
    constexpr double kUsualLoad = 2.5;     // N/m: a shirt hangs from its shoulders with about 1.6
    constexpr double kMinStretch = 0.005;  // strain error of the flat triangle through the corners of bent cloth
    return 1 + static_cast<float>(std::min(fabric.strain_limit, std::max(kMinStretch, kUsualLoad / stiffness)));
}

using Limits = ConstraintSet<LimitBlock, LimitRecord>;

void forget_stress(LevelStress& stress, TriangleId t) {
    stress.above[t.value + 1].setZero();
}

// Fills everything but the values that depend on masses. t: refined.
void set_limit(Cloth& cloth, TriangleId t, std::uint32_t slot) {
    const AdaptiveTriangle& triangle = cloth.mesh.triangle(t);
    Limits& limits = cloth.solver->constraints.parents[triangle.level].limits;
    LimitRecord& record = limits.records[slot / kBlock];
    const std::size_t at = slot % kBlock;
    const Fabric& fabric = cloth.material.fabrics[triangle.panel];
    const MaterialFrame frame = material_frame(triangle.u, cloth.material.grain_angles[triangle.panel]);
    set_frame(limits.blocks[slot / kBlock], at, triangle.vertices, frame);
    const std::array<double, 3> stiffness{fabric.stretch_warp, fabric.stretch_weft, fabric.shear};
    set_values(record.bias, at, saved_limit_of(cloth, t));
    for (std::size_t k = 0; k < 3; ++k) {
        record.compliance[k][at] = compliance_of(cloth, frame, stiffness[k]);
        if (k < 2) record.free_length[k][at] = longest_of(stiffness[k], fabric);
    }
    const ParentOf& parent = cloth.solver->lists.parent_of[t.value];
    record.offset[at] = stress_offset(t);
    record.parent[at] = parent.offset;
    record.of_area[at] = parent.of_area;
    LevelStress& stress = cloth.solver->constraints.stress;
    for (std::vector<Vec4f>* sums : {&stress.below, &stress.off}) (*sums)[t.value + 1].setZero();
}

// Adds a triangle's part of bearable_shear (LimitRecord) to its parent: kMaxLeafShearBias times the stress per unit of
// its bias (per_bias), plus what its inner triangles bear (inside), weighted by area.
void add_bearable_shear(SolverLists& lists, std::uint32_t parent, float of_area, float per_bias, float inside) {
    constexpr float kMaxLeafShearBias = 0.05F;  // a larger shear bias takes too long to accumulate
    lists.bearable_shear[parent / 4] += of_area * (kMaxLeafShearBias * per_bias + inside);
}

void add_bearable_shear_of_leaves(SolverState& solver) {
    std::fill(solver.lists.bearable_shear.begin(), solver.lists.bearable_shear.end(), 0.0F);
    const auto& stretch = solver.constraints.stretch;
    for (std::size_t i = 0; i < stretch.blocks.size(); ++i) {
        const StretchRecord& record = stretch.records[i];
        for (std::size_t at = 0; at < kBlock; ++at) {
            const float per_bias = stretch.blocks[i].shear[at] * record.compliance[2][at];
            add_bearable_shear(solver.lists, record.parent[at], record.of_area[at], per_bias, 0);
        }
    }
}

void add_bearable_shear_of_limits(SolverState& solver, ParentLevel& parents) {
    for (LimitRecord& record : parents.limits.records) {
        for (std::size_t at = 0; at < kBlock; ++at) {
            const float inside = solver.lists.bearable_shear[record.offset[at] / 4];
            const float per_bias = record.per_shear[at] * record.compliance[2][at];
            record.bearable_shear[at] = inside;
            add_bearable_shear(solver.lists, record.parent[at], record.of_area[at], per_bias, inside);
        }
    }
}

void make_limits(Cloth& cloth, int level) {
    SolverState& solver = *cloth.solver;
    solver.constraints.parents[static_cast<std::size_t>(level)].limits.make(
        cloth.mesh.refined_triangles(level), solver.lists.vertices, std::identity{},
        [&](TriangleId t) { return indices(cloth.mesh.triangle(t).vertices); },
        [&](TriangleId t, std::uint32_t slot) { set_limit(cloth, t, slot); });
}

// A released triangle was a leaf by then. An id that is in use again is treated as its new triangle.
void change_limits(Cloth& cloth, const LeafChanges& changes) {
    Constraints& constraints = cloth.solver->constraints;
    const std::size_t dummy_vertex = cloth.solver->lists.vertices;
    for (const TriangleId t : changes.refined_changed) {
        for (ParentLevel& level : constraints.parents) {
            if (level.limits.slot_of(t) == kNoBlockSlot) continue;
            save_limit(cloth, t, level);
            forget_stress(constraints.stress, t);
            level.limits.remove(t, dummy_vertex);
        }
    }
    for (const TriangleId t : changes.refined_changed) {
        const AdaptiveTriangle& triangle = cloth.mesh.triangle(t);
        if (is_leaf(triangle)) continue;
        constraints.parents[triangle.level].limits.insert(t, indices(triangle.vertices), dummy_vertex,
                                                          [&](std::uint32_t slot) { set_limit(cloth, t, slot); });
    }
}

// Lists the centres of split edges that can move, level by level.
void list_centres(Cloth& cloth) {
    for (int level = 0; level < cloth.mesh.max_level(); ++level) {
        std::vector<EdgeCentre>& centres = cloth.solver->constraints.parents[static_cast<std::size_t>(level)].centres;
        centres.clear();
        for (const EdgeId e : cloth.mesh.split_edges(level)) {
            const AdaptiveEdge& edge = cloth.mesh.edge(e);
            if (cloth.inverse_mass[edge.centre.value] <= 0) continue;
            centres.push_back({4 * edge.ends[0].value, 4 * edge.ends[1].value, 4 * edge.centre.value});
        }
    }
}

// Computes the effective masses of the corners of refined triangles, level by level. Pre: list_centres() was called.
//
// A refined triangle moves the cloth around its corners along. So the effective mass of a vertex includes all vertices
// that follow it: its own mass plus half of the effective mass of each edge centre between it and another vertex. Then
// corrections conserve linear momentum. Floats are summed in doubles, so the order does not matter.
void list_limit_masses(Cloth& cloth) {
    SolverState& solver = *cloth.solver;
    SolverLists& lists = solver.lists;
    lists.masses.resize(solver.constraints.parents.size());
    lists.masses_now.resize(solver.constraints.parents.size());
    std::vector<double>& sums = lists.mass_sums;
    sums.assign(lists.vertices + 1, 0.0);
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const float inverse = cloth.inverse_mass[v.value];
        sums[v.value] = inverse > 0 ? static_cast<double>(1 / inverse) : 0.0;
    }
    const auto add = [&](std::uint32_t to, double mass) {
        if (sums[to / 4] > 0) sums[to / 4] += 0.5 * mass;
    };
    for (std::size_t level = solver.constraints.parents.size(); level-- > 0;) {
        for (const EdgeCentre& c : solver.constraints.parents[level].centres) {
            add(c.a, sums[c.centre / 4]);
            add(c.b, sums[c.centre / 4]);
        }
        std::vector<float>& masses = lists.masses_now[level];
        masses.resize(sums.size());
        std::ranges::transform(sums, masses.begin(), [](double sum) { return static_cast<float>(sum); });
    }
}

// Computes the gains of dirty blocks from the masses, and bearable_shear from the gains of all blocks. Pre: the gains
// of the leaves' blocks are up to date. bearable_shear is recomputed for all triangles, because nearly every sum
// contains a changed value.
void update_limit_masses(Cloth& cloth, const Kernels& loops) {
    SolverState& solver = *cloth.solver;
    add_bearable_shear_of_leaves(solver);
    for (std::size_t level = solver.constraints.parents.size(); level-- > 0;) {
        ParentLevel& parents = solver.constraints.parents[level];
        parents.limits.update_dirty_masses([&](auto blocks, auto records) {
            loops.update_limit_masses(blocks, records, solver.lists.masses[level].data());
        });
        add_bearable_shear_of_limits(solver, parents);
    }
}

// Whether all blocks should be made anew: inserting slots one by one gives a worse memory layout than make().
bool is_fragmented(const Cloth& cloth) {
    const std::size_t leaves = cloth.mesh.leaf_triangles().size();
    const SolverState& solver = *cloth.solver;
    return solver.lists.vertices != cloth.mesh.vertex_capacity() || solver.lists.inserted > leaves ||
           solver.constraints.stretch.blocks.size() * kBlock > 2 * leaves + 64 * kBlock;
}

}  // namespace

float compliance_of(const Cloth& cloth, const MaterialFrame& frame, double stiffness) {
    const float own = static_cast<float>(stiffness) * (1 - kMomentum);
    return 1 / (frame.area * cloth.substep * cloth.substep) / own;
}

void note_children(Cloth& cloth, TriangleId t) {
    const AdaptiveTriangle& triangle = cloth.mesh.triangle(t);
    std::vector<ParentOf>& parent_of = cloth.solver->lists.parent_of;
    const float area = material_area(triangle.u);
    for (std::size_t i = 0; i < layout(triangle.configuration).triangle_count; ++i) {
        const TriangleId child = triangle.internal_triangles[i];
        if (child.value >= parent_of.size()) parent_of.resize(cloth.mesh.triangles().capacity());
        parent_of[child.value] = {stress_offset(t), material_area(cloth.mesh.triangle(child).u) / area};
    }
}

void make_blocks(Cloth& cloth) {
    SolverState& solver = *cloth.solver;
    save_biases(cloth);
    save_bends(cloth);
    solver.lists.vertices = cloth.mesh.vertex_capacity();
    solver.lists.inserted = 0;
    solver.lists.has_gathers = has_gathers(cloth.mesh);
    solver.lists.dummy = dummy_block<OverBlock>(solver.lists.vertices);
    const auto levels = static_cast<std::size_t>(cloth.mesh.max_level());
    solver.constraints.parents.resize(levels);
    forget_triangles(solver);
    size_triangles(cloth);
    for (int level = 0; level < cloth.mesh.max_level(); ++level) {
        for (const TriangleId t : cloth.mesh.refined_triangles(level)) note_children(cloth, t);
    }
    make_stretch(cloth);
    make_bending(cloth);
    for (int level = 0; level < cloth.mesh.max_level(); ++level) make_limits(cloth, level);
    list_centres(cloth);
    update_effective_masses(cloth);
}

void change_blocks(Cloth& cloth) {
    const LeafChanges& changes = cloth.mesh.changes();
    cloth.solver->lists.inserted += changes.triangles_added.size();
    if (is_fragmented(cloth)) {
        make_blocks(cloth);
        return;
    }
    size_triangles(cloth);
    change_stretch(cloth, changes);
    change_bending(cloth, changes);
    change_limits(cloth, changes);
    list_centres(cloth);
    update_effective_masses(cloth);
}

namespace {

// Calls visit(v) for each vertex whose value changed, and stores the new values in `kept`.
template <class Visit>
void for_changed(const std::vector<float>& now, std::vector<float>& kept, const Visit& visit) {
    constexpr std::size_t kChunk = 16;  // values that are compared at once: few change
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
    if (slot != kNoBlockSlot) set.dirty.mark_slot(slot);
}

// Marks the leaves round a leaf vertex, and their neighbours opposite to it, in whose bending it is an apex.
void mark_leaves_round(Cloth& cloth, VertexId v) {
    Constraints& constraints = cloth.solver->constraints;
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

// Marks the blocks of refined triangles that contain a vertex with a changed mass. Coarse corners include the masses of
// all vertices that follow, so a few changes affect many; testing all blocks is cheaper than going vertex by vertex.
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
    SolverLists& lists = cloth.solver->lists;
    lists.inverse_masses.resize(cloth.inverse_mass.size());
    for_changed(cloth.inverse_mass, lists.inverse_masses, [&](VertexId v) {
        if (cloth.inverse_mass[v.value] > 0) mark_leaves_round(cloth, v);  // else removed, or all constraints are new
    });
    lists.inverse_masses.push_back(0.0F);  // of the dummy vertex
    for (std::size_t level = 0; level < lists.masses.size(); ++level) {
        bool has_changed = false;
        lists.is_changed.assign(lists.masses_now[level].size(), 0);
        for_changed(lists.masses_now[level], lists.masses[level], [&](VertexId v) {
            lists.is_changed[v.value] = 1;
            has_changed = true;
        });
        if (!has_changed) continue;
        ParentLevel& parents = cloth.solver->constraints.parents[level];
        mark_blocks_with(parents.limits, lists.is_changed);
        mark_blocks_with(parents.bend, lists.is_changed);
    }
}

}  // namespace

void update_effective_masses(Cloth& cloth) {
    const Kernels& loops = kernels(simd_level());
    SolverState& solver = *cloth.solver;
    list_limit_masses(cloth);
    mark_round_changed_masses(cloth);
    Constraints& constraints = solver.constraints;
    constraints.stretch.update_dirty_masses([&](auto blocks, auto records) {
        loops.update_stretch_masses(blocks, records, solver.lists.inverse_masses.data());
    });
    update_bending_masses(cloth, loops);
    for (int level = cloth.mesh.max_level(); level-- > 0;) update_coarse_bending_masses(cloth, loops, level);
    update_limit_masses(cloth, loops);
    solver.lists.over.resize(constraints.stretch.blocks.size());
    solver.lists.over_counts.resize(constraints.stretch.coloring.runs().size());
}

}  // namespace selvedge::sim
