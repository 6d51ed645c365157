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
        scene_ = scene;
        clock.lap(&PictureTimes::upload);
    }
    const Eigen::Matrix4f key_matrix = parallel_matrix(bounds_, scene.light.to_key.normalized());
    if (key_matrix != key_matrix_) {
        key_matrix_ = key_matrix;
        shadow_.draw(key_matrix_, kShadowReach / shadow_width());
    }
    clock.lap(&PictureTimes::shadow);
}

}  // namespace selvedge
