#pragma once
// Panels and setts for the tests of matching, and an independent measurement of the mismatch at seams.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "sim/pattern/outline.h"
#include "sim/pattern/pattern.h"
#include "sim/tartan/sett.h"

namespace selvedge::sim {

// A panel with straight edges through the points, which must be counter-clockwise.
inline Panel polygon_panel(const std::string& name, const std::vector<Vec2d>& points) {
    Panel panel;
    panel.name = name;
    panel.vertices = points;
    const auto count = static_cast<int>(points.size());
    for (int i = 0; i < count; ++i) {
        OutlineEdge edge;
        edge.start = i;
        edge.end = (i + 1) % count;
        panel.edges.push_back(edge);
    }
    return panel;
}

// Edges: 0 bottom, 1 right, 2 top, 3 left. `corner`: position of the lower left corner.
inline Panel box(const std::string& name, const Vec2d& corner, double width, double height) {
    return polygon_panel(name,
                         {corner, corner + Vec2d(width, 0), corner + Vec2d(width, height), corner + Vec2d(0, height)});
}

// Setts with a repeat of 100 threads of 0.5 mm = 5 cm: one is mirrored, the other has no mirror line.
inline Sett mirrored_sett() {
    Sett sett = parse_threadcount("K/20 R20 G5 W/30");
    sett.thread_spacing = 5e-4;
    return sett;
}
inline Sett one_way_sett() {
    Sett sett = parse_threadcount("K20 R30 G10 W40");
    sett.thread_spacing = 5e-4;
    return sett;
}

inline const Panel& panel_at(const Pattern& pattern, const SeamSide& side) {
    return pattern.panels[static_cast<std::size_t>(side.panel)];
}

// The position in the sett, m (weft, warp), at the fraction t of the edge's length from the start of the edge.
inline Vec2d sett_place(const Pattern& pattern, const SeamSide& side, double t) {
    const Panel& panel = panel_at(pattern, side);
    const Vec2d u = outline_point(panel, panel.edges[static_cast<std::size_t>(side.edge)], t);
    return Eigen::Rotation2Dd(-panel.grain_angle) * u + panel.sett_offset;
}

// The distance, m, from `to` to the nearest sett position that is equivalent to `from` (`is_mirrored`: equivalent to
// its mirror image). Brute force: compares the colours of all threads for every shift.
inline double colour_distance(const std::vector<Rgb8>& colours, double spacing, double from, double to,
                              bool is_mirrored) {
    const int count = static_cast<int>(colours.size());
    const auto thread = [&](int i) { return colours[static_cast<std::size_t>(((i % count) + count) % count)]; };
    const double repeat = count * spacing;
    double nearest = repeat;
    for (int shift = 0; shift < count; ++shift) {
        bool is_alike = true;
        for (int i = 0; i < count && is_alike; ++i) is_alike = thread(i) == thread(is_mirrored ? shift - i : i + shift);
        if (!is_alike) continue;
        const double image = is_mirrored ? (shift + 1) * spacing - from : from + shift * spacing;
        nearest = std::min(nearest, std::abs(std::remainder(to - image, repeat)));
    }
    return nearest;
}

// The largest mismatch of a seam, m, for the pattern's sett offsets: at 201 points, with directions from finite
// differences and by comparing colours.
inline double seen_mismatch(const Pattern& pattern, const Seam& seam, const Sett& sett) {
    constexpr int kSteps = 200;
    const auto place = [&](bool of_second, double t) {
        return sett_place(pattern, of_second ? seam.second : seam.first, of_second && seam.is_reversed ? 1 - t : t);
    };
    const std::vector<Rgb8> warp = thread_colours(sett), weft = weft_thread_colours(sett);
    Vec2d agreement = Vec2d::Zero();
    std::vector<Vec2d> crossing;
    for (int i = 0; i <= kSteps; ++i) {
        const double from = std::max(0, i - 1) / double(kSteps), to = std::min(kSteps, i + 1) / double(kSteps);
        const Vec2d first = (place(false, to) - place(false, from)).normalized();
        const Vec2d second = (place(true, to) - place(true, from)).normalized();
        agreement += first.cwiseProduct(second);
        crossing.push_back((first.cwiseAbs() + second.cwiseAbs()) / 2);
    }
    double largest = 0;
    for (int i = 0; i <= kSteps; ++i) {
        for (Eigen::Index f = 0; f < 2; ++f) {
            if (crossing[static_cast<std::size_t>(i)][f] < std::sin(15 * std::numbers::pi / 180)) continue;
            const double t = double(i) / kSteps;
            const std::vector<Rgb8>& colours = f == 0 ? warp : weft;
            double distance =
                colour_distance(colours, sett.thread_spacing, place(false, t)[f], place(true, t)[f], false);
            if (agreement[f] < 0) {
                const double mirrored =
                    colour_distance(colours, sett.thread_spacing, place(false, t)[f], place(true, t)[f], true);
                const double repeat = static_cast<double>(colours.size()) * sett.thread_spacing;
                if (mirrored < repeat) distance = mirrored;
            }
            largest = std::max(largest, distance);
        }
    }
    return largest;
}

}  // namespace selvedge::sim
