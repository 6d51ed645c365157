#pragma once
// Keeping cloth outside of what it may not enter, at the contact offset, with Coulomb friction.  (SPEC 2, 3.3)
//
// Vertices are held outside, and between them the cloth is sampled: in the middle of triangles that are large enough to
// dip into a body, and along edges that are long for its curvature, unless the adaptation splits what dips. What a
// point knows: contact_blocks.h.
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/adaptive/adapt.h"
#include "sim/cloth/constraint_set.h"
#include "sim/cloth/solver_blocks.h"
#include "sim/collide/collider.h"
#include "sim/core/math.h"
#include "sim/core/pool.h"

namespace selvedge::sim {

// What points of the cloth know of the body, as the inner loops read it.
//
// A point remembers where it last asked the collider and how far it may go before it can touch: the true distance
// changes no faster than the point moves. Where it may touch, and has not gone far, it takes the body for the plane
// that it saw there; only when it has gone farther it asks again. So cloth that lies still asks nothing.

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

struct Cloth;
class Collider;
struct Kernels;

struct ContactOptions {
    float offset = 0.003F;          // m, kept from the body; never below the collision field's error
    float friction_scale = 1.0F;    // of the fabrics' friction; 0 while sewing
    float sample_spacing = 0.025F;  // m, edges longer than this are sampled at least this often
    float sampled_edge = 0.02F;     // m: triangles of shorter edges dip less than the offset (L^2 / 8R, R over 2 cm)
    float floor = 0.0F;             // m, height of the floor

    bool operator==(const ContactOptions&) const = default;
};

// Which edges the adaptation splits where they or their triangles cut into the body; none: no edges.
using SplitOnContact = std::optional<SplitLimits>;

struct ContactState {
    std::vector<Vec4f> asked;     // by vertex, see ContactKnowledge
    std::vector<Vec4f> plane;     // by vertex
    std::vector<float> friction;  // by vertex
    std::vector<SampleBlock> samples;
    struct Scratch {
        std::vector<std::uint32_t> asking;
        std::vector<ContactBlock> blocks;
    } scratch;

    // Where the samples stand.
    BlockColoring coloring;
    std::vector<std::uint32_t> of_triangle;  // by TriangleId: its lane, or kSpare
    std::vector<std::uint32_t> of_edge;      // by EdgeId: its first lane, or kSpare
    std::vector<std::uint32_t> next;         // by lane: the next of the same edge, or kSpare
    float spacing = 0, sampled_edge = 0;     // m, that they were made for
    SplitOnContact split{};                  // the same
    std::size_t vertices = 0;                // the spare point's index
    std::size_t inserted = 0;                // since all were made anew
};

// Friction and samples for the present leaves, all anew; no samples of edges that are split where they dip into a body,
// and of their triangles. What is known of vertices is kept.
void refresh_contacts(Cloth& cloth, const ContactOptions& options = {}, const SplitOnContact& split = {});

bool are_contacts_made_for(const Cloth& cloth, const ContactOptions& options, const SplitOnContact& split);

// The same after one adaptation, at a cost in proportion to what it changed (see mesh.changes()), or all anew where
// they were made for other options.
void update_contacts(Cloth& cloth, const ContactOptions& options = {}, const SplitOnContact& split = {});

// Forgets what is known: when the collider is another, or has moved.
void forget_contacts(Cloth& cloth);

// The number of samples, and where the lane'th one is, in positions x; none where the lane is spare.
std::size_t sample_count(const ContactState& contacts);
std::optional<Vec3f> sample_at(const ContactState& contacts, std::size_t lane, const std::vector<Vec4f>& x);

// Moves the samples between vertices, in Cloth::solver, at least `offset` away from the collider and the floor and
// takes off tangential motion since the last sub-step up to friction times the depth corrected.
void push_out_samples(Cloth& cloth, const Kernels& loops, const Collider& body, const ContactOptions& options);

// The same for the vertices themselves, none of which moves farther than longest_move (m) before: contacts see thin
// parts of the body only if no vertex jumps over them. Last in a sub-step: a drawn vertex is never inside.
void hold_vertices(Cloth& cloth, const Kernels& loops, const Collider& body, float longest_move,
                   const ContactOptions& options);

// x moved to the contact offset if it is nearer to the body or inside, else x: by way of the closest point, which takes
// the wrong side far less often than a ray; where it lies against `outward`, by a ray along outward, ahead or behind.
// (SPEC 3.3; thesis figs. 4.9, 4.10)
Vec3f outside(const Vec3f& x, const Vec3f& outward, const Collider& body, float offset);

}  // namespace selvedge::sim
