#pragma once
// What is kept of a scene from one picture to the next: a turning camera asks for nothing new, moving cloth for all
// but what it did not change. What is kept was made from equal input, so a picture does not depend on those before.
#include <memory>

#include "render/picture_times.h"
#include "render/room_light.h"
#include "render/scene_buffers.h"
#include "render/shadow_map.h"

namespace selvedge {

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
    RoomLight room_light_;
    std::vector<Openness> openness_;
    SceneBuffers buffers_;
    ShadowMap shadow_;
    Eigen::Matrix4f key_matrix_ = Eigen::Matrix4f::Zero();
};

}  // namespace selvedge
