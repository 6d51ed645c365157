#include "sim/collide/collider.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/core/assert.h"

namespace selvedge::sim {
void Collider::contacts(std::span<ContactBlock> blocks, float /*reach*/) const {
    for (ContactBlock& block : blocks)
        for (std::size_t i = 0; i < kContactLanes; ++i) block.set(i, contact(block.point(i)));
}

void Collider::contacts_apart(std::span<ContactBlock> blocks, std::span<const std::uint16_t> /*trunk_only*/,
                              float reach) const {
    contacts(blocks, reach);
}

namespace {

constexpr float kNoDirection = 1e-12F;  // m, a shorter vector has no usable direction
constexpr double kNever = std::numeric_limits<double>::infinity();

// Fractions at which |start + t along| = radius, smaller first; kNever where the line misses or has zero length.
std::array<double, 2> ball_crossings(const Vec3d& start, const Vec3d& along, double radius) {
    const double a = along.squaredNorm();
    const double b = start.dot(along);
    const double root = b * b - a * (start.squaredNorm() - radius * radius);
    if (a <= 0 || root < 0) return {kNever, kNever};
    return {(-b - std::sqrt(root)) / a, (-b + std::sqrt(root)) / a};
}

// The smallest fraction that lies on the segment and that `counts` accepts.
template <std::size_t count, class Counts>
std::optional<double> first_fraction(std::array<double, count> fractions, const Counts& counts) {
    std::sort(fractions.begin(), fractions.end());
    for (const double t : fractions)
        if (t >= 0 && t <= 1 && counts(t)) return t;
    return std::nullopt;
}

}  // namespace

SphereCollider::SphereCollider(const Vec3f& centre, float radius) : centre_(centre), radius_(radius) {
    SELVEDGE_ASSERT(radius > 0);
}

Contact SphereCollider::contact(const Vec3f& p) const {
    const Vec3f out = p - centre_;
    const float length = out.norm();
    return {length - radius_, length > kNoDirection ? Vec3f(out / length) : Vec3f::UnitY()};
}

std::optional<SurfaceHit> SphereCollider::first_hit(const Vec3f& from, const Vec3f& to) const {
    const Vec3d start = (from - centre_).cast<double>();
    const Vec3d along = (to - from).cast<double>();
    const auto fraction = first_fraction(ball_crossings(start, along, double(radius_)), [](double) { return true; });
    if (!fraction) return std::nullopt;
    const Vec3f normal = (start + along * *fraction).normalized().cast<float>();
    return SurfaceHit{.point = centre_ + normal * radius_, .normal = normal, .fraction = float(*fraction)};
}

CylinderCollider::CylinderCollider(const CylinderShape& shape) : shape_(shape) {
    SELVEDGE_ASSERT(shape.radius > 0 && shape.half_length > 0 && shape.axis.norm() > kNoDirection);
    shape_.axis.normalize();
}

Contact CylinderCollider::contact(const Vec3f& p) const {
    const Vec3f offset = p - shape_.centre;
    const float along = offset.dot(shape_.axis);
    const Vec3f across = offset - shape_.axis * along;
    const float from_axis = across.norm();
    const Vec3f sideways = from_axis > kNoDirection ? Vec3f(across / from_axis) : shape_.axis.unitOrthogonal();
    const Vec3f endways = along < 0 ? Vec3f(-shape_.axis) : shape_.axis;
    const float beside = from_axis - shape_.radius;
    const float beyond = std::abs(along) - shape_.half_length;
    if (beside <= 0 || beyond <= 0) return beside > beyond ? Contact{beside, sideways} : Contact{beyond, endways};
    const float distance = std::hypot(beside, beyond);  // to the rim
    return {distance, (sideways * beside + endways * beyond) / distance};
}

std::optional<SurfaceHit> CylinderCollider::first_hit(const Vec3f& from, const Vec3f& to) const {
    const Vec3d axis = shape_.axis.cast<double>();
    const double half = double(shape_.half_length);
    const double radius = double(shape_.radius);
    const Vec3d start = (from - shape_.centre).cast<double>();
    const Vec3d step = (to - from).cast<double>();
    const auto across = [&](const Vec3d& v) { return Vec3d(v - axis * v.dot(axis)); };

    const std::array<double, 2> side = ball_crossings(across(start), across(step), radius);
    const auto on_side = first_fraction(side, [&](double t) { return std::abs((start + t * step).dot(axis)) <= half; });
    const double rise = step.dot(axis);
    std::array<double, 2> ends{kNever, kNever};
    if (rise != 0) ends = {(half - start.dot(axis)) / rise, (-half - start.dot(axis)) / rise};
    const auto on_end = first_fraction(ends, [&](double t) { return across(start + t * step).norm() <= radius; });
    if (!on_side && !on_end) return std::nullopt;

    const bool is_end = on_end && (!on_side || *on_end < *on_side);
    const double fraction = is_end ? *on_end : *on_side;
    const Vec3d at = start + fraction * step;
    const Vec3d normal = is_end ? Vec3d(axis * std::copysign(1.0, at.dot(axis))) : across(at).normalized();
    return SurfaceHit{
        .point = shape_.centre + at.cast<float>(), .normal = normal.cast<float>(), .fraction = float(fraction)};
}

}  // namespace selvedge::sim
