#include "render/scene/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "sim/core/assert.h"

namespace selvedge {
namespace {

constexpr std::array<std::pair<std::string_view, View>, 5> kViews{{{"front", View::Front},
                                                                   {"back", View::Back},
                                                                   {"left", View::Left},
                                                                   {"right", View::Right},
                                                                   {"three-quarter", View::ThreeQuarter}}};

struct Axes {
    Vec3f right;
    Vec3f up;
    Vec3f back;  // from the target to the eye
};

float azimuth(View view) {
    constexpr float quarter = 1.5707963F;
    switch (view) {
        case View::Front:
            return 0;
        case View::Back:
            return 2 * quarter;
        case View::Left:
            return quarter;
        case View::Right:
            return -quarter;
        case View::ThreeQuarter:
            return 0.62F;
    }
    return 0;
}

// A little from above, so that the ground is seen as ground.
Axes axes_of(View view) {
    const float angle = azimuth(view);
    const float pitch = view == View::ThreeQuarter ? 0.16F : 0.07F;
    Axes axes;
    axes.back = {std::sin(angle) * std::cos(pitch), std::sin(pitch), std::cos(angle) * std::cos(pitch)};
    axes.right = Vec3f::UnitY().cross(axes.back).normalized();
    axes.up = axes.back.cross(axes.right);
    return axes;
}

// Along one picture axis: a point at s across and b towards the eye is inside when |s - centre| <= (distance - b) t.
// So the greatest of s + b t and the least of s - b t bound the distance, and their mean is the centre.
struct Extent {
    float t = 1;
    float high = -std::numeric_limits<float>::infinity();
    float low = std::numeric_limits<float>::infinity();

    void add(float s, float b) {
        high = std::max(high, s + b * t);
        low = std::min(low, s - b * t);
    }
    float distance() const { return (high - low) / (2 * t); }
    float centre() const { return (high + low) / 2; }
};

}  // namespace

std::optional<View> parse_view(std::string_view name) {
    for (const auto& [known, view] : kViews) {
        if (known == name) return view;
    }
    return std::nullopt;
}

Camera frame_points(const std::vector<Vec3f>& points, View view, const FrameOptions& options) {
    SELVEDGE_ASSERT(!points.empty() && options.aspect > 0);
    Camera camera;
    const Axes axes = axes_of(view);
    const float half = std::tan(camera.fov_y / 2) * (1 - options.margin);
    Extent across{.t = half * options.aspect};
    Extent upward{.t = half};
    float nearest = -std::numeric_limits<float>::infinity();
    float farthest = std::numeric_limits<float>::infinity();
    for (const Vec3f& point : points) {
        const float b = axes.back.dot(point);
        across.add(axes.right.dot(point), b);
        upward.add(axes.up.dot(point), b);
        nearest = std::max(nearest, b);
        farthest = std::min(farthest, b);
    }
    constexpr float least_clearance = 0.05F;  // m: a flat thing seen edge-on would touch the eye
    const float distance = std::max({across.distance(), upward.distance(), nearest + least_clearance});
    camera.eye = across.centre() * axes.right + upward.centre() * axes.up + distance * axes.back;
    camera.target = camera.eye - (distance - (nearest + farthest) / 2) * axes.back;
    camera.up = axes.up;
    camera.near_plane = std::max(0.2F * (distance - nearest), 0.01F);
    camera.far_plane = (distance - farthest) * 4 + 20;
    return camera;
}

Eigen::Matrix4f view_matrix(const Camera& camera) {
    const Vec3f back = (camera.eye - camera.target).normalized();
    const Vec3f right = camera.up.cross(back).normalized();
    const Vec3f up = back.cross(right);
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
    matrix.block<1, 3>(0, 0) = right.transpose();
    matrix.block<1, 3>(1, 0) = up.transpose();
    matrix.block<1, 3>(2, 0) = back.transpose();
    matrix.block<3, 1>(0, 3) = -matrix.block<3, 3>(0, 0) * camera.eye;
    return matrix;
}

Eigen::Matrix4f projection_matrix(const Camera& camera, float aspect) {
    const float focal = 1 / std::tan(camera.fov_y / 2);
    const float depth = camera.near_plane - camera.far_plane;
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Zero();
    matrix(0, 0) = focal / aspect;
    matrix(1, 1) = focal;
    matrix(2, 2) = (camera.far_plane + camera.near_plane) / depth;
    matrix(2, 3) = 2 * camera.far_plane * camera.near_plane / depth;
    matrix(3, 2) = -1;
    return matrix;
}

}  // namespace selvedge
