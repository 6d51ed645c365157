#pragma once
// Keeping cloth outside of what it may not enter, at the contact offset, with Coulomb friction.  (SPEC 2, 3.3)
//
// A point remembers where it last asked the collider and how far it may go before it must ask again: the true distance
// changes no faster than the point moves. Between vertices the cloth is sampled too: in the middle of every triangle,
// and along edges that are long for the body's curvature.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/body/contact_block.h"
#include "sim/core/vec.h"

namespace selvedge {

struct Cloth;
class Collider;
struct Kernels;

struct ContactOptions {
    float offset = 0.003F;          // m, kept from the body; never below the collision field's error
    float friction_scale = 1.0F;    // of the fabrics' friction; 0 while sewing
    float sample_spacing = 0.025F;  // m, edges longer than this are sampled at least this often
    float sampled_edge = 0.02F;     // m: triangles of shorter edges dip less than the offset (L^2 / 8R, R over 2 cm)
    int sample_interval = 1;        // sub-steps from one look at the samples to the next
    float floor = 0.0F;             // m, height of the floor
};

// A point of the cloth between vertices: of an edge, or the middle of a triangle.
struct ContactSample {
    static constexpr float kNew = -1e6F;  // slack of one that never asked

    std::array<std::uint32_t, 3> vertices{};
    std::array<float, 3> shares{};  // of each vertex in the point; they sum to 1
    float friction = 0;
    float slack = kNew;  // m it may move from asked_at before it is asked again; negative: ask now
    Vec4f asked_at = Vec4f::Zero();
};

struct ContactState {
    std::vector<Vec4f> asked;     // by vertex: where it last asked; fourth: its slack, m
    std::vector<float> friction;  // by vertex
    std::vector<ContactSample> samples;
    std::vector<std::uint32_t> asking;  // scratch
    std::vector<ContactBlock> blocks;   // scratch
};

// Friction and samples for the present leaves. What is known of vertices is kept.
void refresh_contacts(Cloth& cloth, const ContactOptions& options = {});

// Forgets what is known: when the collider is another, or has moved.
void forget_contacts(Cloth& cloth);

// Moves the samples between vertices, in Cloth::solver, at least `offset` away from the collider and the floor and
// takes off tangential motion since the last sub-step up to friction times the depth corrected.
void push_out_samples(Cloth& cloth, const Collider& body, const ContactOptions& options);

// The same for the vertices themselves, none of which moves farther than longest_move (m) before: contacts see thin
// parts of the body only if no vertex jumps over them. Last in a sub-step: a drawn vertex is never inside.
void hold_vertices(Cloth& cloth, const Kernels& loops, const Collider& body, float longest_move,
                   const ContactOptions& options);

// x moved to the contact offset if it is nearer to the body or inside, else x: by way of the closest point, which takes
// the wrong side far less often than a ray; where it lies against `outward`, by a ray along outward, ahead or behind.
// (SPEC 3.3; thesis figs. 4.9, 4.10)
Vec3f outside(const Vec3f& x, const Vec3f& outward, const Collider& body, float offset);

}  // namespace selvedge
