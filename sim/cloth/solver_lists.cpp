#include "sim/cloth/solver_lists.h"

#include <algorithm>
#include <cmath>

#include "sim/cloth/bias.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/effective_masses.h"
#include "sim/cloth/limit_lists.h"
#include "sim/cloth/triangle_bending.h"

namespace selvedge {
namespace {

// Whether a seam edge of the triangle has to be shorter than the triangle's own copy of it: there the cloth is
// gathered, in puckers finer than the mesh.  (SPEC 3.2)
bool has_gathered_side(const AdaptiveMesh& mesh, const AdaptiveTriangle& triangle) {
    constexpr float kEase = 0.95F;
    for (std::size_t k = 0; k < 3; ++k) {
        const float own = (triangle.u[(k + 1) % 3] - triangle.u[k]).squaredNorm();
        const float rest = mesh.rest_length(triangle.edges[k]);
        if (rest * rest < kEase * kEase * own) return true;
    }
    return false;
}

bool has_gathers(const AdaptiveMesh& mesh) {
    for (std::uint32_t t = 0; t < mesh.base_triangle_count(); ++t) {
        if (has_gathered_side(mesh, mesh.triangle(TriangleId{t}))) return true;
    }
    return false;
}

// Puckers go on through what touches a gathered side by a corner alone: were it to resist, its sides would be too long
// for the triangles between them, whose third side is gathered, and stretch those.
bool is_gathered(const AdaptiveMesh& mesh, const AdaptiveTriangle& leaf) {
    for (const VertexId corner : leaf.vertices) {
        for (const TriangleId t : mesh.triangles_at(corner)) {
            const AdaptiveTriangle& other = mesh.triangle(t);
            if (other.panel == leaf.panel && has_gathered_side(mesh, other)) return true;
        }
    }
    return false;
}

// All but the gains. t: a leaf.
void set_stretch(Cloth& cloth, TriangleId t, std::uint32_t slot) {
    const AdaptiveTriangle& leaf = cloth.mesh.triangle(t);
    Constraints& constraints = cloth.solver.constraints;
    StretchBlock& block = constraints.stretch.blocks[slot / kBlock];
    StretchRecord& record = constraints.stretch.records[slot / kBlock];
    const std::size_t at = slot % kBlock;
    const Fabric& fabric = cloth.material.fabrics[leaf.panel];
    const MaterialFrame frame = material_frame(leaf.u, cloth.material.grain_angles[leaf.panel]);
    set_frame(block, at, leaf.vertices, frame);
    block.longest[at] = 1 + static_cast<float>(fabric.strain_limit);
    block.push[at] = cloth.solver.lists.has_gathers && is_gathered(cloth.mesh, leaf) ? 0.0F : 1.0F;
    block.slip[at] = static_cast<float>(fabric.shear_hysteresis / (2 * fabric.shear)) / kStick;
    const KeptBias kept = kept_bias(cloth, t);
    set_lane(block.bias, at, kept.value);
    block.anchor[at] = kept.anchor;
    record.compliance[0][at] = compliance_of(cloth, frame, fabric.stretch_warp);
    record.compliance[1][at] = compliance_of(cloth, frame, fabric.stretch_weft);
    record.compliance[2][at] = compliance_of(cloth, frame, fabric.shear);
    const ParentOf& parent = cloth.solver.lists.parent_of[t.value];
    record.parent[at] = parent.place;
    record.of_area[at] = parent.of_area;
    constraints.triangle_of.resize(constraints.stretch.blocks.size() * kBlock, kSpare);
    constraints.thirds.resize(constraints.stretch.blocks.size() * kBlock, 0.0F);
    constraints.triangle_of[slot] = t.value;
    constraints.thirds[slot] = third_of_mass(cloth, leaf.u, leaf.panel);
}

void make_stretch(Cloth& cloth) {
    SolverState& solver = cloth.solver;
    solver.constraints.triangle_of.clear();
    solver.constraints.thirds.clear();
    solver.constraints.stretch.make(
        cloth.mesh.leaf_triangles(), solver.lists.vertices, [](const LeafTriangle& leaf) { return leaf.triangle; },
        [](const LeafTriangle& leaf) { return indices(leaf.v); },
        [&](const LeafTriangle& leaf, std::uint32_t slot) { set_stretch(cloth, leaf.triangle, slot); });
}

void change_stretch(Cloth& cloth, const LeafChanges& changes) {
    Constraints& constraints = cloth.solver.constraints;
    const std::size_t spare_point = cloth.solver.lists.vertices;
    for (const TriangleId t : changes.triangles_gone) {
        keep_bias(cloth, t);
        constraints.triangle_of[constraints.stretch.slot_of(t)] = kSpare;
        constraints.stretch.remove(t, spare_point);
    }
    for (const TriangleId t : changes.triangles_come) {
        constraints.stretch.insert(t, indices(cloth.mesh.triangle(t).vertices), spare_point,
                                   [&](std::uint32_t slot) { set_stretch(cloth, t, slot); });
    }
}

void size_triangles(Cloth& cloth) {
    SolverState& solver = cloth.solver;
    const std::size_t capacity = cloth.mesh.triangles().capacity();
    solver.lists.parent_of.resize(capacity);
    solver.lists.easy_shear.resize(capacity + 1, 0.0F);
    CarriedStress& carried = solver.constraints.carried;
    for (std::vector<Vec4f>* sums : {&carried.above, &carried.below, &carried.off}) {
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
    CarriedStress& carried = solver.constraints.carried;
    for (std::vector<Vec4f>* sums : {&carried.above, &carried.below, &carried.off}) sums->clear();
}

// Slots that are put in one by one lie less well in memory than those that are put in all at once.
bool is_worn(const Cloth& cloth) {
    const std::size_t leaves = cloth.mesh.leaf_triangles().size();
    const SolverState& solver = cloth.solver;
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
    std::vector<ParentOf>& parent_of = cloth.solver.lists.parent_of;
    const float area = material_area(triangle.u);
    for (std::size_t i = 0; i < layout(triangle.configuration).triangle_count; ++i) {
        const TriangleId child = triangle.internal_triangles[i];
        if (child.value >= parent_of.size()) parent_of.resize(cloth.mesh.triangles().capacity());
        parent_of[child.value] = {place_of(t), material_area(cloth.mesh.triangle(child).u) / area};
    }
}

void make_blocks(Cloth& cloth) {
    SolverState& solver = cloth.solver;
    keep_biases(cloth);
    keep_bends(cloth);
    solver.lists.vertices = cloth.mesh.vertex_capacity();
    solver.lists.inserted = 0;
    solver.lists.has_gathers = has_gathers(cloth.mesh);
    solver.lists.spare = spare_block<OverBlock>(solver.lists.vertices);
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
    cloth.solver.lists.inserted += changes.triangles_come.size();
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
