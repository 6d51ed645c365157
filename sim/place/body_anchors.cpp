#include "sim/place/body_anchors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/body/section.h"
#include "sim/pattern/outline.h"
#include "sim/place/limbs.h"

namespace selvedge::sim {
namespace {

// The height of the highest place of the body within 1.5 cm of that x, up to a limit, m.
double highest_beside(const Body& body, double x, double limit) {
    constexpr double kBeside = 0.015;  // m
    double high = -std::numeric_limits<double>::infinity();
    for (const Vec3d& p : body.x) {
        if (std::abs(p.x() - x) < kBeside && p.y() <= limit) high = std::max(high, p.y());
    }
    return high;
}

}  // namespace

Anchors anchors_of(const Body& body, const Stature& stature) {
    constexpr double kNeckSide = 0.845, kCrotch = 0.47;  // of the stature (the mannequin's proportions)
    Anchors anchors;
    const TorsoHeights heights = torso_heights(body, stature);
    const LandmarkHeights landmarks = find_landmarks(body);
    anchors.shoulder = stature.floor + kNeckSide * stature.height();
    anchors.waist = heights.waist;
    anchors.hip = heights.hip;
    anchors.crotch = landmarks.crotch.value_or(stature.floor + kCrotch * stature.height());
    Eigen::AlignedBox3d box;
    for (const double y : {heights.chest, heights.waist, heights.hip}) {
        for (const Vec3d& p : trunk_points(body, y, stature.height())) box.extend(p);
    }
    if (box.isEmpty()) box.extend(Vec3d(0, heights.waist, 0));
    anchors.centre = Vec3d(box.center().x(), heights.waist, box.center().z());
    anchors.front = box.max().z();
    anchors.back = box.min().z();
    return anchors;
}

TrunkSection trunk_section(const Body& body, double y, double stature) {
    TrunkSection section;
    SectionLoop loop;
    loop.points = trunk_points(body, y, stature);
    if (loop.points.empty()) return section;
    section.centre = middle_of_box(loop.points);
    for (const Vec3d& p : loop.points) section.reach = std::max(section.reach, (p - section.centre).norm());
    section.girth = tape_length(loop, {.point = section.centre, .normal = Vec3d::UnitY()});
    return section;
}

double resting_height(const Body& body, const Anchors& anchors, const Stature& stature, double length) {
    constexpr double kStep = 0.005;  // m
    double y = anchors.waist;
    while (y - kStep > anchors.hip && trunk_section(body, y, stature.height()).girth < length) y -= kStep;
    return y;
}

double lift_over_shoulders(const Body& body, const Anchors& anchors, const Panel& panel, std::span<const int> edges) {
    constexpr double kOver = 0.005, kLevel = 0.75;  // m; least run of a level edge over its length
    double lift = 0;
    for (const int e : edges) {
        const OutlineEdge& edge = panel.edges[static_cast<std::size_t>(e)];
        const Vec2d along = outline_point(panel, edge, 1) - outline_point(panel, edge, 0);
        if (-along.x() < kLevel * along.norm()) continue;  // counter-clockwise: upper edges run to the left
        for (const double t : {0.0, 0.5, 1.0}) {
            const Vec3d at = panel.place(outline_point(panel, edge, t));
            lift = std::max(lift, highest_beside(body, at.x(), anchors.shoulder) + kOver - at.y());
        }
    }
    return lift;
}

}  // namespace selvedge::sim
