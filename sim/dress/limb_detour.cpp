#include "sim/dress/limb_detour.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "sim/cloth/cloth_penetration.h"
#include "sim/dress/drape.h"
#include "sim/mesh/sew.h"
#include "sim/place/limb_pieces.h"
#include "sim/place/limbs.h"
#include "sim/place/openings.h"

namespace selvedge::sim {
namespace {

// Raised arms.

constexpr float kShortestFall = 1.4F;  // s: gravity grows for 1 s of it, and cloth that does not fall yet is calm too
constexpr float kLongestFall = 3.0F;   // s: cloth that swings for longer is not waited for
constexpr float kCalmSpeed = 0.15F;    // m/s, rms: the cloth has fallen
constexpr float kTurnSpeed = 1.0F;     // rad/s: the hand moves by 6 mm per step, half its thickness
constexpr float kAngleStep = std::numbers::pi_v<float> / 36;  // rad, between tested angles: 6 cm at the hand
constexpr float kHighest = 24 * kAngleStep;                   // 120 degrees: from 45 below to 75 above the horizontal
constexpr float kClear = 0.005F;  // m, from raised arms: more than the offset of contact, which would push the cloth

struct RaisedArms {
    std::vector<bool> is_below;  // by vertex of the run's mesh: of a panel that ignores the arms
    float angle = 0;             // rad, by which the arms are raised
    float highest = 0;           // rad, where they are clear

    bool fall(SewingRun& run, JointedCollider& limbs, float seconds);
    bool raise(SewingRun& run, JointedCollider& limbs, float seconds);
    bool lower(SewingRun& run, JointedCollider& limbs, float seconds);

    void turn(JointedCollider& limbs, float by);
    bool is_clear(const SewingRun& run, const JointedCollider& limbs) const;
    float clear_angle(const SewingRun& run, JointedCollider& limbs);
};

bool RaisedArms::fall(SewingRun& run, JointedCollider& limbs, float seconds) {
    run.fall(limbs, std::min(1.0F, seconds / static_cast<float>(DrapeOptions{}.lowering_time)));
    if (seconds <= kLongestFall && (seconds <= kShortestFall || run.rms_speed() >= kCalmSpeed)) return true;
    highest = clear_angle(run, limbs);
    return false;
}

bool RaisedArms::raise(SewingRun& run, JointedCollider& limbs, float seconds) {
    turn(limbs, std::min(highest, seconds * kTurnSpeed));
    run.forget_contacts();
    run.fall(limbs);
    if (angle < highest) return true;
    run.meet_trunk_only({});
    return false;
}

bool RaisedArms::lower(SewingRun& run, JointedCollider& limbs, float seconds) {
    if (angle <= 0) return false;
    turn(limbs, std::max(0.0F, highest - seconds * kTurnSpeed));
    run.forget_contacts();
    run.fall(limbs);
    return true;
}

void RaisedArms::turn(JointedCollider& limbs, float by) {
    angle = by;
    for (std::size_t i = 0; i < kArms.size(); ++i) {
        const float side = kArms[i] == LimbKind::LeftArm ? 1.0F : -1.0F;
        limbs.turn(i, Eigen::Quaternionf(Eigen::AngleAxisf(side * by, Vec3f::UnitZ())));
    }
}

// Whether no cloth that ignores the arms is in them.
bool RaisedArms::is_clear(const SewingRun& run, const JointedCollider& limbs) const {
    const Cloth& cloth = run.cloth();
    for (const LeafEdge& leaf : cloth.mesh.leaf_edges()) {
        const auto& ends = cloth.mesh.edge(leaf.edge).ends;
        if (!is_below[ends[0].value]) continue;
        const Vec3f a = cloth.x[ends[0].value].head<3>(), b = cloth.x[ends[1].value].head<3>();
        for (std::size_t i = 0; i < limbs.piece_count(); ++i) {
            if (limbs.meets_piece(i, a, b) || limbs.distance_to_piece(i, a, 2 * kClear) < kClear) return false;
        }
    }
    return true;
}

// The smallest angle from which on the arms are clear up to kHighest, rad; 0 if they are so without being raised,
// kHighest also if they are clear nowhere.
float RaisedArms::clear_angle(const SewingRun& run, JointedCollider& limbs) {
    float clear = kHighest;
    for (float tested = kHighest; tested > -kAngleStep / 2; tested -= kAngleStep) {
        turn(limbs, tested);
        if (!is_clear(run, limbs)) break;
        clear = std::max(0.0F, tested);
    }
    turn(limbs, 0);
    return clear;
}

// Thin limbs.

constexpr double kThin = 0.3;             // share of the distance from the centre line that stays: wrists of 16 mm
constexpr float kSampleSpacing = 0.008F;  // m: a thin wrist cannot pass between two samples of an edge
constexpr float kLargestMove = 0.004F;    // m, of the surface between two sizes, so that it does not pass cloth
constexpr int kStepsPerSize = 2;          // in which cloth is pushed out, before the limbs grow on
constexpr int kStepsToClose = 60;         // 0.5 s, in which seams close that the growing limbs pulled open

struct ThinLimb {
    Body full;
    std::vector<Vec3d> thin;  // m
};

// share 0: thin; 1: as the body has it.
void grow(const std::vector<ThinLimb>& limbs, JointedCollider& collider, double share) {
    for (std::size_t i = 0; i < limbs.size(); ++i) {
        const auto& [full, thin] = limbs[i];
        std::vector<Vec3f> now;
        now.reserve(thin.size());
        for (std::size_t v = 0; v < thin.size(); ++v)
            now.emplace_back((thin[v] + share * (full.x[v] - thin[v])).cast<float>());
        collider.reshape(i, now);
    }
}

LimbDetour::Stage growing(std::vector<ThinLimb> limbs) {
    double longest = 0;  // m
    for (const auto& [full, thin] : limbs) {
        for (std::size_t v = 0; v < thin.size(); ++v) longest = std::max(longest, (full.x[v] - thin[v]).norm());
    }
    const int sizes = static_cast<int>(std::ceil(longest / static_cast<double>(kLargestMove)));
    return [limbs = std::move(limbs), sizes, steps = 0](SewingRun& run, JointedCollider& collider, float) mutable {
        const int size = 1 + steps / kStepsPerSize;
        if (size > sizes && (run.is_closed() || steps >= kStepsPerSize * sizes + kStepsToClose)) return false;
        if (size <= sizes && steps % kStepsPerSize == 0) {
            grow(limbs, collider, static_cast<double>(size) / sizes);
            run.keep_far_contacts(kLargestMove);
        }
        run.hold(collider);
        ++steps;
        return true;
    };
}

// The positions of a closed mesh's vertices: each the mean of those that were joined to it.
std::vector<Vec3d> positions_of(const Cloth& cloth, const std::vector<int>& joined, std::size_t vertices) {
    std::vector<Vec3d> sum(vertices, Vec3d::Zero());
    std::vector<int> count(vertices, 0);
    for (std::size_t v = 0; v < joined.size(); ++v) {
        const auto at = static_cast<std::size_t>(joined[v]);
        sum[at] += cloth.x[v].head<3>().cast<double>();
        ++count[at];
    }
    for (std::size_t v = 0; v < vertices; ++v) sum[v] /= std::max(1, count[v]);
    return sum;
}

// The arm whose sleeve an opening ends; none if it is no sleeve's.
std::optional<LimbKind> arm_of(const Opening& opening, const GarmentMesh& placed, const BodyLimbs& limbs) {
    std::vector<Vec3d> points;
    for (const GarmentTriangle& t : placed.triangles) {
        if (t.panel != opening.panels.front()) continue;
        for (const int v : t.vertices) points.push_back(placed.x[static_cast<std::size_t>(v)]);
    }
    return arm_nearest_to(points, limbs, 0.5);
}

// The arms and legs that leave a garment through another opening than they would where its panels were placed.
// `is_clear`: whether no cloth is in the body. If some is, a limb may leave the garment through it.
LimbSet missed_limbs(const SewingRun& done, const BodyLimbs& limbs, bool is_clear) {
    GarmentMesh closed = done.unsewn();
    const std::vector<int> joined = merge_seams(closed);
    const std::vector<Opening> openings = find_openings(closed);
    const std::vector<Vec3d> now = positions_of(done.cloth(), joined, closed.x.size());
    const LimbPassages meant = find_passages(closed, closed.x, openings, limbs, {.ends_at_cloth = true});
    const LimbPassages found = find_passages(closed, now, openings, limbs, {.ends_at_cloth = is_clear});
    const LimbSet known = meant.known & found.known;
    LimbSet missed, in_sleeve;
    for (std::size_t i = 0; i < openings.size(); ++i) {
        LimbSet other = (meant.through[i] ^ found.through[i]) & known;
        // Both sets are known up to their complement.
        if (2 * other.count() > known.count()) other = known & ~other;
        missed |= other;
        // An arm in the end of its own sleeve is where it belongs, however the panels were placed.
        const auto arm = arm_of(openings[i], closed, limbs);
        if (arm && found.through[i].count() == 1 && found.through[i][index_of(*arm)]) in_sleeve.set(index_of(*arm));
    }
    missed &= ~in_sleeve;
    missed.reset(index_of(LimbKind::Head));
    return missed;
}

// Where cloth is in the body, and the middles of links that are open.
std::vector<Vec3f> find_sewing_faults(const SewingRun& done, const SurfaceBvh& surface) {
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

// Both arms, or both legs, or both, if one of them is missed, or a point lies at one.
std::vector<LimbKind> limbs_at(const std::vector<Vec3f>& points, LimbSet missed, const BodyLimbs& limbs) {
    std::vector<LimbKind> kinds;
    for (const auto& pair : {kArms, kLegs}) {
        const auto is_at = [&](const Vec3f& p) {
            const auto nearest = nearest_on_limbs(limbs, p.cast<double>());
            return nearest && nearest->limb && std::ranges::find(pair, *nearest->limb) != pair.end();
        };
        const bool is_missed = std::ranges::any_of(pair, [&](LimbKind kind) { return missed[index_of(kind)]; });
        if (is_missed || std::ranges::any_of(points, is_at)) kinds.insert(kinds.end(), pair.begin(), pair.end());
    }
    return kinds;
}

std::unique_ptr<JointedCollider> collider_of(BodyInPieces parts, const std::function<void()>& interrupt,
                                             const ContentStore* store) {
    std::vector<BodyPiece> pieces;
    for (LimbPiece& limb : parts.limbs) pieces.push_back(std::move(limb.piece));
    return std::make_unique<JointedCollider>(std::move(parts.trunk), pieces, interrupt, store);
}

}  // namespace

SewingRun LimbDetour::start(GarmentMesh unsewn, const std::vector<Fabric>& fabrics, SewingOptions options) const {
    float& spacing = options.simulation.contact.sample_spacing;
    spacing = std::min(spacing, plan_.sample_spacing);
    SewingRun run(std::move(unsewn), fabrics, options);
    if (!plan_.first_links.empty()) run.close_first(plan_.first_links);
    if (!plan_.trunk_only.empty()) run.meet_trunk_only(plan_.trunk_only);
    return run;
}

bool LimbDetour::advance(SewingRun& run) {
    const float before = run.seconds();
    const bool goes_on =
        stage_ == 0 ? run.advance(*plan_.limbs) : plan_.way_back[stage_ - 1](run, *plan_.limbs, seconds_);
    if (!goes_on) {
        ++stage_;
        seconds_ = 0;
    }
    seconds_ += run.seconds() - before;
    return stage_ <= plan_.way_back.size() && !run.has_bad_number();
}

std::unique_ptr<LimbDetour> plan_raised_arms(const GarmentMesh& unsewn, const GarmentMesh& sewing,
                                             const Pattern& pattern, const MeasuredBody& body,
                                             const std::function<void()>& interrupt, const ContentStore* store) {
    const BodyLimbs& limbs = body.limbs();
    if (limbs.torso.empty()) return nullptr;
    const std::vector<bool> panels = panels_without_arms(unsewn, pattern, limbs);
    if (!are_in_way_of_arms(panels, unsewn, limbs)) return nullptr;
    BodyInPieces parts = cut_off(body.body(), limbs, kArms);
    if (parts.limbs.size() < kArms.size()) return nullptr;
    const auto arms = std::make_shared<RaisedArms>();
    arms->is_below.resize(sewing.x.size(), false);
    for (const GarmentTriangle& t : sewing.triangles) {
        for (const int v : t.vertices)
            arms->is_below[static_cast<std::size_t>(v)] = panels[static_cast<std::size_t>(t.panel)];
    }
    const auto stage = [&](bool (RaisedArms::*step)(SewingRun&, JointedCollider&, float)) {
        return std::bind_front(step, arms);
    };
    return std::make_unique<LimbDetour>(
        LimbDetour::Plan{.limbs = collider_of(std::move(parts), interrupt, store),
                         .trunk_only = arms->is_below,
                         .first_links = {},
                         .way_back = {stage(&RaisedArms::fall), stage(&RaisedArms::raise), stage(&RaisedArms::lower)}});
}

std::unique_ptr<LimbDetour> plan_thin_limbs(const SewingRun& done, const BodyCollider& body, const BodyLimbs& limbs,
                                            const std::function<void()>& interrupt, const ContentStore* store) {
    const std::vector<Vec3f> faults = find_sewing_faults(done, body.surface());
    const LimbSet missed = missed_limbs(done, limbs, faults.empty());
    if (faults.empty() && missed.none()) return nullptr;
    BodyInPieces parts = cut_off(body.body(), limbs, limbs_at(faults, missed, limbs));
    if (parts.limbs.empty()) return nullptr;
    GarmentMesh closed = done.unsewn();
    std::vector<LimbKind> kinds;
    for (const LimbPiece& limb : parts.limbs) kinds.push_back(limb.kind);
    std::vector<bool> first_links = links_along_limbs(closed, limbs, kinds);
    merge_seams(closed);
    std::vector<ThinLimb> thin;
    for (const LimbPiece& limb : parts.limbs)
        thin.push_back({limb.piece.surface, bend_limb(limb, limbs, way_out(closed, limb, limbs), kThin).x});
    auto collider = collider_of(std::move(parts), interrupt, store);
    grow(thin, *collider, 0);
    return std::make_unique<LimbDetour>(LimbDetour::Plan{.limbs = std::move(collider),
                                                         .trunk_only = {},
                                                         .first_links = std::move(first_links),
                                                         .sample_spacing = kSampleSpacing,
                                                         .way_back = {growing(std::move(thin))}});
}

SewingFaults count_sewing_faults(const SewingRun& done, const BodyCollider& body, const BodyLimbs& limbs) {
    const std::size_t places = find_sewing_faults(done, body.surface()).size();
    return {.missed_limbs = missed_limbs(done, limbs, places == 0).count(), .places = places};
}

}  // namespace selvedge::sim
