#pragma once
// Collider for a static body. It samples a distance field; where that is not reliable (at creases, deep inside) it
// computes the exact closest point on the surface. (thesis 4.4)
#include <functional>

#include "sim/body/body.h"
#include "sim/collide/collider.h"
#include "sim/collide/distance_field.h"
#include "sim/collide/surface_bvh.h"

namespace selvedge::sim {

class BodyCollider final : public Collider {
 public:
    // The body must outlive the collider. interrupt: see DistanceField. Pre: the body's surface is closed.
    explicit BodyCollider(const Body& body, const DistanceFieldOptions& options = {},
                          const std::function<void()>& interrupt = {});

    Contact contact(const Vec3f& p) const override;
    void contacts(std::span<ContactBlock> blocks, float reach) const override;
    std::optional<SurfaceHit> first_hit(const Vec3f& from, const Vec3f& to) const override {
        return bvh_.first_hit(from, to);
    }
    float band() const override { return field_.band(); }
    // The field's maximum error; contacts from the exact surface have none.
    float max_error() const override { return field_.max_error(); }

    const Body& body() const { return body_; }
    const SurfaceBvh& surface() const { return bvh_; }
    const DistanceField& field() const { return field_; }

 private:
    Contact exact_contact(const Vec3f& p, float field_distance) const;

    const Body& body_;
    SurfaceBvh bvh_;
    DistanceField field_;
};

}  // namespace selvedge::sim
