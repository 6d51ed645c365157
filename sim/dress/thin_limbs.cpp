#include "sim/dress/thin_limbs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/cloth/cloth_penetration.h"
#include "sim/collide/body_collider.h"
#include "sim/mesh/sew.h"
#include "sim/place/limb_pieces.h"
#include "sim/place/limbs.h"

namespace selvedge::sim {
namespace {

constexpr double kThin = 0.3;             // of the distance from the centre line: wrists of 16 mm
constexpr float kSampleSpacing = 0.008F;  // m: a thin wrist cannot pass between two samples of an edge
constexpr float kLargestMove = 0.004F;    // m, of the surface between two sizes, so that it does not pass cloth
constexpr int kStepsPerSize = 2;          // to push the cloth out
constexpr int kStepsToClose = 60;         // 0.5 s, in which seams close that the growing limbs pulled open

// Where cloth is in the body, and the middles of links that are open.
std::vector<Vec3f> find_faults(const SewingRun& done, const SurfaceBvh& surface) {
    const auto depth = static_cast<float>(kFaceDip);
    const Penetration found = find_penetration(done.cloth(), surface, {.depth = depth});
    std::vector<Vec3f> points;
    for (const PassingEdge& edge : found.passing) points.push_back(edge.at);
    if (found.deepest > 0) points.push_back(found.at);
    for (const SeamLink& link : done.links()) {
        const Vec3f a = done.cloth().x[static_cast<std::size_t>(link.a)].head<3>();
        const Vec3f b = done.cloth().x[static_cast<std::size_t>(link.b)].head<3>();
        if ((a - b).norm() > done.closed_gap()) points.emplace_back((a + b) / 2);
    }
    return points;
}

// Both arms, or both legs, or both, if a point lies at one of them.
std::vector<LimbKind> limbs_at(const std::vector<Vec3f>& points, const BodyLimbs& limbs) {
    std::vector<LimbKind> kinds;
    for (const auto& pair : {kArms, kLegs}) {
        const auto is_at = [&](const Vec3f& p) {
            const auto nearest = nearest_on_limbs(limbs, p.cast<double>());
            return nearest && nearest->limb && std::ranges::find(pair, *nearest->limb) != pair.end();
        };
        if (std::ranges::any_of(points, is_at)) kinds.insert(kinds.end(), pair.begin(), pair.end());
    }
    return kinds;
}

}  // namespace

ThinLimbs::ThinLimbs(std::unique_ptr<JointedCollider> collider, std::vector<Shapes> limbs)
    : collider_(std::move(collider)), limbs_(std::move(limbs)) {
    double longest = 0;  // m
    for (const Shapes& limb : limbs_) {
        for (std::size_t v = 0; v < limb.thin.size(); ++v)
            longest = std::max(longest, (limb.full.x[v] - limb.thin[v]).norm());
    }
    sizes_ = static_cast<int>(std::ceil(longest / static_cast<double>(kLargestMove)));
    grow(0);
}

std::unique_ptr<ThinLimbs> ThinLimbs::plan(const SewingRun& done, const BodyCollider& body,
                                           const std::function<void()>& interrupt, const ContentStore* store) {
    const std::vector<Vec3f> faults = find_faults(done, body.surface());
    if (faults.empty()) return nullptr;
    const BodyLimbs limbs = find_limbs(body.body());
    BodyInPieces parts = cut_off(body.body(), limbs, limbs_at(faults, limbs));
    if (parts.limbs.empty()) return nullptr;
    GarmentMesh closed = done.unsewn();
    merge_seams(closed);
    std::vector<Shapes> shapes;
    for (const LimbPiece& limb : parts.limbs)
        shapes.push_back({limb.piece.surface, bend_limb(limb, limbs, way_out(closed, limb, limbs), kThin).x});
    std::vector<BodyPiece> pieces;
    for (const LimbPiece& limb : parts.limbs) pieces.push_back(limb.piece);
    auto collider = std::make_unique<JointedCollider>(std::move(parts.trunk), pieces, interrupt, store);
    return std::unique_ptr<ThinLimbs>(new ThinLimbs(std::move(collider), std::move(shapes)));
}

std::size_t ThinLimbs::count_faults(const SewingRun& done, const BodyCollider& body) {
    return find_faults(done, body.surface()).size();
}

ContactOptions ThinLimbs::contact(const ContactOptions& usual) {
    ContactOptions close = usual;
    close.sample_spacing = std::min(usual.sample_spacing, kSampleSpacing);
    return close;
}

bool ThinLimbs::advance(SewingRun& sewing) {
    if (steps_ == 0) {
        if (!sewing.advance(*collider_)) ++steps_;
        return !sewing.has_bad_number();
    }
    const int size = 1 + (steps_ - 1) / kStepsPerSize;
    if (size > sizes_ && (sewing.is_closed() || steps_ > kStepsPerSize * sizes_ + kStepsToClose)) return false;
    if (size <= sizes_ && steps_ % kStepsPerSize == 1) {
        grow(static_cast<double>(size) / sizes_);
        sewing.keep_far_contacts(kLargestMove);
    }
    sewing.hold(*collider_);
    ++steps_;
    return !sewing.has_bad_number();
}

// 0: thin; 1: as the body has them.
void ThinLimbs::grow(double share) {
    for (std::size_t i = 0; i < limbs_.size(); ++i) {
        std::vector<Vec3f> now;
        now.reserve(limbs_[i].thin.size());
        for (std::size_t v = 0; v < limbs_[i].thin.size(); ++v)
            now.emplace_back((limbs_[i].thin[v] + share * (limbs_[i].full.x[v] - limbs_[i].thin[v])).cast<float>());
        collider_->reshape(i, now);
    }
}

}  // namespace selvedge::sim
