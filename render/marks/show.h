#pragma once
// Display modes: fills in a scene's paint and marks for a mode, and makes the legend that explains them. Also the
// scales of the strain and clearance legends, and seams and hems as polylines.  (thesis 3.7, figs. 3.16, 3.17)
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/marks/legend.h"
#include "render/scene/scene.h"
#include "render/scene/solids.h"
#include "sim/mesh/draw_mesh.h"

namespace selvedge::render {

struct ShowInput {
    std::vector<float> clearance{};  // m, one per vertex of the garment; needed by Clearance
    float line_radius = 0.003F;      // m, of the lines in Seams and of the outlines in Hierarchy
};

// Whether the mode needs the garment's material coordinates.
bool wants_material(ShowMode mode);

// Whether the mode comes after Plain: its colours stand for values or kinds, so it needs even light (even_light()).
bool is_painted(ShowMode mode);

// Fills in what the mode of the scene's first cloth shows, for this cloth and all that are parts of the same garment
// (the same vertices and panels, as when its panels are of several fabrics): they share one scale and one legend.
// Returns the legend, if the mode has one. Pre: the parts have the same mode, which is not Hierarchy; the material
// coordinates and facts that the mode needs are given and finite.
std::optional<Legend> fill_show(Scene& scene, const ShowInput& facts = {});

// The same for Hierarchy: the model replaces all cloths and solids of the scene.
Legend fill_hierarchy(Scene& scene, const sim::TriangleHierarchy& hierarchy, StackSide side,
                      const ShowInput& facts = {});

// Number of triangles of each level, up to the highest.
Legend level_legend(const sim::DrawMesh& mesh);

// Scales of values: the range that a colour map covers, rounded, and its legend.

// The smallest number of the form {1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8} x 10^n that is >= value. Pre: value > 0, finite.
double round_up(double value);

// Scale from -limit to +limit, in percent; notes with the 99th percentile, maximum and minimum of `strains` (0.01 is
// one percent). Pre: limit > 0, strains not empty.
Legend strain_legend(const std::string& title, double limit, const std::vector<double>& strains);

// Scale from 0 to `limit`, in mm; limit and clearances are in m. Pre: limit > 0, clearances not empty.
Legend clearance_legend(double limit, const std::vector<double>& clearances);

// A garment's seams and hems as polylines: connected edges are joined to the lines that a tailor would sew in one go.

using VertexPath = std::vector<std::uint32_t>;  // vertices of a mesh; a closed path ends with its first vertex

// Connected marked edges between the same two panels, or within one panel (a dart, or a panel sewn to a tube).
struct SeamLine {
    std::array<std::uint16_t, 2> panels{};  // the smaller one first
    std::vector<VertexPath> paths;          // one path, or more if the line forks
    double length = 0;                      // m
};

struct SeamLines {
    std::vector<SeamLine> seams;  // sorted by panels, then by smallest vertex
    std::vector<SeamLine> hems;   // of one panel each
};

SeamLines find_seam_lines(const sim::DrawMesh& mesh);

}  // namespace selvedge::render
