#pragma once
// The projection of a contact: a point of the cloth that is below what it keeps from a plane of the body is moved
// there, and Coulomb friction takes back its sliding over the surface. By positions, the normal impulse is the depth by
// which the motion of the point, or of the surface, made it too low: friction holds a sliding of up to the friction
// coefficient times that depth. Depth that a point had before, and which is taken away without velocity, is no impulse.
// (Bridson et al. 2002, "Robust Treatment of Collisions, Contact and Friction for Cloth Animation"; Macklin et al.
// 2014, "Unified Particle Physics for Real-Time Applications": friction, and stabilization of initial conditions)
//
// Written once, for one point and for as many as a SIMD register holds: Math says what a number and a vector are.
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "sim/core/math.h"

namespace selvedge::sim {

// The arithmetic of one point.
struct OnePoint {
    using Real = float;
    using Xyz = Vec3f;

    static float dot(const Vec3f& a, const Vec3f& b) { return a.dot(b); }
    static Vec3f minus(const Vec3f& a, const Vec3f& b) { return a - b; }
    // a + b t and a - b t
    static Vec3f plus(const Vec3f& a, const Vec3f& b, float t) { return a + b * t; }
    static Vec3f minus(const Vec3f& a, const Vec3f& b, float t) { return a - b * t; }
    // The share of a vector of that squared length that a length of `held` is, at most 1; 0 of none.
    static float share_of(float held, float squared) {
        return squared > 0 ? std::min(1.0F, held / std::sqrt(squared)) : 0.0F;
    }
};

// The motion of a body at rest: none, and it costs nothing.
struct AtRest {};

// A plane as a point meets it at the end of a sub-step.
template <class Math, class Motion = AtRest>
struct MetPlane {
    typename Math::Xyz normal{};   // unit, out of the body
    typename Math::Real depth{};   // m, of the point below what it keeps from the plane; not negative
    typename Math::Real gained{};  // m, the part of the depth that gives no velocity, and so no friction
    Motion motion{};               // m, of the surface in the sub-step
};

// The point x moved out of the body; from: where it was at the start of the sub-step, both m.
template <class Math, class Motion>
[[gnu::always_inline]] inline typename Math::Xyz projected(const typename Math::Xyz& x, const typename Math::Xyz& from,
                                                           const MetPlane<Math, Motion>& plane,
                                                           typename Math::Real friction) {
    const typename Math::Xyz out = Math::plus(x, plane.normal, plane.depth);
    typename Math::Xyz moved = Math::minus(out, from);
    if constexpr (!std::is_same_v<Motion, AtRest>) moved = Math::minus(moved, plane.motion);
    const typename Math::Xyz sliding = Math::minus(moved, plane.normal, Math::dot(moved, plane.normal));
    const typename Math::Real held = friction * (plane.depth - plane.gained);
    return Math::minus(out, sliding, Math::share_of(held, Math::dot(sliding, sliding)));
}

}  // namespace selvedge::sim
