#pragma once
// A scene on its way to GL: what casts shadows, the room's light on every vertex, and the buffers that are drawn.
#include <optional>
#include <vector>

#include "render/cloth_paint.h"
#include "render/cloth_vertices.h"
#include "render/depth_pass.h"
#include "render/gl/handle.h"
#include "render/scene/scene.h"
#include "render/solid_buffer.h"

namespace selvedge {

struct ClothBuffer {
    VertexArray vertex_array;
    Buffer vertices;
    int vertex_count = 0;
    Texture sett_sums{};  // when it is woven
    Vec3f sett_mean = Vec3f::Zero();
    int sett_threads = 0;
    float thread_spacing = 1;  // m, scaled
    Vec2f sett_position = Vec2f::Zero();
    ShowMode show = ShowMode::Plain;  // Tartan only where there is a sett and material coordinates
    Vec3f colour = Vec3f::Zero();     // linear
    PaintBuffer paint{};
};

// A body, or the ground.
struct SurfaceBuffer {
    VertexArray vertex_array;
    Buffer vertices;
    Buffer indices;
    int index_count = 0;
    Vec3f colour = Vec3f::Zero();  // linear
};

struct SceneBuffers {
    std::vector<ClothBuffer> cloths;
    std::vector<SurfaceBuffer> bodies;
    std::vector<SolidBuffer> solids;
    std::optional<SurfaceBuffer> ground;
    Vec3f ground_centre = Vec3f::Zero();
    float ground_radius = 1;  // m
};

Casters casters_of(const Scene& scene);

// Bakes the room's light and uploads. Pre: the scene is not empty and all its numbers are finite.
SceneBuffers make_scene_buffers(const GladGLContext& gl, const Scene& scene, const Casters& casters);

}  // namespace selvedge
