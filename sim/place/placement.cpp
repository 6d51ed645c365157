#include "sim/place/placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "sim/body/section.h"
#include "sim/collide/body_collider.h"
#include "sim/collide/surface_bvh.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/garments.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/segment_distance.h"
#include "sim/place/hanging_seams.h"
#include "sim/place/level_on.h"
#include "sim/place/limb_pieces.h"
#include "sim/place/limbs.h"
#include "sim/place/proportions.h"

namespace selvedge::sim {
namespace {

constexpr double kClearance = 0.01;    // m, between a placed panel and the body
constexpr double kLongestMove = 0.40;  // m
constexpr double kMoveStep = 0.01;     // m

// Mean of the panel's outline vertices in 3D.
Vec3d panel_centre(const Panel& panel) {
    Vec3d sum = Vec3d::Zero();
    for (const Vec2d& u : panel.vertices) sum += panel.place(u);
    return sum / static_cast<double>(std::max<std::size_t>(1, panel.vertices.size()));
}

// Centre of the torso's section at this height, clamped to between crotch and shoulder; arms and legs are other loops.
Vec3d torso_centre(const MeasuredBody& body, double y) {
    const double level = std::clamp(y, body.proportions().at(0.52), body.proportions().at(0.80));
    const Plane plane{.point = Vec3d(0, level, 0)};
    const auto loop = nearest_loop(section(body.body(), plane), Vec3d(0, level, 0));
    const Vec3d centre = loop ? loop->centre : Vec3d(0, level, 0);
    return {centre.x(), y, centre.z()};
}

// A placed panel: its vertices and edge midpoints, and the direction that its right side faces.
struct PlacedPanel {
    std::vector<Vec3d> points;
    Vec3d normal = Vec3d::Zero();
    bool is_tube = false;  // it is bent by more than half a turn
};

std::vector<PlacedPanel> placed_panels(const GarmentMesh& unsewn) {
    std::vector<PlacedPanel> panels(unsewn.panel_names.size());
    std::vector<double> areas(panels.size(), 0);  // twice those
    std::set<std::pair<int, int>> known;          // edges, and vertices as edges from them to themselves
    for (const GarmentTriangle& triangle : unsewn.triangles) {
        PlacedPanel& panel = panels[static_cast<std::size_t>(triangle.panel)];
        std::array<Vec3d, 3> x;
        for (std::size_t i = 0; i < 3; ++i) x[i] = unsewn.x[static_cast<std::size_t>(triangle.vertices[i])];
        for (std::size_t i = 0; i < 3; ++i) {
            const int from = triangle.vertices[i], to = triangle.vertices[(i + 1) % 3];
            if (known.insert({from, from}).second) panel.points.push_back(x[i]);
            if (known.insert(std::minmax(from, to)).second) panel.points.push_back((x[i] + x[(i + 1) % 3]) * 0.5);
        }
        panel.normal += (x[1] - x[0]).cross(x[2] - x[0]);
        areas[static_cast<std::size_t>(triangle.panel)] += (x[1] - x[0]).cross(x[2] - x[0]).norm();
    }
    constexpr double kTube = 0.6;  // the mean normal of half a turn is 2 / pi long
    for (std::size_t p = 0; p < panels.size(); ++p) {
        panels[p].is_tube = panels[p].normal.norm() < kTube * areas[p];
        panels[p].normal.normalize();
    }
    return panels;
}

// Tubes may be nearer: what they are round holds them.
bool is_clear(const PlacedPanel& panel, const Vec3d& shift, const BodyCollider& body) {
    constexpr double kTubeClearance = 0.002;  // m
    const double clearance = panel.is_tube ? kTubeClearance : kClearance;
    return std::all_of(panel.points.begin(), panel.points.end(), [&](const Vec3d& p) {
        return body.contact((p + shift).cast<float>()).distance >= static_cast<float>(clearance);
    });
}

// The smallest move, from `least` on, that clears the panel; nullopt when even the longest does not.
std::optional<double> clearing_move(const PlacedPanel& panel, double least, const BodyCollider& body) {
    for (double move = least; move <= kLongestMove; move += kMoveStep) {
        if (is_clear(panel, panel.normal * move, body)) return move;
    }
    return std::nullopt;
}

// The shortest move of a tube that clears it of the limb that it is round: outward, it would end beside it. None if it
// is clear, or not near any clear place: a longer move would leave the limb outside of a tube that stands open.
std::optional<Vec3d> clearing_nudge(const PlacedPanel& panel, const BodyCollider& body) {
    constexpr int kMostSteps = 2;
    for (int step = 1; step <= kMostSteps; ++step) {
        for (int i = 0; i < 27; ++i) {
            const Vec3d way(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            if (way.isZero()) continue;
            const Vec3d shift = way.normalized() * (step * kMoveStep);
            if (is_clear(panel, shift, body)) return shift;
        }
    }
    return std::nullopt;
}

// Where the line from `from` along the unit direction meets the triangle, m from there; nullopt if it misses it.
// (Moeller and Trumbore 1997)
std::optional<double> distance_along(const Vec3d& from, const Vec3d& along, const std::array<Vec3d, 3>& x) {
    const Vec3d a = x[1] - x[0], b = x[2] - x[0], to = from - x[0];
    const Vec3d across = along.cross(b), up = to.cross(a);
    const double area = a.dot(across);
    if (area == 0) return std::nullopt;
    const double s = to.dot(across) / area, t = along.dot(up) / area;
    if (!(s >= 0 && t >= 0 && s + t <= 1)) return std::nullopt;
    return b.dot(up) / area;
}

// Whether cloth at x lies on the side of the body that looks along `along`.
bool is_before(const Vec3d& x, const Vec3d& along, const BodyCollider& body) {
    const auto nearest = body.surface().closest(x.cast<float>(), std::numeric_limits<float>::infinity());
    return !nearest || nearest->normal.cast<double>().dot(along) > 0;
}

using Triangles = std::vector<std::array<Vec3d, 3>>;  // positions of the corners, m

// Triangles as seen along a direction, in square cells: lines along it meet no others than those of their cell.
class TrianglesInCells {
 public:
    TrianglesInCells(const Triangles& triangles, const Vec3d& along)
        : across_(along.unitOrthogonal()), other_(along.cross(across_)) {
        constexpr double kSmallest = 0.005;  // m
        constexpr double kRounding = 1e-9;   // m
        std::vector<Eigen::AlignedBox2d> boxes(triangles.size());
        double sum = 0;
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            for (const Vec3d& x : triangles[t]) boxes[t].extend(seen(x));
            sum += boxes[t].sizes().maxCoeff();
        }
        size_ = std::max(kSmallest, sum / static_cast<double>(std::max<std::size_t>(1, triangles.size())));
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            const Cell low = cell_at(boxes[t].min() - Vec2d::Constant(kRounding));
            const Cell high = cell_at(boxes[t].max() + Vec2d::Constant(kRounding));
            for (long i = low.first; i <= high.first; ++i) {
                for (long j = low.second; j <= high.second; ++j) cells_[{i, j}].push_back(t);
            }
        }
    }

    // Those of the cell of x, ascending.
    std::span<const std::size_t> at(const Vec3d& x) const {
        const auto found = cells_.find(cell_at(seen(x)));
        return found == cells_.end() ? std::span<const std::size_t>() : found->second;
    }

 private:
    using Cell = std::pair<long, long>;

    Vec2d seen(const Vec3d& x) const { return {x.dot(across_), x.dot(other_)}; }
    Cell cell_at(const Vec2d& p) const {
        return {static_cast<long>(std::floor(p.x() / size_)), static_cast<long>(std::floor(p.y() / size_))};
    }

    Vec3d across_, other_;  // unit
    double size_ = 0;       // m, of a cell
    std::map<Cell, std::vector<std::size_t>> cells_;
};

// How far the panel must move outward to be outside of this cloth, m: 0 if it is.
double move_outside(const PlacedPanel& panel, const Triangles& cloth, const BodyCollider& body) {
    if (panel.points.empty() || cloth.empty()) return 0;
    const TrianglesInCells cells(cloth, panel.normal);
    double move = 0;
    for (const Vec3d& from : panel.points) {
        for (const std::size_t t : cells.at(from)) {
            const auto distance = distance_along(from, panel.normal, cloth[t]);
            if (!distance || *distance + kClearance <= move || *distance > kLongestMove) continue;
            if (is_before(from + *distance * panel.normal, panel.normal, body)) move = *distance + kClearance;
        }
    }
    return move;
}

void add_triangles(Triangles& all, const GarmentMesh& mesh, const std::function<bool(const GarmentTriangle&)>& wanted) {
    for (const GarmentTriangle& t : mesh.triangles) {
        if (!wanted(t)) continue;
        std::array<Vec3d, 3> x;
        for (std::size_t k = 0; k < 3; ++k) x[k] = mesh.x[static_cast<std::size_t>(t.vertices[k])];
        all.push_back(x);
    }
}

// The panels, from the lowest layer to the highest.
std::vector<std::size_t> by_layer(const GarmentMesh& mesh) {
    std::vector<std::size_t> panels(mesh.panel_names.size());
    std::iota(panels.begin(), panels.end(), 0U);
    if (!mesh.panel_layers.empty())
        std::ranges::stable_sort(panels, {}, [&](std::size_t p) { return mesh.panel_layers[p]; });
    return panels;
}

void move_panel(GarmentMesh& unsewn, std::size_t panel, const Vec3d& shift) {
    std::vector<bool> is_of_panel(unsewn.x.size(), false);
    for (const GarmentTriangle& triangle : unsewn.triangles) {
        if (static_cast<std::size_t>(triangle.panel) != panel) continue;
        for (const int v : triangle.vertices) is_of_panel[static_cast<std::size_t>(v)] = true;
    }
    for (std::size_t v = 0; v < unsewn.x.size(); ++v) {
        if (is_of_panel[v]) unsewn.x[v] += shift;
    }
}

// Where the body blocks the straight line between two linked vertices the most.
struct BlockedLink {
    double depth = 0;       // m, inside the body
    bool faces_up = false;  // the body's surface there, as it does on the shoulders
};

BlockedLink find_blocked(const GarmentMesh& unsewn, const SeamLink& link, double lift, const BodyCollider& body) {
    constexpr int kSamples = 16;
    constexpr float kUp = 0.5F;  // cosine: less than 60 degrees from upright
    const Vec3d a = unsewn.x[static_cast<std::size_t>(link.a)] + Vec3d(0, lift, 0);
    const Vec3d b = unsewn.x[static_cast<std::size_t>(link.b)] + Vec3d(0, lift, 0);
    BlockedLink blocked;
    for (int i = 1; i < kSamples; ++i) {
        const Vec3d p = a + (b - a) * (i / double(kSamples));
        const auto contact = body.contact(p.cast<float>());
        const double depth = -static_cast<double>(contact.distance);
        if (depth > blocked.depth) blocked = {.depth = depth, .faces_up = contact.normal.y() > kUp};
    }
    return blocked;
}

// Sum of squared depths: one deep seam is worse than several shallow ones. Depths are capped at 4 cm, because a deeper
// one, as for a tight skirt around spread legs, cannot be cured by a lift.
double blocked_cost(const GarmentMesh& unsewn, std::span<const SeamLink> links, double lift, const BodyCollider& body) {
    constexpr double kDeepest = 0.04;  // m
    double cost = 0;
    for (const SeamLink& link : links) {
        const double depth = std::min(kDeepest, find_blocked(unsewn, link, lift, body).depth);
        cost += depth * depth;
    }
    return cost;
}

constexpr double kLiftStep = 0.01;  // m

bool has_tubes(const GarmentMesh& unsewn) {
    return std::ranges::any_of(placed_panels(unsewn), [](const PlacedPanel& panel) { return panel.is_tube; });
}

// Beyond a maximum of the cost, a sleeve may lie wholly on the wrong side of the arm, where the cost is low again. A
// lift beyond such a maximum is accepted only if the seams are practically clear there.
double least_blocked_lift(const GarmentMesh& unsewn, double as_placed, const BodyCollider& body) {
    constexpr int kStepsEachWay = 12;
    constexpr double kWorthPerStep = 0.05;      // of the initial cost, which each step must save at least
    constexpr double kHump = 1.2, kGood = 0.1;  // of the initial cost
    // A sleeve that is wrapped round an arm and lifted by more would lie beside it.
    constexpr int kStepsOfTubes = 4;
    const int steps = has_tubes(unsewn) ? kStepsOfTubes : kStepsEachWay;
    const std::vector<SeamLink> shoulders = shoulder_links(unsewn);
    const double at_shoulders = blocked_cost(unsewn, shoulders, 0, body);
    double best = 0;
    double least = as_placed;
    for (const double way : {kLiftStep, -kLiftStep}) {
        bool is_behind = false;
        for (int i = 1; i <= steps; ++i) {
            // What bears the garment does not sink into the shoulders, nor through them.
            if (way < 0 && blocked_cost(unsewn, shoulders, i * way, body) > at_shoulders) break;
            const double cost = blocked_cost(unsewn, unsewn.links, i * way, body);
            is_behind |= cost > kHump * as_placed;
            const double with_way = cost + i * kWorthPerStep * as_placed;
            if (with_way >= least || (is_behind && cost > kGood * as_placed)) continue;
            least = with_way;
            best = i * way;
        }
    }
    // What bears the garment has to come to lie on the shoulders, also where that brings other seams nearer.
    for (int i = 0; i < steps && best >= 0 && blocked_cost(unsewn, shoulders, best, body) > kGood * at_shoulders; ++i) {
        const double higher = best + kLiftStep;
        if (blocked_cost(unsewn, unsewn.links, higher, body) >= as_placed) break;
        best = higher;
    }
    return best;
}

// A lift from which no seam grazes the body from above. The cost weighs a shoulder seam like one under an arm or at a
// side. But those slide round what they graze, whereas a shoulder seam bears the garment: while other seams pull at its
// panels, it slips down before or behind the shoulder, and the garment falls.
double lift_off(const GarmentMesh& unsewn, double lift, const BodyCollider& body) {
    constexpr int kMostSteps = 2;  // lift a seam that is less than kClearance deep out of a surface that faces up
    std::vector<SeamLink> grazing;
    for (const SeamLink& link : unsewn.links) {
        const BlockedLink blocked = find_blocked(unsewn, link, lift, body);
        if (blocked.depth > 0 && blocked.depth < kClearance && blocked.faces_up) grazing.push_back(link);
    }
    for (int i = 0; i < kMostSteps; ++i) {
        const bool is_free = std::ranges::none_of(
            grazing, [&](const SeamLink& link) { return find_blocked(unsewn, link, lift, body).depth > 0; });
        if (is_free) break;
        lift += kLiftStep;
    }
    return lift;
}

}  // namespace

double seam_clearing_lift(const GarmentMesh& unsewn, const BodyCollider& body) {
    const double as_placed = blocked_cost(unsewn, unsewn.links, 0, body);
    if (as_placed <= 0) return 0;
    return lift_off(unsewn, least_blocked_lift(unsewn, as_placed, body), body);
}

namespace {

// The corners and the middles of the edges of a panel as it is placed, m.
std::vector<Vec3d> outline_points(const Panel& panel) {
    std::vector<Vec3d> points;
    for (const OutlineEdge& edge : panel.edges) {
        const Vec2d& start = panel.vertices[static_cast<std::size_t>(edge.start)];
        const Vec2d& end = panel.vertices[static_cast<std::size_t>(edge.end)];
        for (const double share : {0.0, 0.5}) points.push_back(panel.place(start + share * (end - start)));
    }
    return points;
}

// The turn from the direction of an arm to that on another body; none if they hang alike or one is not found.
std::optional<Eigen::Quaterniond> turn_of_arm(const BodyLimbs& from, const BodyLimbs& onto, LimbKind arm) {
    constexpr double kAlike = 0.17;  // rad, 10 degrees: a sleeve has room for that
    if (!from[arm].is_found || !onto[arm].is_found) return std::nullopt;
    const auto along = [&](const BodyLimbs& limbs) {
        const std::vector<LimbJoint>& joints = limbs[arm].joints;
        return Vec3d((joints[2].centre - joints[0].centre).normalized());  // from the shoulder to the wrist
    };
    const auto turn = Eigen::Quaterniond::FromTwoVectors(along(from), along(onto));
    if (turn.angularDistance(Eigen::Quaterniond::Identity()) < kAlike) return std::nullopt;
    return turn;
}

// Heights of a body between which others lie alike on all bodies: floor, hips, waist, shoulders, crown, m.
using BodyLevels = std::array<double, 5>;
constexpr std::size_t kShoulderLevel = 3;

BodyLevels levels_of(const MeasuredBody& body, double shoulders) {
    const Proportions& proportions = body.proportions();
    const TorsoHeights torso = torso_heights(body.body(), body.stature());
    return {proportions.floor, torso.hip, torso.waist, shoulders, proportions.crown};
}

// Per panel, the height of the highest point of what seams join it with, m.
std::vector<double> tops_of(const Pattern& pattern) {
    const std::vector<std::size_t> parts = sewn_parts(pattern);
    std::vector<double> tops(pattern.panels.size(), -std::numeric_limits<double>::infinity());
    for (std::size_t p = 0; p < tops.size(); ++p) {
        for (const Vec3d& x : outline_points(pattern.panels[p])) tops[parts[p]] = std::max(tops[parts[p]], x.y());
    }
    for (std::size_t p = 0; p < tops.size(); ++p) tops[p] = tops[parts[p]];
    return tops;
}

}  // namespace

Stature anchor_panels(Pattern& pattern, const MeasuredBody& from, const MeasuredBody& onto) {
    constexpr double kShoulders = 0.80;  // of the stature: the joints, where one of the bodies does not show their top
    const auto &from_top = from.shoulder_top(), &onto_top = onto.shoulder_top();
    const bool have_tops = from_top && onto_top;
    const BodyLevels from_levels = levels_of(from, have_tops ? *from_top : from.proportions().at(kShoulders));
    const BodyLevels onto_levels = levels_of(onto, have_tops ? *onto_top : onto.proportions().at(kShoulders));
    const auto shift = [&](const Vec3d& x, double rise) {
        return Vec3d(torso_centre(onto, x.y() + rise) - torso_centre(from, x.y()));
    };
    const BodyLimbs &from_limbs = from.limbs(), &onto_limbs = onto.limbs();
    const std::vector<double> tops = tops_of(pattern);
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
        Panel& panel = pattern.panels[p];
        // What reaches above the shoulders, as a collar, hangs from them.
        const double held_at = std::min(tops[p], from_levels[kShoulderLevel]);
        const double rise = level_on(held_at, from_levels, onto_levels) - held_at;
        const auto arm = arm_of_panel(panel.label, outline_points(panel), from_limbs);
        panel.translation += shift(panel_centre(panel), rise);
        const auto turn = arm ? turn_of_arm(from_limbs, onto_limbs, *arm) : std::nullopt;
        if (!turn) continue;
        Vec3d shoulder = from_limbs[*arm].joints.front().centre;
        shoulder += shift(shoulder, rise);
        panel.rotation = *turn * panel.rotation;
        panel.translation = shoulder + *turn * (panel.translation - shoulder);
    }
    return onto.stature();
}

ClearedPanels clear_panels(GarmentMesh& unsewn, const BodyCollider& body, const GarmentMesh& worn) {
    ClearedPanels cleared;
    std::vector<std::string>& notes = cleared.notes;
    const std::vector<PlacedPanel> panels = placed_panels(unsewn);
    const auto layer_of = [&](std::size_t p) { return unsewn.panel_layers.empty() ? 0 : unsewn.panel_layers[p]; };
    Triangles inside;
    add_triangles(inside, worn, [](const GarmentTriangle&) { return true; });
    std::optional<int> added;  // the layer up to which panels are in `inside`
    for (const std::size_t i : by_layer(unsewn)) {
        add_triangles(inside, unsewn, [&](const GarmentTriangle& t) {
            const int layer = layer_of(static_cast<std::size_t>(t.panel));
            return layer < layer_of(i) && (!added || layer >= *added);
        });
        added = layer_of(i);
        const double outside = move_outside(panels[i], inside, body);
        const std::string name = "panel '" + unsewn.panel_names[i] + "'";
        if (panels[i].is_tube && outside == 0) {
            if (is_clear(panels[i], Vec3d::Zero(), body)) continue;
            if (const auto nudge = clearing_nudge(panels[i], body)) {
                move_panel(unsewn, i, *nudge);
                notes.push_back(name + " moved by " + std::to_string(std::lround(nudge->norm() * 1000)) +
                                " mm, clear of the limb that it is round");
            } else {
                notes.push_back(name + " meets the limb that it is round");
            }
            continue;
        }
        const std::optional<double> move = clearing_move(panels[i], outside, body);
        if (!move) cleared.stuck.push_back(name + " stands in the body, and nowhere near is clear of it");
        if (!move || *move == 0) continue;
        move_panel(unsewn, i, panels[i].normal * *move);
        const long millimetres = std::lround(*move * 1000);
        notes.push_back(name + " moved " + std::to_string(millimetres) + " mm outward, clear of the body" +
                        (outside > 0 ? " and of what is worn under it" : ""));
    }
    return cleared;
}

ClearedPanels make_sewable(GarmentMesh& unsewn, const BodyCollider& body, const GarmentMesh& worn,
                           const MeasuredBody* measured) {
    const double closed = close_level_gaps(unsewn, measured);
    const double lift = seam_clearing_lift(unsewn, body);
    for (Vec3d& x : unsewn.x) x.y() += lift;
    ClearedPanels cleared = clear_panels(unsewn, body, worn);
    if (closed > 0.001)
        cleared.notes.insert(cleared.notes.begin(), "panels moved by up to " +
                                                        std::to_string(std::lround(closed * 1000)) +
                                                        " mm, against those that they hang from");
    if (lift != 0) {
        const std::string millimetres = std::to_string(std::lround(std::abs(lift) * 1000));
        cleared.notes.insert(cleared.notes.begin(), "all panels moved " + millimetres +
                                                        (lift > 0 ? " mm up" : " mm down") +
                                                        ", so that the seams can close round the body");
    }
    return cleared;
}

namespace {

constexpr double kPointClear = 0.022;  // m, from the torso or limb that the point belongs to
constexpr double kPanelClear = 0.012;  // m, between a wrapped panel and the body
constexpr double kMinClear = 0.006;    // m, from any part of the body: a nearer point, as between thighs, is left out
constexpr double kFurthest = 0.040;    // m, from its own level: limit on the clearance for levels above and below

// A section of a torso or limb, around which a cylinder is fitted.
struct PointSection {
    std::vector<Vec3d> points;  // of the level itself
    std::vector<Vec3d> nearby;  // also of levels above and below
    Vec3d centre = Vec3d::Zero();
};

struct Direction {
    std::string_view name;
    Vec3d outward = Vec3d::Zero();
};

double widest_x(const std::vector<Vec3d>& points, const Vec3d& centre) {
    double widest = 0;
    for (const Vec3d& p : points) widest = std::max(widest, std::abs(p.x() - centre.x()));
    return widest;
}

// Torso.

struct TorsoLevel {
    std::string_view name;
    double y = 0;      // m
    double reach = 0;  // m above and below that a panel placed here must clear
};

std::array<TorsoLevel, 5> torso_levels(const Body& body, const Stature& stature) {
    const TorsoHeights heights = torso_heights(body, stature);
    return {{{"neck", heights.neck, 0},
             {"chest", heights.chest, 0.08},
             {"waist", heights.waist, 0.08},
             {"hip", heights.hip, 0.08},
             {"below hip", heights.hip - 0.07 * stature.height(), 0.04}}};
}

std::optional<PointSection> cut_torso(const Body& body, const Stature& stature, const TorsoLevel& level) {
    constexpr double kMuchWider = 1.45;  // so much wider where the arms join the trunk
    PointSection cut;
    cut.points = trunk_points(body, level.y, stature.height());
    if (cut.points.empty()) return std::nullopt;
    cut.centre = middle_of_box(cut.points);
    cut.nearby = cut.points;
    for (const double way : {-1.0, -0.5, 0.5, 1.0}) {
        if (level.reach == 0) break;
        const auto points = trunk_points(body, level.y + way * level.reach, stature.height());
        if (widest_x(points, cut.centre) > kMuchWider * widest_x(cut.points, cut.centre)) continue;
        cut.nearby.insert(cut.nearby.end(), points.begin(), points.end());
    }
    return cut;
}

// Limbs.

// A part of a limb at which panels are placed.
struct LimbPart {
    std::string name;  // "left upper arm"
    Vec3d top = Vec3d::Zero();
    Vec3d bottom = Vec3d::Zero();
    double share = 0.5;  // fraction of the way from top to bottom
};

std::optional<PointSection> cut_limb(const Body& body, const LimbPart& limb) {
    const Vec3d point = limb.top + limb.share * (limb.bottom - limb.top);
    const auto loop =
        nearest_loop(section(body, {.point = point, .normal = (limb.top - limb.bottom).normalized()}), point);
    if (!loop || (loop->centre - point).norm() > 0.1) return std::nullopt;
    return PointSection{.points = loop->points, .nearby = loop->points, .centre = loop->centre};
}

std::vector<LimbPart> limb_parts(const BodyLimbs& limbs) {
    struct Place {
        std::string_view name;
        std::size_t joint;
        double share;
    };
    constexpr std::array<Place, 2> kArm{{{"upper arm", 0, 0.6}, {"forearm", 1, 0.35}}};
    constexpr std::array<Place, 2> kLeg{{{"thigh", 0, 0.55}, {"calf", 1, 0.3}}};
    std::vector<LimbPart> parts;
    const auto add = [&](LimbKind kind, const std::string& side, const std::array<Place, 2>& places) {
        if (!limbs[kind].is_found) return;
        const std::vector<LimbJoint>& joints = limbs[kind].joints;
        for (const Place& place : places) {
            parts.push_back({side + " " + std::string(place.name), joints[place.joint].centre,
                             joints[place.joint + 1].centre, place.share});
        }
    };
    add(LimbKind::LeftArm, "left", kArm);
    add(LimbKind::RightArm, "right", kArm);
    add(LimbKind::LeftLeg, "left", kLeg);
    add(LimbKind::RightLeg, "right", kLeg);
    return parts;
}

// Points.

// Radius of the smallest circle through `at`, with its centre on the body's side, that encloses all points with the
// panel's clearance.
double radius_round(const PointSection& cut, const Vec3d& at, const Vec3d& outward, const Vec3d& upward) {
    double radius = 0.03;
    for (const Vec3d& p : cut.nearby) {
        const Vec3d to = (p - at) - (p - at).dot(upward) * upward;
        const double along = -to.dot(outward);
        const double squared = to.squaredNorm() - kPanelClear * kPanelClear;
        if (along > 1.2 * kPanelClear) radius = std::max(radius, squared / (2 * (along - kPanelClear)));
    }
    return std::min(radius, 1.0);
}

std::optional<ArrangementPoint> point_at(const PointSection& cut, const Direction& direction, const Vec3d& upward,
                                         const SurfaceBvh& surface) {
    const auto farthest = [&](const std::vector<Vec3d>& points) {
        double most = 0;
        for (const Vec3d& p : points) most = std::max(most, (p - cut.centre).dot(direction.outward));
        return most;
    };
    const double own = farthest(cut.points);
    const double all = std::max(own, std::min(farthest(cut.nearby), own + kFurthest - kPointClear));
    for (const double clear : {kPointClear, 0.014, 0.009}) {
        ArrangementPoint point;
        point.outward = direction.outward;
        point.upward = upward;
        point.position = cut.centre + (all + clear) * direction.outward;
        const auto closest = surface.closest(point.position.cast<float>(), std::numeric_limits<float>::infinity());
        if (closest && closest->distance < static_cast<float>(kMinClear)) continue;
        point.radius = radius_round(cut, point.position, point.outward, upward);
        return point;
    }
    return std::nullopt;
}

void add_points(std::vector<ArrangementPoint>& points, const std::string& name, const PointSection& cut,
                const Vec3d& upward, const std::array<Direction, 4>& directions, const SurfaceBvh& surface) {
    for (const Direction& direction : directions) {
        auto point = point_at(cut, direction, upward, surface);
        if (!point) continue;
        point->name = name + " " + std::string(direction.name);
        points.push_back(std::move(*point));
    }
}

std::array<Direction, 4> directions_about(const LimbPart& limb, const Vec3d& upward) {
    const auto across = [&](const Vec3d& way) { return Vec3d((way - way.dot(upward) * upward).normalized()); };
    const Vec3d front = across(Vec3d::UnitZ());
    const Vec3d outside = across(limb.name.starts_with("left") ? Vec3d(Vec3d::UnitX()) : Vec3d(-Vec3d::UnitX()));
    return {{{"outside", outside}, {"front", front}, {"back", -front}, {"inside", -outside}}};
}

Eigen::AlignedBox2d box_of(const Panel& panel) {
    constexpr double kChordError = 0.0005;  // m
    Eigen::AlignedBox2d box;
    for (const OutlineEdge& edge : panel.edges) {
        for (const Vec2d& u : outline_polyline(panel, edge, kChordError)) box.extend(u);
    }
    return box;
}

}  // namespace

std::vector<ArrangementPoint> arrangement_points(const Body& body) {
    std::vector<ArrangementPoint> points;
    if (body.triangles.empty()) return points;
    const SurfaceBvh surface(body);
    const std::array<Direction, 4> ways{
        {{"front", Vec3d::UnitZ()}, {"back", -Vec3d::UnitZ()}, {"left", Vec3d::UnitX()}, {"right", -Vec3d::UnitX()}}};
    const Stature stature = find_stature(body);
    for (const TorsoLevel& level : torso_levels(body, stature)) {
        if (const auto cut = cut_torso(body, stature, level))
            add_points(points, std::string(level.name), *cut, Vec3d::UnitY(), ways, surface);
    }
    for (const LimbPart& limb : limb_parts(find_limbs(body))) {
        const Vec3d upward = (limb.top - limb.bottom).normalized();
        if (const auto cut = cut_limb(body, limb))
            add_points(points, limb.name, *cut, upward, directions_about(limb, upward), surface);
    }
    return points;
}

// The wrap bends about the panel's x = 0. If that is not its centre, the panel is rotated until its centre faces
// outward.
ArrangementPoint turned(ArrangementPoint point, const Vec3d& centre, double angle) {
    const Eigen::AngleAxisd turn(angle, point.upward);
    point.position = centre + turn * (point.position - centre);
    point.outward = turn * point.outward;
    return point;
}

void arrange(Panel& panel, const ArrangementPoint& point) {
    const Eigen::AlignedBox2d box = box_of(panel);
    if (box.isEmpty()) return;
    const Vec2d middle = box.center();
    const double side = panel.is_mirrored ? -1 : 1;  // the right side faces along side * z
    Eigen::Matrix3d frame;
    frame.col(1) = point.upward;
    frame.col(2) = side * point.outward;
    frame.col(0) = frame.col(1).cross(frame.col(2));
    panel.wrap_cone.reset();
    panel.wrap_radius = point.radius;
    const double turned = middle.x() / panel.wrap_radius;
    panel.rotation = frame * Eigen::AngleAxisd(-turned, Vec3d::UnitY()).toRotationMatrix();
    panel.translation.setZero();
    panel.translation = point.position - panel.place(middle);
}

float clearance_of(const Panel& panel, const BodyCollider& body) {
    constexpr int kSpots = 16;            // along each side of the panel's box
    constexpr double kChordError = 1e-3;  // m
    const Eigen::AlignedBox2d box = outline_box(panel, kChordError);
    std::vector<Vec2d> outline;
    for (const OutlineEdge& edge : panel.edges) {
        const std::vector<Vec2d> line = outline_polyline(panel, edge, kChordError);
        outline.insert(outline.end(), line.begin(), line.end() - 1);
    }
    float least = std::numeric_limits<float>::infinity();
    const auto take = [&](const Vec2d& u) {
        least = std::min(least, body.contact(panel.place(u).cast<float>()).distance);
    };
    for (const Vec2d& u : outline) take(u);
    for (int i = 0; i < kSpots * kSpots; ++i) {
        const Vec2d share((i % kSpots + 0.5) / kSpots, (i / kSpots + 0.5) / kSpots);
        const Vec2d u = box.min() + share.cwiseProduct(box.sizes());
        if (is_inside(u, outline)) take(u);
    }
    return least;
}

}  // namespace selvedge::sim
