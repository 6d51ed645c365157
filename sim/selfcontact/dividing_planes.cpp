#include "sim/selfcontact/dividing_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace selvedge::sim {
namespace {

// A pair is divided while its sides are this far apart along its plane: a share of the gap that it had, and of its
// radius. So a gap of any size never closes, and pairs at their radius are left to the contacts.
constexpr float kGapShare = 0.5F, kRadiusShare = 0.1F;
constexpr int kPartingSweeps = 4, kPartingIterations = 6, kShorteningIterations = 8;

Vec3f divider_of(const PairBlock& block, std::size_t at) {
    return {block.divider[0][at], block.divider[1][at], block.divider[2][at]};
}

float asked_of(const PairBlock& block, std::size_t at) {
    return std::min(kGapShare * block.gap[at], kRadiusShare * block.radius[at]);
}

}  // namespace

DividerExtremes extremes_of(const PairBlock& block, std::size_t at, std::size_t first_side,
                            const MovingPoints& points) {
    const Vec3f normal = divider_of(block, at), origin = points.at(block.vertices[0][at] / 4);
    float lowest = std::numeric_limits<float>::max(), highest = std::numeric_limits<float>::lowest();
    DividerExtremes found;
    for (std::size_t k = 0; k < 4; ++k) {
        const std::uint32_t v = block.vertices[k][at] / 4;
        const float height = normal.dot(points.at(v) - origin);
        if (k < first_side && height < lowest) {
            lowest = height;
            found.first = v;
        } else if (k >= first_side && height > highest) {
            highest = height;
            found.second = v;
        }
    }
    found.apart = lowest - highest;
    return found;
}

CertificateReport DividingPlanes::certify(const SelfContactKernels& loops, const ContactPairs& pairs,
                                          const Start& start, const Motion& mean, const MovingPoints& points) {
    CertificateReport report;
    share_.resize(points.count, 1.0F);
    if (mean.is_by_pair) {
        shared_.resize(points.count);
        sharing_.resize(points.count, 0);
    }
    for (int i = 0; i < kPartingIterations; ++i) {
        if (collect(loops, pairs, start, mean, points) == 0) return report;
        if (!part_all(points, report)) break;
    }
    for (int i = 0; i < kShorteningIterations; ++i) {
        if (collect(loops, pairs, start, mean, points) == 0) return report;
        if (!shorten_all(start, mean, 1, points, report)) break;
    }
    // What moved back may have got into the way of others. In the end all are where they started.
    stopped_.assign(points.count, 0);
    while (collect(loops, pairs, start, mean, points) != 0 && shorten_all(start, mean, 0, points, report)) {
    }
    report.undivided = static_cast<int>(undivided_.size());
    return report;
}

// One pair that is parted may bring others of the list together.
bool DividingPlanes::part_all(const MovingPoints& points, CertificateReport& report) {
    bool has_changed = false, changes = true;
    for (int sweep = 0; changes && sweep < kPartingSweeps; ++sweep) {
        changes = false;
        for (const Undivided& pair : undivided_) changes |= part(pair, points, report);
        has_changed |= changes;
    }
    return has_changed;
}

// Takes back a part of their movement from the vertices of undivided pairs: as much as is necessary, or 1 - `most`.
bool DividingPlanes::shorten_all(const Start& start, const Motion& mean, float most, const MovingPoints& points,
                                 CertificateReport& report) {
    touched_.clear();
    bool changed = false;
    for (const Undivided& pair : undivided_) changed |= shorten(pair, start, mean, points, most);
    take_back(start, mean, points, report);
    return changed;
}

void DividingPlanes::take_back(const Start& start, const Motion& mean, const MovingPoints& points,
                               CertificateReport& report) {
    for (const std::uint32_t v : touched_) {
        const float share = std::exchange(share_[v], 1.0F);
        const Motion shared = take_shared(v, mean);
        const Vec3f origin = start.positions[v].head<3>() + shared.displacement, now = points.at(v),
                    was = points.was_at(v);
        const Vec3f to = origin + (now - origin) * share;
        const Vec3f before = to - (now - was) * share - shared.per_substep * (1 - share);
        points.shift(v, to - now);
        Eigen::Map<Vec3f>(points.before + 4 * static_cast<std::size_t>(v)) = before;
    }
    report.truncated += static_cast<int>(touched_.size());
}

// The motion of a vertex that is not truncated: the mean of its pairs.
DividingPlanes::Motion DividingPlanes::take_shared(std::uint32_t vertex, const Motion& mean) {
    if (!mean.is_by_pair) return mean;
    const auto count = static_cast<float>(std::exchange(sharing_[vertex], 0));
    const Motion sum = std::exchange(shared_[vertex], {});
    return {.displacement = sum.displacement / count, .per_substep = sum.per_substep / count};
}

// Lists the pairs that are not divided; returns how many. Blocks whose slack is greater than all motion since the last
// full test are divided still; if these are few, this is the next full test.
std::size_t DividingPlanes::collect(const SelfContactKernels& loops, const ContactPairs& pairs, const Start& start,
                                    const Motion& mean, const MovingPoints& points) {
    undivided_.clear();
    const std::size_t blocks = pairs.vertex_triangle.block_count() + pairs.edge_edge.block_count();
    if (blocks == 0) return 0;
    const bool is_full = slack_.size() != blocks || 4 * tested_ > blocks;
    if (is_full) begin_full_test(start, mean, points);
    slack_.resize(blocks);
    constexpr float kRounding = 1e-6F;  // m, of positions some metres from the origin
    const float closed = is_full ? 0 : 2 * moved(start, mean, points) + kRounding;  // by the motion of both sides
    tested_ = 0;
    float* slack = slack_.data();
    for (const PairList* const list : {&pairs.vertex_triangle, &pairs.edge_edge}) {
        const std::size_t first = first_side(list->kind());
        for (std::size_t i = 0; i < list->block_count(); ++i, ++slack) {
            if (!is_full && *slack > closed) continue;
            if (!is_full) ++tested_;
            const PairBlock& block = list->blocks()[i];
            float now = 0;
            unsigned found = loops.find_undivided(list->kind(), block, points.now, kGapShare, kRadiusShare, now);
            if (is_full) *slack = now;
            for (; found != 0; found &= found - 1)
                undivided_.push_back({&block, static_cast<std::size_t>(__builtin_ctz(found)), first});
        }
    }
    return undivided_.size();
}

void DividingPlanes::begin_full_test(const Start& start, const Motion& mean, const MovingPoints& points) {
    tested_at_.resize(points.count);
    shared_then_ = mean.displacement;
    for (const std::uint32_t v : start.vertices) tested_at_[v] = points.wide_at(v);
}

// The longest displacement of a vertex since the last full test, in a frame that travels with the cloth, m.
float DividingPlanes::moved(const Start& start, const Motion& mean, const MovingPoints& points) const {
    const Vec4f shared = with_zero_w(mean.displacement - shared_then_);
    float farthest = 0;
    for (const std::uint32_t v : start.vertices) {
        farthest = std::max(farthest, (points.wide_at(v) - tested_at_[v] - shared).squaredNorm());
    }
    return std::sqrt(farthest);
}

// Moves the two nearest vertices apart along the divider, weighted by inverse masses.
bool DividingPlanes::part(const Undivided& pair, const MovingPoints& points, CertificateReport& report) {
    const DividerExtremes nearest = extremes_of(*pair.block, pair.at, pair.first_side, points);
    const float asked = asked_of(*pair.block, pair.at);
    if (nearest.apart >= asked) return false;
    const float mine = points.inverse_mass(nearest.first), theirs = points.inverse_mass(nearest.second);
    if (mine + theirs <= 0) return false;
    constexpr float kMore = 1.02F, kRounding = 1e-7F;  // m
    const Vec3f way =
        divider_of(*pair.block, pair.at) * ((kMore * (asked - nearest.apart) + kRounding) / (mine + theirs));
    points.shift(nearest.first, way * mine);
    points.shift(nearest.second, way * -theirs);
    ++report.parted;
    return true;
}

// Notes the share of their movement that the vertices of an undivided pair may keep: linearly, up to `most`.
bool DividingPlanes::shorten(const Undivided& pair, const Start& start, const Motion& mean, const MovingPoints& points,
                             float most) {
    const float asked = asked_of(*pair.block, pair.at), gap = pair.block->gap[pair.at];
    const float apart = extremes_of(*pair.block, pair.at, pair.first_side, points).apart;
    if (apart >= asked) return false;
    constexpr float kSafe = 0.98F, kLeast = 1e-12F;  // m
    const float share = most * std::clamp(kSafe * (gap - asked) / std::max(kLeast, gap - apart), 0.0F, 1.0F);
    Motion shared;
    for (std::size_t k = 0; mean.is_by_pair && k < 4; ++k) {
        const std::uint32_t v = pair.block->vertices[k][pair.at] / 4;
        shared.displacement += (points.at(v) - start.positions[v].head<3>()) / 4;
        shared.per_substep += (points.at(v) - points.was_at(v)) / 4;
    }
    bool changed = false;
    for (const BlockPoints& vertices : pair.block->vertices) {
        const std::uint32_t v = vertices[pair.at] / 4;
        if (points.inverse_mass(v) <= 0 || (most == 0 && stopped_[v] != 0)) continue;
        changed = true;
        if (most == 0) stopped_[v] = 1;
        if (share_[v] == 1.0F) touched_.push_back(v);
        share_[v] = std::min(share_[v], share);
        if (!mean.is_by_pair) continue;
        shared_[v].displacement += shared.displacement;
        shared_[v].per_substep += shared.per_substep;
        ++sharing_[v];
    }
    return changed;
}

}  // namespace selvedge::sim
