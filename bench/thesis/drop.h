#pragma once
// A square of cloth that is dropped on a sphere or a cylinder: the thesis' test scene.  (SPEC 1.5, tables 3.1 and
// 3.12-3.14, figures 3.23-3.30)
//
// 1 m square, 32 base triangles, cotton shirting; the object has a radius of 0.25 m and stands at the origin, a
// cylinder lies along x. The cloth starts flat and horizontal, 0.1 m above it. Frames of 1/30 s: one adaptation, then
// four steps of 1/120 s.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/draw/renderer.h"
#include "render/image/image.h"
#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/cloth.h"
#include "sim/collide/collider.h"

namespace selvedge::bench {

enum class DropObject { Sphere, Cylinder };

struct DropOptions {
    DropObject object = DropObject::Sphere;
    bool falls_off = false;              // dropped beside the middle and with less friction: it slides off again
    std::optional<int> uniform_level{};  // the same level everywhere; none: adaptive by the criteria
    sim::CriteriaOptions criteria{};
    sim::DiagonalChoice diagonal = sim::DiagonalChoice::MinimalChange;
    double seconds = 2.0;
    double shift = 0;          // m, of the start along z: for runs that should hardly differ
    bool times_parts = false;  // collision and drawing too, which makes the run slower
    std::function<void(const sim::Cloth&, double)> watch{};  // called after each frame with its time, s
};

// Processor times of one frame, ms.
struct DropFrame {
    double time = 0;            // s, at the frame's end
    std::size_t triangles = 0;  // leaves
    double adaptation = 0;
    double steps = 0;      // all four, collision and all
    double collision = 0;  // of them: what they take more than the same steps with nothing near
    double drawing = 0;    // making the arrays that the renderer draws; no drawing itself
};

struct DropRun {
    std::vector<DropFrame> frames;
    sim::TransitionCounts transitions;
    std::vector<Vec3f> grid;  // at the end: positions at 33 x 33 material points, whatever the mesh
};

DropRun run_drop(const DropOptions& options);

// The same several times, which does the same each time; every figure is the least that was seen.
DropRun run_drop_repeatedly(const DropOptions& options, int runs);

// m, over the points of the grids.
double mean_distance(const DropRun& a, const DropRun& b);

// For pictures. half_length: of the cylinder, m.
std::unique_ptr<sim::Collider> make_drop_object(DropObject object);
const char* name_of(DropObject object);
inline constexpr float kDropRadius = 0.25F;     // m
inline constexpr float kDropHalfLength = 0.6F;  // m

// Pictures of a dropped cloth, its triangles coloured by level. Owns the renderer's context: one at a time.

class DropPainter {
 public:
    explicit DropPainter(int side_px) : side_px_(side_px) {}

    render::Image draw(const sim::Cloth& cloth, DropObject object);

 private:
    render::Renderer renderer_;
    int side_px_;
};

}  // namespace selvedge::bench
