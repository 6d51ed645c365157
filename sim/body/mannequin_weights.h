#pragma once
// Skin weights on the mannequin's cage: smooth steps across the joints along each part, fixed ramps where limbs grow
// out of the trunk, then a little smoothing over the quads. Subdivision carries them to the surface.
#include "sim/body/mannequin_table.h"
#include "sim/body/subdivide.h"

namespace selvedge {

// One row per cage vertex (both halves), one column per joint; each row sums to 1.
VertexRows cage_weights(const Cage& cage, const MannequinTable& table);

}  // namespace selvedge
