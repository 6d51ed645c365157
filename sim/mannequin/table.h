#pragma once
// The figures that the mannequin is made from (mannequin_table.json): control points of cross-sections, joints and
// levels, measured on the two CC0 bodies of MakeHuman.
#include <vector>

#include "sim/mannequin/cage.h"
#include "sim/mannequin/mannequin.h"
#include "sim/mannequin/subdivide.h"

namespace selvedge::sim {

// Heights at which the tape goes round the trunk, m.
struct TrunkLevels {
    double bust = 0;
    double underbust = 0;
    double waist = 0;
    double high_hip = 0;
    double hip = 0;
    double crotch = 0;
};

struct MannequinTable {
    std::vector<Vec3d> left_points;  // of the cage's left half, in its order, m
    Joints joints;                   // m
    TrunkLevels levels;
    double armpit = 0;  // height, m
};

MannequinTable read_mannequin_table(Sex sex, const Cage& cage);

// Skin weights on the mannequin's cage: smooth steps across the joints along each part, fixed ramps where limbs grow
// out of the trunk, then a little smoothing over the quads. Subdivision carries them to the surface.

// One row per cage vertex (both halves), one column per joint; each row sums to 1.
VertexRows cage_weights(const Cage& cage, const MannequinTable& table);

}  // namespace selvedge::sim
