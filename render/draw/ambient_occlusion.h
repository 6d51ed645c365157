#pragma once
// Ambient occlusion: for each point, the fraction of directions (weighted by the cosine to the normal) in which no
// cloth or body blocks the ambient light. Baked per vertex from depth images along many directions, so it is smooth,
// free of noise, and does not change when the camera moves. Also the ground sheet, whose vertices store it.
#include <vector>

#include "render/draw/casters.h"
#include "render/draw/cloth_vertices.h"

namespace selvedge::render {

struct AmbientOcclusionOptions {
    int axes = 40;         // axes, spread evenly; each is sampled in both directions
    int side_px = 320;     // width and height of each depth image
    float reach = 0.007F;  // m, offset of a sample point along the normal; raised to one texel if smaller
    float fade = 0.012F;   // m: a blocker nearer than this along the ray counts in part; raised to two texels
};

struct LitPoints {
    std::vector<Vec3f> x;
    std::vector<Vec3f> normals;  // unit, one per point
    std::size_t two_sided = 0;   // the first two_sided points have a back too; the others' `back` stays 1

    void add(const std::vector<Vec3f>& more_x, const std::vector<Vec3f>& more_normals);
    bool operator==(const LitPoints&) const = default;
};

// Keeps the bodies' depth images between calls of bake(), because the cloth changes more often than the bodies.
class AmbientOcclusion {
 public:
    std::vector<AmbientVisibility> bake(const Casters& cloths, const Casters& bodies, const LitPoints& points,
                                        const AmbientOcclusionOptions& options = {});

 private:
    void draw_bodies(const Casters& bodies, const Bounds& bounds, const AmbientOcclusionOptions& options);

    Casters bodies_;  // drawn in body_pictures_
    Bounds bounds_;
    std::vector<DepthRange> body_pictures_;
    std::vector<DepthRange> pictures_;  // with bodies and cloths; a member only to reuse its memory
};

// The ground that catches shadows: a square sheet under the scene. Its vertices store the ambient visibility.

struct Ground {
    Vec3f centre = Vec3f::Zero();
    float radius = 1;  // m, half its side; the ground's shadow fades to zero at this distance from the centre
    BodyItem sheet;    // empty if the scene has no ground
};

Ground make_ground(const Scene& scene, const Bounds& bounds);

// Smooths the baked values: each of the sampled directions casts a faint, sharp shadow of its own on the ground.
// Pre: one value for each vertex of the sheet.
std::vector<AmbientVisibility> softened_ground(std::vector<AmbientVisibility> ambient_visibility);

}  // namespace selvedge::render
