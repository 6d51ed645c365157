#include "editor/viewport3d/orbit_camera.h"

#include <algorithm>
#include <cmath>

namespace selvedge::editor {
namespace {

constexpr float kPi = 3.14159265F;
constexpr float kPole = kPi / 2 - 1e-3F;           // rad, the steepest elevation
constexpr float kNearest = 0.15F, kFarthest = 40;  // m, limits of the distance
constexpr float kUsualLens = render::kUsualFovY;
constexpr float kLongLens = 0.03F;     // rad, vertical field of view
constexpr float kTurnPerPx = 0.0075F;  // rad
constexpr float kNearingPerNotch = 0.87F;
constexpr float kMoveTime = 0.24F;  // s

float wrapped(float angle) {
    return std::remainder(angle, 2 * kPi);
}

float mix(float a, float b, float t) {
    return a + (b - a) * t;
}

// Interpolates distances geometrically and angles along the shorter arc.
CameraPose between(const CameraPose& a, const CameraPose& b, float t) {
    return {.target = a.target + t * (b.target - a.target),
            .distance = a.distance * std::pow(b.distance / a.distance, t),
            .azimuth = wrapped(a.azimuth + t * wrapped(b.azimuth - a.azimuth)),
            .elevation = mix(a.elevation, b.elevation, t),
            .lens = b.lens};
}

}  // namespace

render::Camera camera_at(const CameraPose& standpoint) {
    const float a = standpoint.azimuth;
    const Vec3f back = unit_vector(render::Direction{a, standpoint.elevation});
    const Vec3f right(std::cos(a), 0, -std::sin(a));
    render::Camera camera{.target = standpoint.target, .up = back.cross(right)};
    float distance = standpoint.distance;
    camera.near_plane = std::clamp(0.1F * distance, 0.01F, 0.3F);
    camera.far_plane = 4 * distance + 20;
    if (standpoint.lens == Lens::Long) {
        camera.fov_y = kLongLens;
        distance *= std::tan(kUsualLens / 2) / std::tan(kLongLens / 2);
        camera.near_plane = std::max(0.1F * distance, distance - 10);
        camera.far_plane = distance + 30;
    }
    camera.eye = standpoint.target + distance * back;
    return camera;
}

void OrbitCamera::orbit(const Vec2f& by_px) {
    left_ = 0;
    now_.azimuth = wrapped(now_.azimuth - kTurnPerPx * by_px.x());
    now_.elevation = std::clamp(now_.elevation + kTurnPerPx * by_px.y(), -kPole, kPole);
}

void OrbitCamera::pan(const Vec2f& by_px, const Vec2f& size_px) {
    left_ = 0;
    const Eigen::Matrix4f view = view_matrix(camera());
    const Vec3f right = view.block<1, 3>(0, 0).transpose(), up = view.block<1, 3>(1, 0).transpose();
    const float metres = 2 * now_.distance * std::tan(kUsualLens / 2) / size_px.y();
    now_.target += metres * (by_px.y() * up - by_px.x() * right);
}

void OrbitCamera::zoom(float notches, const Vec3f& about) {
    left_ = 0;
    const float wanted = now_.distance * std::pow(kNearingPerNotch, notches);
    const float distance = std::clamp(wanted, kNearest, kFarthest);
    now_.target = about + (now_.target - about) * (distance / now_.distance);
    now_.distance = distance;
}

void OrbitCamera::look_from(StandardView view) {
    CameraPose there = goal();
    there.elevation = 0;
    switch (view) {
        case StandardView::Front:
            there.azimuth = 0;
            break;
        case StandardView::Back:
            there.azimuth = kPi;
            break;
        case StandardView::Left:
            there.azimuth = kPi / 2;
            break;
        case StandardView::Right:
            there.azimuth = -kPi / 2;
            break;
        case StandardView::Top:
        case StandardView::Bottom:
            there.azimuth = 0;
            there.elevation = view == StandardView::Top ? kPole : -kPole;
            break;
    }
    move_to(there);
}

void OrbitCamera::turn_opposite() {
    CameraPose there = goal();
    if (std::abs(there.elevation) > kPi / 4) {
        there.elevation = -there.elevation;
    } else {
        there.azimuth = wrapped(there.azimuth + kPi);
    }
    move_to(there);
}

void OrbitCamera::frame(const std::vector<Vec3f>& points, float aspect) {
    if (points.empty() || !(aspect > 0)) return;
    CameraPose there = goal();
    const render::Camera camera = frame_points(points, render::Direction{there.azimuth, there.elevation},
                                               {.aspect = aspect, .margin = render::kGarmentMargin});
    there.target = camera.target;
    there.distance = std::clamp((camera.eye - camera.target).norm(), 4 * kNearest, kFarthest);
    move_to(there);
}

void OrbitCamera::change_lens() {
    now_.lens = now_.lens == Lens::Usual ? Lens::Long : Lens::Usual;
    to_.lens = now_.lens;
}

void OrbitCamera::move_to(const CameraPose& there) {
    from_ = now_;
    to_ = there;
    left_ = kMoveTime;
}

void OrbitCamera::shift(const Vec3f& by) {
    for (CameraPose* pose : {&now_, &from_, &to_}) pose->target += by;
}

void OrbitCamera::advance(float seconds) {
    if (!is_moving()) return;
    left_ = std::max(0.0F, left_ - seconds);
    const float t = 1 - left_ / kMoveTime;
    now_ = left_ > 0 ? between(from_, to_, t * t * (3 - 2 * t)) : to_;
}

namespace {

constexpr float kMinDepth = 1e-3F;  // m

struct PictureAxes {
    Vec3f right, up, back;
};

PictureAxes axes_of(const render::Camera& camera) {
    const Eigen::Matrix4f view = view_matrix(camera);
    return {view.block<1, 3>(0, 0).transpose(), view.block<1, 3>(1, 0).transpose(), view.block<1, 3>(2, 0).transpose()};
}

// Focal length in px.
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
    const render::Camera& camera = viewing.camera;
    return (x - camera.eye).dot((camera.target - camera.eye).normalized());
}

std::optional<Vec2f> px_of(const Viewing& viewing, const Vec3f& x) {
    const PictureAxes axes = axes_of(viewing.camera);
    const Vec3f from_eye = x - viewing.camera.eye;
    const float depth = -axes.back.dot(from_eye);
    if (!(depth > kMinDepth)) return std::nullopt;
    const Vec2f slope(axes.right.dot(from_eye) / depth, -axes.up.dot(from_eye) / depth);
    return Vec2f(viewing.size_px / 2 + focal_px(viewing) * slope);
}

float metres_per_px(const Viewing& viewing, const Vec3f& x) {
    return std::max(depth_of(viewing, x), kMinDepth) / focal_px(viewing);
}

Vec3f in_picture_plane(const Viewing& viewing, const Vec2f& px, const Vec3f& x) {
    const Ray ray = ray_through(viewing, px);
    const Vec3f ahead = (viewing.camera.target - viewing.camera.eye).normalized();
    return ray.at(depth_of(viewing, x) / ray.direction.dot(ahead));
}

}  // namespace selvedge::editor
