#include "sim/body/body_collider.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace selvedge {

namespace {

constexpr float kTrustedGradient = 0.95F;  // below, the cell spans a crease (0.2 % of samples near a body)
constexpr float kGuardReach = 0.0015F;     // m, how far the field may be off there

}  // namespace

BodyCollider::BodyCollider(const Body& body, const DistanceFieldOptions& options)
    : body_(body), bvh_(body), field_(bvh_, options) {}

Contact BodyCollider::contact(const Vec3f& p) const {
    const FieldSample sample = field_.sample(p);
    if (sample.distance >= band()) return {band(), Vec3f::Zero()};
    const float length = sample.gradient.norm();
    if (length >= kTrustedGradient) return {sample.distance, sample.gradient / length};

    const bool is_deep = sample.distance <= -band();
    const float reach = std::abs(sample.distance) + std::max(kGuardReach, max_error());
    std::optional<ClosestPoint> closest = is_deep ? std::nullopt : bvh_.closest(p, reach);
    if (!closest) closest = bvh_.closest(p, std::numeric_limits<float>::infinity());
    if (!closest || closest->distance >= band()) return {band(), Vec3f::Zero()};
    return {closest->distance, closest->normal};
}

}  // namespace selvedge
