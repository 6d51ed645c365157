#pragma once
// Where a garment is drafted smaller than the body: there its cloth must stretch, and that it does is no fault of the
// drape. A horizontal plane cuts garment and body; the girth that the garment was drafted with is the length of the
// cut in material coordinates, the body's that of a tape round all that the garment encloses.  (ISO 8559-1: girths)
#include <vector>

#include "sim/body/body.h"
#include "sim/core/math.h"
#include "sim/mesh/plain_mesh.h"

namespace selvedge::sim {

struct FitOptions {
    double step = 0.02;             // m between levels
    double contact_offset = 0.003;  // m that cloth keeps from the body
    double tolerance = 0.005;       // of the body's girth: by less than this no garment is called smaller
    double reach = 0.05;            // m about a tight cut in which it stretches the cloth: a step and 3 cm
};

// A level at which one closed loop of the garment is too short for what it goes round.
struct TightLevel {
    double y = 0;                // m
    double garment_girth = 0;    // m, material length round the garment
    double body_girth = 0;       // m, tape round the body 1 contact offset away from it
    Vec3d low = Vec3d::Zero();   // the box about the garment's loop in the room
    Vec3d high = Vec3d::Zero();  // its y is that of the level
};

// Ordered by height, at whole multiples of the step. Each closed loop counts for itself, so that one level may stand
// here several times: for a body and two sleeves. A sleeve's cut is oblique, but so is that of the arm in it, by the
// same plane. Both legs in a skirt have one tape round them. Where the garment hangs open there is no girth to compare.
// Pre: triangles have corner material coordinates and run the same way across shared edges; positions are finite.
std::vector<TightLevel> tight_levels(const PlainMesh& garment, const Body& body, const FitOptions& options = {});

// Whether the height is within reach of a tight level.
bool is_tight_at(const std::vector<TightLevel>& levels, double y, const FitOptions& options = {});

// Whether the point is within reach of a tight loop: a tight sleeve says nothing about the waist beside it.
bool is_tight_at(const std::vector<TightLevel>& levels, const Vec3d& x, const FitOptions& options = {});

// How far a garment stands off the body.

// m from each point to the nearest of the body's surface, negative inside. Exact but for rounding.
std::vector<float> measure_clearance(const std::vector<Vec3f>& points, const Body& body);

}  // namespace selvedge::sim
