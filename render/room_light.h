#pragma once
// How much of the room's light reaches a point past all the cloth and body round it (ambient occlusion): the share of
// directions, weighted by the cosine, in which it sees out. Baked per vertex from depth pictures taken from all round,
// so it is smooth and has no noise.
#include <vector>

#include "render/cloth_vertices.h"
#include "render/depth_pass.h"

namespace selvedge {

struct RoomLightOptions {
    int directions = 80;
    int side_px = 320;     // of each depth picture
    float reach = 0.007F;  // m off the surface from which a point looks out
    float fade = 0.012F;   // m: a blocker nearer than this along the ray counts in part
};

// Pre: one unit normal per point.
std::vector<Openness> bake_room_light(const GladGLContext& gl, const Casters& casters, const std::vector<Vec3f>& points,
                                      const std::vector<Vec3f>& normals, const RoomLightOptions& options = {});

}  // namespace selvedge
