#include "sim/place/placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "sim/body/section.h"
#include "sim/collide/body_collider.h"

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
Vec3d torso_centre(const Body& body, double y) {
    const HeightRange height = height_range(body);
    const double stature = height.high - height.low;
    const double level = std::clamp(y, height.low + 0.52 * stature, height.low + 0.80 * stature);
    const Plane plane{.point = Vec3d(0, level, 0)};
    const auto loop = nearest_loop(section(body, plane), Vec3d(0, level, 0));
    const Vec3d centre = loop ? loop->centre : Vec3d(0, level, 0);
    return {centre.x(), y, centre.z()};
}

// A placed panel: its vertices and edge midpoints, and the direction that its right side faces.
struct PlacedPanel {
    std::vector<Vec3d> points;
    Vec3d normal = Vec3d::Zero();
};

std::vector<PlacedPanel> placed_panels(const GarmentMesh& unsewn) {
    std::vector<PlacedPanel> panels(unsewn.panel_names.size());
    for (const GarmentTriangle& triangle : unsewn.triangles) {
        PlacedPanel& panel = panels[static_cast<std::size_t>(triangle.panel)];
        std::array<Vec3d, 3> x;
        for (std::size_t i = 0; i < 3; ++i) x[i] = unsewn.x[static_cast<std::size_t>(triangle.vertices[i])];
        for (std::size_t i = 0; i < 3; ++i) {
            panel.points.push_back(x[i]);
            panel.points.push_back((x[i] + x[(i + 1) % 3]) * 0.5);
        }
        panel.normal += (x[1] - x[0]).cross(x[2] - x[0]);
    }
    for (PlacedPanel& panel : panels) panel.normal.normalize();
    return panels;
}

bool is_clear(const PlacedPanel& panel, double move, const BodyCollider& body) {
    const Vec3d shift = panel.normal * move;
    return std::all_of(panel.points.begin(), panel.points.end(), [&](const Vec3d& p) {
        return body.contact((p + shift).cast<float>()).distance >= static_cast<float>(kClearance);
    });
}

// The smallest move that clears the panel; nullopt when even the longest does not.
std::optional<double> clearing_move(const PlacedPanel& panel, const BodyCollider& body) {
    for (double move = 0; move <= kLongestMove; move += kMoveStep) {
        if (is_clear(panel, move, body)) return move;
    }
    return std::nullopt;
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

// Maximum depth of the line from a to b inside the body, m.
double blocked_depth(const Vec3d& a, const Vec3d& b, const BodyCollider& body) {
    constexpr int kSamples = 16;
    double deepest = 0;
    for (int i = 1; i < kSamples; ++i) {
        const Vec3d p = a + (b - a) * (i / double(kSamples));
        deepest = std::max(deepest, -static_cast<double>(body.contact(p.cast<float>()).distance));
    }
    return deepest;
}

// Sum of squared depths: one deep seam is worse than several shallow ones. Depths are capped at 4 cm, because a deeper
// one, as for a tight skirt around spread legs, cannot be cured by a lift.
double blocked_cost(const GarmentMesh& unsewn, double lift, const BodyCollider& body) {
    constexpr double kDeepest = 0.04;  // m
    const Vec3d up(0, lift, 0);
    double cost = 0;
    for (const SeamLink& link : unsewn.links) {
        const Vec3d& a = unsewn.x[static_cast<std::size_t>(link.a)];
        const Vec3d& b = unsewn.x[static_cast<std::size_t>(link.b)];
        const double depth = std::min(kDeepest, blocked_depth(a + up, b + up, body));
        cost += depth * depth;
    }
    return cost;
}

}  // namespace

// Beyond a maximum of the cost, a sleeve may lie wholly on the wrong side of the arm, where the cost is low again. A
// lift beyond such a maximum is accepted only if the seams are practically clear there.
double seam_clearing_lift(const GarmentMesh& unsewn, const BodyCollider& body) {
    constexpr int kStepsEachWay = 12;
    constexpr double kStep = 0.01;               // m
    constexpr double kWorthPerStep = 0.05;       // of the initial cost, which each step must save at least
    constexpr double kHump = 1.2, kClear = 0.1;  // of the initial cost
    const double as_placed = blocked_cost(unsewn, 0, body);
    if (as_placed <= 0) return 0;
    double best = 0;
    double least = as_placed;
    for (const double way : {kStep, -kStep}) {
        bool is_behind = false;
        for (int i = 1; i <= kStepsEachWay; ++i) {
            const double cost = blocked_cost(unsewn, i * way, body);
            is_behind |= cost > kHump * as_placed;
            const double with_way = cost + i * kWorthPerStep * as_placed;
            if (with_way >= least || (is_behind && cost > kClear * as_placed)) continue;
            least = with_way;
            best = i * way;
        }
    }
    return best;
}

void anchor_panels(Pattern& pattern, const Body& from, const Body& onto) {
    const HeightRange a = height_range(from);
    const HeightRange b = height_range(onto);
    const double ratio = (b.high - b.low) / (a.high - a.low);
    for (Panel& panel : pattern.panels) {
        const Vec3d centre = panel_centre(panel);
        const double level = b.low + (centre.y() - a.low) * ratio;
        panel.translation += torso_centre(onto, level) - torso_centre(from, centre.y());
    }
}

std::vector<std::string> clear_panels(GarmentMesh& unsewn, const BodyCollider& body) {
    std::vector<std::string> notes;
    const std::vector<PlacedPanel> panels = placed_panels(unsewn);
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const std::optional<double> move = clearing_move(panels[i], body);
        const std::string name = "panel '" + unsewn.panel_names[i] + "'";
        if (!move) notes.push_back(name + " stands in the body, and nowhere near is clear of it");
        if (!move || *move == 0) continue;
        move_panel(unsewn, i, panels[i].normal * *move);
        const long millimetres = std::lround(*move * 1000);
        notes.push_back(name + " moved " + std::to_string(millimetres) + " mm outward, clear of the body");
    }
    return notes;
}

std::vector<std::string> make_sewable(GarmentMesh& unsewn, const BodyCollider& body) {
    std::vector<std::string> notes;
    const double lift = seam_clearing_lift(unsewn, body);
    for (Vec3d& x : unsewn.x) x.y() += lift;
    if (lift != 0) {
        const std::string millimetres = std::to_string(std::lround(std::abs(lift) * 1000));
        notes.push_back("all panels moved " + millimetres + (lift > 0 ? " mm up" : " mm down") +
                        ", so that the seams can close round the body");
    }
    for (std::string& note : clear_panels(unsewn, body)) notes.push_back(std::move(note));
    return notes;
}

}  // namespace selvedge::sim
