#pragma once
// The standoff of a vertex: how far beyond the contact offset it is kept from the body, so that the flat triangles
// round it do not cut into the body. Fine cloth, and cloth on flat parts of the body, needs none.
//
//      a-----.-----b   A chord of length L dips L^2 / 8R below its ends on a surface of radius R. Instead of an offset
//     /   d  |      \  that is large enough for every chord, the ends of each are raised by what its middle lacks.
//    (   body         )
#include "sim/cloth/contact.h"

namespace selvedge::sim {

struct Cloth;
class Collider;

// m, least distance from the body that is kept in the middle of edges and triangles; on a
// body that moves, beside the middle too where the cloth leaves it or turns round it
inline constexpr float kChordClearance = 0.0001F;

// m, largest standoff: what the chords of cloth in motion need at the default offset
inline constexpr float kMaxStandoff = 0.003F;

struct StandoffOptions {
    // m, standoff of vertices that do not touch the body: so that thin parts of it, such as fingers, stop cloth that
    // falls on them
    float free = 0;
    float lowering = kMaxStandoff;  // m, by which a standoff is lowered at most, per call
};

// Gives all vertices the standoff of free ones.
void free_standoffs(Cloth& cloth, const StandoffOptions& options);

// Raises the standoff of vertices round edges and triangles that are too near to the body, and lowers it where cloth
// that touches the body has room. Vertices are moved out without gaining velocity. Call it between two steps,
// regularly.
void update_standoffs(Cloth& cloth, const Collider& body, const StandoffOptions& options = {});

}  // namespace selvedge::sim
