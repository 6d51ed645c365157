#include "editor/fitting/view_ray.h"

#include <algorithm>
#include <cmath>

namespace selvedge {
namespace {

constexpr float kLeastDepth = 1e-3F;  // m

struct PictureAxes {
    Vec3f right, up, back;
};

PictureAxes axes_of(const Camera& camera) {
    const Eigen::Matrix4f view = view_matrix(camera);
    return {view.block<1, 3>(0, 0).transpose(), view.block<1, 3>(1, 0).transpose(), view.block<1, 3>(2, 0).transpose()};
}

// px per unit of slope.
float focal_px(const Viewing& viewing) {
    return viewing.size_px.y() / 2 / std::tan(viewing.camera.fov_y / 2);
}

}  // namespace

Ray ray_through(const Viewing& viewing, const Vec2f& px) {
    const PictureAxes axes = axes_of(viewing.camera);
    const Vec2f slope = (px - viewing.size_px / 2) / focal_px(viewing);
    return {.origin = viewing.camera.eye,
            .direction = (slope.x() * axes.right - slope.y() * axes.up - axes.back).normalized()};
}

float depth_of(const Viewing& viewing, const Vec3f& x) {
    const Camera& camera = viewing.camera;
    return (x - camera.eye).dot((camera.target - camera.eye).normalized());
}

std::optional<Vec2f> px_of(const Viewing& viewing, const Vec3f& x) {
    const PictureAxes axes = axes_of(viewing.camera);
    const Vec3f from_eye = x - viewing.camera.eye;
    const float depth = -axes.back.dot(from_eye);
    if (!(depth > kLeastDepth)) return std::nullopt;
    const Vec2f slope(axes.right.dot(from_eye) / depth, -axes.up.dot(from_eye) / depth);
    return Vec2f(viewing.size_px / 2 + focal_px(viewing) * slope);
}

float metres_per_px(const Viewing& viewing, const Vec3f& x) {
    return std::max(depth_of(viewing, x), kLeastDepth) / focal_px(viewing);
}

Vec3f in_picture_plane(const Viewing& viewing, const Vec2f& px, const Vec3f& x) {
    const Ray ray = ray_through(viewing, px);
    const Vec3f ahead = (viewing.camera.target - viewing.camera.eye).normalized();
    return ray.at(depth_of(viewing, x) / ray.direction.dot(ahead));
}

}  // namespace selvedge
