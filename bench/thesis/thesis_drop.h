#pragma once
// The test scene of the thesis: a square of cloth falls on a sphere or a cylinder. Runs it, times its parts, and draws
// it. (thesis 3.8.2, tables 3.1 and 3.12-3.14, figs. 3.23-3.30)
//
// The cloth is 1 m square, with 32 base triangles, of cotton shirting. The object has a radius of 0.25 m and its centre
// at the origin; the axis of the cylinder is x. The cloth starts flat and horizontal, 0.1 m above the object. A frame
// is 1/30 s: one adaptation, then four steps of 1/120 s.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/draw/renderer.h"
#include "render/image/image.h"
#include "sim/adaptive/adaptive_mesh.h"
#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/cloth.h"
#include "sim/collide/collider.h"

namespace selvedge::bench {

// The choices between two diagonals that the thesis tried beside the minimal change, and judged no better.  (fig. 3.9)

enum class DiagonalChoice {
    MinimalChange,
    Length,      // shortest in 3D
    RestLength,  // shortest in material coordinates
    Curvature,   // along which the surface bends least
};

// For AdaptClothOptions::diagonal_cost. Empty for MinimalChange. The cloth must outlive it.
std::function<float(const sim::Diagonal&)> diagonal_cost(const sim::Cloth& cloth, DiagonalChoice choice);

enum class ThesisDropObject { Sphere, Cylinder };

struct ThesisDropOptions {
    ThesisDropObject object = ThesisDropObject::Sphere;
    bool falls_off = false;              // starts off centre, with less friction, so that it slides off the object
    std::optional<int> uniform_level{};  // uniform refinement to this level; none: adaptive by the criteria
    sim::CriteriaOptions criteria{};
    DiagonalChoice diagonal = DiagonalChoice::MinimalChange;
    double seconds = 2.0;
    double shift = 0;          // m, of the start position along z, to compare runs that should hardly differ
    bool times_parts = false;  // also times collision and drawing; the run takes longer
    std::function<void(const sim::Cloth&, double)> watch{};  // called after each frame with the simulated time, s
};

// CPU times of one frame, ms.
struct ThesisDropFrame {
    double time = 0;            // s, simulated, at the end of the frame
    std::size_t triangles = 0;  // leaves
    double adaptation = 0;
    double steps = 0;      // all four steps, including collision
    double collision = 0;  // part of steps: time beyond that of the same steps without an object
    double drawing = 0;    // filling the vertex arrays for the renderer; no rendering
};

struct ThesisDropRun {
    std::vector<ThesisDropFrame> frames;
    sim::TransitionCounts transitions;
    std::vector<Vec3f> grid;  // final positions at 33 x 33 material points, independent of the mesh
};

ThesisDropRun run_thesis_drop(const ThesisDropOptions& options);

// Repeats the run, which is deterministic. Each time is the minimum over the runs.
ThesisDropRun run_thesis_drop_repeatedly(const ThesisDropOptions& options, int runs);

// m, mean distance of corresponding grid points.
double mean_distance(const ThesisDropRun& a, const ThesisDropRun& b);

// The object as a collider, and its dimensions for pictures.
std::unique_ptr<sim::Collider> make_drop_object(ThesisDropObject object);
const char* name_of(ThesisDropObject object);
inline constexpr float kDropRadius = 0.25F;     // m
inline constexpr float kDropHalfLength = 0.6F;  // m, of the cylinder

// Draws a dropped cloth with its triangles coloured by level. Owns the renderer's GL context: create only one at a
// time.

class DropPainter {
 public:
    explicit DropPainter(int side_px) : side_px_(side_px) {}

    render::Image draw(const sim::Cloth& cloth, ThesisDropObject object);

 private:
    render::Renderer renderer_;
    int side_px_;
};

}  // namespace selvedge::bench
