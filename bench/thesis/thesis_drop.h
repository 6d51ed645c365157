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

// The cloth that falls: this program's; the same with contact at its vertices alone; or the thesis' own as a baseline
// (provot_cloth.h).
enum class DropCloth { Selvedge, VerticesOnly, MassSpring };

class DropPainter;

// Settings are those of a garment's drape (sim/dress/drape.h), for both cloths as far as they have them, except: no
// floor, no contact of cloth with cloth, no phase that relaxes, lowers or finishes the cloth, rejoins at all times.
struct ThesisDropOptions {
    ThesisDropObject object = ThesisDropObject::Sphere;
    DropCloth cloth = DropCloth::Selvedge;
    bool falls_off = false;              // starts off centre, with less friction, so that it slides off the object
    std::optional<int> uniform_level{};  // uniform refinement to this level; none: adaptive by the criteria
    sim::CriteriaOptions criteria{};
    DiagonalChoice diagonal = DiagonalChoice::MinimalChange;
    double seconds = 2.0;
    double shift = 0;                // m, of the start position along z, to compare runs that should hardly differ
    DropPainter* painter = nullptr;  // optional: draws pictures, which are timed
    int frames_per_picture = 1;
    std::function<void(const sim::Cloth&, double)> watch{};  // called after each frame with the simulated time, s
};

// Wall-clock times, ms.
struct DropTimes {
    double adaptation = 0;
    double simulation = 0;  // the steps without collision
    double collision = 0;   // contact within the steps, and the standoffs that they need
    double rendering = 0;   // one picture, from the cloth to its pixels; 0 where none is drawn

    double total_update() const { return adaptation + simulation + collision; }
};

// One update: one adaptation and four steps, and a picture.
struct ThesisDropFrame {
    double time = 0;            // s, simulated, at the end of the frame
    std::size_t triangles = 0;  // leaves after the adaptation
    double gap = 0;             // m, least distance of a vertex from the object when the adaptation begins
    DropTimes wall;
    double update_cpu = 0;  // ms of CPU time of the total update
};

struct ThesisDropRun {
    std::vector<ThesisDropFrame> frames;
    sim::TransitionCounts transitions;
    std::vector<Vec3f> grid;  // final positions at 33 x 33 material points, independent of the mesh
};

ThesisDropRun run_thesis_drop(const ThesisDropOptions& options);

// Repeats the run, which is deterministic. Each frame's update is that of the run in which its total took least; its
// CPU time is the least of all runs. Only the first run draws: pictures take far longer than updates.
ThesisDropRun run_thesis_drop_repeatedly(const ThesisDropOptions& options, int runs);

// m, mean distance of corresponding grid points.
double mean_distance(const ThesisDropRun& a, const ThesisDropRun& b);

// 1/m, how much the drape bends per length: the mean over inner grid points of |sum of the four neighbours - 4 x| /
// spacing^2. It sums turning angles, so that a fold counts the same on a coarse and on a fine mesh.
double mean_bend(const ThesisDropRun& run);

// The object as a collider, and its dimensions for pictures.
std::unique_ptr<sim::Collider> make_drop_object(ThesisDropObject object);
const char* name_of(ThesisDropObject object);
render::BodyItem drop_object_item(ThesisDropObject object);
inline constexpr float kDropRadius = 0.25F;     // m
inline constexpr float kDropHalfLength = 0.6F;  // m, of the cylinder

// Draws a dropped cloth with its triangles coloured by level, on one thread if Mesa's software renderer draws. Owns the
// renderer's GL context: create only one at a time.

class DropPainter {
 public:
    explicit DropPainter(int side_px);

    render::Image draw(const sim::Cloth& cloth, ThesisDropObject object);

 private:
    int side_px_;
    render::Renderer renderer_;
};

}  // namespace selvedge::bench
