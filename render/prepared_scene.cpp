#include "render/prepared_scene.h"

namespace selvedge {
namespace {

// But for camera, light and background, which no buffer holds.
bool is_same_matter(const Scene& a, const Scene& b) {
    return a.has_ground == b.has_ground && a.ground_y == b.ground_y && a.cloths == b.cloths && a.bodies == b.bodies &&
           a.solids == b.solids;
}

// In the order in which make_scene_buffers reads their openness.
LitPoints lit_points(const Scene& scene, const Ground& ground) {
    LitPoints points;
    for (const ClothItem& cloth : scene.cloths) points.add(cloth.mesh.x, vertex_normals(cloth.mesh));
    points.two_sided = points.x.size();
    for (const BodyItem& body : scene.bodies) points.add(body.x, body.normals);
    points.add(ground.sheet.x, ground.sheet.normals);
    return points;
}

}  // namespace

PreparedScene::PreparedScene(const GladGLContext& gl) : gl_(gl), shadow_(gl) {}

void PreparedScene::prepare(const Scene& scene, PartClock& clock) {
    const bool is_same = scene_ && is_same_matter(*scene_, scene);
    clock.lap(&PictureTimes::compare);
    if (!is_same) {
        build(scene, clock);
        scene_ = std::make_shared<const Scene>(scene);
        clock.lap(&PictureTimes::upload);
    }
    turn_light(scene.light, clock);
}

void PreparedScene::prepare(const SceneView& view, PartClock& clock) {
    const bool is_same = scene_ && (scene_ == view.scene || is_same_matter(*scene_, *view.scene));
    clock.lap(&PictureTimes::compare);
    if (!is_same) build(*view.scene, clock);
    scene_ = view.scene;
    turn_light(view.light, clock);
}

void PreparedScene::build(const Scene& scene, PartClock& clock) {
    Casters casters = casters_of(scene);
    bounds_ = steady_bounds_of(casters.x);
    const Ground ground = make_ground(scene, bounds_);
    LitPoints points = lit_points(scene, ground);
    if (!(casters == casters_ && points == points_)) {
        openness_ = room_light_.bake(cloth_casters_of(scene), body_casters_of(scene), points);
    }
    clock.lap(&PictureTimes::room_light);
    points_ = std::move(points);
    if (!(casters == casters_)) {
        casters_ = std::move(casters);
        shadow_.load(casters_);
        key_matrix_.setZero();
    }
    buffers_ = make_scene_buffers(gl_, scene, ground, openness_);
    clock.lap(&PictureTimes::upload);
}

void PreparedScene::turn_light(const Light& light, PartClock& clock) {
    const Eigen::Matrix4f key_matrix = parallel_matrix(bounds_, light.to_key.normalized());
    if (key_matrix != key_matrix_) {
        key_matrix_ = key_matrix;
        shadow_.draw(key_matrix_, kShadowReach / shadow_width());
    }
    clock.lap(&PictureTimes::shadow);
}

}  // namespace selvedge
