#include "sim/selfcontact/dividing_planes.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace selvedge::sim {
namespace {

// A pair is divided while its sides are this far apart along its plane: a share of the gap that it had, and of its
// radius. So a gap of any size never closes, and pairs at their radius are left to the contacts.
constexpr float kGapShare = 0.5F, kRadiusShare = 0.1F;
constexpr float kWatched = 0.0005F;  // m: pairs that are divided by no more are tested in later rounds too
constexpr int kPartingRounds = 12, kShorteningRounds = 8, kStoppingRounds = 4;

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
                                          std::span<const Vec4f> start, const Vec3f& mean, const Vec3f& mean_move,
                                          const MovingPoints& points) {
    CertificateReport report;
    undivided_.clear();
    collect(loops, pairs.vertex_triangle, points);
    collect(loops, pairs.edge_edge, points);
    share_.resize(points.count, 1.0F);
    constexpr int kRounds = kPartingRounds + kShorteningRounds + kStoppingRounds;
    for (bool changed = true; changed && report.rounds < kRounds; ++report.rounds) {
        changed = false;
        touched_.clear();
        for (const Undivided& pair : undivided_) {
            if (report.rounds < kPartingRounds) {
                changed |= part(pair, points, report);
            } else {
                changed |= shorten(pair, points, report.rounds < kPartingRounds + kShorteningRounds ? 1.0F : 0.0F);
            }
        }
        for (const std::uint32_t v : touched_) {
            const float share = std::exchange(share_[v], 1.0F);
            const Vec3f origin = start[v].head<3>() + mean, now = points.at(v);
            const Eigen::Map<const Vec3f> was(points.before + 4 * static_cast<std::size_t>(v));
            const Vec3f to = origin + (now - origin) * share;
            const Vec3f before = to - (now - was) * share - mean_move * (1 - share);
            Eigen::Map<Vec3f>(points.now + 4 * static_cast<std::size_t>(v)) = to;
            Eigen::Map<Vec3f>(points.before + 4 * static_cast<std::size_t>(v)) = before;
        }
        report.truncated += static_cast<int>(touched_.size());
    }
    return report;
}

void DividingPlanes::collect(const SelfContactKernels& loops, const PairList& pairs, const MovingPoints& points) {
    for (std::size_t i = 0; i < pairs.block_count(); ++i) {
        const PairBlock& block = pairs.blocks()[i];
        unsigned found = loops.find_undivided(pairs.kind(), block, points.now, kGapShare, kRadiusShare, kWatched);
        for (; found != 0; found &= found - 1) {
            undivided_.push_back({&block, static_cast<std::size_t>(__builtin_ctz(found)), first_side(pairs.kind())});
        }
    }
}

// Moves the two nearest vertices apart along the divider, weighted by inverse masses.
bool DividingPlanes::part(const Undivided& pair, const MovingPoints& points, CertificateReport& report) const {
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
bool DividingPlanes::shorten(const Undivided& pair, const MovingPoints& points, float most) {
    const float asked = asked_of(*pair.block, pair.at), gap = pair.block->gap[pair.at];
    const float apart = extremes_of(*pair.block, pair.at, pair.first_side, points).apart;
    if (apart >= asked) return false;
    constexpr float kSafe = 0.98F, kLeast = 1e-12F;  // m
    const float share = most * std::clamp(kSafe * (gap - asked) / std::max(kLeast, gap - apart), 0.0F, 1.0F);
    bool changed = false;
    for (const BlockPoints& vertices : pair.block->vertices) {
        const std::uint32_t v = vertices[pair.at] / 4;
        if (points.inverse_mass(v) <= 0) continue;
        changed = true;
        if (share_[v] == 1.0F) touched_.push_back(v);
        share_[v] = std::min(share_[v], share);
    }
    return changed;
}

}  // namespace selvedge::sim
