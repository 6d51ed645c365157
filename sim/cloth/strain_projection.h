#pragma once
// Projects a cloth onto the strain limits of its fabrics: where triangles are beyond them, the vertices are moved until
// no warp or weft yarn is, and the cloth keeps out of the body and out of itself. Gauss-Seidel iterations over these
// triangles, and over those that their correction stretches, alternate with the contacts. It is a projection of
// positions (Mueller et al. 2007) without time: nothing falls or swings, and velocities stay as they are. Watched faces
// (face_contact.h) are moved out of the body; an iteration in which they are deeper is not better, whatever its strain.
//
// A step of the solver cannot do that. It iterates over all constraints once per sub-step, and contacts are the last of
// them, so that single triangles between contacts, or of light vertices that swing, stay beyond the limit.
#include "sim/cloth/step.h"

namespace selvedge::sim {

struct StrainProjectionOptions {
    float tolerance = 0.01F;       // of strain: what is beyond the limit by less is left as it is
    int iterations = 60;           // alternations with the contacts, at most
    int sweeps_per_iteration = 8;  // Gauss-Seidel iterations
    float depth = 0.0002F;         // m, of watched faces inside the body: less is left as it is
    float longest_move = 3e-4F;    // m per iteration, so that contacts are found before cloth has passed them
};

struct StrainProjectionReport {
    int iterations = 0;      // until strain and depth were within their tolerances, or all of them
    float worst_over = 0;    // largest strain beyond the limit in the best iteration, which the cloth keeps
    float deepest_face = 0;  // m, of the watched faces inside the body in that iteration
};

// The strain of the more stretched yarn beyond its fabric's limit and the usual tolerance, summed over the leaf
// triangles that have such; 0 if project_strain() has nothing to do for them.
double total_excess(const Cloth& cloth);

// Uses the contact options and self-contact of `stepping`; contacts are without friction. Pre: as step().
StrainProjectionReport project_strain(Cloth& cloth, const Collider& body, const StepOptions& stepping,
                                      const StrainProjectionOptions& options = {});

}  // namespace selvedge::sim
