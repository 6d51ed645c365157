#pragma once
// The body that every mannequin of one sex is bent from: the cage filled with the table's figures, subdivided.
#include "sim/body/even_table.h"
#include "sim/body/mannequin_girths.h"
#include "sim/body/subdivide.h"

namespace selvedge {

struct MannequinBase {
    Sex sex = Sex::Female;
    Body surface;        // without bones and skin
    VertexRows weights;  // one row per vertex, one column per joint
    Landmarks landmarks;
    double armpit = 0;   // height, m
    double height = 0;   // m
    EvenTable axis;      // z of the middle of the trunk by height, in the midplane, m
    GirthValues girths;  // m
};

// Pre: subdivisions >= 1, for the trunk's axis needs a vertex every 2 cm.
MannequinBase make_mannequin_base(Sex sex, int subdivisions);

}  // namespace selvedge
