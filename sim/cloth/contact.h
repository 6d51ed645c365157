#pragma once
// Keeping cloth outside a body that stands still, at the contact offset, with Coulomb friction.  (SPEC 2, 3.3)
//
// A vertex remembers where it last asked the body and how far it may go before it must ask again: the true distance
// changes no faster than the vertex moves. Between vertices the cloth is sampled too: in the middle of every triangle,
// and along edges that are long for the body's curvature.
#include <array>
#include <cstdint>
#include <vector>

#include "sim/core/vec.h"

namespace selvedge {

struct Cloth;
class Collider;

struct ContactOptions {
    float offset = 0.003F;          // m, kept from the body; never below the collision field's error
    float friction_scale = 1.0F;    // of the fabrics' friction; 0 while sewing
    float sample_spacing = 0.025F;  // m, edges longer than this are sampled at least this often
    float floor = 0.0F;             // m, height of the floor
};

// A point of the cloth that may not enter the body: a leaf vertex, a point of an edge, or the middle of a triangle.
struct ContactPoint {
    std::array<std::uint32_t, 3> vertices{};
    std::array<float, 3> shares{1, 0, 0};  // of each vertex in the point; they sum to 1
    int vertex_count = 1;
    float friction = 0;
    float slack = -1;  // m it may move from asked_at before it is asked again; negative: ask now
    Vec4f asked_at = Vec4f::Zero();
};

struct ContactState {
    std::vector<ContactPoint>
        points;  // leaf vertices first, then points of edges and triangles; refreshed by an adaption
};

// Points for the present leaves. What is known of vertices that were points before is kept.
void refresh_contacts(Cloth& cloth, const ContactOptions& options = {});

// Moves the points between vertices at least `offset` away from the body and the floor and takes off tangential motion
// since x_prev up to friction times the depth corrected.
void push_out_between(Cloth& cloth, const Collider& body, const ContactOptions& options);

// The same for the vertices themselves. Last in a sub-step: a drawn vertex is never inside.
void push_out_vertices(Cloth& cloth, const Collider& body, const ContactOptions& options);

// x moved to the contact offset if it is nearer to the body or inside, else x: by way of the closest point, which takes
// the wrong side far less often than a ray; where it lies against `outward`, by a ray along outward, ahead or behind.
// (SPEC 3.3; thesis figs. 4.9, 4.10)
Vec3f outside(const Vec3f& x, const Vec3f& outward, const Collider& body, float offset);

}  // namespace selvedge
