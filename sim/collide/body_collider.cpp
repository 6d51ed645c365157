#include "sim/collide/body_collider.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/content_store.h"
#include "sim/core/flat_bytes.h"
#include "sim/core/simd_level.h"

namespace selvedge::sim {
namespace {

constexpr float kGuardReach = 0.0015F;  // m, assumed maximum error of the field at a crease

// The level of SIMD belongs to it, because plain kernels differ from the others by rounding. AVX2 and AVX-512 give
// identical bits, so machines of both kinds share their fields.
std::string made_from(const SurfaceBvh& bvh, const DistanceFieldOptions& options) {
    FlatWriter writer;
    writer.value(simd_level() == SimdLevel::Plain);
    writer.value(options.cell);
    writer.value(options.band);
    writer.list(std::vector(bvh.points().begin(), bvh.points().end()));
    writer.list(std::vector(bvh.triangles().begin(), bvh.triangles().end()));
    return writer.bytes();
}

// The field of the surface, with the same bits whether it is made or found in the store, where a new one is kept.
DistanceField stored_field(const SurfaceBvh& bvh, const DistanceFieldOptions& options,
                           const std::function<void()>& interrupt, const ContentStore* store) {
    const auto make = [&] { return DistanceField(bvh, options, interrupt); };
    if (store == nullptr) return make();
    return find_or_make(
        store, "field", made_from(bvh, options), make, [](const DistanceField& field) { return field.to_bytes(); },
        DistanceField::from_bytes);
}

}  // namespace

BodyCollider::BodyCollider(const Body& body, const DistanceFieldOptions& options,
                           const std::function<void()>& interrupt, const ContentStore* store)
    : body_(body),
      bvh_(body),
      field_(stored_field(bvh_, options, interrupt, store)),
      thin_parts_(find_thin_parts(bvh_, field_)) {}

Contact BodyCollider::contact(const Vec3f& p) const {
    const FieldSample sample = field_.sample(p);
    if (sample.distance >= band()) return {band(), Vec3f::Zero()};
    const Vec3f& g = sample.gradient;
    const float length = std::sqrt(g.x() * g.x() + g.y() * g.y() + g.z() * g.z());
    if (length < DistanceField::kTrustedGradient) return exact_contact(p, sample.distance);
    return {sample.distance, g * (1 / length)};
}

void BodyCollider::contacts(std::span<ContactBlock> blocks, float reach) const {
    constexpr std::size_t kAtOnce = 64;
    std::array<std::uint16_t, kAtOnce> doubtful;
    for (std::size_t first = 0; first < blocks.size(); first += kAtOnce) {
        const std::span<ContactBlock> some = blocks.subspan(first, std::min(kAtOnce, blocks.size() - first));
        field_.sample(some, reach, doubtful);
        for (std::size_t b = 0; b < some.size(); ++b)
            for (unsigned lanes = doubtful[b]; lanes != 0; lanes &= lanes - 1) {
                const std::size_t i = std::size_t(std::countr_zero(lanes));
                some[b].set(i, exact_contact(some[b].point(i), some[b].distance[i]));
            }
    }
}

Contact BodyCollider::exact_contact(const Vec3f& p, float field_distance) const {
    const bool is_deep = field_distance <= -band();
    const float reach = std::abs(field_distance) + std::max(kGuardReach, max_error());
    std::optional<ClosestPoint> closest = is_deep ? std::nullopt : bvh_.closest(p, reach);
    if (!closest) closest = bvh_.closest(p, std::numeric_limits<float>::infinity());
    if (!closest || closest->distance >= band()) return {band(), Vec3f::Zero()};
    return {closest->distance, closest->normal};
}

}  // namespace selvedge::sim
