#pragma once
// What cloth may not enter: how far it is, and which way out.  (SPEC 3.3)
#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "sim/body/surface_bvh.h"
#include "sim/core/vec.h"

namespace selvedge {

struct Contact {
    float distance = 0;            // m, negative inside; band() when it is at least that far outside
    Vec3f normal = Vec3f::Zero();  // unit, the way out; zero when distance is band()
};

// Points that are asked about at once, and what is known of them. Spare lanes hold any point, a copy of another say.
inline constexpr std::size_t kContactLanes = 16;

struct alignas(64) ContactBlock {
    using Lanes = std::array<float, kContactLanes>;
    Lanes x{}, y{}, z{};  // asked, m
    Lanes distance{};     // answer, as in Contact
    Lanes nx{}, ny{}, nz{};
};

class Collider {
 public:
    Collider() = default;
    Collider(const Collider&) = delete;
    Collider& operator=(const Collider&) = delete;
    virtual ~Collider() = default;

    virtual Contact contact(const Vec3f& p) const = 0;

    // contact() for every lane of every block. Only what is nearer than `reach` (m) matters to the caller: an answer
    // of at least reach may be too small, by any amount; too large it is by max_error() at most, like every answer;
    // and its normal is worth nothing. So a point may move by distance - max_error() before it can touch.
    virtual void contacts(std::span<ContactBlock> blocks, float reach) const;

    // Where the segment first meets the surface, from either side.
    virtual std::optional<SurfaceHit> first_hit(const Vec3f& from, const Vec3f& to) const = 0;

    // Nothing is known of distances beyond this outside, m.
    virtual float band() const = 0;
    // Distances are at most this much too large, m; and where they are below the reach, too small.
    virtual float max_error() const = 0;
};

}  // namespace selvedge
