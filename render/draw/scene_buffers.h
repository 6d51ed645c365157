#pragma once
// A scene as GL holds it: the buffers that are drawn, with the room's light on every vertex.
#include <memory>
#include <optional>
#include <vector>

#include "render/draw/ambient_occlusion.h"
#include "render/draw/cloth_vertices.h"
#include "render/draw/renderer.h"
#include "render/draw/sett_sums.h"
#include "render/draw/shadow.h"
#include "render/gl/handle.h"
#include "render/scene/scene.h"

namespace selvedge::render {

// Solids on their way to GL.

struct SolidBuffer {
    VertexArray vertex_array;
    Buffer vertices;
    Buffer indices;
    int index_count = 0;
};

SolidBuffer make_solid_buffer(const GladGLContext& gl, const SolidItem& item);

struct ClothBuffer {
    VertexArray vertex_array;
    Buffer vertices;
    int vertex_count = 0;
    Texture sett_sums{};      // when it is woven
    SettSums warp{}, weft{};  // without their sums
    sim::Weave weave = sim::Weave::Twill22;
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
                                const std::vector<Openness>& ambient_visibility);

// What is kept of a scene from one picture to the next: a turning camera asks for nothing new, moving cloth for all
// but what it did not change. What is kept was made from equal input, so a picture does not depend on those before.

class PreparedScene {
 public:
    explicit PreparedScene(const GladGLContext& gl);

    // Pre: the scene is not empty and all its numbers are finite.
    void prepare(const Scene& scene, PartClock& clock);
    void prepare(const SceneView& view, PartClock& clock);

    const SceneBuffers& buffers() const { return buffers_; }
    const ShadowMap& shadow() const { return shadow_; }
    const Eigen::Matrix4f& key_matrix() const { return key_matrix_; }  // room to -1..1, as the key light sees it
    float shadow_width() const { return 2 * bounds_.radius; }          // m

 private:
    void build(const Scene& scene, PartClock& clock);
    void turn_light(const Light& light, PartClock& clock);

    const GladGLContext& gl_;
    std::shared_ptr<const Scene> scene_;  // that the rest was made from
    Casters casters_;
    Bounds bounds_;
    LitPoints points_;
    AmbientOcclusion ambient_occlusion_;
    std::vector<Openness> ambient_visibility_;
    SceneBuffers buffers_;
    ShadowMap shadow_;
    Eigen::Matrix4f key_matrix_ = Eigen::Matrix4f::Zero();
};

}  // namespace selvedge::render
