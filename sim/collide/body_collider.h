#pragma once
// Collider for a static body. It samples a distance field; where that is not reliable (at creases, deep inside) it
// computes the exact closest point on the surface. (thesis 4.4)
#include <functional>
#include <span>
#include <vector>

#include "sim/body/body.h"
#include "sim/collide/collider.h"
#include "sim/collide/distance_field.h"
#include "sim/collide/surface_bvh.h"
#include "sim/collide/thin_parts.h"

namespace selvedge::sim {

class ContentStore;

class BodyCollider final : public Collider {
 public:
    // The body must outlive the collider. interrupt: see DistanceField. store: where the field may be found and is
    // kept, null for none. Pre: the body's surface is closed.
    explicit BodyCollider(const Body& body, const DistanceFieldOptions& options = {},
                          const std::function<void()>& interrupt = {}, const ContentStore* store = nullptr);

    Contact contact(const Vec3f& p) const override;
    void contacts(std::span<ContactBlock> blocks, float reach) const override;
    std::optional<SurfaceHit> first_hit(const Vec3f& from, const Vec3f& to) const override {
        return bvh_.first_hit(from, to);
    }
    const SurfaceBvh* exact_surface() const override { return &bvh_; }
    std::span<const ThinPart> thin_parts() const override { return thin_parts_; }
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
    std::vector<ThinPart> thin_parts_;
};

}  // namespace selvedge::sim
