#include "bench/thesis/limb_cylinders.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "bench/support/cloth_run.h"
#include "sim/collide/surface_bvh.h"
#include "sim/core/assert.h"
#include "sim/pattern/segment_distance.h"

namespace selvedge::bench {
namespace {

constexpr double kCircleTolerance = 1e-12;  // relative, of a point on a circle

bool encloses(const Circle& circle, const Vec2d& p) {
    return (p - circle.centre).squaredNorm() <= circle.radius * circle.radius * (1 + kCircleTolerance) + 1e-24;
}

Circle circle_of(const Vec2d& a, const Vec2d& b) {
    return {.centre = (a + b) / 2, .radius = (a - b).norm() / 2};
}

// Through three points; through the two that are farthest apart if they lie on a line.
Circle circle_of(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
    const Vec2d ab = b - a, ac = c - a;
    const double area = 2 * (ab.x() * ac.y() - ab.y() * ac.x());
    if (std::abs(area) < 1e-18) {
        Circle widest = circle_of(a, b);
        for (const Circle& other : {circle_of(a, c), circle_of(b, c)}) {
            if (other.radius > widest.radius) widest = other;
        }
        return widest;
    }
    const Vec2d to_centre = Vec2d(ac.y() * ab.squaredNorm() - ab.y() * ac.squaredNorm(),
                                  ab.x() * ac.squaredNorm() - ac.x() * ab.squaredNorm()) /
                            area;
    return {.centre = a + to_centre, .radius = to_centre.norm()};
}

using Polygon = std::vector<Vec3d>;

// The part of a convex polygon that lies where side * (z - at) >= 0.
Polygon clipped(const Polygon& polygon, double at, double side) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double above_a = side * (a.z() - at), above_b = side * (b.z() - at);
        if (above_a >= 0) kept.push_back(a);
        if ((above_a < 0) != (above_b < 0)) kept.push_back(a + (b - a) * (above_a / (above_a - above_b)));
    }
    return kept;
}

// The directions in which a convex polygon is seen from a point: `width` rad from `start` on.
struct Directions {
    double start = 0, width = 2 * std::numbers::pi;
};

// With all points that are at most `margin` away from it.
Directions directions_of(const Polygon& polygon, const Vec2d& from, double margin) {
    double nearest = std::numeric_limits<double>::infinity(), low = 0, high = 0;
    double turns = 0;  // about `from`, along the outline
    const auto at = [&](std::size_t i) { return Vec2d(polygon[i % polygon.size()].head<2>() - from); };
    const auto angle_between = [](const Vec2d& a, const Vec2d& b) {
        return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        nearest = std::min(nearest, sim::distance_to_segment(Vec2d::Zero(), at(i), at(i + 1)));
        turns += angle_between(at(i), at(i + 1));
        const double angle = angle_between(at(0), at(i));
        low = std::min(low, angle);
        high = std::max(high, angle);
    }
    constexpr double kRounding = 1e-9;
    const bool is_round = std::abs(turns) > std::numbers::pi;
    if (is_round || nearest <= margin + kRounding) return {};
    const double wider = std::asin(margin / nearest) + kRounding;
    return {.start = std::atan2(at(0).y(), at(0).x()) + low - wider, .width = high - low + 2 * wider};
}

int slice_at(double angle, int slices) {
    const double turn = angle / (2 * std::numbers::pi);
    return std::min(slices - 1, static_cast<int>((turn - std::floor(turn)) * slices));
}

// Axes from the bone's direction and a vertex beside it, one per row.  (thesis fig. 5.1)
Eigen::Matrix3d axes_of(const Vec3d& start, const Vec3d& tip, const Vec3d& vertex) {
    const Vec3d z = (tip - start).normalized();
    const Vec3d beside = vertex - start;
    const Vec3d x = (beside - z * z.dot(beside)).normalized();
    Eigen::Matrix3d axes;
    axes << x.transpose(), z.cross(x).transpose(), z.transpose();
    return axes;
}

// The end of a bone in the rest pose: the joint of its only child, or else the middle of its rigid vertices.
Vec3d rest_tip(const sim::Body& body, int bone, const std::vector<std::uint32_t>& vertices) {
    const Vec3d start = body.bones[static_cast<std::size_t>(bone)].joint;
    constexpr double kShortest = 0.005;  // m
    int children = 0;
    Vec3d tip = start;
    for (const sim::Bone& child : body.bones) {
        if (child.parent != bone) continue;
        ++children;
        tip = child.joint;
    }
    if (children == 1 && (tip - start).norm() > kShortest) return tip;
    tip.setZero();
    for (const std::uint32_t v : vertices) tip += body.x[v] / static_cast<double>(vertices.size());
    return (tip - start).norm() > kShortest ? tip : Vec3d(start + Vec3d::UnitY());
}

// Makes one bone's cylinder in the rest pose.
class CylinderMaker {
 public:
    CylinderMaker(const sim::Body& body, int bone, const std::vector<std::uint32_t>& triangles,
                  const LimbOptions& options)
        : body_(body), triangles_(triangles), options_(options) {
        made_.bone = bone;
    }

    LimbBounds::Cylinder make(const Eigen::Affine3d& frame) {
        find_frame(frame);
        for (const std::uint32_t t : triangles_) {
            Polygon& polygon = local_.emplace_back();
            for (const int v : body_.triangles[t])
                polygon.emplace_back(axes_ * (body_.x[static_cast<std::size_t>(v)] - start_));
        }
        find_cylinder();
        const double length = static_cast<double>(made_.high - made_.low);
        const int stacks = std::max(1, static_cast<int>(std::ceil(length / options_.stack_length)));
        made_.slice_start.push_back(0);
        for (int i = 0; i < stacks; ++i) add_stack(i);
        return std::move(made_);
    }

 private:
    void find_frame(const Eigen::Affine3d& frame) {
        std::vector<std::uint32_t> vertices;
        for (const std::uint32_t t : triangles_)
            for (const int v : body_.triangles[t]) vertices.push_back(static_cast<std::uint32_t>(v));
        std::ranges::sort(vertices);
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
        start_ = frame.translation();
        const Vec3d tip = rest_tip(body_, made_.bone, vertices);
        const Vec3d along = (tip - start_).normalized();
        // Of those that follow the bone best, the one farthest from its axis: any serves, but this turns least.
        const auto rank = [&](std::uint32_t v) {
            return std::pair(std::round(100 * weight_of(v)), along.cross(body_.x[v] - start_).norm());
        };
        made_.vertex = *std::ranges::max_element(vertices, {}, rank);
        made_.tip = frame.inverse() * tip;
        axes_ = axes_of(start_, tip, body_.x[made_.vertex]);
    }

    float weight_of(std::uint32_t v) const {
        const sim::SkinWeights& skin = body_.skin[v];
        float weight = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            if (skin.bones[k] == made_.bone) weight += skin.weights[k];
        }
        return weight;
    }

    void find_cylinder() {
        std::vector<Vec2d> points;
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const Polygon& polygon : local_) {
            for (const Vec3d& p : polygon) {
                points.emplace_back(p.head<2>());
                low = std::min(low, p.z());
                high = std::max(high, p.z());
            }
        }
        const Circle circle = smallest_circle(std::move(points));
        made_.centre = circle.centre.cast<float>();
        made_.radius = static_cast<float>(circle.radius);
        made_.low = static_cast<float>(low);
        made_.high = static_cast<float>(high);
    }

    void add_stack(int index) {
        const double low = static_cast<double>(made_.low) + index * options_.stack_length - reach_;
        const double high = low + options_.stack_length + 2 * reach_;
        std::vector<Polygon> parts;
        std::vector<std::uint32_t> of;
        std::vector<Vec2d> points;
        for (std::size_t i = 0; i < local_.size(); ++i) {
            Polygon part = clipped(clipped(local_[i], low, 1), high, -1);
            if (part.empty()) continue;
            for (const Vec3d& p : part) points.emplace_back(p.head<2>());
            parts.push_back(std::move(part));
            of.push_back(triangles_[i]);
        }
        const Circle circle = points.empty() ? Circle{} : smallest_circle(std::move(points));
        made_.stacks.push_back(
            {.centre = circle.centre.cast<float>(),
             .radius = parts.empty() ? -std::numeric_limits<float>::infinity() : static_cast<float>(circle.radius)});
        list_slices(parts, of, circle.centre);
    }

    void list_slices(const std::vector<Polygon>& parts, const std::vector<std::uint32_t>& of, const Vec2d& centre) {
        std::vector<std::vector<std::uint32_t>> slices(static_cast<std::size_t>(options_.slices));
        const double width = 2 * std::numbers::pi / options_.slices;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const Directions seen = directions_of(parts[i], centre, reach_);
            const int first = slice_at(seen.start, options_.slices);
            const double turn = seen.start / (2 * std::numbers::pi);
            const double before = (turn - std::floor(turn)) * 2 * std::numbers::pi - first * width;
            const int count = std::min(options_.slices, 1 + static_cast<int>((before + seen.width) / width));
            for (int j = 0; j < count; ++j)
                slices[static_cast<std::size_t>((first + j) % options_.slices)].push_back(of[i]);
        }
        for (const std::vector<std::uint32_t>& slice : slices) {
            made_.listed.insert(made_.listed.end(), slice.begin(), slice.end());
            made_.slice_start.push_back(static_cast<std::uint32_t>(made_.listed.size()));
        }
    }

    const sim::Body& body_;
    const std::vector<std::uint32_t>& triangles_;
    const LimbOptions& options_;
    double reach_ = options_.margin + options_.slack;  // m
    LimbBounds::Cylinder made_;
    Vec3d start_ = Vec3d::Zero();
    Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
    std::vector<Polygon> local_;  // by triangle
};

int dominant_bone(const sim::Body& body, const std::array<int, 3>& corners) {
    std::vector<float> sums(body.bones.size(), 0);
    for (const int v : corners) {
        const sim::SkinWeights& skin = body.skin[static_cast<std::size_t>(v)];
        for (std::size_t k = 0; k < 4; ++k) sums[skin.bones[k]] += skin.weights[k];
    }
    return static_cast<int>(std::ranges::max_element(sums) - sums.begin());
}

Vec3d middle_of(const sim::Body& body, std::uint32_t triangle) {
    Vec3d middle = Vec3d::Zero();
    for (const int v : body.triangles[triangle]) middle += body.x[static_cast<std::size_t>(v)] / 3;
    return middle;
}

// Cuts the triangles in the middle of the longest side of their box until each part has at most `most`.
void split_into_parts(const sim::Body& body, std::span<std::uint32_t> triangles, std::size_t most,
                      std::vector<std::span<std::uint32_t>>& parts) {
    Eigen::AlignedBox3d box;
    for (const std::uint32_t t : triangles) box.extend(middle_of(body, t));
    Eigen::Index axis = 0;
    const double longest = box.sizes().maxCoeff(&axis);
    if (triangles.size() <= most || longest <= 0) {
        parts.push_back(triangles);
        return;
    }
    const double cut = box.center()[axis];
    const auto upper = std::stable_partition(triangles.begin(), triangles.end(),
                                             [&](std::uint32_t t) { return middle_of(body, t)[axis] < cut; });
    const auto count = static_cast<std::size_t>(upper - triangles.begin());
    if (count == 0 || count == triangles.size()) {  // by rounding
        parts.push_back(triangles);
        return;
    }
    split_into_parts(body, triangles.first(count), most, parts);
    split_into_parts(body, triangles.subspan(count), most, parts);
}

}  // namespace

Circle smallest_circle(std::vector<Vec2d> points) {
    SELVEDGE_ASSERT(!points.empty());
    std::mt19937 random(1);  // NOLINT: the same order each time
    for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random() % i]);
    Circle circle{.centre = points[0]};
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (encloses(circle, points[i])) continue;
        circle = {.centre = points[i]};
        for (std::size_t j = 0; j < i; ++j) {
            if (encloses(circle, points[j])) continue;
            circle = circle_of(points[i], points[j]);
            for (std::size_t k = 0; k < j; ++k) {
                if (!encloses(circle, points[k])) circle = circle_of(points[i], points[j], points[k]);
            }
        }
    }
    return circle;
}

std::vector<int> map_bones(const sim::Body& body, float rigid_weight) {
    const auto bone_of = [&](int v) {
        const sim::SkinWeights& skin = body.skin[static_cast<std::size_t>(v)];
        for (std::size_t k = 0; k < 4; ++k) {
            if (skin.weights[k] >= rigid_weight) return static_cast<int>(skin.bones[k]);
        }
        return kDeformable;
    };
    std::vector<int> map;
    for (const auto& [a, b, c] : body.triangles) {
        const int bone = bone_of(a);
        map.push_back(bone == bone_of(b) && bone == bone_of(c) ? bone : kDeformable);
    }
    return map;
}

LimbBounds::LimbBounds(const sim::Body& body, const LimbOptions& options)
    : options_(options), bone_map_(map_bones(body, options.rigid_weight)), planes_(body.triangles.size()) {
    SELVEDGE_ASSERT(!body.skin.empty() && options.slices > 0 && options.stack_length > 0 && options.margin >= 0 &&
                    options.slack >= 0);
    for (const auto& [a, b, c] : body.triangles)
        triangles_.push_back(
            {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
    std::vector<Vec3f> x;
    for (const Vec3d& p : body.x) x.emplace_back(p.cast<float>());
    make_cylinders(body);
    make_spheres(body);
    move_to(body, rest_pose(body), x);
}

void LimbBounds::make_cylinders(const sim::Body& body) {
    const std::vector<Eigen::Affine3d> frames = bone_frames(body, rest_pose(body));
    std::vector<std::vector<std::uint32_t>> rigid(body.bones.size());
    for (std::size_t t = 0; t < bone_map_.size(); ++t) {
        if (bone_map_[t] != kDeformable) rigid[static_cast<std::size_t>(bone_map_[t])].push_back(std::uint32_t(t));
    }
    for (std::size_t bone = 0; bone < rigid.size(); ++bone) {
        if (rigid[bone].empty()) continue;
        cylinders_.push_back(CylinderMaker(body, static_cast<int>(bone), rigid[bone], options_).make(frames[bone]));
    }
}

void LimbBounds::make_spheres(const sim::Body& body) {
    std::vector<std::vector<std::uint32_t>> of_bone(body.bones.size());
    for (std::size_t t = 0; t < bone_map_.size(); ++t) {
        if (bone_map_[t] != kDeformable) continue;
        of_bone[static_cast<std::size_t>(dominant_bone(body, body.triangles[t]))].push_back(std::uint32_t(t));
    }
    for (std::vector<std::uint32_t>& region : of_bone) {
        if (region.empty()) continue;
        std::vector<std::span<std::uint32_t>> parts;
        split_into_parts(body, region, static_cast<std::size_t>(options_.triangles_per_sphere), parts);
        const auto first = static_cast<std::uint32_t>(spheres_.size());
        for (const std::span<std::uint32_t> part : parts) {
            const auto start = static_cast<std::uint32_t>(deformable_.size());
            deformable_.insert(deformable_.end(), part.begin(), part.end());
            spheres_.push_back({.first = start, .end = static_cast<std::uint32_t>(deformable_.size())});
        }
        regions_.push_back({.first = first, .end = static_cast<std::uint32_t>(spheres_.size())});
    }
}

void LimbBounds::move_to(const sim::Body& body, const sim::Pose& pose, std::span<const Vec3f> x, LimbTimes* times) {
    x_.assign(x.begin(), x.end());
    const double start = thread_seconds();
    move_cylinders(body, pose);
    fit_spheres();
    const double fitted = thread_seconds();
    find_planes();
    if (times == nullptr) return;
    times->structures += fitted - start;
    times->planes += thread_seconds() - fitted;
}

void LimbBounds::move_cylinders(const sim::Body& body, const sim::Pose& pose) {
    const std::vector<Eigen::Affine3d> frames = bone_frames(body, pose);
    for (Cylinder& cylinder : cylinders_) {
        const Eigen::Affine3d& frame = frames[static_cast<std::size_t>(cylinder.bone)];
        const Vec3d start = frame.translation();
        cylinder.axes = axes_of(start, frame * cylinder.tip, x_[cylinder.vertex].cast<double>()).cast<float>();
        cylinder.origin = start.cast<float>();
    }
}

void LimbBounds::fit_spheres() {
    for (Sphere& sphere : spheres_) {
        Eigen::AlignedBox3f box;
        for (std::uint32_t i = sphere.first; i < sphere.end; ++i)
            for (const std::uint32_t v : triangles_[deformable_[i]]) box.extend(x_[v]);
        sphere.centre = box.center();
        float squared = 0;
        for (std::uint32_t i = sphere.first; i < sphere.end; ++i)
            for (const std::uint32_t v : triangles_[deformable_[i]])
                squared = std::max(squared, (x_[v] - sphere.centre).squaredNorm());
        sphere.radius = std::sqrt(squared);
    }
    for (Sphere& region : regions_) {
        const std::span<const Sphere> parts = spheres().subspan(region.first, region.end - region.first);
        Eigen::AlignedBox3f box;
        for (const Sphere& part : parts) box.extend(part.centre);
        region.centre = box.center();
        region.radius = 0;
        for (const Sphere& part : parts)
            region.radius = std::max(region.radius, (part.centre - region.centre).norm() + part.radius);
    }
}

void LimbBounds::find_planes() {
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
        const auto [a, b, c] = triangles_[t];
        const Vec3f normal = (x_[b] - x_[a]).cross(x_[c] - x_[a]).normalized();
        planes_[t] = {normal.x(), normal.y(), normal.z(), normal.dot(x_[a])};
    }
}

void LimbBounds::collect_from_cylinders(const Vec3f& p, std::vector<std::uint32_t>& triangles) const {
    const auto margin = static_cast<float>(options_.margin + options_.slack);
    for (const Cylinder& cylinder : cylinders_) {
        const Vec3f local = cylinder.axes * (p - cylinder.origin);
        if (local.z() < cylinder.low - margin || local.z() > cylinder.high + margin) continue;
        const float reach = cylinder.radius + margin;
        if ((local.head<2>() - cylinder.centre).squaredNorm() > reach * reach) continue;
        const float along = (local.z() - cylinder.low) / static_cast<float>(options_.stack_length);
        const auto index = std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(along), 0,
                                                      static_cast<std::ptrdiff_t>(cylinder.stacks.size()) - 1);
        const Stack& stack = cylinder.stacks[static_cast<std::size_t>(index)];
        const Vec2f beside = local.head<2>() - stack.centre;
        const float stack_reach = stack.radius + margin;
        if (stack_reach < 0 || beside.squaredNorm() > stack_reach * stack_reach) continue;
        const int slice = slice_at(static_cast<double>(std::atan2(beside.y(), beside.x())), options_.slices);
        const auto at = static_cast<std::size_t>(index * options_.slices + slice);
        triangles.insert(triangles.end(), cylinder.listed.begin() + cylinder.slice_start[at],
                         cylinder.listed.begin() + cylinder.slice_start[at + 1]);
    }
}

void LimbBounds::collect_from_spheres(const Vec3f& p, std::vector<std::uint32_t>& triangles) const {
    const auto margin = static_cast<float>(options_.margin);
    const auto is_in = [&](const Sphere& sphere) {
        const float reach = sphere.radius + margin;
        return (p - sphere.centre).squaredNorm() <= reach * reach;
    };
    for (const Sphere& region : regions_) {
        if (!is_in(region)) continue;
        for (std::uint32_t i = region.first; i < region.end; ++i) {
            if (!is_in(spheres_[i])) continue;
            triangles.insert(triangles.end(), deformable_.begin() + spheres_[i].first,
                             deformable_.begin() + spheres_[i].end);
        }
    }
}

std::optional<LimbContact> LimbBounds::nearest(const Vec3f& p, std::span<const std::uint32_t> triangles) const {
    constexpr float kSame = 1e-6F;                                     // m, rounding
    float least = std::numeric_limits<float>::infinity(), beyond = 0;  // m, of p from the surface; from that plane
    LimbContact nearest;
    for (const std::uint32_t t : triangles) {
        const float above = planes_[t].head<3>().dot(p) - planes_[t].w();
        if (std::abs(above) >= least + kSame) continue;
        const auto [a, b, c] = triangles_[t];
        const Vec3f point = sim::closest_on_triangle(p, x_[a], x_[b], x_[c]).point;
        const float distance = (p - point).norm();
        if (distance >= least + kSame || (distance > least - kSame && std::abs(above) <= beyond)) continue;
        least = std::min(least, distance);
        beyond = std::abs(above);
        nearest = {.point = point, .distance = above < 0 ? -least : least, .triangle = t};
    }
    return std::isinf(nearest.distance) ? std::nullopt : std::optional(nearest);
}

std::optional<float> LimbBounds::crossing(std::uint32_t triangle, const std::array<Vec3f, 2>& segment) const {
    const auto [a, b, c] = triangles_[triangle];
    return sim::crossing_fraction(segment, x_[a], x_[b], x_[c]);
}

std::optional<LimbContact> LimbBounds::contact(const Vec3f& p) const {
    std::vector<std::uint32_t> triangles;
    return contact(p, triangles);
}

std::optional<LimbContact> LimbBounds::contact(const Vec3f& p, std::vector<std::uint32_t>& triangles) const {
    triangles.clear();
    collect_from_cylinders(p, triangles);
    collect_from_spheres(p, triangles);
    return nearest(p, triangles);
}

}  // namespace selvedge::bench
