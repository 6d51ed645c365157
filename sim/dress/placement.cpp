#include "sim/dress/placement.h"

#include <algorithm>
#include <cmath>

#include "sim/body/collider.h"
#include "sim/body/section.h"
#include "sim/pattern/outline.h"

namespace selvedge {
namespace {

constexpr double kClearance = 0.01;    // m, between a placed panel and the body
constexpr double kLongestMove = 0.40;  // m
constexpr double kMoveStep = 0.01;     // m

// Mean of the panel's outline vertices in the room: its level and side.
Vec3d panel_centre(const Panel& panel) {
    Vec3d sum = Vec3d::Zero();
    for (const Vec2d& u : panel.vertices) sum += panel.place(u);
    return sum / static_cast<double>(std::max<std::size_t>(1, panel.vertices.size()));
}

// Centre of the torso at a level between knee and neck; arms and legs are other loops.
Vec3d torso_centre(const Body& body, double y) {
    const HeightRange height = height_range(body);
    const double stature = height.high - height.low;
    const double level = std::clamp(y, height.low + 0.52 * stature, height.low + 0.80 * stature);
    const Plane plane{.point = Vec3d(0, level, 0)};
    const auto loop = nearest_loop(section(body, plane), Vec3d(0, level, 0));
    const Vec3d centre = loop ? loop->centre : Vec3d(0, level, 0);
    return {centre.x(), y, centre.z()};
}

std::vector<Vec3d> sample_panel(const Panel& panel) {
    constexpr int kSteps = 24;  // across the larger side of the panel's box
    Vec2d low = panel.vertices.front();
    Vec2d high = low;
    for (const Vec2d& u : panel.vertices) {
        low = low.cwiseMin(u);
        high = high.cwiseMax(u);
    }
    std::vector<Vec3d> points;
    for (const OutlineEdge& edge : panel.edges) {
        for (int i = 0; i < kSteps; ++i) points.push_back(panel.place(outline_point(panel, edge, i / double(kSteps))));
    }
    // Between opposite outline points lies the panel: chords to the box's centre are enough to see a body poke through.
    const Vec3d centre = panel.place((low + high) * 0.5);
    const std::size_t outline = points.size();
    for (std::size_t i = 0; i < outline; ++i) {
        for (int k = 1; k < 8; ++k) points.push_back(points[i] + (centre - points[i]) * (k / 8.0));
    }
    return points;
}

bool is_clear(const std::vector<Vec3d>& points, const Vec3d& shift, const BodyCollider& body) {
    return std::all_of(points.begin(), points.end(), [&](const Vec3d& p) {
        return body.contact((p + shift).cast<float>()).distance >= static_cast<float>(kClearance);
    });
}

// How deep the line from a to b runs through the body at its deepest, m.
double blocked_depth(const Vec3d& a, const Vec3d& b, const BodyCollider& body) {
    constexpr int kSamples = 16;
    double deepest = 0;
    for (int i = 1; i < kSamples; ++i) {
        const Vec3d p = a + (b - a) * (i / double(kSamples));
        deepest = std::max(deepest, -static_cast<double>(body.contact(p.cast<float>()).distance));
    }
    return deepest;
}

// Squares: one seam held far back is worse than several that slide a little.
double blocked_cost(const GarmentMesh& unsewn, double lift, const BodyCollider& body) {
    const Vec3d up(0, lift, 0);
    double cost = 0;
    for (const SeamLink& link : unsewn.links) {
        const Vec3d& a = unsewn.x[static_cast<std::size_t>(link.a)];
        const Vec3d& b = unsewn.x[static_cast<std::size_t>(link.b)];
        const double depth = blocked_depth(a + up, b + up, body);
        cost += depth * depth;
    }
    return cost;
}

}  // namespace

double seam_clearing_lift(const GarmentMesh& unsewn, const BodyCollider& body) {
    constexpr int kStepsEachWay = 12;
    constexpr double kStep = 0.01;  // m
    double best = 0;
    double least = blocked_cost(unsewn, 0, body);
    for (int i = 1; i <= kStepsEachWay && least > 0; ++i) {
        for (const double lift : {i * kStep, -i * kStep}) {
            const double cost = blocked_cost(unsewn, lift, body);
            if (cost >= least) continue;
            least = cost;
            best = lift;
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

std::vector<std::string> clear_panels(Pattern& pattern, const BodyCollider& body) {
    std::vector<std::string> notes;
    for (Panel& panel : pattern.panels) {
        const std::vector<Vec3d> points = sample_panel(panel);
        const Vec3d normal = panel.rotation * Vec3d(0, 0, panel.is_mirrored ? -1 : 1);
        for (double move = 0; move <= kLongestMove; move += kMoveStep) {
            if (!is_clear(points, normal * move, body)) continue;
            panel.translation += normal * move;
            if (move > 0) {
                notes.push_back("panel '" + panel.name + "' moved " +
                                std::to_string(static_cast<int>(std::lround(move * 1000))) +
                                " mm outward, clear of the body");
            }
            break;
        }
    }
    return notes;
}

}  // namespace selvedge
