#pragma once
// A half front with an upright dart in its waist and a level one in its side, both sewn.
#include <cmath>

#include "sim/pattern/pattern.h"

namespace selvedge::sim {

inline Vec2d turned_about(const Vec2d& centre, const Vec2d& p, double angle) {
    return centre + Eigen::Rotation2Dd(angle) * (p - centre);
}

// Edges: 0 waist before the dart, 1 and 2 its legs, 3 waist after it, 4 side below the dart, 5 and 6 its legs, 7 side
// above it, 8 top, 9 middle. The middle is at x = 0.
inline Panel darted_panel() {
    const Vec2d waist_tip(0.12, 0.14), waist_begin(0.10, -0.004), side_tip(0.16, 0.22), side_begin(0.25, 0.16);
    Panel panel;
    panel.name = "front";
    panel.vertices = {{0, 0},        waist_begin, waist_tip, turned_about(waist_tip, waist_begin, 0.3),
                      {0.24, 0.012}, side_begin,  side_tip,  turned_about(side_tip, side_begin, 0.5),
                      {0.25, 0.36},  {0, 0.38}};
    for (int e = 0; e < 10; ++e) panel.edges.push_back({.start = e, .end = (e + 1) % 10});
    return panel;
}

inline Pattern darted_pattern() {
    Pattern pattern;
    pattern.name = "darts";
    pattern.panels = {darted_panel()};
    pattern.seams = {{{0, 1}, {0, 2}}, {{0, 5}, {0, 6}}};
    return pattern;
}

}  // namespace selvedge::sim
