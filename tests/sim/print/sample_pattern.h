#pragma once
// A pattern with every kind of edge, notch and line, for the tests of paper that goes out.
#include <filesystem>
#include <string>
#include <vector>

#include "sim/pattern/pattern.h"
#include "sim/pattern/pattern_file.h"
#include "tests/support/checkout.h"

namespace selvedge::sim {

// Two panels: a sleeve-like one with a line, a quadratic, a cubic and an arc, and a strip on the cross grain.
inline Pattern sample_pattern() {
    Panel cap;
    cap.name = "cap <Ärmel & \"x\">";
    cap.vertices = {{0, 0}, {0.3, 0}, {0.32, 0.25}, {0.15, 0.4}, {0.0, 0.2}};
    cap.edges.resize(5);
    for (int e = 0; e < 5; ++e) cap.edges[static_cast<std::size_t>(e)] = {e, (e + 1) % 5};
    cap.edges[1].kind = CurveKind::Quadratic;
    cap.edges[1].control[0] = {0.34, 0.12};
    cap.edges[2].kind = CurveKind::Cubic;
    cap.edges[2].control = {Vec2d(0.3, 0.33), Vec2d(0.22, 0.4)};
    cap.edges[3].kind = CurveKind::Arc;
    cap.edges[3].arc_radius = 0.2;
    cap.edges[0].allowance = 0.03;
    cap.edges[0].allowance_corner = AllowanceCorner::Mirrored;
    cap.notches = {{.edge = 1, .t = 0.4, .kind = NotchKind::V, .count = 2},
                   {.edge = 2, .t = 0.5, .kind = NotchKind::T, .count = 1},
                   {.edge = 3, .t = 0.3, .kind = NotchKind::Castle, .count = 1},
                   {.edge = 4, .t = 0.6, .kind = NotchKind::Slit, .count = 1},
                   {.edge = 0, .t = 0.5, .kind = NotchKind::U, .count = 3}};
    cap.internal_lines = {
        {.name = "pocket line", .points = {{0.1, 0.1}, {0.2, 0.1}, {0.2, 0.15}}, .use = LineUse::Mark},
        {.name = "middle", .points = {{0.15, 0}, {0.15, 0.4}}, .use = LineUse::Fold}};
    cap.drill_points = {{0.12, 0.2}};
    cap.grain_angle = 0.2;
    cap.pieces = 2;
    Panel strip;
    strip.name = "strip";
    strip.vertices = {{0, 0}, {0.5, 0}, {0.5, 0.06}, {0, 0.06}};
    strip.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    strip.grain_angle = 1.5707963267948966;
    Pattern pattern;
    pattern.name = "Hemd Größe";
    pattern.size = "40";
    pattern.allowance = 0.01;
    pattern.panels = {cap, strip};
    pattern.seams = {
        {.first = {0, 0}, .second = {1, 0}, .name = "hem & strip", .is_eased = true, .sewing = "round & round"},
        {.first = {0, 1}, .second = {0, 4}, .is_reversed = false}};
    return pattern;
}

inline std::vector<std::filesystem::path> shipped_patterns() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() + "/patterns")) {
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    }
    return files;
}

}  // namespace selvedge::sim
