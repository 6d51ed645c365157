#include "sim/cloth/solver_lists.h"

#include <algorithm>
#include <cmath>

#include "sim/cloth/bias.h"
#include "sim/cloth/block_lists.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/effective_masses.h"
#include "sim/cloth/limit_lists.h"
#include "sim/cloth/triangle_bending.h"

namespace selvedge {
namespace {

using StretchLists = BlockLists<StretchBlock, StretchRecord>;

StretchLists stretch_lists(SolverState& solver) {
    return {solver.blocks.stretch, solver.blocks.records, solver.lanes.stretch, solver.lanes.dirty_stretch};
}

// Whether a seam edge of the triangle has to be shorter than the triangle's own copy of it: there the cloth is
// gathered, in puckers finer than the mesh.  (SPEC 3.2)
bool is_gathered(const AdaptiveMesh& mesh, const AdaptiveTriangle& triangle) {
    constexpr float kEase = 0.95F;
    for (std::size_t k = 0; k < 3; ++k) {
        const float own = (triangle.u[(k + 1) % 3] - triangle.u[k]).squaredNorm();
        const float rest = mesh.rest_length(triangle.edges[k]);
        if (rest * rest < kEase * kEase * own) return true;
    }
    return false;
}

// All but the gains. t: a leaf.
void set_stretch(Cloth& cloth, TriangleId t, std::uint32_t lane) {
    const AdaptiveTriangle& leaf = cloth.mesh.triangle(t);
    SolverBlocks& blocks = cloth.solver.blocks;
    StretchBlock& block = blocks.stretch[lane / kBlock];
    StretchRecord& record = blocks.records[lane / kBlock];
    const std::size_t at = lane % kBlock;
    const Fabric& fabric = cloth.fabrics[leaf.panel];
    const MaterialFrame frame = material_frame(leaf.u, cloth.grain_angles[leaf.panel]);
    set_frame(block, at, leaf.vertices, frame);
    block.longest[at] = 1 + static_cast<float>(fabric.strain_limit);
    block.push[at] = is_gathered(cloth.mesh, leaf) ? 0.0F : 1.0F;
    block.slip[at] = static_cast<float>(fabric.shear_hysteresis / (2 * fabric.shear)) / kStick;
    const KeptBias kept = kept_bias(cloth, t);
    set_lane(block.bias, at, kept.value);
    block.anchor[at] = kept.anchor;
    record.compliance[0][at] = compliance_of(cloth, frame, fabric.stretch_warp);
    record.compliance[1][at] = compliance_of(cloth, frame, fabric.stretch_weft);
    record.compliance[2][at] = compliance_of(cloth, frame, fabric.shear);
    const ParentOf& parent = cloth.solver.lanes.parent_of[t.value];
    record.parent[at] = parent.place;
    record.of_area[at] = parent.of_area;
    blocks.triangle_of.resize(blocks.stretch.size() * kBlock, kSpare);
    blocks.thirds.resize(blocks.stretch.size() * kBlock, 0.0F);
    blocks.triangle_of[lane] = t.value;
    blocks.thirds[lane] = third_of_mass(cloth, leaf.u, leaf.panel);
    cloth.solver.lanes.stretch_of[t.value] = lane;
}

void make_stretch(Cloth& cloth) {
    SolverState& solver = cloth.solver;
    solver.blocks.triangle_of.clear();
    solver.blocks.thirds.clear();
    stretch_lists(solver).make(
        cloth.mesh.leaf_triangles(), solver.lanes.vertices, [](const LeafTriangle& leaf) { return indices(leaf.v); },
        [&](const LeafTriangle& leaf, std::uint32_t lane) { set_stretch(cloth, leaf.triangle, lane); });
}

void change_stretch(Cloth& cloth, const LeafChanges& changes) {
    SolverState& solver = cloth.solver;
    StretchLists lists = stretch_lists(solver);
    for (const TriangleId t : changes.triangles_gone) {
        std::uint32_t& lane = solver.lanes.stretch_of[t.value];
        keep_bias(cloth, t);
        solver.blocks.triangle_of[lane] = kSpare;
        lists.give_back(lane, solver.lanes.vertices);
    }
    for (const TriangleId t : changes.triangles_come) {
        set_stretch(cloth, t, lists.take(indices(cloth.mesh.triangle(t).vertices), solver.lanes.vertices));
    }
}

void size_triangles(Cloth& cloth) {
    SolverState& solver = cloth.solver;
    const std::size_t capacity = cloth.mesh.triangles().capacity();
    solver.lanes.stretch_of.resize(capacity, kSpare);
    solver.lanes.limit_of.resize(capacity, kSpare);
    solver.lanes.limit_level.resize(capacity, 0);
    solver.lanes.parent_of.resize(capacity);
    solver.lanes.easy_shear.resize(capacity + 1, 0.0F);
    CarriedStress& carried = solver.blocks.carried;
    for (std::vector<Vec4f>* stress : {&carried.own, &carried.above, &carried.below}) {
        stress->resize(capacity + 1, Vec4f::Zero());
    }
}

void forget_triangles(SolverState& solver) {
    solver.lanes.stretch_of.clear();
    solver.lanes.limit_of.clear();
    solver.lanes.limit_level.clear();
    solver.lanes.parent_of.clear();
    CarriedStress& carried = solver.blocks.carried;
    for (std::vector<Vec4f>* stress : {&carried.own, &carried.above, &carried.below}) stress->clear();
}

// Lanes that are put in one by one lie less well in memory than those that are put in all at once.
bool is_worn(const Cloth& cloth) {
    const std::size_t leaves = cloth.mesh.leaf_triangles().size();
    const SolverState& solver = cloth.solver;
    return solver.lanes.vertices != cloth.mesh.vertex_capacity() || solver.lanes.inserted > leaves ||
           solver.blocks.stretch.size() * kBlock > 2 * leaves + 64 * kBlock;
}

}  // namespace

// Over a sub-step, of a triangle of that stiffness, of which momentum makes a share.  (XPBD)
float compliance_of(const Cloth& cloth, const MaterialFrame& frame, double stiffness) {
    const float own = static_cast<float>(stiffness) * (1 - kMomentum);
    return 1 / (frame.area * cloth.substep * cloth.substep) / own;
}

void note_children(Cloth& cloth, TriangleId t) {
    const AdaptiveTriangle& triangle = cloth.mesh.triangle(t);
    std::vector<ParentOf>& parent_of = cloth.solver.lanes.parent_of;
    const float area = material_area(triangle.u);
    for (std::size_t i = 0; i < layout(triangle.configuration).triangle_count; ++i) {
        const TriangleId child = triangle.internal_triangles[i];
        if (child.value >= parent_of.size()) parent_of.resize(cloth.mesh.triangles().capacity());
        parent_of[child.value] = {place_of(t), material_area(cloth.mesh.triangle(child).u) / area};
    }
}

std::uint32_t stretch_lane(const Cloth& cloth, TriangleId t) {
    const SolverState& solver = cloth.solver;
    if (t.value >= solver.lanes.stretch_of.size()) return kSpare;
    const std::uint32_t lane = solver.lanes.stretch_of[t.value];
    if (lane == kSpare) return kSpare;
    const StretchBlock& block = solver.blocks.stretch[lane / kBlock];
    return corners_at(block, lane % kBlock) == indices(cloth.mesh.triangle(t).vertices) ? lane : kSpare;
}

void make_blocks(Cloth& cloth) {
    SolverState& solver = cloth.solver;
    keep_biases(cloth);
    keep_bends(cloth);
    solver.lanes.vertices = cloth.mesh.vertex_capacity();
    solver.lanes.inserted = 0;
    solver.blocks.spare = spare_block<OverBlock>(solver.lanes.vertices);
    const auto levels = static_cast<std::size_t>(cloth.mesh.max_level());
    solver.blocks.parents.resize(levels);
    solver.lanes.limits.resize(levels);
    solver.lanes.dirty_limits.resize(levels);
    forget_triangles(solver);
    size_triangles(cloth);
    for (int level = 0; level < cloth.mesh.max_level(); ++level) {
        for (const TriangleId t : cloth.mesh.refined_triangles(level)) note_children(cloth, t);
    }
    make_stretch(cloth);
    make_bending(cloth);
    for (int level = 0; level < cloth.mesh.max_level(); ++level) make_limits(cloth, level);
    list_centres(cloth);
    mark_all_dirty(cloth);
    update_effective_masses(cloth);
}

void change_blocks(Cloth& cloth) {
    const LeafChanges& changes = cloth.mesh.changes();
    cloth.solver.lanes.inserted += changes.triangles_come.size();
    if (is_worn(cloth)) {
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

}  // namespace selvedge
