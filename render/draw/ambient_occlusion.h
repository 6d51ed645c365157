#pragma once
// How much of the room's light reaches a point past all the cloth and body round it (ambient occlusion): the share of
// directions, weighted by the cosine, in which it sees out. Baked per vertex from depth pictures taken from all round,
// so it is smooth, has no noise, and stands still when the camera moves.
#include <vector>

#include "render/draw/cloth_vertices.h"
#include "render/draw/depth_range.h"

namespace selvedge::render {

struct RoomLightOptions {
    int axes = 40;         // each is looked along both ways
    int side_px = 320;     // of each depth picture
    float reach = 0.007F;  // m off the surface from which a point looks out; at least a texel
    float fade = 0.012F;   // m: a blocker nearer than this along the ray counts in part; at least two texels
};

struct LitPoints {
    std::vector<Vec3f> x;
    std::vector<Vec3f> normals;  // unit, one per point
    std::size_t two_sided = 0;   // so many, the first, are lit from behind too; the others' backs stay 1

    void add(const std::vector<Vec3f>& more_x, const std::vector<Vec3f>& more_normals);
    bool operator==(const LitPoints&) const = default;
};

// Keeps the bodies' depth pictures from one baking to the next, for cloth moves more often than they do.
class AmbientOcclusion {
 public:
    std::vector<Openness> bake(const Casters& cloths, const Casters& bodies, const LitPoints& points,
                               const RoomLightOptions& options = {});

 private:
    void draw_bodies(const Casters& bodies, const Bounds& bounds, const RoomLightOptions& options);

    Casters bodies_;  // that the pictures show
    Bounds bounds_;
    std::vector<DepthRange> body_pictures_;
    std::vector<DepthRange> pictures_;  // of all; kept for their memory
};

// The ground that catches shadows: a square sheet under the scene, whose room light is held by its vertices.

struct Ground {
    Vec3f centre = Vec3f::Zero();
    float radius = 1;  // m, half its side; nothing is seen of it from there on
    BodyItem sheet;    // empty where the scene has none
};

Ground make_ground(const Scene& scene, const Bounds& bounds);

// Each of the finitely many directions throws a faint shadow of its own on the ground: melts them into one.
// Pre: one value for each of the sheet's vertices.
std::vector<Openness> softened_ground(std::vector<Openness> ambient_visibility);

}  // namespace selvedge::render
