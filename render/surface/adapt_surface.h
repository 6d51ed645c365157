#pragma once
// Where the drawn surface is fine and where it is coarse. It touches nothing but what is drawn.  (SPEC 1.3, 5)
#include <optional>

#include "render/surface/curved_surface.h"
#include "sim/adaptive/back_face.h"
#include "sim/adaptive/criteria.h"

namespace selvedge::render {

struct SurfaceCriteria {
    bool curvature = true;
    bool buckling = true;  // edges that are shorter than their material
    bool length = false;   // the same question, asked later
    sim::CurvatureOptions curvature_angles{.split_angle = 0.12F, .rejoin_angle = 0.05F};  // of curves' normals
    sim::BucklingOptions buckling_ratios{.split_ratio = 1.02F, .rejoin_ratio = 1.01F};
    sim::LengthOptions compressions{};
    float least_bulge = 0.0002F;   // m that a curve with M = 1 leaves its chord; with less an edge is not split, with
                                   // half of it it agrees to rejoin, whatever the others say
    float shortest_edge = 0.002F;  // m; shorter ones are not split
};

struct AdaptSurfaceOptions {
    SurfaceCriteria criteria{};
    int max_level = sim::kDeepestLevel;     // or the surface's own
    sim::Visibility* visibility = nullptr;  // with it what is turned away is kept coarse; made here for each adaptation
    // A picture by itself is fine at once. One of a film is not: vertices glide in and out (update_surface), and an
    // edge is rejoined when its vertex has glided to its middle.
    bool glides = false;
};

// After update_surface(). Post: the plan is that of the mesh; the next update_surface() moves what is new.
sim::AdaptReport adapt_surface(CurvedSurface& surface, const AdaptSurfaceOptions& options = {});

// Until no edge changes any more, for a picture by itself: adapts and updates in turns.
void settle_surface(CurvedSurface& surface, std::span<const Vec4f> x, std::span<const Vec4f> normals,
                    const AdaptSurfaceOptions& options = {}, const MoveOptions& move = {});

}  // namespace selvedge::render
