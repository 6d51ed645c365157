#pragma once
// Specimens for virtual textile tests, meshed and sewn like a garment. The clamp that holds a specimen and the weight
// that loads it are separate panels, so that the clamp's edge is exact on any mesh.
#include <vector>

#include "sim/core/math.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/pattern.h"

namespace selvedge::bench {

// A strip with coordinates a across it and l along it; l = 0 at the clamp, l = length at the free end.
struct StripCut {
    double width = 0.05;        // m
    double length = 0.5;        // m
    double weight = 0;          // N/m (per metre of width), sewn to the free end; 0: none
    double mesh_angle = 0;      // rad, rotation of the strip on the mesher's grid
    double warp_angle = 0;      // rad, from the strip's length to the warp: 0 tests the warp, pi/2 the weft
    double edge_length = 0.02;  // m, of the base mesh
};

struct Specimen {
    sim::GarmentMesh mesh;  // sewn; its pins are all vertices of the holder (see cut_ridge_strip for the exception)
    std::vector<sim::Fabric> fabrics;
    double mesh_angle = 0;

    static constexpr int kHolder = 0;  // panels
    static constexpr int kCloth = 1;

    // Material coordinates of the point (a, l) of the specimen.
    Vec2d material(double a, double l) const { return Eigen::Rotation2Dd(mesh_angle) * Vec2d(a, l); }
};

// World directions of a (across) and l (along), unit vectors.
struct SpecimenFrame {
    Vec3d across = Vec3d::UnitX();
    Vec3d along = -Vec3d::UnitY();
};

// The strip lies flat in the plane of the frame, with a = l = 0 at the origin.
Specimen cut_strip(const sim::Fabric& fabric, const StripCut& cut, const SpecimenFrame& frame);

// A strip of twice the length, laid over a ridge at l = 0. It is pinned there along a seam and hangs down on both
// sides; by symmetry it is level at the ridge. (A clamp that pins the cells behind its edge would let the cloth bend
// over half a cell too much.) The half with l < 0 is the panel kHolder. No weight.
Specimen cut_ridge_strip(const sim::Fabric& fabric, const StripCut& cut, const SpecimenFrame& frame);

// The disc of Cusick's drape test, horizontal, with the centre of its support at the origin.
struct DiscCut {
    double support_radius = 0.09;  // m
    double radius = 0.15;          // m
    double mesh_angle = 0;         // rad
    double edge_length = 0.03;     // m
};
Specimen cut_disc(const sim::Fabric& fabric, const DiscCut& cut);

}  // namespace selvedge::bench
