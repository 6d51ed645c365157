#pragma once
// Pieces of cloth for virtual textile tests, cut by the garment mesher and sewn as a garment is: what holds a specimen,
// or weighs it down, is a panel of its own, so that the clamp's edge is where it should be on any mesh.
#include <vector>

#include "sim/core/math.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/pattern.h"

namespace selvedge::bench {

// A strip: across it runs a, along it l, from 0 at the clamp to its length.
struct StripCut {
    double width = 0.05;        // m
    double length = 0.5;        // m
    double weight = 0;          // N per metre of width, sewn to the free end; 0: none
    double mesh_angle = 0;      // rad, by which the strip lies turned on the mesher's grid
    double warp_angle = 0;      // rad, from the strip's length to the warp: 0 tests the warp, pi/2 the weft
    double edge_length = 0.02;  // m, of the base mesh
};

struct Specimen {
    sim::GarmentMesh mesh;  // sewn, with its pins: all vertices of what holds the specimen
    std::vector<sim::Fabric> fabrics;
    double mesh_angle = 0;

    static constexpr int kHolder = 0;  // panels
    static constexpr int kCloth = 1;

    // Material coordinates of the point (a, l) of the specimen.
    Vec2d material(double a, double l) const { return Eigen::Rotation2Dd(mesh_angle) * Vec2d(a, l); }
};

// across, along: where a and l point in the room, unit.
struct SpecimenFrame {
    Vec3d across = Vec3d::UnitX();
    Vec3d along = -Vec3d::UnitY();
};

// The strip stands flat where the frame puts it, a = l = 0 at the origin.
Specimen cut_strip(const sim::Fabric& fabric, const StripCut& cut, const SpecimenFrame& frame);

// A strip of twice the length laid over a ridge at l = 0: pinned there along a seam, it droops on both sides, and is
// level at the ridge by symmetry. (A clamp that holds the cells behind it would let the cloth bend over half a cell
// more than it should.) The half with l < 0 is the panel kHolder. No weight.
Specimen cut_ridge_strip(const sim::Fabric& fabric, const StripCut& cut, const SpecimenFrame& frame);

// Cusick's disc, level, its support's centre at the origin.
struct DiscCut {
    double support_radius = 0.09;  // m
    double radius = 0.15;          // m
    double mesh_angle = 0;         // rad
    double edge_length = 0.03;     // m
};
Specimen cut_disc(const sim::Fabric& fabric, const DiscCut& cut);

}  // namespace selvedge::bench
