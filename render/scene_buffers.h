#pragma once
// A scene as GL holds it: the buffers that are drawn, with the room's light on every vertex.
#include <optional>
#include <vector>

#include "render/cloth_paint.h"
#include "render/cloth_vertices.h"
#include "render/gl/handle.h"
#include "render/ground.h"
#include "render/scene/scene.h"
#include "render/sett_sums.h"
#include "render/solid_buffer.h"

namespace selvedge {

struct ClothBuffer {
    VertexArray vertex_array;
    Buffer vertices;
    int vertex_count = 0;
    Texture sett_sums{};      // when it is woven
    SettSums warp{}, weft{};  // without their sums
    Weave weave = Weave::Twill22;
    float thread_spacing = 1;  // m, scaled
    Vec2f sett_position = Vec2f::Zero();
    ShowMode show = ShowMode::Plain;  // Tartan only where there is a sett and material coordinates
    Vec3f colour = Vec3f::Zero();     // linear
    PaintBuffer paint{};
    Material material{};
};

// A body, or the ground.
struct SurfaceBuffer {
    VertexArray vertex_array;
    Buffer vertices;
    Buffer indices;
    int index_count = 0;
    bool is_closed = false;        // its inside is not seen
    Vec3f colour = Vec3f::Zero();  // linear
    Material material{};
};

struct SceneBuffers {
    std::vector<ClothBuffer> cloths;
    std::vector<SurfaceBuffer> bodies;
    std::vector<SolidBuffer> solids;
    std::optional<SurfaceBuffer> ground;
    Vec3f ground_centre = Vec3f::Zero();
    float ground_radius = 1;  // m
};

// A closed surface faces as much one way as the other; one with a hole lacks what the hole would face.
bool is_closed(const BodyItem& item);

// openness: of the cloths' vertices, then the bodies', then the ground's, as baked.
SceneBuffers make_scene_buffers(const GladGLContext& gl, const Scene& scene, const Ground& ground,
                                const std::vector<Openness>& openness);

}  // namespace selvedge
