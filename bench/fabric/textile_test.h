#pragma once
// Textile tests with simulated cloth. Each compares the measured value with theory or with a finer solution for the
// same fabric. Fabrics, time steps and criteria are those of garments. Extra damping serves only to bring specimens to
// rest.
#include <string>

#include "bench/support/cloth_run.h"
#include "sim/pattern/fabric.h"

namespace selvedge::bench {

enum class YarnDirection { Warp, Weft, Bias };
std::string name_of(YarnDirection direction);

// The mesh of a specimen.
struct MeshSetting {
    double angle = 0;  // rad, rotation of the specimen on the mesher's grid
    int level = 2;     // of all leaves; the finest level when adaptive
    bool is_adaptive = false;
};
std::string level_name(const MeshSetting& setting);  // "0" .. "3", "adaptive"

// The time steps of dressing: 12 sub-steps per step of 1/120 s.
struct Stepping {
    int substeps = 12;
    double frame_seconds = 1.0 / 120;
};
RunOptions run_options(const MeshSetting& setting, const Stepping& stepping);

struct Reading {
    double expected = 0;
    double measured = 0;
    bool is_at_rest = true;
    double error() const { return measured / expected - 1; }
};

// Peirce's cantilever test on both sides of a ridge, with the overhang at which the chord should dip by 41.5 degrees.
// Returns the bending rigidity, N m, computed with the exact elastica from the mean measured dip angle. Without
// internal friction, in the cloth and in the theory.
Reading test_cantilever(const sim::Fabric& fabric, YarnDirection direction, const MeshSetting& mesh,
                        const Stepping& stepping = {});

// Mean strain over the length of a strip that hangs from its upper end under its own weight. For warp and weft.
Reading test_own_weight(const sim::Fabric& fabric, YarnDirection direction, const MeshSetting& mesh,
                        const Stepping& stepping = {});

// Strain under a weight at the lower end. Warp and weft: 19.6 N/m (E20 of the FAST tests) if this strains the fabric to
// less than half its strain limit; otherwise 4.9 N/m (E5) or the load that reaches half the limit, the smaller. Bias:
// the load for a strain of 1 %, measured away from the clamps.
Reading test_load(const sim::Fabric& fabric, YarnDirection direction, const MeshSetting& mesh,
                  const Stepping& stepping = {});

struct DrapeReading {
    double coefficient = 0;  // %
    int folds = 0;
    bool is_at_rest = true;
};
// Cusick's drape test: a disc 30 cm in diameter on a support 18 cm in diameter.
DrapeReading test_drape(const sim::Fabric& fabric, const MeshSetting& mesh, const Stepping& stepping = {});

// Period, s, of a strip of 30 cm that is released at 20 degrees from the vertical and swings about its upper end.
// Theory of a hanging chain, small amplitude: 2 pi sqrt(L/g) / 1.2024. Returns 0 if the strip does not swing.
double swing_period(const sim::Fabric& fabric, const MeshSetting& mesh, const Stepping& stepping = {});

// The same strip, released horizontally: the greatest increase of kinetic plus potential energy above the start value,
// divided by the work of its weight over the strip's length. The cloth starts unstrained, so a value above zero means
// that the solver created energy.
double energy_growth(const sim::Fabric& fabric, const MeshSetting& mesh, const Stepping& stepping = {});

}  // namespace selvedge::bench
