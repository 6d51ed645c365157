#include "sim/cloth/bias.h"

#include <algorithm>

#include "sim/cloth/cloth.h"

namespace selvedge {
namespace {

std::span<const TriangleId> inside(const AdaptiveTriangle& triangle) {
    return {triangle.internal_triangles.data(), layout(triangle.configuration).triangle_count};
}

void set_bias(Cloth& cloth, TriangleId t, const Vec3f& bias) {
    if (t.value >= cloth.bias.size()) cloth.bias.resize(cloth.mesh.triangles().capacity());
    cloth.bias[t.value] = {.value = bias, .adaption = cloth.adaptions};
}

bool is_kept(const Cloth& cloth, TriangleId t) {
    return t.value < cloth.bias.size() && cloth.bias[t.value].adaption == cloth.adaptions;
}

Vec3f bias_in(const Cloth& cloth, std::uint32_t lane) {
    const std::array<BlockFloats, 3>& bias = cloth.solver.blocks.stretch[lane / kBlock].bias;
    const std::size_t at = lane % kBlock;
    return {bias[0][at], bias[1][at], bias[2][at]};
}

}  // namespace

Vec3f kept_bias(const Cloth& cloth, TriangleId t) {
    if (is_kept(cloth, t)) return cloth.bias[t.value].value;
    const std::uint32_t lane = stretch_lane(cloth, t, cloth.mesh.triangle(t).vertices);
    return lane == kSpare ? Vec3f(Vec3f::Zero()) : bias_in(cloth, lane);
}

void keep_bias(Cloth& cloth, TriangleId t) {
    if (is_kept(cloth, t)) return;
    set_bias(cloth, t, bias_in(cloth, cloth.solver.lanes.stretch_of[t.value]));
}

void keep_biases(Cloth& cloth) {
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
        set_bias(cloth, leaf.triangle, kept_bias(cloth, leaf.triangle));
    }
}

void BiasHandover::before(TriangleId t) {
    const AdaptiveTriangle& triangle = cloth_.mesh.triangle(t);
    count_ = 0;
    if (is_leaf(triangle)) {
        mean_ = kept_bias(cloth_, t);
        return;
    }
    Vec3f sum = Vec3f::Zero();
    float area = 0;
    for (const TriangleId child : inside(triangle)) {
        const AdaptiveTriangle& one = cloth_.mesh.triangle(child);
        const float a = material_area(one.u);
        sum += a * kept_bias(cloth_, child);
        area += a;
        inside_[count_] = child;
        corners_[count_++] = one.vertices;
    }
    mean_ = sum / area;
}

void BiasHandover::after(TriangleId t) {
    const AdaptiveTriangle& triangle = cloth_.mesh.triangle(t);
    if (is_leaf(triangle)) set_bias(cloth_, t, mean_);
    for (const TriangleId child : inside(triangle)) {
        const auto end = inside_.begin() + static_cast<std::ptrdiff_t>(count_);
        const auto was = std::find(inside_.begin(), end, child);
        const bool stays = was != end && corners_[static_cast<std::size_t>(was - inside_.begin())] ==
                                             cloth_.mesh.triangle(child).vertices;
        if (!stays) set_bias(cloth_, child, mean_);
    }
}

}  // namespace selvedge
