#include "sim/body/yielding_flesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "sim/body/parted_legs.h"
#include "sim/core/assert.h"

namespace selvedge::sim {
namespace {

constexpr float kRoom = static_cast<float>(kRoomForCloth);
constexpr float kDeepest = 0.05F;    // m, of an overlap, the radius of a slender thigh: deeper ones are left
constexpr float kFadeOut = 0.01F;    // m, over which those that are too deep are let go
constexpr float kFadeIn = 0.002F;    // m, over which pairs that lack room come in
constexpr float kThickest = 0.2F;    // m, that counts as thickness: a trunk
constexpr float kSlender = 0.03F;    // m: there is no cloth between two sides that are both less thick, as fingers
constexpr float kSpacing = 0.018F;   // m, between samples: 14 round an arm
constexpr float kPatch = 0.08F;      // m, size of patches
constexpr float kBlur = 0.025F;      // m, radius along the surface of the samples that make a distance: 6 of them
constexpr float kFullWeight = 0.5F;  // a third of the weight of all samples within kBlur, on a flat surface
constexpr float kFacing = 0.3F;      // cosine, from which the opposite of a normal counts as facing another
constexpr int kPasses = 2;           // the second takes what sides that are not parallel leave

// m, the hypotenuse of kDeepest and kBlur: samples that are farther apart are not looked at.
constexpr float kReach = 0.056F;

// A cell of a grid, and which of six directions a normal is nearest to.
using FacingCell = std::tuple<int, int, int, int>;

FacingCell cell_of(const Vec3f& x, const Vec3f& normal, float size) {
    const auto at = [&](Eigen::Index axis) { return static_cast<int>(std::floor(x[axis] / size)); };
    Eigen::Index axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    return {static_cast<int>(2 * axis) + (normal[axis] < 0 ? 1 : 0), at(0), at(1), at(2)};
}

std::vector<Vec3f> area_normals(const Body& body, const std::vector<Vec3f>& x) {
    std::vector<Vec3f> normals(x.size(), Vec3f::Zero());
    for (const auto& t : body.triangles) {
        const Vec3f &a = x[std::size_t(t[0])], &b = x[std::size_t(t[1])], &c = x[std::size_t(t[2])];
        const Vec3f normal = (b - a).cross(c - a);
        for (const int v : t) normals[std::size_t(v)] += normal;
    }
    for (Vec3f& normal : normals) normal = normal.stableNormalized();
    return normals;
}

// The least that the product of a normal in one box and one in the other can be.
float least_product(const Eigen::AlignedBox3f& a, const Eigen::AlignedBox3f& b) {
    const Eigen::Array3f low = a.min().array(), high = a.max().array();
    const Eigen::Array3f ends = (low * b.min().array()).min(low * b.max().array());
    return ends.min(high * b.min().array()).min(high * b.max().array()).sum();
}

void add_bones(const Body& body, std::uint32_t vertex, std::set<int>& bones) {
    constexpr float kLittle = 0.1F;  // weight below which a bone folds nothing
    for (std::size_t k = 0; k < 4; ++k)
        if (body.skin[vertex].weights[k] > kLittle) bones.insert(body.skin[vertex].bones[k]);
}

}  // namespace

// Where the samples of a patch are, and which ways they face.
struct PatchBounds {
    Eigen::AlignedBox3f places, normals;

    PatchBounds(std::span<const Vec3f> x, std::span<const Vec3f> n) {
        for (const Vec3f& p : x) places.extend(p);
        for (const Vec3f& normal : n) normals.extend(normal);
    }
    bool are_within(const PatchBounds& other, float distance) const {
        return places.squaredExteriorDistance(other.places) < distance * distance;
    }
    bool may_meet(const Vec3f& p, const Vec3f& normal, float distance) const {
        if (places.squaredExteriorDistance(p) >= distance * distance) return false;
        const Eigen::Array3f at_low = normal.array() * normals.min().array();
        return at_low.min(normal.array() * normals.max().array()).sum() < -kFacing;
    }
    bool may_face(const PatchBounds& other) const { return least_product(normals, other.normals) < -kFacing; }
};

namespace {

// Pairs of patches that face each other within the distance, each once.
template <class Use>
void for_facing(const std::vector<PatchBounds>& bounds, float distance, Use&& use) {
    std::vector<std::uint32_t> order(bounds.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, {}, [&](std::uint32_t i) { return std::pair(bounds[i].places.min().y(), i); });
    for (std::size_t first = 0; first < order.size(); ++first) {
        const PatchBounds& a = bounds[order[first]];
        for (std::size_t second = first; second < order.size(); ++second) {
            const PatchBounds& b = bounds[order[second]];
            if (b.places.min().y() > a.places.max().y() + distance) break;
            if (a.are_within(b, distance) && a.may_face(b)) use(order[first], order[second]);
        }
    }
}

}  // namespace

// The samples in a pose.
struct YieldingFlesh::Now {
    std::vector<Vec3f> x, normal;  // m, unit
};

// What a vertex knows of the other side: weighted sums over samples.
struct YieldingFlesh::Found {
    float weight = 0;
    Vec3f back = Vec3f::Zero();  // m, the way that it goes
};

YieldingFlesh::YieldingFlesh(const Body& body) {
    SELVEDGE_ASSERT(body.skin.size() == body.x.size());
    const std::vector<Vec3d>& bind = body.bind.empty() ? body.x : body.bind;
    for (const Vec3d& x : bind) bind_.emplace_back(x.cast<float>());
    constexpr double kLargest = 100;  // m: what has no size of a body has no flesh
    if (!std::ranges::all_of(bind, [](const Vec3d& x) { return x.norm() < kLargest; })) return;
    make_samples(body);
    measure_thickness();
    find_what_never_meets(body);
    std::vector<std::vector<std::uint32_t>> at(bind_.size());
    for (std::size_t t = 0; t < body.triangles.size(); ++t)
        for (const int v : body.triangles[t]) at[std::size_t(v)].push_back(std::uint32_t(t));
    for (Sample& sample : samples_) {
        sample.triangles_begin = std::uint32_t(around_.size());
        for (const std::uint32_t t : at[sample.vertex]) {
            const auto& triangle = body.triangles[t];
            around_.push_back({std::uint32_t(triangle[0]), std::uint32_t(triangle[1]), std::uint32_t(triangle[2])});
        }
        sample.triangles_end = std::uint32_t(around_.size());
    }
}

// Of the vertices in a cell, the one nearest to their middle is the sample.
void YieldingFlesh::make_samples(const Body& body) {
    const std::vector<Vec3f> normals = area_normals(body, bind_);
    std::map<std::pair<FacingCell, FacingCell>, std::vector<std::uint32_t>> cells;  // by patch
    for (std::size_t v = 0; v < bind_.size(); ++v)
        cells[{cell_of(bind_[v], normals[v], kPatch), cell_of(bind_[v], normals[v], kSpacing)}].push_back(
            std::uint32_t(v));
    const FacingCell* last = nullptr;
    for (const auto& [cell, members] : cells) {
        Vec3f middle = Vec3f::Zero();
        for (const std::uint32_t v : members) middle += bind_[v] / float(members.size());
        const auto nearer = [&](std::uint32_t a, std::uint32_t b) {
            return (bind_[a] - middle).squaredNorm() < (bind_[b] - middle).squaredNorm();
        };
        Sample sample{.vertex = *std::ranges::min_element(members, nearer)};
        sample.bind = bind_[sample.vertex];
        sample.bind_normal = normals[sample.vertex];
        sample.members_begin = std::uint32_t(members_.size());
        members_.insert(members_.end(), members.begin(), members.end());
        sample.members_end = std::uint32_t(members_.size());
        if (last == nullptr || *last != cell.first) patches_.push_back({std::uint32_t(samples_.size()), 0});
        last = &cell.first;
        samples_.push_back(sample);
        patches_.back().end = std::uint32_t(samples_.size());
    }
}

// To the nearest samples of the opposite side, on average.
void YieldingFlesh::measure_thickness() {
    std::vector<std::vector<std::pair<float, float>>> opposite(samples_.size());  // height and weight
    const auto note = [&](std::uint32_t i, std::uint32_t k) {
        const Vec3f way = samples_[i].bind - samples_[k].bind;
        const float height = samples_[i].bind_normal.dot(way);
        const float aside = 1 - (way.squaredNorm() - height * height) / (kBlur * kBlur);
        if (height > 0 && height < kThickest && aside > 0) opposite[i].emplace_back(height, aside * aside);
    };
    for_facing(bind_bounds(), kThickest, [&](std::uint32_t a, std::uint32_t b) {
        for (std::uint32_t i = patches_[a].begin; i < patches_[a].end; ++i) {
            for (std::uint32_t k = patches_[b].begin; k < patches_[b].end; ++k) {
                if (samples_[i].bind_normal.dot(samples_[k].bind_normal) > -kFacing) continue;
                note(i, k);
                note(k, i);
            }
        }
    });
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        samples_[i].thickness = kThickest;
        if (opposite[i].empty()) continue;
        const float least = std::ranges::min(opposite[i]).first;
        float sum = 0, weights = 0;
        for (const auto& [height, weight] : opposite[i]) {
            if (height > least + kBlur) continue;
            sum += weight * height;
            weights += weight;
        }
        samples_[i].thickness = sum / weights;
    }
}

// Patches of which no samples may meet: what one bone moves alone does not fold; what is far from each other is not the
// same flesh.
void YieldingFlesh::find_what_never_meets(const Body& body) {
    never_meet_.assign(patches_.size() * patches_.size(), false);
    std::vector<std::set<int>> bones(patches_.size());
    for (std::size_t p = 0; p < patches_.size(); ++p)
        for (std::uint32_t i = patches_[p].begin; i < patches_[p].end; ++i)
            add_bones(body, samples_[i].vertex, bones[p]);
    const auto may_meet = [&](const Range& a, const Range& b) {
        for (std::uint32_t i = a.begin; i < a.end; ++i) {
            for (std::uint32_t k = b.begin; k < b.end; ++k) {
                if (samples_[i].thickness < kSlender && samples_[k].thickness < kSlender) continue;
                if (relation(samples_[i].bind, samples_[k]).weight > 0) return true;
                if (relation(samples_[k].bind, samples_[i]).weight > 0) return true;
            }
        }
        return false;
    };
    const std::vector<PatchBounds> bounds = bind_bounds();
    for (std::size_t a = 0; a < patches_.size(); ++a) {
        for (std::size_t b = a; b < patches_.size(); ++b) {
            if (!bounds[a].are_within(bounds[b], 2 * kDeepest)) continue;
            const bool is_rigid = bones[a].size() == 1 && bones[a] == bones[b];
            const bool never_meet = is_rigid || !may_meet(patches_[a], patches_[b]);
            never_meet_[a * patches_.size() + b] = never_meet_[b * patches_.size() + a] = never_meet;
        }
    }
}

std::vector<PatchBounds> YieldingFlesh::bind_bounds() const {
    std::vector<Vec3f> x, normals;
    for (const Sample& sample : samples_) {
        x.push_back(sample.bind);
        normals.push_back(sample.bind_normal);
    }
    std::vector<PatchBounds> bounds;
    for (const auto& [begin, end] : patches_)
        bounds.emplace_back(std::span(x).subspan(begin, end - begin), std::span(normals).subspan(begin, end - begin));
    return bounds;
}

// Of a vertex that was bound at a, to a sample of the other side. Far places are never the same flesh.
YieldingFlesh::Relation YieldingFlesh::relation(const Vec3f& a, const Sample& b) const {
    const Vec3f way = a - b.bind;
    const float near = std::clamp(2 - way.norm() / kDeepest, 0.0F, 1.0F), height = b.bind_normal.dot(way);
    return {.weight = 1 - near * std::clamp(-height / kFadeOut, 0.0F, 1.0F),
            .room = near * std::min(kRoom, height) + (1 - near) * kRoom};
}

// With a part in the region, or near enough to press on one that has. Cloth goes where the flesh goes that it is on:
// what comes near to it is looked for that much farther away. None if a sample is not finite.
std::vector<std::uint32_t> YieldingFlesh::patches_near(const std::vector<Vec3f>& x, const Region& region,
                                                       std::span<const Vec3f> before) const {
    if (before.empty()) before = x;
    Vec3d motion = Vec3d::Zero();
    for (std::size_t v = 0; v < x.size(); ++v) motion += (x[v] - before[v]).cast<double>();
    const Vec3f drift = (motion / std::max(1.0, static_cast<double>(x.size()))).cast<float>();
    const float reach = kReach + kSpacing;
    std::vector<bool> is_near(patches_.size(), false);
    float farthest = 0;  // that flesh in the region goes, relative to the drift
    const auto mark_near = [&](const Region& wide, const auto& place) {
        for (std::size_t p = 0; p < patches_.size(); ++p) {
            Eigen::AlignedBox3f box;
            for (std::uint32_t i = patches_[p].begin; i < patches_[p].end; ++i) box.extend(place(samples_[i].vertex));
            if (wide.meets(box)) is_near[p] = true;
        }
    };
    mark_near(region.grown(reach), [&](std::uint32_t v) { return before[v]; });
    for (std::size_t p = 0; p < patches_.size(); ++p) {
        for (std::uint32_t i = patches_[p].begin; i < patches_[p].end; ++i) {
            const std::uint32_t v = samples_[i].vertex;
            if (!x[v].allFinite()) return {};
            if (is_near[p]) farthest = std::max(farthest, (x[v] - before[v] - drift).norm());
        }
    }
    mark_near(region.grown(reach + farthest), [&](std::uint32_t v) { return Vec3f(x[v] - drift); });
    std::vector<std::uint32_t> near;
    for (std::uint32_t p = 0; p < patches_.size(); ++p)
        if (is_near[p]) near.push_back(p);
    return near;
}

void YieldingFlesh::place_samples(const std::vector<Vec3f>& x, std::span<const std::uint32_t> patches, Now& now) const {
    now.x.resize(samples_.size());
    now.normal.resize(samples_.size());
    for (const std::uint32_t p : patches) {
        for (std::uint32_t i = patches_[p].begin; i < patches_[p].end; ++i) {
            const Sample& sample = samples_[i];
            now.x[i] = x[sample.vertex];
            Vec3f normal = Vec3f::Zero();
            for (std::uint32_t t = sample.triangles_begin; t < sample.triangles_end; ++t) {
                const auto [a, b, c] = around_[t];
                normal += (x[b] - x[a]).cross(x[c] - x[a]);
            }
            now.normal[i] = normal.stableNormalized();
        }
    }
}

// Samples that face each other with too little room between them, or between their members.
std::vector<YieldingFlesh::Pair> YieldingFlesh::find_pairs(const Now& now,
                                                           std::span<const std::uint32_t> patches) const {
    std::vector<Pair> pairs;
    std::vector<PatchBounds> bounds;
    for (const std::uint32_t p : patches) {
        const auto [begin, end] = patches_[p];
        bounds.emplace_back(std::span(now.x).subspan(begin, end - begin),
                            std::span(now.normal).subspan(begin, end - begin));
    }
    for_facing(bounds, kReach, [&](std::uint32_t a, std::uint32_t b) {
        const std::uint32_t first = patches[a], second = patches[b];
        if (never_meet_[first * patches_.size() + second]) return;
        find_between(now, patches_[first], patches_[second], bounds[b], pairs);
    });
    return pairs;
}

void YieldingFlesh::find_between(const Now& now, const Range& own, const Range& other, const PatchBounds& bounds,
                                 std::vector<Pair>& pairs) const {
    const auto note = [&](std::uint32_t i, std::uint32_t k, float height) {
        if (height >= kRoom + kFadeOut) return;
        const Relation bound = relation(samples_[i].bind, samples_[k]);
        if (bound.weight > 0 && height < bound.room + kFadeOut) pairs.push_back({i, k});
    };
    for (std::uint32_t i = own.begin; i < own.end; ++i) {
        if (!bounds.may_meet(now.x[i], now.normal[i], kReach)) continue;
        for (std::uint32_t k = own.begin == other.begin ? i + 1 : other.begin; k < other.end; ++k) {
            const Vec3f way = now.x[i] - now.x[k];
            if (way.squaredNorm() >= kReach * kReach || now.normal[i].dot(now.normal[k]) >= -kFacing) continue;
            if (samples_[i].thickness < kSlender && samples_[k].thickness < kSlender) continue;
            note(i, k, now.normal[k].dot(way));
            note(k, i, -now.normal[i].dot(way));
        }
    }
}

// Springs in series share a way by their lengths: the thicker flesh goes back farther.
void YieldingFlesh::gather(const std::vector<Vec3f>& x, const Now& now, std::span<const Pair> pairs,
                           std::vector<Found>& found) const {
    for (const auto& [i, k] : pairs) {
        const float facing = -now.normal[i].dot(now.normal[k]) - kFacing;
        if (facing <= 0) continue;
        const Sample &own = samples_[i], &other = samples_[k];
        const float share = own.thickness / (own.thickness + other.thickness);
        for (std::uint32_t m = own.members_begin; m < own.members_end; ++m) {
            const std::uint32_t v = members_[m];
            const Vec3f way = x[v] - now.x[k];
            const float height = now.normal[k].dot(way);
            const float aside = 1 - (way.squaredNorm() - height * height) / (kBlur * kBlur);
            if (aside <= 0 || height <= -kDeepest) continue;
            const Relation bound = relation(bind_[v], other);
            const float lack = bound.room - height;
            if (lack <= 0) continue;
            const float weight = bound.weight * facing * aside * aside * std::min(1.0F, lack / kFadeIn);
            const float held = std::min(1.0F, (kDeepest + height) / kFadeOut);
            found[v].weight += weight;
            found[v].back += weight * held * share * lack * now.normal[k];
        }
    }
}

void YieldingFlesh::give_way(std::vector<Vec3f>& x, const Region& region, std::span<const Vec3f> before) const {
    SELVEDGE_ASSERT(x.size() == bind_.size() && (before.empty() || before.size() == x.size()));
    const std::vector<std::uint32_t> patches = patches_near(x, region, before);
    Now now;
    place_samples(x, patches, now);
    const std::vector<Pair> pairs = find_pairs(now, patches);
    for (int pass = 0; pass < kPasses && !pairs.empty(); ++pass) {
        if (pass > 0) place_samples(x, patches, now);
        std::vector<Found> found(x.size());
        gather(x, now, pairs, found);
        for (std::size_t v = 0; v < x.size(); ++v)
            if (found[v].weight > 0) x[v] += found[v].back / std::max(found[v].weight, kFullWeight);
    }
}

const MovingFlesh::Knot& MovingFlesh::knot(const Body& body, const std::function<Pose(double)>& pose_at, long index,
                                           const Region& region) {
    Knot& knot = knots_[static_cast<std::size_t>(index % 2)];
    if (knot.index == index) return knot;
    std::vector<Vec3f> x;
    surface_.skin().positions(body, pose_at(static_cast<double>(index) * kFleshSeconds), x);
    knot = {.index = index, .way = x};
    surface_.flesh().give_way(knot.way, region, last_);
    for (std::size_t v = 0; v < x.size(); ++v) knot.way[v] -= x[v];
    return knot;
}

void MovingFlesh::positions(const Body& body, const std::function<Pose(double)>& pose_at, double seconds,
                            const Region& region, std::vector<Vec3f>& x) {
    constexpr double kAtKnot = 1e-6;  // share of the way between two
    const double at = std::max(0.0, seconds / kFleshSeconds);
    const auto index = static_cast<long>(std::floor(at + kAtKnot));
    const double share = at - static_cast<double>(index);
    surface_.skin().positions(body, pose_at(seconds), x);
    const std::vector<Vec3f>& before = knot(body, pose_at, index, region).way;
    if (share < kAtKnot) {
        for (std::size_t v = 0; v < x.size(); ++v) x[v] += before[v];
    } else {
        const std::vector<Vec3f>& after = knot(body, pose_at, index + 1, region).way;
        const auto weight = static_cast<float>(share);
        for (std::size_t v = 0; v < x.size(); ++v) x[v] += (1 - weight) * before[v] + weight * after[v];
    }
    last_ = x;
}

Body posed(const Body& body, const Pose& pose) {
    return posed(body, pose, FleshSurface(body));
}

Body posed(const Body& body, const Pose& pose, const FleshSurface& surface) {
    Body result = body;
    std::vector<Vec3f> x;
    surface.positions(body, pose, x);
    std::ranges::transform(x, result.x.begin(), [](const Vec3f& p) { return Vec3d(p.cast<double>()); });
    const std::vector<Eigen::Affine3d> frames = bone_frames(body, pose);
    for (std::size_t i = 0; i < result.bones.size(); ++i) {
        result.bones[i].rest = pose.bones[i];
        result.bones[i].joint = frames[i].translation();
    }
    if (result.bind.empty()) result.bind = body.x;
    result.made_from.clear();  // of another surface
    return result;
}

}  // namespace selvedge::sim
