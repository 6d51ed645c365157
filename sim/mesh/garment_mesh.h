#pragma once
// All panels of a garment as one mesh: 3D positions on vertices, 2D material coordinates on triangle corners, for
// they jump at a seam where the position does not.  (SPEC 3.2)
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/math.h"
#include "sim/mesh/plain_mesh.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

struct GarmentTriangle {
    std::array<int, 3> vertices{};  // counter-clockwise seen from the fabric's right side
    std::array<Vec2d, 3> u{Vec2d::Zero(), Vec2d::Zero(), Vec2d::Zero()};  // per corner, m, own panel's held frame
    int panel = 0;
};

// Two vertices that a seam brings together.
struct SeamLink {
    int a = 0;
    int b = 0;
    int seam = 0;  // index into Pattern::seams
};

// Unsewn (links not empty: the panels are apart) or sewn (links empty: linked vertices are one).
struct GarmentMesh {
    std::vector<Vec3d> x;  // positions, m
    std::vector<GarmentTriangle> triangles;
    std::vector<SeamLink> links;
    std::vector<int> pins;  // vertices that do not move
    std::vector<std::string> panel_names;
    std::vector<double> panel_grain_angles;   // rad, see Panel::grain_angle
    std::vector<Vec2d> panel_sett_offsets{};  // m, see Panel::sett_offset; empty: none is moved
};

// Whether a garment mesh is sound.  (SPEC 3.1)

// Every fault of the mesh, each with its place ("triangle 12 (front): ..."); empty when it is sound: indices in range,
// numbers finite, no triangle of zero area or given twice, no edge with three triangles or with two that run the same
// way along it, no vertex without a triangle or that joins two fans of triangles.
std::vector<std::string> check_mesh(const GarmentMesh& mesh);

// What a garment mesh measures.  (SPEC 3.1)

// The seam whose sides differ most in length.
struct SeamMismatch {
    int seam = 0;           // index into Pattern::seams
    double ratio = 1;       // longer side over the shorter
    double difference = 0;  // m
};

struct MeshReport {
    int triangles = 0;
    int vertices = 0;                            // sewn
    double min_angle_deg = 0;                    // in material coordinates
    std::string min_angle_panel;                 // where that is
    int seam_edges = 0;                          // sewn edges whose two sides came from different outline edges
    std::optional<SeamMismatch> worst_mismatch;  // none where there are no seams
};

// Pre: `sewn` is merge_seams(unsewn).mesh and `unsewn` is assemble(pattern).
MeshReport report_mesh(const Pattern& pattern, const GarmentMesh& unsewn, const GarmentMesh& sewn);

// How far a mesh is strained along its threads, from positions and material coordinates alone: the measure of
// sim/cloth/cloth.h for who has no cloth.

struct MeshStrain {
    float warp = 0;  // length of the deformed warp direction less 1: the root of the right Cauchy-Green tensor's entry
    float weft = 0;
};

// One per triangle; 0 where it has no area in the material. Pre: the mesh has material coordinates.
std::vector<MeshStrain> measure_strain(const PlainMesh& mesh);

// A figure of each triangle, carried to the corners: the mean, by material area, over the triangles of the same panel
// about the vertex, for warp and weft are others on the other side of a seam.
// Pre: one value per triangle; the mesh has material coordinates.
std::vector<std::array<float, 3>> smooth_in_panels(const PlainMesh& mesh, const std::vector<float>& values);

}  // namespace selvedge::sim
