#pragma once
// One panel cut into triangles: constrained Delaunay of its sampled outline with interior points of our own placing.
// No point is ever added on the outline, or seams would no longer match.  (SPEC 3.1)
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "sim/core/math.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// One panel cut into triangles, in its own plane.  (SPEC 3.1)

// The stretch of the outline that came from one OutlineEdge: outline[first], outline[first+1], ..
// outline[first+segments] (indices modulo the outline's size).
struct OutlineRun {
    int first = 0;
    int segments = 0;
};

struct PanelMesh {
    std::vector<Vec2d> u;                       // material coordinates, m, held frame
    std::vector<std::array<int, 3>> triangles;  // counter-clockwise
    std::vector<int> outline;                   // vertices along the outline, counter-clockwise, each once
    std::vector<OutlineRun> runs;               // one per OutlineEdge of the panel, same order
};

struct TriangulateOptions {
    double target_edge = 0.05;   // m
    int relaxations = 12;        // rounds of moving interior points
    int max_triangles = 200000;  // of this panel
};

// segments: per outline edge, see count_segments(). The outline may touch itself from outside, along a slit of no
// width or in a point; both sides keep their own vertices.
// Throws InputError naming the panel when its outline is open, crosses itself, pinches the cloth to a point, runs
// clockwise or has an edge without length, or when more than max_triangles would be needed.
PanelMesh triangulate(const Panel& panel, const std::vector<int>& segments, const TriangulateOptions& options = {});

// Constrained Delaunay triangulation of the inside of an outline.  (CGAL's Constrained_Delaunay_triangulation_2)

// Triangles over the vertices 0..outline.size()-1 (the outline, counter-clockwise) and those that follow (interior).
// No vertex is added. The outline may touch itself where points coincide exactly, as the banks of a slit do: the plane
// has one point there, the result keeps the vertices apart, each with the triangles on its own bank.
// Each triangle starts with its lowest vertex, triangles are sorted, so the result does not depend on CGAL's order.
// Nothing is returned when the outline does not bound an inside on its left, when that inside is pinched in a point, or
// when an interior point lies on the outline or coincides with another.
// Pre: find_crossing(outline) is empty.
std::optional<std::vector<std::array<int, 3>>> delaunay_inside(std::span<const Vec2d> outline,
                                                               std::span<const Vec2d> interior);

// Where the interior vertices of a panel start: on a hexagonal grid, kept off the outline, finer where the outline is
// sampled finely.  (SPEC 3.1)

// The edge length wanted at each place of a panel: the outline's own spacing on the outline, growing with the
// distance from it up to the target.
class SizeField {
 public:
    // target_edge: m. Pre: outline is not empty.
    SizeField(std::span<const Vec2d> outline, double target_edge);
    double at(const Vec2d& point) const;  // m
    double smallest() const;              // m, over the outline

 private:
    std::span<const Vec2d> outline_;
    std::vector<double> spacing_;
    double target_edge_;
};

// A place and direction for the grid; several are tried and the best mesh is kept.
struct GridPose {
    double along = 0;        // shift along the rows, in edges
    double across = 0;       // shift across them, in rows
    bool is_turned = false;  // rows run along y instead of x
};

std::vector<Vec2d> place_interior_points(std::span<const Vec2d> outline, const SizeField& size, double target_edge,
                                         const GridPose& pose);

// Better triangles by moving, removing and adding interior points; the outline stays as it is.  (SPEC 3.1)

// A triangulation in the making: outline points first, then the interior ones.
struct PlanarMesh {
    std::vector<Vec2d> points;
    std::size_t outline_count = 0;
    std::vector<std::array<int, 3>> triangles;
};

// How bad the angles are: the sum over all triangles of the cubes of what their smallest angle lacks to 35 degrees, so
// that few bad ones weigh more than many fair ones.
double angle_penalty(const PlanarMesh& mesh);

// Moves each interior point to the centre of its neighbourhood (Lloyd), then sharp triangles' points to where their
// smallest angle is largest; after each round the mesh is triangulated anew. A round that does not lower the penalty
// is thrown away.
void relax(PlanarMesh& mesh, const SizeField& size, int rounds);

// Removes or adds single interior points at the worst triangles where that lowers the penalty.
void heal(PlanarMesh& mesh, const SizeField& size);

}  // namespace selvedge::sim
