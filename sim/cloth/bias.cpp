#include "sim/cloth/bias.h"

#include "sim/cloth/cloth.h"

namespace selvedge {
namespace {

std::span<const TriangleId> inside(const AdaptiveTriangle& triangle) {
    return {triangle.internal_triangles.data(), layout(triangle.configuration).triangle_count};
}

void set_bias(Cloth& cloth, TriangleId t, const Vec3f& bias) {
    cloth.bias[t.value] = {.value = bias, .u = cloth.mesh.triangle(t).u, .adaption = cloth.adaptions};
}

// An id may have been given to another triangle, or given back and taken again in an earlier adaption.
bool is_known(const Cloth& cloth, TriangleId t) {
    const KeptBias& kept = cloth.bias[t.value];
    return kept.adaption == cloth.adaptions && kept.u == cloth.mesh.triangle(t).u;
}

}  // namespace

void keep_bias(Cloth& cloth) {
    ++cloth.adaptions;
    const SolverBlocks& blocks = cloth.solver.blocks;
    const std::span<const LeafTriangle> leaves = cloth.mesh.leaf_triangles();
    for (std::size_t lane = 0; lane < blocks.leaf_of.size(); ++lane) {
        if (blocks.leaf_of[lane] == kSpare) continue;
        const std::array<BlockFloats, 3>& bias = blocks.stretch[lane / kBlock].bias;
        const std::size_t at = lane % kBlock;
        set_bias(cloth, leaves[blocks.leaf_of[lane]].triangle, {bias[0][at], bias[1][at], bias[2][at]});
    }
    for (int level = cloth.mesh.max_level() - 1; level >= 0; --level) {
        for (const TriangleId t : cloth.mesh.refined_triangles(level)) {
            Vec3f sum = Vec3f::Zero();
            float area = 0;
            for (const TriangleId child : inside(cloth.mesh.triangle(t))) {
                const float a = material_area(cloth.mesh.triangle(child).u);
                sum += a * cloth.bias[child.value].value;
                area += a;
            }
            set_bias(cloth, t, sum / area);
        }
    }
}

void hand_on_bias(Cloth& cloth) {
    cloth.bias.resize(cloth.mesh.triangles().capacity());
    for (int level = 0; level < cloth.mesh.max_level(); ++level) {
        for (const TriangleId t : cloth.mesh.refined_triangles(level)) {
            for (const TriangleId child : inside(cloth.mesh.triangle(t))) {
                if (!is_known(cloth, child)) set_bias(cloth, child, cloth.bias[t.value].value);
            }
        }
    }
}

}  // namespace selvedge
