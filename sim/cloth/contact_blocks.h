#pragma once
// What points of the cloth know of the body, as the inner loops read it.
//
// A point remembers where it last asked the collider and how far it may go before it can touch: the true distance
// changes no faster than the point moves. Where it may touch, and has not gone far, it takes the body for the plane
// that it saw there; only when it has gone farther it asks again. So cloth that lies still asks nothing.
#include <array>

#include "sim/cloth/solver_blocks.h"

namespace selvedge {

// Colliders are asked with a reach of so much more than the contact offset, so that a plane within it can be trusted.
inline constexpr float kPlaneReach = 0.0002F;  // m: a plane is off by at most its square / (2 R), 2 um at R = 1 cm

// By vertex, four floats each.
struct ContactKnowledge {
    static constexpr float kLost = -1;      // m: a slack below it: nothing is known, ask
    static constexpr float kUnknown = -10;  // m, such a slack

    float* asked = nullptr;  // place, and fourth the slack, m
    float* plane = nullptr;  // unit normal there, and fourth the height above the offset surface, m
};

// Points of the cloth between vertices: of an edge, or the middle of a triangle. A spare lane is far from everything.
struct alignas(64) SampleBlock {
    std::array<BlockPoints, 3> vertices{};  // none twice within a block; of an edge the third is the spare point
    std::array<BlockFloats, 3> shares{};    // of each vertex in the point; they sum to 1
    BlockFloats friction{};
    std::array<BlockFloats, 3> asked{};  // m, as in ContactKnowledge
    BlockFloats slack{};
    std::array<BlockFloats, 3> normal{};
    BlockFloats height{};
    BlockFloats sunk{};  // m below the offset surface when it was new
};

}  // namespace selvedge
