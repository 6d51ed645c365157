#pragma once
// All panels of a garment as one mesh, its validation, its statistics and its strain. Vertices have 3D positions;
// triangle corners have 2D material coordinates, because these are discontinuous at seams.
// (thesis 4.3, fig. 4.4)
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/math.h"
#include "sim/mesh/draw_mesh.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// The resolution and limits of meshing.
struct MeshOptions {
    double target_edge = 0.05;   // m, target edge length; 0.05 gives about 700 triangles for a T-shirt
    double chord_error = 0.003;  // m, largest distance of an outline curve from its chords
    int relaxations = 12;        // iterations of moving interior points
    int max_triangles = 200000;  // per panel; if more are needed, the units are probably wrong

    bool operator==(const MeshOptions&) const = default;
};

// The line of its panel on which a side of a triangle lies. Outline edges are lines; most sides lie on none.
struct SideLine {
    int edge = -1;       // index into Panel::edges; -1: none
    float drawn_to = 1;  // share of the side's length to which an elastic draws it; the cloth is gathered there

    bool is_none() const { return edge < 0; }
    bool operator==(const SideLine&) const = default;
};

struct GarmentTriangle {
    std::array<int, 3> vertices{};  // counter-clockwise seen from the fabric's right side
    std::array<Vec2d, 3> u{Vec2d::Zero(), Vec2d::Zero(), Vec2d::Zero()};  // per corner, m, panel frame of `panel`
    int panel = 0;
    std::array<SideLine, 3> lines{};  // lines[k]: of the side from corner k to the next; none in meshes of no pattern
};

// Two vertices that a seam joins.
struct SeamLink {
    int a = 0;
    int b = 0;
    int seam = 0;  // index into Pattern::seams
};

// Either unsewn (panels are separate and `links` lists the vertices to join) or sewn (linked vertices are merged and
// `links` is empty).
struct GarmentMesh {
    std::vector<Vec3d> x;  // positions, m
    std::vector<GarmentTriangle> triangles;
    std::vector<SeamLink> links;
    std::vector<int> pins;  // pinned vertices
    std::vector<std::string> panel_names;
    std::vector<double> panel_grain_angles;   // rad, see Panel::grain_angle
    std::vector<Vec2d> panel_sett_offsets{};  // m, see Panel::sett_offset; empty: all zero
    std::vector<int> panel_layers{};          // see Panel::layer; empty: all zero
};

// The mesh as it is drawn: every triangle and vertex of level 0.
DrawMesh draw_mesh(const GarmentMesh& mesh);

// The panel of each vertex; -1: it has no triangle. Pre: unsewn.
std::vector<int> panels_of_vertices(const GarmentMesh& mesh);

// All faults of the mesh, each with its location ("triangle 12 (front): ..."); empty for a valid mesh. A valid mesh has
// indices in range, finite numbers, no duplicate triangle and none of zero or negative area, no edge with three
// triangles, none inside a panel whose two triangles have opposite orientation (at a seam they may: Seam::is_reversed),
// no vertex without a triangle or with two separate fans of triangles, and, in a panel with lines, an outline edge on
// each side at its border, on no other side, and each edge in one piece. If an index is out of range, only index faults
// are reported.
std::vector<std::string> check_mesh(const GarmentMesh& mesh);

// The seam whose sides have the largest length ratio.
struct SeamMismatch {
    int seam = 0;           // index into Pattern::seams
    double ratio = 1;       // longer side / shorter side
    double difference = 0;  // m
};

struct MeshReport {
    int triangles = 0;
    double min_angle_deg = 0;                    // in material coordinates
    std::string min_angle_panel;                 // panel of that angle
    std::optional<SeamMismatch> worst_mismatch;  // none where there are no seams
};

// Statistics of the pattern's mesh, sewn or not.
MeshReport report_mesh(const Pattern& pattern, const GarmentMesh& mesh);

// Strain along the yarn directions, computed from positions and material coordinates only. The same measure as in
// sim/cloth/cloth.h, for meshes without simulation state.
struct MeshStrain {
    float warp = 0;  // sqrt(d^T C d) - 1, with d the warp direction and C the right Cauchy-Green tensor
    float weft = 0;
};

// One per triangle; 0 where the triangle has zero area in material space. Pre: the mesh has material coordinates.
std::vector<MeshStrain> measure_strain(const DrawMesh& mesh);

// Converts values per triangle to values per corner: the mean over the triangles of the same panel around the vertex,
// weighted by area in material space. Panels are not mixed, because yarn directions change at a seam.
// Pre: one value per triangle; the mesh has material coordinates.
std::vector<std::array<float, 3>> smooth_in_panels(const DrawMesh& mesh, const std::vector<float>& values);

}  // namespace selvedge::sim
