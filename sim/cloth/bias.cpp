#include "sim/cloth/bias.h"

#include <algorithm>

#include "sim/cloth/block_lanes.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/triangle_bending.h"

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
void set_leaf(Cloth& cloth, TriangleId t, const Vec3f& value, float anchor) {
    set_kept(cloth, t, value, limit_of_leaf(value));
    cloth.bias[t.value].anchor = anchor;
}

// And back: the same share of a strain is taken back.
Vec3f leaf_of_limit(const Vec3f& mean, const Vec3f& limit) {
    constexpr float kSame = kLimitShare / kLeafShare;
    return {std::max(mean.x(), kSame * limit.x()), std::max(mean.y(), kSame * limit.y()), mean.z()};
}

bool is_kept(const Cloth& cloth, TriangleId t) {
    return t.value < cloth.bias.size() && cloth.bias[t.value].adaption == cloth.adaptions;
}

KeptBias bias_in(const Cloth& cloth, std::uint32_t lane) {
    const StretchBlock& block = cloth.solver.blocks.stretch[lane / kBlock];
    return {.value = lane_of(block.bias, lane % kBlock), .anchor = block.anchor[lane % kBlock]};
}

void set_bend(Cloth& cloth, TriangleId t, const KeptBend& bend) {
    if (t.value >= cloth.bend.size()) cloth.bend.resize(cloth.mesh.triangles().capacity());
    cloth.bend[t.value] = bend;
    cloth.bend[t.value].adaption = cloth.adaptions;
}

bool is_bend_kept(const Cloth& cloth, TriangleId t) {
    return t.value < cloth.bend.size() && cloth.bend[t.value].adaption == cloth.adaptions;
}

// Of those that are known.
struct MeanBend {
    Vec3f sum = Vec3f::Zero();
    float area = 0;

    void add(const KeptBend& bend, float of_area) {
        if (!bend.is_known) return;
        sum += of_area * bend.anchor;
        area += of_area;
    }
    KeptBend mean() const { return area > 0 ? KeptBend{.anchor = sum / area, .is_known = true} : KeptBend{}; }
};

// A visit makes a multiplier of share (s + b) / (seen + c) of a strain s and a bias b, and s / c is wanted. So the bias
// is in proportion to (seen + (1 - share) c) / c. c: the compliance over a sub-step, to which it is as 1 to its square.
float fitted(float bias, float seen, float compliance, float share, float ratio) {
    const float then = compliance / (ratio * ratio);
    const float sum = seen + (1 - share) * compliance;
    return sum > 0 ? bias * (seen + (1 - share) * then) / sum * (ratio * ratio) : bias;
}

void fit_lane(StretchBlock& block, const StretchRecord& record, std::size_t at, float ratio) {
    const std::array<float, 3> gains{block.warp[at], block.weft[at], block.shear[at]};
    for (std::size_t k = 0; k < 3; ++k) {
        const float compliance = record.compliance[k][at];
        block.bias[k][at] = fitted(block.bias[k][at], 1 / gains[k] - compliance, compliance, kLeafShare, ratio);
    }
}

// All of a multiplier is made by the bias. Of warp and weft roughly so: there is a length that is free without any.
void fit_lane(LimitRecord& record, std::size_t at, float ratio) {
    for (std::size_t k = 0; k < 3; ++k) {
        const float compliance = record.compliance[k][at];
        const float seen = (kLimitShare * record.per_stress[k][at] - 1) * compliance;
        record.bias[k][at] = fitted(record.bias[k][at], seen, compliance, 0, ratio);
    }
}

Vec3f limit_in(const Cloth& cloth, TriangleId t, std::uint32_t lane) {
    const SolverState& solver = cloth.solver;
    return lane_of(solver.blocks.parents[solver.lanes.limit_level[t.value]].records[lane / kBlock].bias, lane % kBlock);
}

}  // namespace

void fit_biases(Cloth& cloth, float ratio) {
    SolverBlocks& blocks = cloth.solver.blocks;
    for (std::size_t lane = 0; lane < blocks.triangle_of.size(); ++lane) {
        if (blocks.triangle_of[lane] == kSpare) continue;
        fit_lane(blocks.stretch[lane / kBlock], blocks.records[lane / kBlock], lane % kBlock, ratio);
    }
    for (ParentLevel& level : blocks.parents) {
        for (LimitRecord& record : level.records) {
            for (std::size_t at = 0; at < kBlock; ++at) {
                if (record.place[at] != kNoPlace) fit_lane(record, at, ratio);
            }
        }
    }
}

KeptBias kept_bias(const Cloth& cloth, TriangleId t) {
    if (is_kept(cloth, t)) return cloth.bias[t.value];
    const std::uint32_t lane = stretch_lane(cloth, t);
    return lane == kSpare ? KeptBias{} : bias_in(cloth, lane);
}

Vec3f kept_limit(const Cloth& cloth, TriangleId t) {
    if (is_kept(cloth, t)) return cloth.bias[t.value].limit;
    const std::uint32_t lane = limit_lane(cloth, t);
    return lane == kSpare ? Vec3f(Vec3f::Zero()) : limit_in(cloth, t, lane);
}

void keep_bias(Cloth& cloth, TriangleId t) {
    if (is_kept(cloth, t)) return;
    const KeptBias kept = bias_in(cloth, cloth.solver.lanes.stretch_of[t.value]);
    set_leaf(cloth, t, kept.value, kept.anchor);
}

void keep_limit(Cloth& cloth, TriangleId t) {
    if (is_kept(cloth, t)) return;
    set_kept(cloth, t, Vec3f::Zero(), limit_in(cloth, t, cloth.solver.lanes.limit_of[t.value]));
}

void keep_biases(Cloth& cloth) {
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
        const KeptBias kept = kept_bias(cloth, leaf.triangle);
        set_leaf(cloth, leaf.triangle, kept.value, kept.anchor);
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
    bend_ = kept_bend(cloth_, t);
    if (is_leaf(triangle)) {
        mean_bend_ = bend_;
        const KeptBias kept = kept_bias(cloth_, t);
        mean_ = kept.value;
        mean_anchor_ = kept.anchor;
        limit_ = limit_of_leaf(mean_);
        return;
    }
    limit_ = kept_limit(cloth_, t);
    Vec3f sum = Vec3f::Zero();
    MeanBend bends;
    float anchors = 0, area = 0;
    for (const TriangleId child : inside(triangle)) {
        const AdaptiveTriangle& one = cloth_.mesh.triangle(child);
        const float a = material_area(one.u);
        const KeptBias kept = kept_bias(cloth_, child);
        sum += a * kept.value;
        anchors += a * kept.anchor;
        bends.add(kept_bend(cloth_, child), a);
        area += a;
        inside_[count_] = child;
        corners_[count_++] = one.vertices;
    }
    mean_ = sum / area;
    mean_anchor_ = anchors / area;
    mean_bend_ = bends.mean();
}

void BiasHandover::after(TriangleId t) {
    const AdaptiveTriangle& triangle = cloth_.mesh.triangle(t);
    set_bend(cloth_, t, is_leaf(triangle) ? mean_bend_ : bend_);
    if (is_leaf(triangle)) return set_leaf(cloth_, t, leaf_of_limit(mean_, limit_), mean_anchor_);
    set_kept(cloth_, t, Vec3f::Zero(), limit_);
    for (const TriangleId child : inside(triangle)) {
        const auto end = inside_.begin() + static_cast<std::ptrdiff_t>(count_);
        const auto was = std::find(inside_.begin(), end, child);
        const bool stays = was != end && corners_[static_cast<std::size_t>(was - inside_.begin())] ==
                                             cloth_.mesh.triangle(child).vertices;
        if (stays) continue;
        set_leaf(cloth_, child, mean_, mean_anchor_);
        set_bend(cloth_, child, mean_bend_);
    }
}

KeptBend kept_bend(const Cloth& cloth, TriangleId t) {
    if (is_bend_kept(cloth, t)) return cloth.bend[t.value];
    const BendSlot slot = bend_slot(cloth, t);
    if (slot.block == nullptr) return {};
    return {.anchor = lane_of(slot.block->anchor, slot.at), .is_known = slot.block->realised[slot.at] > 0};
}

void keep_bend(Cloth& cloth, TriangleId t) {
    if (!is_bend_kept(cloth, t)) set_bend(cloth, t, kept_bend(cloth, t));
}

void keep_bends(Cloth& cloth) {
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) keep_bend(cloth, leaf.triangle);
    for (int level = 0; level < cloth.mesh.max_level(); ++level) {
        for (const TriangleId t : cloth.mesh.refined_triangles(level)) keep_bend(cloth, t);
    }
}

}  // namespace selvedge
