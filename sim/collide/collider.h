#pragma once
// Interface to the objects that cloth collides with: signed distance and normal at points, first hits of segments. Also
// the analytic colliders: sphere, cylinder, and none. (thesis 4.4)
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "sim/collide/surface_bvh.h"
#include "sim/core/math.h"

namespace selvedge::sim {

// Batches of query points and their contacts.

struct Contact {
    float distance = 0;            // m, negative inside; the Collider's band() at that distance outside or farther
    Vec3f normal = Vec3f::Zero();  // unit, pointing out of the body; zero when distance is band()
};

inline constexpr std::size_t kContactLanes = 16;

// Sixteen query points and their results. Unused slots hold any point, for example a copy of another.
struct alignas(64) ContactBlock {
    using Lanes = std::array<float, kContactLanes>;
    Lanes x{}, y{}, z{};     // query points, m
    Lanes distance{};        // result, m, as in Contact
    Lanes nx{}, ny{}, nz{};  // result, as in Contact

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

struct ThinPart;
class MovingBodyCollider;

class Collider {
 public:
    Collider() = default;
    Collider(const Collider&) = delete;
    Collider& operator=(const Collider&) = delete;
    virtual ~Collider() = default;

    virtual Contact contact(const Vec3f& p) const = 0;

    // contact() for every slot of every block. The caller needs exact results only nearer than `reach` (m): a returned
    // distance of at least reach may be too small by any amount, and its normal is undefined. No distance is too large
    // by more than max_error(), so a point can move by distance - max_error() before it can touch the surface.
    virtual void contacts(std::span<ContactBlock> blocks, float reach) const;

    // The same for colliders that have a body's limbs apart: the slots of trunk_only, a bit per slot and a mask per
    // block, have no contact with the limbs. Other colliders have no such parts.
    virtual void contacts_apart(std::span<ContactBlock> blocks, std::span<const std::uint16_t> trunk_only,
                                float reach) const;

    // Whether a query costs by its slots rather than by its blocks, so that slots that need no contact are left out, as
    // those of trunk_only are.
    virtual bool costs_by_slot() const { return false; }

    // First intersection of the segment with the surface, from either side.
    virtual std::optional<SurfaceHit> first_hit(const Vec3f& from, const Vec3f& to) const = 0;

    // The exact surface, if the collider has one that does not move; and its thin parts.
    virtual const SurfaceBvh* exact_surface() const { return nullptr; }
    virtual std::span<const ThinPart> thin_parts() const { return {}; }

    // The collider itself if its surface moves during a step.
    virtual const MovingBodyCollider* moving() const { return nullptr; }

    // Distances outside are capped at this value, m.
    virtual float band() const = 0;
    // Bound on the error of a distance, m: for overestimates always, for underestimates where the distance is below
    // `reach`.
    virtual float max_error() const = 0;
};

// Analytic colliders: the sphere and cylinder of the thesis' drop experiments (thesis 3.8.2), and no body at all.

// Distances come from a formula: the band is practically unlimited and the error is rounding only.
class AnalyticCollider : public Collider {
 public:
    float band() const override { return 1e6F; }
    float max_error() const override { return 1e-6F; }
};

// No body: reports no contact anywhere.
class NoBody final : public AnalyticCollider {
 public:
    Contact contact(const Vec3f&) const override { return {band(), Vec3f::Zero()}; }
    std::optional<SurfaceHit> first_hit(const Vec3f&, const Vec3f&) const override { return std::nullopt; }
};

class SphereCollider final : public AnalyticCollider {
 public:
    // Lengths in m. Pre: radius > 0.
    SphereCollider(const Vec3f& centre, float radius);

    Contact contact(const Vec3f& p) const override;
    std::optional<SurfaceHit> first_hit(const Vec3f& from, const Vec3f& to) const override;

 private:
    Vec3f centre_;
    float radius_;
};

struct CylinderShape {
    Vec3f centre = Vec3f::Zero();                                // m
    Vec3f axis = Vec3f::UnitX();                                 // any non-zero length
    float radius = 0;                                            // m
    float half_length = std::numeric_limits<float>::infinity();  // m, from the centre to each flat end
};

class CylinderCollider final : public AnalyticCollider {
 public:
    // Pre: radius and half length > 0.
    explicit CylinderCollider(const CylinderShape& shape);

    Contact contact(const Vec3f& p) const override;
    std::optional<SurfaceHit> first_hit(const Vec3f& from, const Vec3f& to) const override;

 private:
    CylinderShape shape_;  // with a unit axis
};

}  // namespace selvedge::sim
