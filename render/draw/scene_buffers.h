#pragma once
// A scene in GL buffers, with the ambient visibility of every vertex, and PreparedScene, which keeps these buffers from
// one picture to the next.
#include <memory>
#include <optional>
#include <vector>

#include "render/draw/ambient_occlusion.h"
#include "render/draw/cloth_vertices.h"
#include "render/draw/renderer.h"
#include "render/draw/shadow.h"
#include "render/gl/target.h"
#include "render/scene/scene.h"

namespace selvedge::render {

// GL buffers of a SolidItem.

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
    Texture sett_sums{};      // prefix sums of warp (row 0) and weft (row 1); only if woven
    SettSums warp{}, weft{};  // their means and thread counts are passed to the shader
    sim::Weave weave = sim::Weave::Twill22;
    float thread_spacing = 1;  // m, times sett_scale
    Vec2f sett_position = Vec2f::Zero();
    Texture picture{};                     // only if a picture is printed on it
    std::array<Vec3f, 2> picture_rows{};   // to its texture coordinates (scene.h)
    Vec3f picture_ground = Vec3f::Zero();  // linear
    ShowMode show = ShowMode::Plain;       // Tartan only if there are a sett and material coordinates
    Vec3f colour = Vec3f::Zero();          // linear
    PaintBuffer paint{};
    Material material{};
};

// A body or the ground.
struct SurfaceBuffer {
    VertexArray vertex_array;
    Buffer vertices;
    Buffer indices;
    int index_count = 0;
    bool is_closed = false;        // back faces are culled
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

// Whether the triangles' area vectors add up to zero, as on a closed surface (tolerance: 1e-4 of the area).
bool is_closed(const BodyItem& item);

// ambient_visibility: of the cloths' vertices, then the bodies', then the ground's, as baked.
SceneBuffers make_scene_buffers(const GladGLContext& gl, const Scene& scene, const Ground& ground,
                                const std::vector<AmbientVisibility>& ambient_visibility);

// Keeps a scene's buffers from one picture to the next. If only the camera moves, nothing is rebuilt; if cloth moves,
// only what depends on it. Everything kept was made from equal input, so a picture does not depend on earlier ones.

class PreparedScene {
 public:
    explicit PreparedScene(const GladGLContext& gl);

    // Pre: the scene is not empty and all its numbers are finite.
    void prepare(const Scene& scene, PartClock& clock);
    void prepare(const SceneView& view, PartClock& clock);

    const SceneBuffers& buffers() const { return buffers_; }
    const ShadowMap& shadow() const { return shadow_; }
    const Eigen::Matrix4f& key_matrix() const { return key_matrix_; }  // world space to -1..1, from the key light
    float shadow_width() const { return 2 * bounds_.radius; }          // m, covered by the shadow map

 private:
    void build(const Scene& scene, PartClock& clock);
    void turn_light(const Light& light, PartClock& clock);

    const GladGLContext& gl_;
    std::shared_ptr<const Scene> scene_;  // from which the other members were made
    Casters casters_;
    Bounds bounds_;
    LitPoints points_;
    AmbientOcclusion ambient_occlusion_;
    std::vector<AmbientVisibility> ambient_visibility_;
    SceneBuffers buffers_;
    ShadowMap shadow_;
    Eigen::Matrix4f key_matrix_ = Eigen::Matrix4f::Zero();
};

}  // namespace selvedge::render
