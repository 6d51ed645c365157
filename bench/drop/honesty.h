#pragma once
// What a drop does when nobody times it: whether it comes to rest, whether energy comes from nowhere, and how far it
// ends from where finer time steps take it.
#include "bench/drop/drop.h"

namespace selvedge {

struct RestFigures {
    double kinetic_energy = 0;  // J, after ten more seconds
    double rms_speed = 0;       // m/s, of a sub-step: what trembles counts
    double net_speed = 0;       // m/s, rms of the mean motion over the last second: what creeps
};
RestFigures rest_after(ClothRun& run, const DropScene& scene, double seconds = 10);

// Gravity is switched off for a while, and nothing does work on the cloth any more. Energy is kinetic and elastic by
// the fabric's figures; a cloth that is stretched further than they say holds less than that, so the kinetic energy is
// reported too.
struct WeightlessFigures {
    double energy_growth = 0;   // greatest energy over that at the start, less 1; 0 when it never grows
    double kinetic_growth = 0;  // most that the highest kinetic energy of a quarter of a second exceeds that of the
                                // quarter before, of that of the first
    double kinetic_end = 0;     // J
};
WeightlessFigures weightless(ClothRun& run, const DropScene& scene, double seconds = 3);

struct ConvergedFigures {
    int substeps = 0;           // of the converged runs
    ShapeDistance distance;     // from the run judged to the converged one, after the last frame
    ShapeDistance noise_floor;  // between two converged runs whose start differs by a millimetre
};
ConvergedFigures compare_converged(const SphereDrop& drop, const SphereDropOptions& options, int converged_substeps);

}  // namespace selvedge
