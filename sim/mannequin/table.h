#pragma once
// The data of the mannequin (mannequin_table.json): control points of cross-sections, joints and levels, measured on
// the two CC0 bodies of MakeHuman. Also the skin weights of the cage.
#include <vector>

#include "sim/mannequin/cage.h"
#include "sim/mannequin/mannequin.h"
#include "sim/mannequin/subdivide.h"

namespace selvedge::sim {

// Heights of the trunk's girths and of the crotch, m.
struct TrunkLevels {
    double bust = 0;
    double underbust = 0;
    double waist = 0;
    double high_hip = 0;
    double hip = 0;
    double crotch = 0;
};

struct MannequinTable {
    std::vector<Vec3d> left_points;  // of the cage's left half, in the cage's order, m
    Joints joints;                   // m
    TrunkLevels levels;
    double armpit = 0;  // height, m
};

MannequinTable read_mannequin_table(Sex sex, const Cage& cage);

// Skin weights of the mannequin's cage: smooth steps across the joints along each part, fixed ramps where limbs meet
// the trunk, then two smoothing iterations over the quads. Subdivision interpolates them on the surface.

// One row per cage vertex (both halves), one column per joint; each row sums to 1.
VertexRows cage_weights(const Cage& cage, const MannequinTable& table);

}  // namespace selvedge::sim
