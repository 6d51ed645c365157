#pragma once
// Refines and coarsens the drawn surface by criteria. The simulated cloth is not changed.  (thesis 3.4, ch. 6)
#include <optional>

#include "render/surface/curved_surface.h"
#include "sim/adaptive/back_face.h"
#include "sim/adaptive/criteria.h"

namespace selvedge::render {

struct SurfaceCriteria {
    bool curvature = true;
    bool buckling = true;  // requests splits of edges that are shorter than their rest length
    bool length = false;   // the same measure with a higher threshold
    sim::CurvatureOptions curvature_angles{.split_angle = 0.12F, .rejoin_angle = 0.05F};  // between the curves' normals
    sim::BucklingOptions buckling_ratios{.split_ratio = 1.02F, .rejoin_ratio = 1.01F};
    sim::LengthOptions compressions{};
    float min_bulge = 0.0002F;     // m, how far a curve with M = 1 leaves its chord: up to this, no split; below
                                   // half of it, a rejoin is allowed whatever the other criteria say
    float shortest_edge = 0.002F;  // m, rest length; shorter edges are not split
};

struct AdaptSurfaceOptions {
    SurfaceCriteria criteria{};
    int max_level = sim::kDeepestLevel;     // at most the surface's own
    sim::Visibility* visibility = nullptr;  // if given, hidden parts stay coarse; adapt_surface() updates it
    // false, for a single picture: new vertices stand on their curves at once. true, for animation: vertices move in
    // and out gradually (update_surface), and an edge rejoins when its vertex has reached the edge's midpoint.
    bool glides = false;
};

// Call after update_surface(). Post: the plan fits the mesh. The next update_surface() moves the new vertices.
sim::AdaptReport adapt_surface(CurvedSurface& surface, const AdaptSurfaceOptions& options = {});

// For a single picture: repeats adapt_surface() and move_surface() until no edge changes, at most 12 times.
void settle_surface(CurvedSurface& surface, std::span<const Vec4f> x, std::span<const Vec4f> normals,
                    const AdaptSurfaceOptions& options = {}, const MoveOptions& move = {});

}  // namespace selvedge::render
