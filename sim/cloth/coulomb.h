#pragma once
// Coulomb friction of a contact, by positions: friction takes back the sliding of a point over the surface, by up to
// the friction coefficient times the depth by which the surface pushed the point out, for that depth is the normal
// impulse times h / m.  (Bridson et al. 2002, friction; Macklin et al. 2014, "Unified Particle Physics", friction)
//
// Written once, for one point and for as many as a SIMD register holds: Math says what a number and a vector are.
#include <algorithm>
#include <cmath>

#include "sim/core/math.h"

namespace selvedge::sim {

// The arithmetic of one point.
struct OnePoint {
    using Real = float;
    using Xyz = Vec3f;

    static float dot(const Vec3f& a, const Vec3f& b) { return a.dot(b); }
    // a - b t
    static Vec3f minus(const Vec3f& a, const Vec3f& b, float t) { return a - b * t; }
    static Vec3f scaled(const Vec3f& a, float t) { return a * t; }
    // The share of a vector of that squared length that a length of `held` is, at most 1; 0 of none.
    static float share_of(float held, float squared) {
        return squared > 0 ? std::min(1.0F, held / std::sqrt(squared)) : 0.0F;
    }
};

// What friction takes back of the motion of a point relative to the surface (m): its sliding, by up to `held` (m).
template <class Math>
[[gnu::always_inline]] inline typename Math::Xyz taken_by_friction(const typename Math::Xyz& motion,
                                                                   const typename Math::Xyz& normal,
                                                                   typename Math::Real held) {
    const typename Math::Xyz sliding = Math::minus(motion, normal, Math::dot(motion, normal));
    return Math::scaled(sliding, Math::share_of(held, Math::dot(sliding, sliding)));
}

}  // namespace selvedge::sim
