#include "sim/place/shoulder_top.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sim/body/vertical_line.h"
#include "sim/place/measured_body.h"

namespace selvedge::sim {
namespace {

using Corners = std::array<Vec3d, 3>;

// The triangles that reach above the height at that x.
std::vector<Corners> triangles_over(const Body& body, double x, double y) {
    std::vector<Corners> found;
    for (const std::array<int, 3>& triangle : body.triangles) {
        Corners corners;
        for (std::size_t i = 0; i < 3; ++i) corners[i] = body.x[static_cast<std::size_t>(triangle[i])];
        const auto [left, right] = std::minmax({corners[0].x(), corners[1].x(), corners[2].x()});
        const double top = std::max({corners[0].y(), corners[1].y(), corners[2].y()});
        if (left <= x && x <= right && top > y) found.push_back(corners);
    }
    return found;
}

// The first way out of the body above (x, y, z); none from where that is not inside. What comes after it is the head.
std::optional<double> way_out(const std::vector<Corners>& triangles, double x, double y, double z) {
    std::optional<VerticalMeeting> first;
    for (const Corners& corners : triangles) {
        const auto met = meet_vertical(corners, x, z);
        if (met && met->y > y && (!first || met->y < first->y)) first = met;
    }
    if (!first || !first->faces_up) return std::nullopt;
    return first->y;
}

}  // namespace

std::optional<double> find_shoulder_top(const MeasuredBody& body) {
    // Of the stature. Where shoulder seams lie, from the middle of the trunk; between places before and behind that;
    // a level of the chest.
    constexpr double kBeside = 0.058, kStep = 0.005, kChest = 0.75;
    constexpr int kSteps = 10;                         // to each side
    constexpr double kLowest = 0.77, kHighest = 0.92;  // of the stature, on people of any build
    const Proportions& proportions = body.proportions();
    const double stature = proportions.stature_by_trunk(), chest = proportions.at(kChest);
    const std::optional<SectionLoop> trunk = nearest_loop(body.sections().at(chest), Vec3d(0, chest, 0));
    if (!trunk) return std::nullopt;
    double sum = 0;
    for (const double side : {-1.0, 1.0}) {
        const double x = trunk->centre.x() + side * kBeside * stature;
        const std::vector<Corners> triangles = triangles_over(body.body(), x, chest);
        std::optional<double> top;
        for (int i = -kSteps; i <= kSteps; ++i) {
            const auto out = way_out(triangles, x, chest, trunk->centre.z() + i * kStep * stature);
            if (out && (!top || *out > *top)) top = out;
        }
        if (!top) return std::nullopt;
        sum += *top;
    }
    const double top = sum / 2;
    if (top < proportions.at(kLowest) || top > proportions.at(kHighest)) return std::nullopt;
    return top;
}

}  // namespace selvedge::sim
