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
    cap.notches = {{1, 0.4, NotchKind::V, 2},
                   {2, 0.5, NotchKind::T, 1},
                   {3, 0.3, NotchKind::Castle, 1},
                   {4, 0.6, NotchKind::Slit, 1},
                   {0, 0.5, NotchKind::U, 3}};
    cap.internal_lines = {{"pocket line", {{0.1, 0.1}, {0.2, 0.1}, {0.2, 0.15}}, LineUse::Mark},
                          {"middle", {{0.15, 0}, {0.15, 0.4}}, LineUse::Fold}};
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
    pattern.seams = {{{0, 0}, {1, 0}, true, "hem & strip", true, "round & round"}, {{0, 1}, {0, 4}, false, "", false}};
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
