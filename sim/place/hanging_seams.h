#pragma once
// The seams by which a garment hangs, told by where their cloth lies. Shoulder seams bear it: both sides hang from
// them. At level seams, as at a waist, one side hangs from the other.
#include <vector>

#include "sim/mesh/garment_mesh.h"
#include "sim/place/measured_body.h"

namespace selvedge::sim {

// Those between panels whose cloth lies below the seam on both sides, as it was placed. Pre: unsewn.
std::vector<SeamLink> shoulder_links(const GarmentMesh& unsewn);

// Moves what hangs from level seams up or down until they are closed, each group of panels that other seams join as a
// whole. What has shoulder seams stays where it is, and so does what stands on a seam, as a hood on a neckline.
// Patterns are often placed with a gap there; while it is sewn, a skirt would pull a bodice down through the shoulders.
// Returns the largest move, m. body: round which it is placed, so that the side seams of a wide skirt are not taken for
// shoulder seams; null: not known. Pre: unsewn.
double close_level_gaps(GarmentMesh& unsewn, const MeasuredBody* body = nullptr);

// Places panels where they will hang: closes gaps at level seams, and moves up what has shoulder seams until their
// highest point is on the body's shoulders. Does nothing to shoulder seams where the body's are not known.
// Pre: unsewn, placed round the body.
void hang_on_shoulders(GarmentMesh& unsewn, const MeasuredBody& body);

}  // namespace selvedge::sim
