#pragma once
// Textile tests with simulated cloth. Each compares the measured value with theory or with a finer solution for the
// same fabric. Fabrics, time steps and criteria are those of garments. Extra damping serves only to bring specimens to
// rest.
#include <string>
#include <vector>

#include "bench/support/cloth_run.h"
#include "sim/core/math.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/pattern.h"

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

// Specimens for virtual textile tests, meshed and sewn like a garment. The clamp that holds a specimen and the weight
// that loads it are separate panels, so that the clamp's edge is exact on any mesh.

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
