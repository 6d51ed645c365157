#include "render/draw/ambient_occlusion.h"

#include <algorithm>
#include <cmath>

#include "sim/core/assert.h"
#include "sim/core/parallel.h"

namespace selvedge::render {
namespace {

// Ambient visibility along one axis: in its direction (is_along) or against it.
struct AxisVisibility {
    const DepthRange& picture;
    float fade = 0;  // in the image's units of depth

    // 1 if no surface of this texel blocks a point at this depth; falls to 0 over `fade`.
    float is_open(int x, int y, float depth, bool is_along) const {
        x = std::clamp(x, 0, picture.side_px - 1);
        y = std::clamp(y, 0, picture.side_px - 1);
        const DepthRange::Span& span = picture.at(x, y);
        const float behind = is_along ? depth - span.nearest : span.farthest - depth;
        return std::clamp(1 - behind / fade, 0.0F, 1.0F);
    }

    // Bilinear, so that it changes smoothly from vertex to vertex.
    float ambient_visibility(const Vec3f& point, bool is_along) const {
        const Eigen::Matrix4f& m = picture.matrix;
        const Vec3f at = m.block<3, 3>(0, 0) * point + m.block<3, 1>(0, 3);
        const float x = std::floor(at.x()), y = std::floor(at.y());
        const float side = static_cast<float>(picture.side_px);
        if (!(x >= -1 && y >= -1 && x < side && y < side)) return 1;
        const int left = static_cast<int>(x), low = static_cast<int>(y);
        const float s = at.x() - x, t = at.y() - y;
        return (1 - t) *
                   ((1 - s) * is_open(left, low, at.z(), is_along) + s * is_open(left + 1, low, at.z(), is_along)) +
               t * ((1 - s) * is_open(left, low + 1, at.z(), is_along) +
                    s * is_open(left + 1, low + 1, at.z(), is_along));
    }
};

// Spread evenly over a half sphere (Fibonacci spiral); with the opposite directions, over the whole sphere.
Vec3f axis_direction(int i, int count) {
    const double y = 1 - (i + 0.5) / count;
    const double radius = std::sqrt(1 - y * y);
    const double angle = i * 2.399963229728653;
    return Vec3d(radius * std::cos(angle), y, radius * std::sin(angle)).cast<float>();
}

struct Sums {
    float front = 0;
    float back = 0;
    float weight = 0;
};

}  // namespace

void LitPoints::add(const std::vector<Vec3f>& more_x, const std::vector<Vec3f>& more_normals) {
    x.insert(x.end(), more_x.begin(), more_x.end());
    normals.insert(normals.end(), more_normals.begin(), more_normals.end());
}

void AmbientOcclusion::draw_bodies(const Casters& bodies, const Bounds& bounds,
                                   const AmbientOcclusionOptions& options) {
    const auto axes = static_cast<std::size_t>(options.axes);
    const bool is_kept = body_pictures_.size() == axes && body_pictures_[0].side_px == options.side_px &&
                         bounds == bounds_ && bodies == bodies_;
    if (is_kept) return;
    body_pictures_.resize(axes);
    sim::parallel_for(axes, 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Vec3f axis = axis_direction(static_cast<int>(i), options.axes);
            body_pictures_[i] = empty_depth_range(bounds, axis, options.side_px);
            draw_casters(body_pictures_[i], bodies);
        }
    });
    bodies_ = bodies;
    bounds_ = bounds;
}

std::vector<AmbientVisibility> AmbientOcclusion::bake(const Casters& cloths, const Casters& bodies,
                                                      const LitPoints& points, const AmbientOcclusionOptions& options) {
    SELVEDGE_ASSERT(points.x.size() == points.normals.size() && options.axes >= 1);
    std::vector<Vec3f> all = cloths.x;
    all.insert(all.end(), bodies.x.begin(), bodies.x.end());
    const Bounds bounds = steady_bounds_of(all);
    draw_bodies(bodies, bounds, options);
    pictures_.resize(body_pictures_.size());
    sim::parallel_for(pictures_.size(), 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            pictures_[i] = body_pictures_[i];
            draw_casters(pictures_[i], cloths);
        }
    });
    const float width = 2 * bounds.radius, texel = width / static_cast<float>(options.side_px);
    const float reach = std::max(options.reach, texel), fade = std::max(options.fade, 2 * texel) / width;
    std::vector<AmbientVisibility> result(points.x.size());
    sim::parallel_for(points.x.size(), 8192, [&](std::size_t first, std::size_t last) {
        std::vector<Sums> sums(last - first);
        for (int i = 0; i < options.axes; ++i) {
            const Vec3f axis = axis_direction(i, options.axes);
            const AxisVisibility look{.picture = pictures_[static_cast<std::size_t>(i)], .fade = fade};
            for (std::size_t p = first; p < last; ++p) {
                const float cosine = points.normals[p].dot(axis);
                const Vec3f off = reach * points.normals[p];
                const float weight = std::abs(cosine);
                Sums& sum = sums[p - first];
                sum.weight += weight;
                sum.front += weight * look.ambient_visibility(points.x[p] + off, cosine > 0);
                if (p < points.two_sided) sum.back += weight * look.ambient_visibility(points.x[p] - off, cosine <= 0);
            }
        }
        for (std::size_t p = first; p < last; ++p) {
            const Sums& sum = sums[p - first];
            if (!(sum.weight > 0)) continue;
            result[p].front = sum.front / sum.weight;
            if (p < points.two_sided) result[p].back = sum.back / sum.weight;
        }
    });
    return result;
}

namespace {

constexpr std::uint32_t kCells = 96;  // per side: resolution of the baked values
constexpr std::uint32_t kDrawn = 2;   // per side: cells drawn as one; fine enough after smoothing

// One pass of the kernel [1 2 1]/4 along the ground's rows (step 1) or columns.
void soften(std::vector<AmbientVisibility>& ambient_visibility, std::size_t step) {
    constexpr std::size_t side = kCells + 1;
    const std::vector<AmbientVisibility> before = ambient_visibility;
    for (std::size_t i = 0; i < ambient_visibility.size(); ++i) {
        const std::size_t place = step == 1 ? i % side : i / side;
        if (place == 0 || place + 1 == side) continue;
        ambient_visibility[i].front = 0.25F * (before[i - step].front + 2 * before[i].front + before[i + step].front);
    }
}

BodyItem make_sheet(const Vec3f& centre, float radius) {
    BodyItem sheet;
    for (std::uint32_t j = 0; j <= kCells; ++j) {
        for (std::uint32_t i = 0; i <= kCells; ++i) {
            const Vec2f at = Vec2f(float(i), float(j)) * (2 * radius / float(kCells)) - Vec2f(radius, radius);
            sheet.x.emplace_back(centre.x() + at.x(), centre.y(), centre.z() - at.y());
        }
    }
    sheet.normals.assign(sheet.x.size(), Vec3f::UnitY());
    for (std::uint32_t j = 0; j < kCells; j += kDrawn) {
        for (std::uint32_t i = 0; i < kCells; i += kDrawn) {
            const std::uint32_t a = j * (kCells + 1) + i, b = a + kDrawn, c = a + kDrawn * (kCells + 1), d = c + kDrawn;
            sheet.triangles.push_back({a, b, d});
            sheet.triangles.push_back({a, d, c});
        }
    }
    return sheet;
}

}  // namespace

Ground make_ground(const Scene& scene, const Bounds& bounds) {
    Ground ground{
        .centre = {bounds.centre.x(), scene.ground_y, bounds.centre.z()}, .radius = 1.8F * bounds.radius, .sheet = {}};
    if (scene.has_ground) ground.sheet = make_sheet(ground.centre, ground.radius);
    return ground;
}

std::vector<AmbientVisibility> softened_ground(std::vector<AmbientVisibility> ambient_visibility) {
    SELVEDGE_ASSERT(ambient_visibility.size() == std::size_t{kCells + 1} * (kCells + 1));
    constexpr int iterations = 6;  // standard deviation: sqrt(iterations / 2) cells
    for (int i = 0; i < iterations; ++i) {
        soften(ambient_visibility, 1);
        soften(ambient_visibility, kCells + 1);
    }
    return ambient_visibility;
}

}  // namespace selvedge::render
