#include "render/room_light.h"

#include <algorithm>
#include <cmath>

#include "sim/core/assert.h"
#include "sim/core/parallel.h"

namespace selvedge {
namespace {

struct DepthPicture {
    Vec3f direction;  // towards the light, unit
    Eigen::Matrix4f matrix;
    float fade = 0;  // in units of depth
    int side_px = 0;
    std::vector<float> depths;

    float at(int x, int y) const {
        x = std::clamp(x, 0, side_px - 1);
        y = std::clamp(y, 0, side_px - 1);
        return depths[static_cast<std::size_t>(y) * static_cast<std::size_t>(side_px) + static_cast<std::size_t>(x)];
    }

    // 1 when the point at this depth sees out past what this texel holds; 1 is the depth of nothing.
    float is_open(int x, int y, float depth) const {
        const float blocker = at(x, y);
        return blocker >= 1 ? 1 : std::clamp(1 - (depth - blocker) / fade, 0.0F, 1.0F);
    }

    // Bilinear, so that it changes smoothly from vertex to vertex.
    float openness(const Vec3f& point) const {
        const Eigen::Vector4f clip = matrix * point.homogeneous();
        const float x = (clip.x() * 0.5F + 0.5F) * static_cast<float>(side_px) - 0.5F;
        const float y = (clip.y() * 0.5F + 0.5F) * static_cast<float>(side_px) - 0.5F;
        const float depth = clip.z() * 0.5F + 0.5F;
        const int left = static_cast<int>(std::floor(x)), low = static_cast<int>(std::floor(y));
        if (left < -1 || low < -1 || left >= side_px || low >= side_px) return 1;
        const float s = x - static_cast<float>(left), t = y - static_cast<float>(low);
        return (1 - t) * ((1 - s) * is_open(left, low, depth) + s * is_open(left + 1, low, depth)) +
               t * ((1 - s) * is_open(left, low + 1, depth) + s * is_open(left + 1, low + 1, depth));
    }
};

// Evenly over the whole sphere (Fibonacci's spiral).
Vec3f sphere_direction(int i, int count) {
    const double y = 1 - 2 * (i + 0.5) / count;
    const double radius = std::sqrt(1 - y * y);
    const double angle = i * 2.399963229728653;
    return Vec3d(radius * std::cos(angle), y, radius * std::sin(angle)).cast<float>();
}

struct Sums {
    float front = 0, front_weight = 0;
    float back = 0, back_weight = 0;
};

void add_direction(Sums& sums, const DepthPicture& picture, const Vec3f& point, const Vec3f& normal, float reach) {
    const float cosine = normal.dot(picture.direction);
    if (cosine > 0) {
        sums.front += cosine * picture.openness(point + reach * normal);
        sums.front_weight += cosine;
    } else {
        sums.back -= cosine * picture.openness(point - reach * normal);
        sums.back_weight -= cosine;
    }
}

}  // namespace

std::vector<Openness> bake_room_light(const GladGLContext& gl, const Casters& casters, const std::vector<Vec3f>& points,
                                      const std::vector<Vec3f>& normals, const RoomLightOptions& options) {
    SELVEDGE_ASSERT(points.size() == normals.size());
    const Bounds bounds = bounds_of(casters.x);
    const DepthPass pass(gl, casters, options.side_px);
    std::vector<Sums> sums(points.size());
    for (int i = 0; i < options.directions; ++i) {
        DepthPicture picture;
        picture.direction = sphere_direction(i, options.directions);
        picture.matrix = parallel_matrix(bounds, picture.direction);
        picture.fade = options.fade / (2 * bounds.radius);
        picture.side_px = options.side_px;
        pass.draw(picture.matrix);
        picture.depths = pass.read();
        parallel_for(points.size(), 4096, [&](std::size_t first, std::size_t last) {
            for (std::size_t p = first; p < last; ++p) {
                add_direction(sums[p], picture, points[p], normals[p], options.reach);
            }
        });
    }
    std::vector<Openness> result(points.size());
    for (std::size_t p = 0; p < points.size(); ++p) {
        if (sums[p].front_weight > 0) result[p].front = sums[p].front / sums[p].front_weight;
        if (sums[p].back_weight > 0) result[p].back = sums[p].back / sums[p].back_weight;
    }
    return result;
}

}  // namespace selvedge
