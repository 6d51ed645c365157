#pragma once
// Contact of whole faces with the body. Vertices and samples are points of the cloth that are fixed in it; a finger or
// a toe can pass between them. A watched face has one contact point that moves in it, to where it is nearest to the
// body: a descent on the signed distance, each step to the point of the face that is nearest to a point inside the body
// (local optimization after Macklin et al. 2020, "Local Optimization for Robust Signed Distance Field Collision").
//
//      \             Watched are the faces that can meet a thin part of the body (sim/collide/thin_parts.h) before the
//       \   ( )      next adaptation splits them, and at the end of a drape those that an exact test found too deep.
//    ----\-------
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/cloth/body_contact.h"
#include "sim/collide/collider.h"
#include "sim/core/math.h"

namespace selvedge::sim {

struct Cloth;
struct ContactOptions;
class SurfaceBvh;

// A watched face with the result of its last query, as in the contact cache of vertices.
struct FaceContact {
    static constexpr float kUnknown = -1;  // m: the slack of a face without a result

    Carrier carrier{.shares = {1.0F / 3.0F, 1.0F / 3.0F, 1.0F / 3.0F}};
    TangentPlane plane{};                 // of the body at rest, where the face is nearest to it
    std::array<Vec3f, 3> query_points{};  // m, positions of the vertices at the last query
    float slack = kUnknown;               // m, that the vertices may move before the face can touch
};

// The point of a triangle that is nearest to a surface, or deepest in it.
struct NearestOfFace {
    std::array<float, 3> shares{};  // of the corners
    Vec3f x = Vec3f::Zero();        // m
    float distance = 0;             // m, negative inside
};

// By the descent. corners: m.
NearestOfFace nearest_of_face(const SurfaceBvh& surface, const std::array<Vec3f, 3>& corners);

// Watches the leaf triangles that can meet thin parts of the body within these seconds, and no others. Call it after
// an adaptation; any adaptation that changes the mesh ends the watch.
void watch_faces_near_thin_parts(Cloth& cloth, const Collider& body, float seconds);

// Watches also the leaf triangles of which a part is inside the body by more than `depth` (m), by an exact test. One
// that is watched already starts its next query from where the test found it deepest. Returns their number; 0 for a
// collider without an exact surface.
int watch_faces_inside(Cloth& cloth, const Collider& body, float depth);

// Moves the watched faces in Cloth::solver at least `offset` away from the body, with friction as for samples. Depth
// that a face had before the sub-step is removed without becoming velocity.
void push_out_faces(Cloth& cloth, const Collider& body, const ContactOptions& options);

// The largest depth of the watched faces in Cloth::solver inside the body, m; 0 if none is inside.
float deepest_watched_face(const Cloth& cloth, const Collider& body);

}  // namespace selvedge::sim
