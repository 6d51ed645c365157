#include "sim/dress/limbs_aside.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "sim/cloth/contact.h"
#include "sim/dress/drape.h"
#include "sim/place/limb_pieces.h"
#include "sim/place/limbs.h"

namespace selvedge::sim {
namespace {

constexpr float kShortestFall = 1.4F;  // s: gravity grows for 1 s of it, and cloth that does not fall yet is calm too
constexpr float kLongestFall = 3.0F;   // s: cloth that swings for longer is not waited for
constexpr float kCalmSpeed = 0.15F;    // m/s, rms: the cloth has fallen
constexpr float kTurnSpeed = 1.0F;     // rad/s: the hand moves by 6 mm per step, half its thickness
constexpr float kAngleStep = std::numbers::pi_v<float> / 36;  // rad, between tested angles
constexpr float kHighest = 24 * kAngleStep;                   // 120 degrees: from 45 below to 75 above the horizontal
constexpr float kClear = 0.005F;  // m, from raised arms: more than the offset of contact, which would push the cloth

}  // namespace

LimbsAside::LimbsAside(std::unique_ptr<JointedCollider> collider, std::vector<bool> is_below)
    : collider_(std::move(collider)), is_below_(std::move(is_below)) {}

std::unique_ptr<LimbsAside> LimbsAside::plan(const GarmentMesh& unsewn, const GarmentMesh& sewing,
                                             const Pattern& pattern, const MeasuredBody& body,
                                             const std::function<void()>& interrupt, const ContentStore* store) {
    const BodyLimbs& limbs = body.limbs();
    if (limbs.torso.empty()) return nullptr;
    const std::vector<bool> panels = panels_without_arms(unsewn, pattern, limbs);
    if (std::ranges::none_of(panels, std::identity())) return nullptr;
    BodyInPieces parts = cut_off(body.body(), limbs, kArms);
    if (parts.limbs.size() < kArms.size()) return nullptr;
    std::vector<bool> is_below(sewing.x.size(), false);
    for (const GarmentTriangle& t : sewing.triangles) {
        for (const int v : t.vertices)
            is_below[static_cast<std::size_t>(v)] = panels[static_cast<std::size_t>(t.panel)];
    }
    auto collider = std::make_unique<JointedCollider>(
        std::move(parts.trunk), std::vector{std::move(parts.limbs[0].piece), std::move(parts.limbs[1].piece)},
        interrupt, store);
    return std::unique_ptr<LimbsAside>(new LimbsAside(std::move(collider), std::move(is_below)));
}

bool LimbsAside::advance(SewingRun& sewing) {
    const float before = sewing.seconds();
    const bool goes_on = advance_phase(sewing);
    seconds_ += sewing.seconds() - before;
    return goes_on && !sewing.has_bad_number();
}

bool LimbsAside::advance_phase(SewingRun& sewing) {
    switch (phase_) {
        case Phase::Close:
            if (!is_ready_) sewing.meet_trunk_only(is_below_);
            is_ready_ = true;
            if (!sewing.advance(*collider_)) begin(Phase::Fall, sewing);
            break;
        case Phase::Fall:
            sewing.fall(*collider_, std::min(1.0F, seconds_ / static_cast<float>(DrapeOptions{}.lowering_time)));
            if (seconds_ > kLongestFall || (seconds_ > kShortestFall && sewing.rms_speed() < kCalmSpeed)) {
                raised_ = clear_angle(sewing);
                begin(Phase::Raise, sewing);
            }
            break;
        case Phase::Raise:
            angle_ = std::min(raised_, seconds_ * kTurnSpeed);
            turn_arms();
            sewing.forget_contacts();
            sewing.fall(*collider_);
            if (angle_ >= raised_) begin(Phase::Lower, sewing);
            break;
        case Phase::Lower:
            if (angle_ <= 0) return false;
            angle_ = std::max(0.0F, raised_ - seconds_ * kTurnSpeed);
            turn_arms();
            sewing.forget_contacts();
            sewing.fall(*collider_);
            break;
    }
    return true;
}

void LimbsAside::begin(Phase phase, SewingRun& sewing) {
    phase_ = phase;
    seconds_ = 0;
    if (phase == Phase::Lower) sewing.meet_trunk_only({});
}

void LimbsAside::turn_arms() {
    for (std::size_t i = 0; i < kArms.size(); ++i) {
        const float side = kArms[i] == LimbKind::LeftArm ? 1.0F : -1.0F;
        collider_->turn(i, Eigen::Quaternionf(Eigen::AngleAxisf(side * angle_, Vec3f::UnitZ())));
    }
}

// Whether no cloth that ignores the arms is in them.
bool LimbsAside::is_clear(const SewingRun& sewing) const {
    const Cloth& cloth = sewing.cloth();
    for (const LeafEdge& leaf : cloth.mesh.leaf_edges()) {
        const auto& ends = cloth.mesh.edge(leaf.edge).ends;
        if (!is_below_[ends[0].value]) continue;
        const Vec3f a = cloth.x[ends[0].value].head<3>(), b = cloth.x[ends[1].value].head<3>();
        for (std::size_t i = 0; i < collider_->piece_count(); ++i) {
            if (collider_->meets_piece(i, a, b) || collider_->distance_to_piece(i, a, 2 * kClear) < kClear)
                return false;
        }
    }
    return true;
}

// The smallest angle above which the arms are clear; 0 if they are where they are.
float LimbsAside::clear_angle(const SewingRun& sewing) {
    float clear = kHighest;
    for (angle_ = kHighest; angle_ > -kAngleStep / 2; angle_ -= kAngleStep) {
        turn_arms();
        if (!is_clear(sewing)) break;
        clear = std::max(0.0F, angle_);
    }
    angle_ = 0;
    turn_arms();
    return clear;
}

}  // namespace selvedge::sim
