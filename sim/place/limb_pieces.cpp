#include "sim/place/limb_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "sim/body/section.h"
#include "sim/collide/surface_bvh.h"
#include "sim/mesh/sew.h"

namespace selvedge::sim {
namespace {

// Joints of an arm.
constexpr std::size_t kShoulder = 0, kElbow = 1, kWrist = 2;
constexpr std::size_t kChest = 2;  // of the torso

struct Cut {
    Plane plane;        // its normal points along the arm
    double radius = 0;  // m, of the section
};

// The plane across the upper arm that is nearest to the shoulder and cuts the arm as an arm: nearer ones cut the chest.
std::optional<Cut> find_cut(const Body& body, const Limb& arm) {
    constexpr double kFirst = 0.15, kStep = 0.05, kLast = 0.6;  // of the upper arm
    constexpr double kWider = 1.6;                              // area of a section that still is one of the arm
    const Vec3d shoulder = arm.joints[kShoulder].centre;
    const Vec3d upper_arm = arm.joints[kElbow].centre - shoulder;
    std::optional<Cut> cut;
    double area = 0;
    for (double share = kLast; share > kFirst; share -= kStep) {
        const Plane plane{.point = shoulder + share * upper_arm, .normal = upper_arm.normalized()};
        const auto loop = nearest_loop(section(body, plane), plane.point);
        if (!loop) break;
        if (!cut) area = loop->area;
        const double radius = std::sqrt(loop->area / std::numbers::pi);
        if (loop->area > kWider * area || (loop->centre - plane.point).norm() > radius) break;
        cut = Cut{{.point = loop->centre, .normal = plane.normal}, radius};
    }
    return cut;
}

double distance_to_line(const std::vector<LimbJoint>& joints, const Vec3d& x) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        const Vec3d along = joints[i + 1].centre - joints[i].centre;
        const double share = std::clamp(along.dot(x - joints[i].centre) / along.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (joints[i].centre + share * along - x).norm());
    }
    return least;
}

// Marks the vertices that are connected with the wrist on the far side of the cut. Returns whether all are near the
// arm.
bool mark_arm(const Body& body, const Limb& arm, const Cut& cut, double stature, std::vector<bool>& is_of_arm) {
    constexpr double kReach = 0.1;  // of the stature, from the centre line: a spread hand
    const auto is_beyond = [&](const Vec3d& x) { return (x - cut.plane.point).dot(cut.plane.normal) > 0; };
    DisjointSets parts(body.x.size());
    for (const auto& t : body.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = t[k], b = t[(k + 1) % 3];
            if (is_beyond(body.x[static_cast<std::size_t>(a)]) && is_beyond(body.x[static_cast<std::size_t>(b)]))
                parts.join(a, b);
        }
    }
    std::optional<std::size_t> nearest;
    const Vec3d& wrist = arm.joints[kWrist].centre;
    for (std::size_t v = 0; v < body.x.size(); ++v) {
        if (is_beyond(body.x[v]) && (!nearest || (body.x[v] - wrist).norm() < (body.x[*nearest] - wrist).norm()))
            nearest = v;
    }
    if (!nearest) return false;
    const int part = parts.find(static_cast<int>(*nearest));
    for (std::size_t v = 0; v < body.x.size(); ++v) {
        if (!is_beyond(body.x[v]) || parts.find(static_cast<int>(v)) != part) continue;
        if (distance_to_line(arm.joints, body.x[v]) > kReach * stature) return false;
        is_of_arm[v] = true;
    }
    return true;
}

// The triangles for which `is_part` holds, closed by a fan about the middle of their border.
template <class IsPart>
Body closed_part(const Body& body, const IsPart& is_part) {
    Body part;
    std::vector<int> index(body.x.size(), -1);
    std::map<std::pair<int, int>, int> border;  // directed edges without an opposite one
    for (const auto& t : body.triangles) {
        if (!is_part(t)) continue;
        std::array<int, 3> triangle{};
        for (std::size_t k = 0; k < 3; ++k) {
            int& to = index[static_cast<std::size_t>(t[k])];
            if (to < 0) {
                to = static_cast<int>(part.x.size());
                part.x.push_back(body.x[static_cast<std::size_t>(t[k])]);
            }
            triangle[k] = to;
        }
        part.triangles.push_back(triangle);
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = triangle[k], b = triangle[(k + 1) % 3];
            if (border.erase({b, a}) == 0) border[{a, b}] = 1;
        }
    }
    if (border.empty()) return part;
    Vec3d middle = Vec3d::Zero();
    for (const auto& entry : border) middle += part.x[static_cast<std::size_t>(entry.first.first)];
    part.x.emplace_back(middle / static_cast<double>(border.size()));
    const int top = static_cast<int>(part.x.size()) - 1;
    for (const auto& entry : border) part.triangles.push_back({entry.first.second, entry.first.first, top});
    return part;
}

}  // namespace

std::optional<BodyWithoutArms> cut_off_arms(const Body& body, const BodyLimbs& limbs) {
    BodyWithoutArms cut_body;
    std::array<std::vector<bool>, kArms.size()> is_of;
    for (std::size_t i = 0; i < kArms.size(); ++i) {
        const Limb& arm = limbs[kArms[i]];
        if (!arm.is_found) return std::nullopt;
        const auto cut = find_cut(body, arm);
        is_of[i].assign(body.x.size(), false);
        if (!cut || !mark_arm(body, arm, *cut, limbs.height.high - limbs.height.low, is_of[i])) return std::nullopt;
        cut_body.arms[i].joint = cut->plane.point;
    }
    const auto is_of_arm = [&](const std::array<int, 3>& t, std::size_t i) {
        return std::ranges::all_of(t, [&](int v) { return is_of[i][static_cast<std::size_t>(v)]; });
    };
    for (std::size_t i = 0; i < kArms.size(); ++i)
        cut_body.arms[i].surface = closed_part(body, [&](const auto& t) { return is_of_arm(t, i); });
    cut_body.trunk = closed_part(body, [&](const auto& t) { return !is_of_arm(t, 0) && !is_of_arm(t, 1); });
    return cut_body;
}

namespace {

// Lines along an arm from the middle of the upper arm to the fingertips: its centre line and four at its radius.
std::vector<std::vector<Vec3d>> lines_along(const Limb& arm) {
    std::vector<std::vector<Vec3d>> lines(5);
    const std::vector<LimbJoint>& joints = arm.joints;
    const Vec3d along = (joints.back().centre - joints.front().centre).normalized();
    const Vec3d across = along.unitOrthogonal(), other = along.cross(across);
    const std::array<Vec3d, 5> ways{Vec3d::Zero(), across, -across, other, -other};
    for (std::size_t i = 0; i < ways.size(); ++i) {
        for (const LimbJoint& joint : joints) lines[i].push_back(joint.centre + joint.radius * ways[i]);
        lines[i].front() = (lines[i][kShoulder] + lines[i][kElbow]) / 2;
    }
    return lines;
}

// Marks the panels of the surface through which the line passes.
void mark_panels_on(const std::vector<Vec3d>& line, const SurfaceBvh& surface,
                    const std::vector<GarmentTriangle>& triangles, std::vector<bool>& is_marked) {
    constexpr float kBeyond = 1e-4F;  // m behind a hit, where the line goes on
    for (std::size_t i = 1; i < line.size(); ++i) {
        Vec3f from = line[i - 1].cast<float>();
        const Vec3f to = line[i].cast<float>(), way = (to - from).normalized();
        while (const auto hit = surface.first_hit(from, to)) {
            is_marked[static_cast<std::size_t>(triangles[hit->triangle].panel)] = true;
            from = hit->point + kBeyond * way;
            if ((to - from).dot(way) <= 0) break;
        }
    }
}

// The points of each panel's triangles, m.
std::vector<std::vector<Vec3d>> points_of_panels(const GarmentMesh& mesh) {
    std::vector<std::vector<Vec3d>> points(mesh.panel_names.size());
    for (const GarmentTriangle& t : mesh.triangles) {
        for (const int v : t.vertices)
            points[static_cast<std::size_t>(t.panel)].push_back(mesh.x[static_cast<std::size_t>(v)]);
    }
    return points;
}

// Whether a point lies over the chest, where bodices have some and skirts have none: not on an arm that is as high.
bool is_over_chest(const Vec3d& x, const BodyLimbs& limbs) {
    const auto position = nearest_on_limbs(limbs, x);
    const bool is_at_torso = position && (!position->limb || position->limb == LimbKind::Head);
    return is_at_torso && x.y() > limbs.torso[kChest].centre.y();
}

}  // namespace

std::optional<LimbKind> arm_nearest_to(const std::vector<Vec3d>& points, const BodyLimbs& limbs, double share) {
    std::array<std::size_t, kArms.size()> nearest{};
    for (const Vec3d& x : points) {
        const auto position = nearest_on_limbs(limbs, x);
        for (std::size_t i = 0; i < kArms.size(); ++i) nearest[i] += position && position->limb == kArms[i] ? 1 : 0;
    }
    const auto most = static_cast<std::size_t>(std::ranges::max_element(nearest) - nearest.begin());
    if (static_cast<double>(nearest[most]) <= share * static_cast<double>(points.size())) return std::nullopt;
    return kArms[most];
}

std::optional<LimbKind> arm_of_panel(std::string_view label, const std::vector<Vec3d>& points, const BodyLimbs& limbs) {
    constexpr double kMost = 0.8;
    return arm_nearest_to(points, limbs, label == "arm" ? 0 : kMost);
}

std::vector<bool> panels_without_arms(const GarmentMesh& unsewn, const Pattern& pattern, const BodyLimbs& limbs) {
    GarmentMesh closed = unsewn;
    merge_seams(closed);
    Body cloth;
    cloth.x = closed.x;
    for (const GarmentTriangle& t : closed.triangles) cloth.triangles.push_back(t.vertices);
    const SurfaceBvh surface(cloth);
    std::vector<bool> is_in_way(pattern.panels.size(), false), without = is_in_way;
    for (const LimbKind kind : kArms) {
        if (!limbs[kind].is_found) continue;
        for (const auto& line : lines_along(limbs[kind])) mark_panels_on(line, surface, closed.triangles, is_in_way);
    }
    const std::vector<std::vector<Vec3d>> points = points_of_panels(unsewn);
    bool is_any = false;
    for (std::size_t p = 0; p < without.size(); ++p) {
        const std::string& label = pattern.panels[p].label;
        const auto is_bodice = [&](const Vec3d& x) { return is_over_chest(x, limbs); };
        without[p] =
            label == "leg" || (!arm_of_panel(label, points[p], limbs) && std::ranges::none_of(points[p], is_bodice));
        is_any |= without[p] && is_in_way[p];
    }
    if (!is_any) without.assign(without.size(), false);
    return without;
}

}  // namespace selvedge::sim
