#pragma once
// Contacts of the cloth with a body and the floor: points of the cloth are kept at least the contact offset away, with
// Coulomb friction.  (thesis 4.4.2, 5.4.2)
//
// All vertices are contact points. Between them the cloth has samples: in the middle of triangles that are large enough
// to dip into a body, and along edges that are long compared with its curvature. There are no samples where the
// adaptation splits edges that dip into the body instead.
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/adaptive/adapt.h"
#include "sim/cloth/body_contact.h"
#include "sim/cloth/constraint_set.h"
#include "sim/cloth/contact_options.h"
#include "sim/cloth/face_contact.h"
#include "sim/cloth/moving_contact_state.h"
#include "sim/cloth/solver_blocks.h"
#include "sim/collide/collider.h"
#include "sim/core/math.h"
#include "sim/core/pool.h"

namespace selvedge::sim {

// The contact cache: per contact point the result of its last collider query.
//
// The cache holds the position of the query and a slack: the distance that the point may move from there before it can
// touch, because the distance to the body changes no faster than the point moves. A point that moved farther than its
// slack but at most kPlaneReach uses the tangent plane of the body found by the query; beyond that it queries the
// collider again. So cloth at rest makes no queries.

// Colliders are queried with a reach of the contact offset plus this, which is also how far the tangent plane is used.
inline constexpr float kPlaneReach = 0.0002F;  // m: the plane's error is kPlaneReach^2 / (2 R), 2 um at R = 1 cm

// Arrays by vertex, four floats each.
struct ContactCacheArrays {
    static constexpr float kInvalidBelow = -1;  // m: a slack below this means that the entry is invalid
    static constexpr float kUnknown = -10;      // m: the slack of an invalid entry

    float* query_point = nullptr;  // position of the last query; w: the slack, m
    float* plane = nullptr;        // unit normal found there; w: the height above the offset surface, m
};

// Samples: carriers on an edge or in the middle of a triangle. A free slot has a slack of 1,000 km.
struct alignas(64) SampleBlock {
    std::array<BlockPoints, 3> vertices{};  // none twice, unless in turn; the third of an edge is the dummy vertex
    std::array<BlockFloats, 3> shares{};    // as in Carrier
    BlockFloats friction{};
    SideBlock side{};       // found by the last query; its point is where the sample was then
    BlockFloats slack{};    // m, as in ContactCacheArrays
    BlockFloats sunk{};     // m, depth below the offset surface at the sample's first query
    BlockPoints in_turn{};  // 1 in all slots or 0: the samples may share vertices, so they are pushed one by one
};

// Which blocks of samples are too far from the body to be looked at. Each look at a block measures how far its samples
// may move before one is near. The block is skipped until the cloth has moved so far: no sample moves farther than the
// vertex that moves farthest. So cloth far from the body costs one pass over its vertices per sub-step.
struct SampleSkips {
    std::vector<Vec4f> last;         // positions when `moved` was last increased
    double moved = 0;                // m, sum of the longest motions of a vertex from one call to the next
    std::vector<double> skip_until;  // by block, m: it is skipped while `moved` is less; empty: none is
};

struct Cloth;
struct Kernels;

// The edges that the adaptation splits if they, or their triangles, penetrate the offset surface; nullopt: no edges.
using SplitOnContact = std::optional<SplitLimits>;

struct ContactState {
    std::vector<Vec4f> query_point;  // by vertex, see ContactCacheArrays
    std::vector<Vec4f> plane;        // by vertex
    std::vector<float> friction;     // by vertex
    std::vector<float> standoff;     // by vertex, m beyond the contact offset; see standoff.h
    std::vector<SampleBlock> samples;
    SampleSkips skips;                // of samples, with a body at rest
    std::vector<FaceContact> faces;   // those that are watched
    MovingContacts moving;            // with a body that moves
    float offset = 0;                 // m, contact offset that the cached heights and slacks refer to
    std::vector<bool> is_trunk_only;  // by vertex and of the dummy vertex: see contacts_apart(); empty: none
    struct Scratch {
        std::vector<std::uint32_t> to_query;
        std::vector<ContactBlock> blocks;
        std::vector<std::uint16_t> trunk_only;
    } scratch;

    // The slots of the samples.
    BlockColoring coloring;
    std::vector<std::uint32_t> of_triangle;  // by TriangleId: its first slot, or kNoBlockSlot
    std::vector<std::uint32_t> of_edge;      // by EdgeId: its first slot, or kNoBlockSlot
    std::vector<std::uint32_t> next;         // by slot: the next one of the same edge or triangle, or kNoBlockSlot
    float spacing = 0, sampled_edge = 0;     // m, the options that the samples were made for
    SplitOnContact split{};                  // the same
    std::size_t vertices = 0;                // the dummy vertex' index
    std::size_t inserted = 0;                // samples inserted since all were made anew
};

// Makes friction coefficients and samples anew for the present leaves. Edges that `split` allows to be split, and their
// triangles, get no samples. The contact cache of vertices is kept.
void refresh_contacts(Cloth& cloth, const ContactOptions& options = {}, const SplitOnContact& split = {});

bool are_contacts_made_for(const Cloth& cloth, const ContactOptions& options, const SplitOnContact& split);

// The same after one adaptation, incrementally from mesh.changes(); makes everything anew if the options differ.
void update_contacts(Cloth& cloth, const ContactOptions& options = {}, const SplitOnContact& split = {});

// Invalidates the contact cache. Call it when the collider is another one or has moved.
void forget_contacts(Cloth& cloth);

// The same when no point of the collider's surface has moved by more than `by` (m): what was farther away stays known.
void keep_far_contacts(Cloth& cloth, float by);

// The number of samples; and the position of the sample in `slot` for vertex positions x, nullopt for a free slot.
std::size_t sample_count(const ContactState& contacts);
std::optional<Vec3f> sample_at(const ContactState& contacts, std::size_t slot, const std::vector<Vec4f>& x);

// Makes the cached heights and slacks refer to this contact offset (m). Called by each step.
void set_contact_offset(Cloth& cloth, float offset);

// Moves the samples in Cloth::solver at least `offset` away from the collider. Friction reduces the tangential motion
// since the last sub-step by up to the friction coefficient times the corrected depth. Returns the number of blocks
// that were not skipped.
std::size_t push_out_samples(Cloth& cloth, const Kernels& loops, const Collider& body, const ContactOptions& options);

// The same for the vertices, which are also kept above the floor. First limits the motion of each vertex in this
// sub-step to longest_move (m), because a vertex that jumps over a thin part of the body has no contact with it. Called
// last in a sub-step, so that no drawn vertex is inside of the body.
void hold_vertices(Cloth& cloth, const Kernels& loops, const Collider& body, float longest_move,
                   const ContactOptions& options);

// Returns x, moved to the contact offset if it is nearer to the body or inside. It moves along the normal of the
// closest point, which chooses the wrong side far less often than a ray. If that normal points against `outward`, it
// uses the hit of a ray along `outward`, forwards or backwards.  (thesis figs. 4.9, 4.10)
Vec3f outside(const Vec3f& x, const Vec3f& outward, const Collider& body, float offset);

}  // namespace selvedge::sim
