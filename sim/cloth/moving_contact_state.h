#pragma once
// What the contacts of a cloth with a body that moves know, by step and from step to step; see moving_contact.h.
#include <array>
#include <cstdint>
#include <vector>

#include "sim/cloth/body_contact.h"
#include "sim/collide/moving_body.h"
#include "sim/core/blocks.h"
#include "sim/core/math.h"

namespace selvedge::sim {

inline constexpr float kRecovery =
    1;  // m/s, at which vertices and faces rise to their contact offset, without velocity
inline constexpr float kUnforeseen = 0.002F;  // m, that forces may add to a way until the next search

struct alignas(64) MovingVertexBlock {
    BlockPoints vertices{};  // unused slots: the dummy vertex
    BlockFloats friction{};
    MovingSideBlock side{};
};

// A vertex between two sides of the body; the first is its own.
struct CreaseContact {
    Carrier carrier{};
    std::array<BodySide, 2> sides{};
};

// A face that may meet a thin part of the body, at the point of it that is nearest to that.
struct MovingFace {
    Carrier carrier{};
    BodySide side{};
};

// A vertex to which no triangle comes near within the step, as far as its way can be foreseen. When it leaves the ball
// of this radius round `centre`, which drifts with the surface, it searches again.
struct FreeVertex {
    std::uint32_t vertex = 0;
    Vec3f centre = Vec3f::Zero();  // m, less the drift
    float radius = 0;              // m
};

// What a vertex knows of the surface after a step; the plane is where the step ended.
struct LastContact {
    static constexpr std::uint32_t kNone = NearestTriangle::kNone;
    std::uint32_t triangle = kNone;
    std::uint32_t second = kNone;  // of the other side, in a crease
    bool is_pinched = false;       // that leaves less room than the offset of both sides
    Vec3f point = Vec3f::Zero(), normal = Vec3f::Zero();
    Vec3f motion = Vec3f::Zero();  // of the surface there in the step, m
};

struct MovingContacts {
    std::vector<MovingVertexBlock> vertices;
    std::vector<CreaseContact> creases;
    std::vector<FreeVertex> free;
    std::vector<MovingSideBlock> samples;  // as ContactState::samples; unused where is_sample_near is 0
    std::vector<std::uint8_t> is_sample_near;
    std::vector<MovingFace> faces;
    std::vector<LastContact> last;             // by vertex
    std::vector<std::uint32_t> order;          // the vertices that can move, neighbours in space near each other
    std::uint32_t order_made_at = UINT32_MAX;  // Cloth::adaptations
    int pinched = 0;  // vertices without room for the contact offset on both sides, in the last sub-step
};

}  // namespace selvedge::sim
