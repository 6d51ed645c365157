#pragma once
// What cloth may not enter: how far it is, and which way out.  (SPEC 3.3)
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include "sim/collide/surface_bvh.h"
#include "sim/core/math.h"

namespace selvedge::sim {

// Points that are asked about at once, and what is known of them.  (SPEC 3.3)

struct Contact {
    float distance = 0;            // m, negative inside; a Collider's band() when it is at least that far outside
    Vec3f normal = Vec3f::Zero();  // unit, the way out; zero when distance is band()
};

inline constexpr std::size_t kContactLanes = 16;

// Spare lanes hold any point, a copy of another say.
struct alignas(64) ContactBlock {
    using Lanes = std::array<float, kContactLanes>;
    Lanes x{}, y{}, z{};     // asked, m
    Lanes distance{};        // answer, m, as in Contact
    Lanes nx{}, ny{}, nz{};  // its normal

    Vec3f point(std::size_t lane) const { return {x[lane], y[lane], z[lane]}; }
    void set_point(std::size_t lane, const Vec3f& p) {
        x[lane] = p.x();
        y[lane] = p.y();
        z[lane] = p.z();
    }
    void set(std::size_t lane, const Contact& contact) {
        distance[lane] = contact.distance;
        nx[lane] = contact.normal.x();
        ny[lane] = contact.normal.y();
        nz[lane] = contact.normal.z();
    }
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

// Colliders of which everything is known by a formula: the sphere and cylinder that cloth is dropped on, and nothing at
// all.  (SPEC 1.5)

// What has a formula knows of distances as far as anything can lie, and is off by rounding only.
class AnalyticCollider : public Collider {
 public:
    float band() const override { return 1e6F; }
    float max_error() const override { return 1e-6F; }
};

// Never touched.
class NoBody final : public AnalyticCollider {
 public:
    Contact contact(const Vec3f&) const override { return {band(), Vec3f::Zero()}; }
    std::optional<SurfaceHit> first_hit(const Vec3f&, const Vec3f&) const override { return std::nullopt; }
};

class SphereCollider final : public AnalyticCollider {
 public:
    // m. Pre: radius > 0.
    SphereCollider(const Vec3f& centre, float radius);

    Contact contact(const Vec3f& p) const override;
    std::optional<SurfaceHit> first_hit(const Vec3f& from, const Vec3f& to) const override;

 private:
    Vec3f centre_;
    float radius_;
};

struct CylinderShape {
    Vec3f centre = Vec3f::Zero();                                // m
    Vec3f axis = Vec3f::UnitX();                                 // any length but 0
    float radius = 0;                                            // m
    float half_length = std::numeric_limits<float>::infinity();  // m, from the centre to each of the flat ends
};

class CylinderCollider final : public AnalyticCollider {
 public:
    // Pre: radius and half length > 0.
    explicit CylinderCollider(const CylinderShape& shape);

    Contact contact(const Vec3f& p) const override;
    std::optional<SurfaceHit> first_hit(const Vec3f& from, const Vec3f& to) const override;

 private:
    CylinderShape shape_;  // its axis has unit length
};

}  // namespace selvedge::sim
