#include "sim/cloth/bias.h"

#include <algorithm>

#include "sim/cloth/cloth.h"

namespace selvedge {
namespace {

std::span<const TriangleId> inside(const AdaptiveTriangle& triangle) {
    return {triangle.internal_triangles.data(), layout(triangle.configuration).triangle_count};
}

void set_kept(Cloth& cloth, TriangleId t, const Vec3f& value, const Vec3f& limit) {
    if (t.value >= cloth.bias.size()) cloth.bias.resize(cloth.mesh.triangles().capacity());
    cloth.bias[t.value] = {.value = value, .limit = limit, .adaption = cloth.adaptions};
}

// A triangle that is refined goes on to carry what it did: its leaves, of less mass, carry little with the same bias.
Vec3f limit_of_leaf(const Vec3f& value) {
    return {std::max(0.0F, value.x()), std::max(0.0F, value.y()), value.z()};
}
void set_leaf(Cloth& cloth, TriangleId t, const Vec3f& value) {
    set_kept(cloth, t, value, limit_of_leaf(value));
}

// And back: leaves take back three quarters of a strain, limits half of it.
Vec3f leaf_of_limit(const Vec3f& mean, const Vec3f& limit) {
    constexpr float kSame = 2.0F / 3.0F;
    return {std::max(mean.x(), kSame * limit.x()), std::max(mean.y(), kSame * limit.y()), mean.z()};
}

bool is_kept(const Cloth& cloth, TriangleId t) {
    return t.value < cloth.bias.size() && cloth.bias[t.value].adaption == cloth.adaptions;
}

Vec3f bias_in(const Cloth& cloth, std::uint32_t lane) {
    const std::array<BlockFloats, 3>& bias = cloth.solver.blocks.stretch[lane / kBlock].bias;
    const std::size_t at = lane % kBlock;
    return {bias[0][at], bias[1][at], bias[2][at]};
}

Vec3f limit_in(const Cloth& cloth, TriangleId t, std::uint32_t lane) {
    const SolverState& solver = cloth.solver;
    const auto& bias = solver.blocks.parents[solver.lanes.limit_level[t.value]].records[lane / kBlock].bias;
    const std::size_t at = lane % kBlock;
    return {bias[0][at], bias[1][at], bias[2][at]};
}

}  // namespace

Vec3f kept_bias(const Cloth& cloth, TriangleId t) {
    if (is_kept(cloth, t)) return cloth.bias[t.value].value;
    const std::uint32_t lane = stretch_lane(cloth, t, cloth.mesh.triangle(t).vertices);
    return lane == kSpare ? Vec3f(Vec3f::Zero()) : bias_in(cloth, lane);
}

Vec3f kept_limit(const Cloth& cloth, TriangleId t) {
    if (is_kept(cloth, t)) return cloth.bias[t.value].limit;
    const std::uint32_t lane = limit_lane(cloth, t);
    return lane == kSpare ? Vec3f(Vec3f::Zero()) : limit_in(cloth, t, lane);
}

void keep_bias(Cloth& cloth, TriangleId t) {
    if (is_kept(cloth, t)) return;
    set_leaf(cloth, t, bias_in(cloth, cloth.solver.lanes.stretch_of[t.value]));
}

void keep_limit(Cloth& cloth, TriangleId t) {
    if (is_kept(cloth, t)) return;
    set_kept(cloth, t, Vec3f::Zero(), limit_in(cloth, t, cloth.solver.lanes.limit_of[t.value]));
}

void keep_biases(Cloth& cloth) {
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
        set_leaf(cloth, leaf.triangle, kept_bias(cloth, leaf.triangle));
    }
    for (int level = 0; level < cloth.mesh.max_level(); ++level) {
        for (const TriangleId t : cloth.mesh.refined_triangles(level)) {
            set_kept(cloth, t, Vec3f::Zero(), kept_limit(cloth, t));
        }
    }
}

void BiasHandover::before(TriangleId t) {
    const AdaptiveTriangle& triangle = cloth_.mesh.triangle(t);
    count_ = 0;
    if (is_leaf(triangle)) {
        mean_ = kept_bias(cloth_, t);
        limit_ = limit_of_leaf(mean_);
        return;
    }
    limit_ = kept_limit(cloth_, t);
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
    if (is_leaf(triangle)) return set_leaf(cloth_, t, leaf_of_limit(mean_, limit_));
    set_kept(cloth_, t, Vec3f::Zero(), limit_);
    for (const TriangleId child : inside(triangle)) {
        const auto end = inside_.begin() + static_cast<std::ptrdiff_t>(count_);
        const auto was = std::find(inside_.begin(), end, child);
        const bool stays = was != end && corners_[static_cast<std::size_t>(was - inside_.begin())] ==
                                             cloth_.mesh.triangle(child).vertices;
        if (!stays) set_leaf(cloth_, child, mean_);
    }
}

}  // namespace selvedge
