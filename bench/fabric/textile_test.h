#pragma once
// Textile tests made with virtual cloth, each against what theory, or a finer solution, says of the same fabric. The
// same fabrics, time steps and criteria everywhere; damping beyond the fabric's only brings specimens to rest.
#include <string>

#include "bench/support/cloth_run.h"
#include "sim/pattern/fabric.h"

namespace selvedge::bench {

enum class ThreadDirection { Warp, Weft, Bias };
std::string name_of(ThreadDirection direction);

// How a specimen is meshed.
struct MeshSetting {
    double angle = 0;  // rad, of the specimen on the mesher's grid
    int level = 2;     // of all leaves; of the finest when adaptive
    bool is_adaptive = false;
};
std::string level_name(const MeshSetting& setting);  // "0" .. "3", "adaptive"

// As a garment is dressed: steps of 1/120 s with 12 sub-steps.
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

// Peirce's cantilever: a strip whose chord should dip 41.5 degrees, on both sides of a ridge. Reads the bending
// rigidity, N m, by the exact elastica from the mean angle that it does dip. Internal friction is left out, in cloth
// and theory.
Reading test_cantilever(const sim::Fabric& fabric, ThreadDirection direction, const MeshSetting& mesh,
                        const Stepping& stepping = {});

// A strip that hangs by its upper end: strain by its own weight, of its whole length. Warp and weft.
Reading test_own_weight(const sim::Fabric& fabric, ThreadDirection direction, const MeshSetting& mesh,
                        const Stepping& stepping = {});

// Strain by a weight sewn to the lower end. Warp and weft: 19.6 or 4.9 N/m (FAST's E20 and E5), or what strains the
// fabric to half its limit if that is less. Bias: what strains it 1 %, read clear of the clamps.
Reading test_load(const sim::Fabric& fabric, ThreadDirection direction, const MeshSetting& mesh,
                  const Stepping& stepping = {});

struct DrapeReading {
    double coefficient = 0;  // %
    int folds = 0;
    bool is_at_rest = true;
};
// Cusick's drape test: a disc of 30 cm on a support of 18 cm.
DrapeReading test_drape(const sim::Fabric& fabric, const MeshSetting& mesh, const Stepping& stepping = {});

// A strip of 30 cm that swings about its upper end, let go at 20 degrees: period, s. Theory for a hanging chain, small
// swings: 2 pi sqrt(L/g) / 1.2024.
double swing_period(const sim::Fabric& fabric, const MeshSetting& mesh, const Stepping& stepping = {});

// The same strip let go level: by how much kinetic and potential energy ever rise above what they were at the start, of
// the work that its weight does when it falls its whole length. The cloth starts unstrained, so that above nil, energy
// came from nowhere.
double energy_growth(const sim::Fabric& fabric, const MeshSetting& mesh, const Stepping& stepping = {});

}  // namespace selvedge::bench
