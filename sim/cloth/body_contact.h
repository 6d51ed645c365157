#pragma once
// A contact of the cloth with a body: a carrier, which is a point of the cloth; a side of the body, which is a tangent
// plane with the offset that is kept from it; and friction. A vertex is its own carrier. A sample is one on an edge or
// within a triangle (contact.h). A face is one whose point moves within it (face_contact.h, moving_faces.h). A vertex
// in a crease has two sides (moving_contact.h). A body at rest is one whose planes do not move.
#include <array>
#include <cstdint>
#include <vector>

#include "sim/cloth/projection.h"
#include "sim/collide/tangent_plane.h"
#include "sim/core/blocks.h"
#include "sim/core/math.h"

namespace selvedge::sim {

inline constexpr float kFarAway = 1e6F;  // m, from where nothing touches the body: the slack of unused slots

// The time of a sub-step within its step, as shares of the step.
struct StepShare {
    float end = 1;     // passed at the sub-step's end
    float length = 1;  // that the sub-step takes
};

// m, kept from a plane: at the start of the step, and its change until the end, by which a point that was too low rises
struct ContactOffset {
    float start = 0, change = 0;
};

struct BodySide {
    TangentPlane plane{};
    ContactOffset offset{};
};

// A point of the cloth, at a mean of one to three vertices.
struct Carrier {
    std::array<std::uint32_t, 3> vertices{};  // those without a share may be any
    std::array<float, 3> shares{1, 0, 0};     // barycentric weights, which sum to 1
    float friction = 0;
};

// Points are by vertex, m; w: the inverse mass, 1/kg.
Vec3f point_of(const Carrier& carrier, const std::vector<Vec4f>& points);

// Moves its vertices so that the carrier moves by that (m): each by its share and its inverse mass, as an impulse at
// the carrier does. Does nothing if none can move.
void shift(const Carrier& carrier, const Vec3f& by, std::vector<Vec4f>& points);

// The side of the body at the end of a sub-step, as a point x (m) meets it. A depth of 0 where it is not below.
MetPlane<OnePoint, Vec3f> met(const BodySide& side, const Vec3f& x, const StepShare& share);

// Projects the carrier. What it gains without velocity is added to the points of the last sub-step too.
void push_out(const Carrier& carrier, const MetPlane<OnePoint, Vec3f>& plane, float friction_scale,
              std::vector<Vec4f>& points, std::vector<Vec4f>& before);

// Sides of the body for sixteen carriers, at rest, and in motion as well.
struct alignas(64) SideBlock {
    std::array<BlockFloats, 3> point{}, normal{};  // as in TangentPlane; any point at that height, m
    BlockFloats height{};                          // m, of the point above what is kept; less ContactOffset::start
};
struct alignas(64) MovingSideBlock {
    SideBlock start{};
    std::array<BlockFloats, 3> motion{}, turn{};
    BlockFloats rise{};  // ContactOffset::change
};
void set_side(MovingSideBlock& block, std::size_t slot, const BodySide& side);
// Far below anything.
void clear_side(MovingSideBlock& block, std::size_t slot);

}  // namespace selvedge::sim
