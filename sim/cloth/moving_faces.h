#pragma once
// Contact of whole faces with thin parts of a body that moves, such as a hand that comes upon a skirt: as with a body
// at rest (face_contact.h), a face has one contact point where it is nearest to the body. It is found once in a step,
// and follows the tangent plane there, as vertices do (moving_contact.h).
#include "sim/cloth/moving_contact_state.h"
#include "sim/collide/moving_body.h"

namespace selvedge::sim {

struct Cloth;
struct ContactOptions;

// Finds the faces that may meet thin parts of the body in a step of so many sub-steps.
void find_moving_faces(Cloth& cloth, const MovingBodyCollider& body, const ContactOptions& options, int substeps);

// Moves these faces in Cloth::solver to the outer side of their planes, with friction against the surface's motion.
// Depth that a face had before the step is removed without becoming velocity.
void push_out_faces_on_planes(Cloth& cloth, const StepShare& share, const ContactOptions& options);

}  // namespace selvedge::sim
