#include "render/scene/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "sim/core/assert.h"

namespace selvedge::render {
namespace {

struct NamedView {
    std::string_view name;
    View view;
    Direction direction;
};

// A little from above, so that the ground is visible as a plane.
constexpr std::array<NamedView, 9> kViews{{{"front", View::Front, {0, 0.07F}},
                                           {"back", View::Back, {3.1415927F, 0.07F}},
                                           {"left", View::Left, {1.5707963F, 0.07F}},
                                           {"right", View::Right, {-1.5707963F, 0.07F}},
                                           {"three-quarter", View::ThreeQuarter, {0.62F, 0.16F}},
                                           {"three-quarter-back", View::ThreeQuarterBack, {3.1415927F - 0.62F, 0.16F}},
                                           {"top", View::Top, {0, 1.45F}},
                                           {"close", View::Close, {0.22F, 0.12F}},
                                           {"hem", View::Hem, {0.22F, 0.12F}}}};

struct Axes {
    Vec3f right;
    Vec3f up;
    Vec3f back;  // from the target to the eye
};

Axes axes_of(const Direction& direction) {
    Axes axes;
    axes.back = unit_vector(direction);
    axes.right = Vec3f::UnitY().cross(axes.back).normalized();
    axes.up = axes.back.cross(axes.right);
    return axes;
}

// Bounds along one axis of the picture. A point at s along the axis and b towards the eye is visible if
// -(distance - b) before <= s - centre <= (distance - b) after. So the maximum of s + b after and the minimum of
// s - b before give the smallest distance, and the centre that fits a distance.
struct Extent {
    float before = 1;
    float after = 1;
    float high = -std::numeric_limits<float>::infinity();
    float low = std::numeric_limits<float>::infinity();

    void add(float s, float b) {
        high = std::max(high, s + b * after);
        low = std::min(low, s - b * before);
    }
    float min_distance() const { return (high - low) / (before + after); }
    float centre(float distance) const { return (high - distance * after + low + distance * before) / 2; }
};

}  // namespace

std::optional<View> parse_view(std::string_view name) {
    for (const NamedView& known : kViews) {
        if (known.name == name) return known.view;
    }
    return std::nullopt;
}

Direction direction_of(View view) {
    for (const NamedView& known : kViews) {
        if (known.view == view) return known.direction;
    }
    return {};
}

Vec3f unit_vector(const Direction& direction) {
    const float angle = direction.azimuth, pitch = direction.elevation;
    return {std::sin(angle) * std::cos(pitch), std::sin(pitch), std::cos(angle) * std::cos(pitch)};
}

Camera frame_points(const std::vector<Vec3f>& points, View view, const FrameOptions& options) {
    return frame_points(points, direction_of(view), options);
}

Camera frame_points(const std::vector<Vec3f>& points, const Direction& direction, const FrameOptions& options) {
    SELVEDGE_ASSERT(!points.empty() && options.aspect > 0);
    Camera camera;
    const Axes axes = axes_of(direction);
    const float half = std::tan(camera.fov_y / 2), all = 1 - options.margin;
    Extent across{.before = half * options.aspect * (all - 2 * options.free_left),
                  .after = half * options.aspect * all};
    Extent upward{.before = half * (all - 2 * options.free_below), .after = half * all};
    SELVEDGE_ASSERT(across.before + across.after > 0 && upward.before + upward.after > 0);
    float nearest = -std::numeric_limits<float>::infinity();
    float farthest = std::numeric_limits<float>::infinity();
    for (const Vec3f& point : points) {
        const float b = axes.back.dot(point);
        across.add(axes.right.dot(point), b);
        upward.add(axes.up.dot(point), b);
        nearest = std::max(nearest, b);
        farthest = std::min(farthest, b);
    }
    constexpr float min_clearance = 0.05F;  // m: else a flat object seen edge-on would touch the eye
    const float distance = std::max({across.min_distance(), upward.min_distance(), nearest + min_clearance});
    camera.eye = across.centre(distance) * axes.right + upward.centre(distance) * axes.up + distance * axes.back;
    camera.target = camera.eye - (distance - (nearest + farthest) / 2) * axes.back;
    camera.up = axes.up;
    camera.near_plane = std::max(0.2F * (distance - nearest), 0.01F);
    camera.far_plane = (distance - farthest) * 4 + 20;
    return camera;
}

Camera camera_at(const Vec3f& eye, const Vec3f& target, const std::vector<Vec3f>& points) {
    Camera camera{.eye = eye, .target = target};
    const Vec3f back = (camera.eye - camera.target).normalized();
    if (std::abs(back.y()) > 0.999F) camera.up = -Vec3f::UnitZ();
    float nearest = std::numeric_limits<float>::infinity(), farthest = 0;
    for (const Vec3f& point : points) {
        const float depth = (camera.eye - point).dot(back);
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
    }
    camera.near_plane = std::max(0.2F * nearest, 0.01F);
    camera.far_plane = 4 * farthest + 20;
    return camera;
}

float pixel_size(const Camera& camera, int height_px) {
    return 2 * (camera.eye - camera.target).norm() * std::tan(camera.fov_y / 2) / float(height_px);
}

Camera zoomed(Camera camera, float times) {
    SELVEDGE_ASSERT(times > 0);
    camera.fov_y = 2 * std::atan(std::tan(camera.fov_y / 2) / times);
    return camera;
}

Camera turned(Camera camera, float angle, const Vec3f& axis) {
    const float c = std::cos(angle), s = std::sin(angle);
    const auto turn = [&](const Vec3f& v) { return Vec3f(c * v.x() - s * v.z(), v.y(), s * v.x() + c * v.z()); };
    camera.eye = axis + turn(camera.eye - axis);
    camera.target = axis + turn(camera.target - axis);
    camera.up = turn(camera.up);
    return camera;
}

Vec3f upright_through(const std::vector<Vec3f>& points) {
    SELVEDGE_ASSERT(!points.empty());
    const Vec3f middle = sim::box_around(points).center();
    return {middle.x(), 0, middle.z()};
}

std::vector<Vec3f> at_all_turns(const std::vector<Vec3f>& points, const Vec3f& axis, const std::vector<float>& turns) {
    std::vector<Vec3f> swept;
    swept.reserve(points.size() * turns.size());
    for (const float angle : turns) {
        const float c = std::cos(angle), s = std::sin(angle);
        for (const Vec3f& point : points) {
            const Vec3f v = point - axis;
            swept.push_back(axis + Vec3f(c * v.x() + s * v.z(), v.y(), -s * v.x() + c * v.z()));
        }
    }
    return swept;
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

bool is_detail(View view) {
    return view == View::Close || view == View::Hem;
}

std::vector<Vec3f> detail_patch(const std::vector<Vec3f>& garment, View view) {
    SELVEDGE_ASSERT(is_detail(view) && !garment.empty());
    const Eigen::AlignedBox3f box = sim::box_around(garment);
    constexpr float overlap = 0.02F;  // m, beyond the garment's edge
    const float middle = box.center().x(), half = kDetailSize / 2;
    const float bottom = view == View::Close ? box.max().y() + overlap - kDetailSize : box.min().y() - overlap;
    float front = -std::numeric_limits<float>::infinity();
    for (const Vec3f& x : garment) {
        const bool is_inside = std::abs(x.x() - middle) < half && x.y() > bottom && x.y() < bottom + kDetailSize;
        if (is_inside) front = std::max(front, x.z());
    }
    if (!std::isfinite(front)) front = box.max().z();
    std::vector<Vec3f> corners;
    for (const float side : {-half, half}) {
        for (const float up : {0.0F, kDetailSize}) corners.emplace_back(middle + side, bottom + up, front);
    }
    return corners;
}

}  // namespace selvedge::render
