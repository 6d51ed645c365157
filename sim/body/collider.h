#pragma once
// What cloth asks of a body that stands still: how far, and which way out. The distance field answers; where it cannot
// be trusted (creases, deep inside) the exact surface does.  (SPEC 3.3)
#include "sim/body/body.h"
#include "sim/body/distance_field.h"
#include "sim/body/surface_bvh.h"

namespace selvedge {

struct Contact {
    float distance = 0;            // m, negative inside; band() when it is at least that far outside
    Vec3f normal = Vec3f::Zero();  // unit, the way out of the body; zero when distance is band()
};

class BodyCollider {
 public:
    // The body must outlive the collider. Pre: it is closed.
    explicit BodyCollider(const Body& body, const DistanceFieldOptions& options = {});

    Contact contact(const Vec3f& p) const;

    // Distances are at most this far off where contact() did not ask the exact surface, m (see DistanceField).
    float max_error() const { return field_.max_error(); }
    // Nothing is known of distances beyond this outside, m.
    float band() const { return field_.band(); }

    const Body& body() const { return body_; }
    const SurfaceBvh& surface() const { return bvh_; }
    const DistanceField& field() const { return field_; }

 private:
    const Body& body_;
    SurfaceBvh bvh_;
    DistanceField field_;
};

}  // namespace selvedge
