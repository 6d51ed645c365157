#pragma once
// Triangulates one panel: constrained Delaunay triangulation of its sampled outline and of interior points placed on a
// hexagonal grid, then smoothing and local repair of the interior. No point is added on the outline, because the
// samples of a seam's two sides must match.
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "sim/core/math.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// The part of the outline that belongs to one OutlineEdge: outline[first], outline[first+1], ...,
// outline[first+segments] (indices modulo the outline's size).
struct OutlineRun {
    int first = 0;
    int segments = 0;
};

struct PanelMesh {
    std::vector<Vec2d> u;                       // material coordinates, m, panel frame
    std::vector<std::array<int, 3>> triangles;  // counter-clockwise
    std::vector<int> outline;                   // outline vertices, counter-clockwise, each once
    std::vector<OutlineRun> runs;               // one per OutlineEdge of the panel, same order
};

struct TriangulateOptions {
    double target_edge = 0.05;   // m
    int relaxations = 12;        // iterations of moving interior points
    int max_triangles = 200000;  // of this panel
};

// segments: per outline edge, see count_segments(). The outline may touch itself along a slit of zero width, or in a
// point if the cloth is not pinched there; the two sides keep separate vertices. Throws InputError that names the panel
// if the outline is open, crosses itself, pinches the cloth to a point, is clockwise or has an edge of zero length, or
// if about more than max_triangles are needed.
PanelMesh triangulate(const Panel& panel, const std::vector<int>& segments, const TriangulateOptions& options = {});

// Constrained Delaunay triangulation of the inside of an outline (CGAL's Constrained_Delaunay_triangulation_2).
// Vertices 0..outline.size()-1 are the outline, counter-clockwise; the interior vertices follow. No vertex is added.
// The outline may touch itself where points coincide exactly, for example along a slit. CGAL has one point there, but
// the result keeps separate vertices, each with the triangles on its side of the slit. Each triangle starts with its
// lowest vertex and triangles are sorted, so that the result does not depend on CGAL's order. Returns nullopt if the
// outline has no inside on its left, if the inside is pinched in a point, or if an interior point is on the outline or
// coincides with another point. Pre: find_crossing(outline) is empty.
std::optional<std::vector<std::array<int, 3>>> delaunay_inside(std::span<const Vec2d> outline,
                                                               std::span<const Vec2d> interior);

// The target edge length at each point of a panel: the spacing of the samples on the outline, increasing with the
// distance from it up to target_edge.
class SizeField {
 public:
    // target_edge: m. Pre: outline is not empty.
    SizeField(std::span<const Vec2d> outline, double target_edge);
    double at(const Vec2d& point) const;  // m
    double smallest() const;              // m, minimum over the outline

 private:
    std::span<const Vec2d> outline_;
    std::vector<double> spacing_;
    double target_edge_;
};

// Position and direction of the hexagonal grid; several are tried and the best mesh is kept.
struct GridPose {
    double along = 0;        // shift along the rows, in edge lengths
    double across = 0;       // shift across the rows, in row heights
    bool is_turned = false;  // rows run along y instead of x
};

// The initial interior points: on hexagonal grids with a minimum distance from the outline and from each other, finer
// where the outline is sampled finely. target_edge: m.
std::vector<Vec2d> place_interior_points(std::span<const Vec2d> outline, const SizeField& size, double target_edge,
                                         const GridPose& pose);

// A triangulation during optimisation: outline points first, then interior points. Only interior points change.
struct PlanarMesh {
    std::vector<Vec2d> points;
    std::size_t outline_count = 0;
    std::vector<std::array<int, 3>> triangles;
};

// Quality measure, lower is better: the sum over all triangles of max(0, 35 degrees - smallest angle)^3, in rad^3. The
// cube makes a few bad triangles count more than many moderate ones.
double angle_penalty(const PlanarMesh& mesh);

// Smooths the mesh. First `rounds` Lloyd iterations: each interior point moves to the weighted centroid of its
// triangles; the iteration with the lowest penalty is kept. Then at most `rounds` iterations that move points of bad
// triangles to where the smallest angle is largest, until the penalty no longer decreases. Retriangulates after each
// iteration.
void relax(PlanarMesh& mesh, const SizeField& size, int rounds);

// Removes or adds single interior points at the worst triangles if that lowers the penalty.
void heal(PlanarMesh& mesh, const SizeField& size);

}  // namespace selvedge::sim
