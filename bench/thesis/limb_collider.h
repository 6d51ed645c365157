#pragma once
// The thesis' cylinders and spheres as what cloth collides with. The surface stands still while the cloth makes its
// sub-steps, and is moved between them.  (thesis 5.3.4, 5.4.2)
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "bench/thesis/limb_cylinders.h"
#include "sim/collide/collider.h"

namespace selvedge::bench {

class LimbCollider final : public sim::Collider {
 public:
    // m: the structures list triangles out to this distance. It must exceed the distances at which cloth is held.
    static constexpr double kReach = 0.01;

    // Starts in the body's rest pose. Pre: the body has a skin.
    explicit LimbCollider(const sim::Body& body) : limbs_(body, {.margin = kReach}) {}

    // As LimbBounds::move_to(). Contact caches of cloths are invalid after it (keep_far_contacts).
    void move_to(const sim::Body& body, const sim::Pose& pose, std::span<const Vec3f> x, LimbTimes* times = nullptr) {
        limbs_.move_to(body, pose, x, times);
    }

    // The nearest triangle's. A point that lies deeper than kReach counts as outside, for no structure lists what is
    // nearest to it.
    sim::Contact contact(const Vec3f& p) const override;
    void contacts(std::span<sim::ContactBlock> blocks, float reach) const override;
    std::optional<sim::SurfaceHit> first_hit(const Vec3f& from, const Vec3f& to) const override;
    float band() const override { return static_cast<float>(kReach); }
    // m, rounding, as long as the rigid triangles stay within the slack (LimbOptions)
    float max_error() const override { return 1e-6F; }

    const LimbBounds& limbs() const { return limbs_; }

 private:
    sim::Contact contact(const Vec3f& p, std::vector<std::uint32_t>& triangles) const;

    LimbBounds limbs_;
};

}  // namespace selvedge::bench
