#pragma once
// Colliders of which everything is known by a formula: the sphere and cylinder that cloth is dropped on, and nothing at
// all.  (SPEC 1.5)
#include <limits>

#include "sim/body/collider.h"

namespace selvedge {

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

}  // namespace selvedge
