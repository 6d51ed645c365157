#pragma once
// Contacts with a body that moves during a step. At the start of a step, each contact point near the body finds the
// triangle nearest to the middle of its way relative to the surface. In the sub-steps it is kept on the outer side of
// that triangle's tangent plane, which moves with the surface; friction acts against the surface's own motion.
// (thesis 5.3.4, 5.3.5, 5.4.2)
//
//        x      Side memory: the point that searches is first put outside of the plane that it had before, so that a
//    .---+---.  limb that moves through it within one step pushes it along and does not come out behind it.
//   (  body   ) -> motion
//
// A point that is nearer to the body than the contact offset when a step begins is not thrown out: its plane rises to
// the offset at kRecovery.
//
// In a crease, a second plane keeps the point away from the other side. Where the two sides leave less room than twice
// the contact offset, the point is held in the middle and counted as pinched: also where they overlap more deeply than
// flesh gives way (sim/body/yielding_flesh.h).
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/cloth/moving_contact_state.h"
#include "sim/collide/moving_body.h"
#include "sim/core/math.h"
#include "sim/core/pool.h"

namespace selvedge::sim {

struct Cloth;
struct ContactOptions;
struct Kernels;

// Whether the vertex has no room outside of the body: there is no place for it that is not in its surface.
bool is_pinched(const MovingContacts& contacts, VertexId vertex);
std::vector<std::uint8_t> pinched_vertices(const MovingContacts& contacts);  // by vertex; empty: none

// The signed distance of the body from a point between vertices, from what is known of the surface at these after a
// step; far away where one of them is pinched: each plane with the mean of its normal and the one at the point, which
// is exact for a surface of constant curvature. nullopt where one of them is far from the body, or the normals differ
// too much: then ask the collider. shares: barycentric coordinates of x.
std::optional<float> distance_between(const MovingContacts& contacts, std::span<const VertexId> vertices,
                                      std::span<const float> shares, const Vec3f& x);

// A vertex c that halves the edge from a to b: it knows what both ends know, if they are on one side of the body.
void note_split(MovingContacts& contacts, VertexId c, VertexId a, VertexId b);

// Finds the planes of all contact points in Cloth::solver for a step of so many sub-steps.
void find_moving_contacts(Cloth& cloth, const MovingBodyCollider& body, const ContactOptions& options, int substeps);

// The samples, then the vertices, as push_out_samples() and hold_vertices() (contact.h).
void push_out_samples_on_planes(Cloth& cloth, const Kernels& loops, const StepShare& share,
                                const ContactOptions& options);
void hold_vertices_on_planes(Cloth& cloth, const MovingBodyCollider& body, const Kernels& loops, const StepShare& share,
                             float longest_move, const ContactOptions& options);

// Stores in the contact cache what the vertices know of the surface at the end of the step.
void end_moving_contacts(Cloth& cloth, const ContactOptions& options);

}  // namespace selvedge::sim
