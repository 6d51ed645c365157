#pragma once
// Pinned vertices of a cloth on a body that moves: each keeps its place in the frame of the triangle of the body that
// it is nearest to.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/cloth/cloth.h"
#include "sim/cloth/step.h"
#include "sim/collide/surface_bvh.h"
#include "sim/core/math.h"

namespace selvedge::sim {

class PinnedFollowers {
 public:
    // Where the pinned vertices of the cloth are when the surface, which is now where they are, has moved to `end`, m.
    // Valid until the next call.
    std::span<const KinematicVertex> follow(const Cloth& cloth, const SurfaceBvh& surface, std::span<const Vec3f> end);

 private:
    struct Follower {
        bool is_bound = false;
        std::uint32_t triangle = 0;
        std::array<float, 3> shares{};
        float height = 0;  // m, along the triangle's normal
    };

    static Follower bound(const Vec3f& x, const SurfaceBvh& surface);
    static Vec3f place_of(const Follower& follower, const SurfaceBvh& surface, std::span<const Vec3f> x);

    std::vector<Follower> followers_;  // by vertex
    std::vector<KinematicVertex> places_;
};

}  // namespace selvedge::sim
