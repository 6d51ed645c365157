#include "sim/cloth/state_transfer.h"

#include <algorithm>

#include "sim/cloth/cloth.h"
#include "sim/cloth/solver_blocks.h"
#include "sim/cloth/solver_state.h"
#include "sim/cloth/triangle_bending.h"

namespace selvedge::sim {
namespace {

std::span<const TriangleId> inside(const AdaptiveTriangle& triangle) {
    return {triangle.internal_triangles.data(), layout(triangle.configuration).triangle_count};
}

void restore_saved(Cloth& cloth, TriangleId t, const SavedBias& bias) {
    cloth.solver->saved_bias.save(t, cloth.adaptations, bias);
}

// The initial bias of the coarse strain limit of a leaf that becomes refined. The triangle continues to bear its
// stress, because its leaves, which have less mass, bear little with the same bias.
Vec3f limit_of_leaf(const Vec3f& value) {
    return {std::max(0.0F, value.x()), std::max(0.0F, value.y()), value.z()};
}
void set_leaf(Cloth& cloth, TriangleId t, const Vec3f& value, float anchor) {
    restore_saved(cloth, t, {.value = value, .limit = limit_of_leaf(value), .anchor = anchor});
}

// The bias of a refined triangle that becomes a leaf. The factor makes the correction the same with the other
// relaxation.
Vec3f leaf_of_limit(const Vec3f& mean, const Vec3f& limit) {
    constexpr float kSame = kLimitShare / kLeafShare;
    return {std::max(mean.x(), kSame * limit.x()), std::max(mean.y(), kSame * limit.y()), mean.z()};
}

bool is_kept(const Cloth& cloth, TriangleId t) {
    return cloth.solver->saved_bias.find(t, cloth.adaptations) != nullptr;
}

SavedBias bias_in(const Cloth& cloth, std::uint32_t slot) {
    const StretchBlock& block = cloth.solver->constraints.stretch.blocks[slot / kBlock];
    return {.value = values_at(block.bias, slot % kBlock), .anchor = block.anchor[slot % kBlock]};
}

Vec3f limit_in(const ParentLevel& level, std::uint32_t slot) {
    return values_at(level.limits.records[slot / kBlock].bias, slot % kBlock);
}

// The area-weighted mean of the known states.
struct MeanBend {
    Vec3f sum = Vec3f::Zero();
    float area = 0;

    void add(const SavedBend& bend, float of_area) {
        if (!bend.is_known) return;
        sum += of_area * bend.anchor;
        area += of_area;
    }
    SavedBend mean() const { return area > 0 ? SavedBend{.anchor = sum / area, .is_known = true} : SavedBend{}; }
};

// One iteration gives the multiplier share (s + b) / (seen + c) for a strain s and a bias b; the required one is s / c.
// So b is proportional to (seen + (1 - share) c) / c. c: the compliance over a sub-step, proportional to 1 / substep^2.
// ratio: new over old length of a sub-step.
float fitted(float bias, float seen, float compliance, float share, float ratio) {
    const float then = compliance / (ratio * ratio);
    const float sum = seen + (1 - share) * compliance;
    return sum > 0 ? bias * (seen + (1 - share) * then) / sum * (ratio * ratio) : bias;
}

void fit_slot(StretchBlock& block, const StretchRecord& record, std::size_t at, float ratio) {
    const std::array<float, 3> gains{block.warp[at], block.weft[at], block.shear[at]};
    for (std::size_t k = 0; k < 3; ++k) {
        const float compliance = record.compliance[k][at];
        block.bias[k][at] = fitted(block.bias[k][at], 1 / gains[k] - compliance, compliance, kLeafShare, ratio);
    }
}

// The whole multiplier of a coarse strain limit comes from its bias. For warp and weft, only the part counts by which
// the bias exceeds the unused free strain, free_length - 1 - strain; the rest (`idle`) is not rescaled. stress: of the
// triangle and its ancestors, divided by stiffness; it is at most the strain and is used in its place.
void fit_slot(LimitRecord& record, std::size_t at, const Vec4f& stress, float ratio) {
    for (std::size_t k = 0; k < 3; ++k) {
        const float compliance = record.compliance[k][at];
        const float seen = (kLimitShare * record.per_stress[k][at] - 1) * compliance;
        const float bias = record.bias[k][at];
        const float strain = stress[static_cast<int>(k)];
        const float idle = k < 2 ? std::clamp(record.free_length[k][at] - 1 - strain, 0.0F, bias) : 0.0F;
        record.bias[k][at] = idle + fitted(bias - idle, seen, compliance, 0, ratio);
    }
}

}  // namespace

void rescale_biases(Cloth& cloth, float ratio) {
    Constraints& constraints = cloth.solver->constraints;
    for (std::size_t slot = 0; slot < constraints.triangle_of.size(); ++slot) {
        if (constraints.triangle_of[slot] == kNoBlockSlot) continue;
        fit_slot(constraints.stretch.blocks[slot / kBlock], constraints.stretch.records[slot / kBlock], slot % kBlock,
                 ratio);
    }
    for (ParentLevel& level : constraints.parents) {
        for (LimitRecord& record : level.limits.records) {
            for (std::size_t at = 0; at < kBlock; ++at) {
                if (record.offset[at] == kNoOffset) continue;
                fit_slot(record, at, constraints.stress.above[record.offset[at] / 4], ratio);
            }
        }
    }
}

SavedBias saved_bias_of(const Cloth& cloth, TriangleId t) {
    if (const SavedBias* const kept = cloth.solver->saved_bias.find(t, cloth.adaptations)) return *kept;
    const std::uint32_t slot = cloth.solver->constraints.stretch.slot_of(t, indices(cloth.mesh.triangle(t).vertices));
    return slot == kNoBlockSlot ? SavedBias{} : bias_in(cloth, slot);
}

Vec3f saved_limit_of(const Cloth& cloth, TriangleId t) {
    if (const SavedBias* const kept = cloth.solver->saved_bias.find(t, cloth.adaptations)) return kept->limit;
    const AdaptiveTriangle& triangle = cloth.mesh.triangle(t);
    const std::vector<ParentLevel>& parents = cloth.solver->constraints.parents;
    if (triangle.level >= parents.size()) return Vec3f::Zero();
    const std::uint32_t slot = parents[triangle.level].limits.slot_of(t, indices(triangle.vertices));
    return slot == kNoBlockSlot ? Vec3f(Vec3f::Zero()) : limit_in(parents[triangle.level], slot);
}

void save_bias(Cloth& cloth, TriangleId t) {
    if (is_kept(cloth, t)) return;
    const SavedBias kept = bias_in(cloth, cloth.solver->constraints.stretch.slot_of(t));
    set_leaf(cloth, t, kept.value, kept.anchor);
}

void save_limit(Cloth& cloth, TriangleId t, const ParentLevel& level) {
    if (!is_kept(cloth, t)) restore_saved(cloth, t, {.limit = limit_in(level, level.limits.slot_of(t))});
}

void save_biases(Cloth& cloth) {
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
        const SavedBias kept = saved_bias_of(cloth, leaf.triangle);
        set_leaf(cloth, leaf.triangle, kept.value, kept.anchor);
    }
    for (int level = 0; level < cloth.mesh.max_level(); ++level) {
        for (const TriangleId t : cloth.mesh.refined_triangles(level)) {
            restore_saved(cloth, t, {.limit = saved_limit_of(cloth, t)});
        }
    }
}

void StateTransfer::before(TriangleId t) {
    const AdaptiveTriangle& triangle = cloth_.mesh.triangle(t);
    count_ = 0;
    bend_ = saved_bend_of(cloth_, t);
    if (is_leaf(triangle)) {
        mean_bend_ = bend_;
        const SavedBias kept = saved_bias_of(cloth_, t);
        mean_ = kept.value;
        mean_anchor_ = kept.anchor;
        limit_ = limit_of_leaf(mean_);
        return;
    }
    limit_ = saved_limit_of(cloth_, t);
    Vec3f sum = Vec3f::Zero();
    MeanBend bends;
    float anchors = 0, area = 0;
    for (const TriangleId child : inside(triangle)) {
        const AdaptiveTriangle& one = cloth_.mesh.triangle(child);
        const float a = material_area(one.u);
        const SavedBias kept = saved_bias_of(cloth_, child);
        sum += a * kept.value;
        anchors += a * kept.anchor;
        bends.add(saved_bend_of(cloth_, child), a);
        area += a;
        inside_[count_] = child;
        corners_[count_++] = one.vertices;
    }
    mean_ = sum / area;
    mean_anchor_ = anchors / area;
    mean_bend_ = bends.mean();
}

void StateTransfer::after(TriangleId t) {
    const AdaptiveTriangle& triangle = cloth_.mesh.triangle(t);
    cloth_.solver->saved_bend.save(t, cloth_.adaptations, is_leaf(triangle) ? mean_bend_ : bend_);
    if (is_leaf(triangle)) return set_leaf(cloth_, t, leaf_of_limit(mean_, limit_), mean_anchor_);
    restore_saved(cloth_, t, {.limit = limit_});
    for (const TriangleId child : inside(triangle)) {
        const auto end = inside_.begin() + static_cast<std::ptrdiff_t>(count_);
        const auto was = std::find(inside_.begin(), end, child);
        const bool stays = was != end && corners_[static_cast<std::size_t>(was - inside_.begin())] ==
                                             cloth_.mesh.triangle(child).vertices;
        if (stays) continue;
        set_leaf(cloth_, child, mean_, mean_anchor_);
        cloth_.solver->saved_bend.save(child, cloth_.adaptations, mean_bend_);
    }
}

SavedBend saved_bend_of(const Cloth& cloth, TriangleId t) {
    if (const SavedBend* const kept = cloth.solver->saved_bend.find(t, cloth.adaptations)) return *kept;
    const BendSlot slot = bend_slot(cloth, t);
    if (slot.block == nullptr) return {};
    return {.anchor = values_at(slot.block->anchor, slot.at), .is_known = slot.block->realised[slot.at] > 0};
}

void save_bend(Cloth& cloth, TriangleId t) {
    const bool is_kept = cloth.solver->saved_bend.find(t, cloth.adaptations) != nullptr;
    if (!is_kept) cloth.solver->saved_bend.save(t, cloth.adaptations, saved_bend_of(cloth, t));
}

void save_bends(Cloth& cloth) {
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) save_bend(cloth, leaf.triangle);
    for (int level = 0; level < cloth.mesh.max_level(); ++level) {
        for (const TriangleId t : cloth.mesh.refined_triangles(level)) save_bend(cloth, t);
    }
}

}  // namespace selvedge::sim
