#pragma once
// What tables 5.3 and 5.4 measure of one run of the dress on the walking character, and the comparison of the thesis'
// cylinders and spheres with our hierarchy on the vertices of a cloth.  (thesis 5.6)
#include <string>
#include <vector>

#include "bench/thesis/character_run.h"
#include "bench/thesis/limb_cylinders.h"

namespace selvedge::bench {

// One query for each vertex of a cloth, against the body where it is. Times in ms, CPU time of one thread.
struct CollisionQueries {
    double vertices = 0;
    double cylinder_candidates = 0, cylinder_ms = 0;  // potentially colliding triangles, and the time to collect them
    double sphere_candidates = 0, sphere_ms = 0;
    double nearest_ms = 0;    // of these candidates
    double hierarchy_ms = 0;  // our search for the same triangles
    double missed = 0;        // vertices within the margin whose nearest triangle is not among the candidates
};

// Pre: both are where the body is.
CollisionQueries query_vertices(const sim::Cloth& cloth, const LimbBounds& limbs,
                                const sim::MovingBodyCollider& hierarchy);

}  // namespace selvedge::bench
