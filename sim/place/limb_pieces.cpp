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
#include "sim/core/disjoint_sets.h"
#include "sim/mesh/sew.h"
#include "sim/place/openings.h"

namespace selvedge::sim {
namespace {

// Joints of an arm; those of a leg are hip, knee, ankle.
constexpr std::size_t kShoulder = 0, kElbow = 1, kWrist = 2;
constexpr std::size_t kChest = 2;  // of the torso

struct LimbCut {
    Plane plane;        // its normal points along the limb
    double radius = 0;  // m, of the section
};

// The plane across the upper arm that is nearest to the shoulder and cuts the arm as an arm: nearer ones cut the chest.
// The same for thighs.
std::optional<LimbCut> find_cut(const Body& body, const Limb& limb) {
    constexpr double kFirst = 0.15, kStep = 0.05, kLast = 0.6;  // of the upper arm
    constexpr double kWider = 1.6;                              // area of a section that still is one of the limb
    const Vec3d shoulder = limb.joints[kShoulder].centre;
    const Vec3d upper_arm = limb.joints[kElbow].centre - shoulder;
    std::optional<LimbCut> cut;
    double area = 0;
    for (double share = kLast; share > kFirst; share -= kStep) {
        const Plane plane{.point = shoulder + share * upper_arm, .normal = upper_arm.normalized()};
        const auto loop = nearest_loop(section(body, plane), plane.point);
        if (!loop) break;
        if (!cut) area = loop->area;
        const double radius = std::sqrt(loop->area / std::numbers::pi);
        if (loop->area > kWider * area || (loop->centre - plane.point).norm() > radius) break;
        cut = LimbCut{{.point = loop->centre, .normal = plane.normal}, radius};
    }
    return cut;
}

struct LinePoint {
    Vec3d x = Vec3d::Zero();  // m
    double length = 0;        // m, of the line from its first joint
};

// The point of a centre line that is nearest to x.
LinePoint nearest_on(const std::vector<LimbJoint>& joints, const Vec3d& x) {
    LinePoint nearest{joints.front().centre, 0};
    double length = 0;
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        const Vec3d along = joints[i + 1].centre - joints[i].centre;
        const double share = nearest_share(joints[i], joints[i + 1], x);
        const Vec3d point = joints[i].centre + share * along;
        if ((point - x).squaredNorm() < (nearest.x - x).squaredNorm()) nearest = {point, length + share * along.norm()};
        length += along.norm();
    }
    return nearest;
}

// The vertices that are connected with the wrist, or the ankle, on the far side of the cut. nullopt if one of them is
// too far from the limb's line to belong to it.
std::optional<std::vector<bool>> find_vertices(const Body& body, const Limb& limb, const LimbCut& cut, double stature) {
    constexpr double kReach = 0.13;  // of the stature, from the centre line: a spread hand, the toes
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
    const Vec3d& wrist = limb.joints[kWrist].centre;
    for (std::size_t v = 0; v < body.x.size(); ++v) {
        if (is_beyond(body.x[v]) && (!nearest || (body.x[v] - wrist).norm() < (body.x[*nearest] - wrist).norm()))
            nearest = v;
    }
    if (!nearest) return std::nullopt;
    std::vector<bool> is_of_limb(body.x.size(), false);
    const int part = parts.find(static_cast<int>(*nearest));
    for (std::size_t v = 0; v < body.x.size(); ++v) {
        if (!is_beyond(body.x[v]) || parts.find(static_cast<int>(v)) != part) continue;
        if ((nearest_on(limb.joints, body.x[v]).x - body.x[v]).norm() > kReach * stature) return std::nullopt;
        is_of_limb[v] = true;
    }
    return is_of_limb;
}

using DirectedEdge = std::pair<int, int>;

// Closes each loop of a border by a fan about its middle.
void close_border(const std::vector<DirectedEdge>& border, Body& part) {
    DisjointSets loops(part.x.size());
    for (const auto& [a, b] : border) loops.join(a, b);
    struct Loop {
        Vec3d sum = Vec3d::Zero();
        int edges = 0;
        int middle = 0;
    };
    std::map<int, Loop> by_vertex;
    for (const auto& [a, b] : border) {
        Loop& loop = by_vertex[loops.find(a)];
        loop.sum += part.x[static_cast<std::size_t>(a)];
        ++loop.edges;
    }
    for (auto& [vertex, loop] : by_vertex) {
        loop.middle = static_cast<int>(part.x.size());
        part.x.emplace_back(loop.sum / loop.edges);
    }
    for (const auto& [a, b] : border) part.triangles.push_back({b, a, by_vertex[loops.find(a)].middle});
}

// The triangles for which `is_part` holds, closed where they were cut.
template <class IsPart>
Body closed_part(const Body& body, const IsPart& is_part) {
    Body part;
    std::vector<int> index(body.x.size(), -1);
    std::map<DirectedEdge, int> border;  // those without an opposite one
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
    std::vector<DirectedEdge> edges;
    for (const auto& entry : border) edges.push_back(entry.first);
    close_border(edges, part);
    return part;
}

Body surface_of(const GarmentMesh& mesh) {
    Body surface;
    surface.x = mesh.x;
    for (const GarmentTriangle& t : mesh.triangles) surface.triangles.push_back(t.vertices);
    return surface;
}

}  // namespace

BodyInPieces cut_off(const Body& body, const BodyLimbs& limbs, std::span<const LimbKind> kinds) {
    constexpr int kTrunk = -1;
    BodyInPieces parts;
    std::vector<int> part_of(body.x.size(), kTrunk);  // per vertex, index into parts.limbs
    for (const LimbKind kind : kinds) {
        const Limb& limb = limbs[kind];
        if (!limb.is_found) continue;
        const auto cut = find_cut(body, limb);
        if (!cut) continue;
        const auto is_of_limb = find_vertices(body, limb, *cut, limbs.height.high - limbs.height.low);
        if (!is_of_limb) continue;
        for (std::size_t v = 0; v < part_of.size(); ++v) {
            if ((*is_of_limb)[v]) part_of[v] = static_cast<int>(parts.limbs.size());
        }
        parts.limbs.push_back({kind, {{}, cut->plane.point}, cut->plane.normal, cut->radius});
    }
    const auto part_at = [&](const std::array<int, 3>& t) {
        const int part = part_of[static_cast<std::size_t>(t[0])];
        const bool is_one = std::ranges::all_of(t, [&](int v) { return part_of[static_cast<std::size_t>(v)] == part; });
        return is_one ? part : kTrunk;
    };
    for (std::size_t i = 0; i < parts.limbs.size(); ++i) {
        parts.limbs[i].piece.surface =
            closed_part(body, [&](const auto& t) { return part_at(t) == static_cast<int>(i); });
    }
    parts.trunk = closed_part(body, [&](const auto& t) { return part_at(t) == kTrunk; });
    return parts;
}

namespace {

// The middle of the opening through which the limb leaves with the smallest turn, without passing through cloth.
std::optional<Vec3d> nearest_exit(const GarmentMesh& closed, const SurfaceBvh& cloth, const LimbPiece& limb,
                                  const BodyLimbs& limbs) {
    const Vec3d& root = limb.piece.joint;
    const Vec3d as_it_is = (limbs[limb.kind].joints[kWrist].centre - root).normalized();
    double best = std::cos(std::numbers::pi / 4);
    std::optional<Vec3d> exit;
    for (const Opening& opening : find_openings(closed)) {
        const Vec3d centre = centre_of(opening, closed.x);
        if (centre.x() * root.x() < 0 && std::abs(centre.x()) > limb.radius) continue;  // of the limb on the other side
        const double turn = (centre - root).normalized().dot(as_it_is);
        if (turn <= best || cloth.first_hit(root.cast<float>(), centre.cast<float>())) continue;
        best = turn;
        exit = centre;
    }
    return exit;
}

// Whether a loop, taken for round, has the point within it.
bool has_within(const SectionLoop& loop, const Vec3d& point) {
    return (loop.centre - point).norm() < std::sqrt(loop.area / std::numbers::pi);
}

Vec3d mirrored(const Vec3d& point) {
    return {-point.x(), point.y(), point.z()};
}

// The point at that length of a line, m; straight on beyond its end.
Vec3d point_along(const std::vector<Vec3d>& line, double length) {
    std::size_t i = 0;
    for (; i + 2 < line.size(); ++i) {
        const double part = (line[i + 1] - line[i]).norm();
        if (length <= part) break;
        length -= part;
    }
    return line[i] + length * (line[i + 1] - line[i]).normalized();
}

}  // namespace

namespace {

double length_of(const std::vector<Vec3d>& line) {
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
    return length;
}

// m along the limb, from its root to the wrist or the ankle.
double length_to_wrist(const LimbPiece& limb, const BodyLimbs& limbs) {
    const std::vector<LimbJoint>& joints = limbs[limb.kind].joints;
    return nearest_on(joints, joints[kWrist].centre).length - nearest_on(joints, limb.piece.joint).length;
}

}  // namespace

std::vector<Vec3d> way_out(const GarmentMesh& closed, const LimbPiece& limb, const BodyLimbs& limbs) {
    constexpr int kParts = 10;
    const Body cloth = surface_of(closed);
    const Vec3d& root = limb.piece.joint;
    const auto exit = nearest_exit(closed, SurfaceBvh(cloth), limb, limbs);
    if (!exit) return {root, root + length_to_wrist(limb, limbs) * limb.along};
    std::vector<Vec3d> way{root};
    for (int i = 1; i < kParts; ++i) {
        const double share = static_cast<double>(i) / kParts;
        const Plane plane{.point = root + share * (*exit - root), .normal = (*exit - root).normalized()};
        const auto round = nearest_loop(section(cloth, plane), plane.point);
        const bool is_of_limb = round && has_within(*round, plane.point) && !has_within(*round, mirrored(plane.point));
        way.push_back(is_of_limb ? round->centre : plane.point);
    }
    way.push_back(*exit);
    return way;
}

Body bend_limb(const LimbPiece& limb, const BodyLimbs& limbs, const std::vector<Vec3d>& way, double share) {
    const std::vector<LimbJoint>& joints = limbs[limb.kind].joints;
    constexpr double kMostLonger = 1.5;
    const double root_at = nearest_on(joints, limb.piece.joint).length;
    const double longer = std::clamp(length_of(way) / length_to_wrist(limb, limbs), 1.0, kMostLonger);
    Body bent = limb.piece.surface;
    for (Vec3d& x : bent.x) {
        const double beyond = std::clamp((x - limb.piece.joint).dot(limb.along) / limb.radius, 0.0, 1.0);
        const LinePoint centre = nearest_on(joints, x);
        const Vec3d to = point_along(way, longer * std::max(0.0, centre.length - root_at)) + share * (x - centre.x);
        x += beyond * (to - x);
    }
    return bent;
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

// Of these limbs, the one to which more than that share of the points are nearest.
std::optional<LimbKind> limb_nearest_to(const std::vector<Vec3d>& points, const BodyLimbs& limbs,
                                        std::span<const LimbKind> kinds, double share) {
    std::array<std::size_t, kLimbCount> nearest{};
    for (const Vec3d& x : points) {
        const auto position = nearest_on_limbs(limbs, x);
        if (position && position->limb) ++nearest[index_of(*position->limb)];
    }
    const auto most = std::ranges::max_element(kinds, {}, [&](LimbKind kind) { return nearest[index_of(kind)]; });
    if (most == kinds.end()) return std::nullopt;
    if (static_cast<double>(nearest[index_of(*most)]) <= share * static_cast<double>(points.size()))
        return std::nullopt;
    return *most;
}

// Whether a point lies over the chest, where bodices have some and skirts have none: not on an arm that is as high.
bool is_over_chest(const Vec3d& x, const BodyLimbs& limbs) {
    const auto position = nearest_on_limbs(limbs, x);
    const bool is_at_torso = position && (!position->limb || position->limb == LimbKind::Head);
    return is_at_torso && x.y() > limbs.torso[kChest].centre.y();
}

// Per panel, whether what it is sewn to goes over a shoulder or round an arm: a bodice without straps does not.
std::vector<bool> reaches_shoulders(const GarmentMesh& unsewn, const Pattern& pattern, const BodyLimbs& limbs) {
    constexpr double kBelow = 0.03;  // m, from the joint of the shoulder: the upper edge of a bodice lies lower
    double shoulder = std::numeric_limits<double>::infinity();
    for (const LimbKind kind : kArms) {
        if (limbs[kind].is_found) shoulder = std::min(shoulder, limbs[kind].joints[kShoulder].centre.y() - kBelow);
    }
    DisjointSets parts(pattern.panels.size());
    const std::vector<int> panel_of = panels_of_vertices(unsewn);
    const auto panel_at = [&](int v) { return panel_of[static_cast<std::size_t>(v)]; };
    for (const SeamLink& link : unsewn.links) parts.join(panel_at(link.a), panel_at(link.b));
    std::vector<bool> part_reaches(pattern.panels.size(), false), reaches = part_reaches;
    for (const GarmentTriangle& t : unsewn.triangles) {
        for (const int v : t.vertices) {
            if (unsewn.x[static_cast<std::size_t>(v)].y() > shoulder)
                part_reaches[static_cast<std::size_t>(parts.find(t.panel))] = true;
        }
    }
    for (std::size_t p = 0; p < reaches.size(); ++p)
        reaches[p] = part_reaches[static_cast<std::size_t>(parts.find(static_cast<int>(p)))];
    return reaches;
}

}  // namespace

std::optional<LimbKind> arm_nearest_to(const std::vector<Vec3d>& points, const BodyLimbs& limbs, double share) {
    return limb_nearest_to(points, limbs, kArms, share);
}

std::optional<LimbKind> arm_of_panel(std::string_view label, const std::vector<Vec3d>& points, const BodyLimbs& limbs) {
    constexpr double kMost = 0.8;
    return arm_nearest_to(points, limbs, label == "arm" ? 0 : kMost);
}

std::vector<bool> links_along_limbs(const GarmentMesh& unsewn, const BodyLimbs& limbs,
                                    std::span<const LimbKind> kinds) {
    constexpr double kMost = 0.5;         // of a panel's points, nearest to the limb that it is round
    const double along = std::sqrt(0.5);  // least cosine between a seam and its limb: 45 degrees
    std::vector<std::optional<LimbKind>> limb_of;
    for (const std::vector<Vec3d>& points : points_of_panels(unsewn))
        limb_of.push_back(points.empty() ? std::nullopt : limb_nearest_to(points, limbs, kinds, kMost));
    const std::vector<int> panel_of = panels_of_vertices(unsewn);
    const auto middle = [&](const SeamLink& link) {
        return Vec3d((unsewn.x[static_cast<std::size_t>(link.a)] + unsewn.x[static_cast<std::size_t>(link.b)]) / 2);
    };
    std::vector<bool> is_along(unsewn.links.size(), false);
    for (std::size_t from = 0; from < unsewn.links.size();) {
        const SeamLink& first = unsewn.links[from];
        std::size_t to = from;
        while (to < unsewn.links.size() && unsewn.links[to].seam == first.seam) ++to;
        const auto limb = limb_of[static_cast<std::size_t>(panel_of[static_cast<std::size_t>(first.a)])];
        const auto other = limb_of[static_cast<std::size_t>(panel_of[static_cast<std::size_t>(first.b)])];
        if (limb && limb == other) {
            const std::vector<LimbJoint>& joints = limbs[*limb].joints;
            const Vec3d limb_way = joints[kWrist].centre - joints[kShoulder].centre;
            const Vec3d seam_way = middle(unsewn.links[to - 1]) - middle(first);
            const bool runs_along = std::abs(seam_way.dot(limb_way)) > along * seam_way.norm() * limb_way.norm();
            std::fill(is_along.begin() + static_cast<std::ptrdiff_t>(from),
                      is_along.begin() + static_cast<std::ptrdiff_t>(to), runs_along);
        }
        from = to;
    }
    return is_along;
}

std::vector<bool> panels_without_arms(const GarmentMesh& unsewn, const Pattern& pattern, const BodyLimbs& limbs) {
    const std::vector<std::vector<Vec3d>> points = points_of_panels(unsewn);
    const std::vector<bool> reaches = reaches_shoulders(unsewn, pattern, limbs);
    std::vector<bool> without(pattern.panels.size(), false);
    for (std::size_t p = 0; p < without.size(); ++p) {
        if (points[p].empty()) continue;
        const std::string& label = pattern.panels[p].label;
        const auto is_bodice = [&](const Vec3d& x) { return reaches[p] && is_over_chest(x, limbs); };
        without[p] =
            label == "leg" || (!arm_of_panel(label, points[p], limbs) && std::ranges::none_of(points[p], is_bodice));
    }
    return without;
}

bool are_in_way_of_arms(const std::vector<bool>& panels, const GarmentMesh& unsewn, const BodyLimbs& limbs) {
    GarmentMesh closed = unsewn;
    merge_seams(closed);
    const SurfaceBvh surface(surface_of(closed));
    std::vector<bool> is_in_way(panels.size(), false);
    for (const LimbKind kind : kArms) {
        if (!limbs[kind].is_found) continue;
        for (const auto& line : lines_along(limbs[kind])) mark_panels_on(line, surface, closed.triangles, is_in_way);
    }
    for (std::size_t p = 0; p < panels.size(); ++p)
        if (panels[p] && is_in_way[p]) return true;
    return false;
}

}  // namespace selvedge::sim
