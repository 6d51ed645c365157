#include "tests/docs/foundation.h"

#include "sim/cloth/material_frame.h"
#include "sim/cloth/solver_lists.h"
#include "sim/cloth/solver_state.h"

namespace selvedge::sim {
// [make]
namespace {

const FoundationKernels& foundation_kernels() {
    return for_level(simd_level(), foundation_kernels_of<SimdLevel::Plain>(), foundation_kernels_of<SimdLevel::Avx2>(),
                     foundation_kernels_of<SimdLevel::Avx512>());
}

void set_foundation(Foundation& foundation, const Cloth& cloth, TriangleId t, std::uint32_t slot) {
    const AdaptiveTriangle& leaf = cloth.mesh.triangle(t);
    const MaterialFrame frame = material_frame(leaf.u, cloth.material.grain_angles[leaf.panel]);
    const std::size_t block = slot / kBlock, at = slot % kBlock;
    for (std::size_t k = 0; k < 3; ++k)
        foundation.set.blocks[block].vertices[k][at] = 4 * leaf.vertices[k].value;  // a point has four floats
    foundation.set.records[block].compliance[0][at] = compliance_of(cloth, frame, double(foundation.stiffness));
}

// Pre: the solver's masses are those of the present leaves.
void update_gains(Foundation& foundation, const Cloth& cloth) {
    foundation.set.update_dirty_masses([&](auto blocks, auto records) {
        foundation_kernels().update_masses(blocks, records, cloth.solver->lists.inverse_masses.data());
    });
}

}  // namespace

void make_foundation(Foundation& foundation, const Cloth& cloth) {
    foundation.vertices = cloth.mesh.vertex_capacity();
    foundation.set.forget();
    foundation.set.make(
        cloth.mesh.leaf_triangles(), foundation.vertices, [](const LeafTriangle& leaf) { return leaf.triangle; },
        [](const LeafTriangle& leaf) { return indices(leaf.v); },
        [&](const LeafTriangle& leaf, std::uint32_t slot) { set_foundation(foundation, cloth, leaf.triangle, slot); });
    update_gains(foundation, cloth);
}
// [/make]

// [change]
void change_foundation(Foundation& foundation, const Cloth& cloth) {
    if (foundation.vertices != cloth.mesh.vertex_capacity()) return make_foundation(foundation, cloth);
    const LeafChanges& changes = cloth.mesh.changes();
    for (const TriangleId t : changes.triangles_removed) foundation.set.remove(t, foundation.vertices);
    for (const TriangleId t : changes.triangles_added) {
        foundation.set.insert(t, indices(cloth.mesh.triangle(t).vertices), foundation.vertices,
                              [&](std::uint32_t slot) { set_foundation(foundation, cloth, t, slot); });
    }
    foundation.set.dirty.mark_all(foundation.set.blocks.size());  // the masses of neighbours have changed too
    update_gains(foundation, cloth);
}

void solve_foundation(Foundation& foundation, float* points) {
    foundation.set.for_colors([&](auto blocks, auto) { foundation_kernels().solve(blocks, foundation.plane, points); });
}
// [/change]

}  // namespace selvedge::sim
