#pragma once
// Collider for a body that moves: its vertices travel along straight lines from where they are to where they will be at
// the end of a step. A contact point asks once per step for the triangle that is nearest to it, and then follows that
// triangle's tangent plane, which moves with the surface. (thesis 5.3.4, 5.3.5)
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/body/body.h"
#include "sim/collide/collider.h"
#include "sim/collide/surface_bvh.h"
#include "sim/collide/tangent_plane.h"
#include "sim/collide/thin_parts.h"

namespace selvedge::sim {

// A point that looks for the surface, and a triangle of it that is near, if one is known.
struct SearchPoint {
    Vec3f x = Vec3f::Zero();  // m
    std::uint32_t known = NearestTriangle::kNone;
};

class MovingBodyCollider final : public Collider {
 public:
    // Starts at rest, where the body is. The body need not outlive the collider. Pre: its surface is closed.
    explicit MovingBodyCollider(const Body& body);

    // Sets where the surface is at the end of the next step: vertex positions, m. What stays outside of the region is
    // left out of all answers until the next call, as in SurfaceBvh::sweep_to(). Pre: as many as the body has.
    void move_to(std::span<const Vec3f> x, const Region& region = {});
    // m, the longest_deformation() that move_to() would set.
    float deformation_to(std::span<const Vec3f> x, const Region& region) const;
    // Ends the step: the surface is where move_to() sent it, and rests until the next call of that.
    void arrive();
    // Puts the surface there without motion. Contact caches of cloths are invalid after it (forget_contacts).
    void place(std::span<const Vec3f> x);

    // The surface at the start of the step.
    const SurfaceBvh& surface() const { return bvh_; }
    // m, the largest distance that a vertex travels in the step; and that one in the region travels relative to the
    // surface's drift
    float longest_motion() const { return longest_motion_; }
    float longest_deformation() const { return longest_deformation_; }
    // Where the body is thin, on its way in the step.
    std::vector<ThinPart> thin_parts_in_step() const { return thin_parts_.between(bvh_.points(), bvh_.end_points()); }
    // The tangent plane at the point of the triangle that is nearest to p.
    TangentPlane plane_at(std::uint32_t triangle, const Vec3f& p) const;

    // The points of the surface, at the start of the step, that are nearest to these; nullopt where none is within
    // `radius` (m). A triangle that is known only makes the search faster.
    std::vector<std::optional<ClosestPoint>> closest(std::span<const SearchPoint> points, float radius) const;

    const MovingBodyCollider* moving() const override { return this; }

    // As for any collider, of the surface at the start of the step. A point that lies deeper than kDeepest counts as
    // outside, at band().
    static constexpr float kDeepest = 0.01F;  // m
    Contact contact(const Vec3f& p) const override;
    void contacts(std::span<ContactBlock> blocks, float reach) const override;
    std::optional<SurfaceHit> first_hit(const Vec3f& from, const Vec3f& to) const override {
        return bvh_.first_hit(from, to);
    }
    float band() const override { return kDeepest; }
    float max_error() const override { return 1e-6F; }  // rounding

 private:
    SurfaceBvh bvh_;
    MovingThinParts thin_parts_;
    float longest_motion_ = 0, longest_deformation_ = 0;
};

}  // namespace selvedge::sim
