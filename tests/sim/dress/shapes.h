#pragma once
// Patterns shared by the tests of sim/dress: small ones, and those that ship.
#include <filesystem>
#include <string>
#include <vector>

#include "sim/pattern/pattern.h"
#include "sim/pattern/pattern_file.h"
#include "tests/support/checkout.h"

namespace selvedge::sim::test {

inline Pattern shipped(const std::string& name) {
    return load_pattern(std::filesystem::path(source_folder()) / "patterns" / (name + ".json")).pattern;
}

// Edges: 0 bottom, 1 right, 2 top, 3 left. The lower edge is at height y, the panel's centre at x = 0. A back panel is
// mirrored, so that its right side faces -z.
struct RectangleOptions {
    double width = 0.4;   // m
    double height = 0.3;  // m
    double y = 1.0;       // m
    double z = 0.15;      // m
    bool is_back = false;
};

inline Panel rectangle(const std::string& name, const RectangleOptions& options) {
    Panel panel;
    panel.name = name;
    const double half = options.width / 2;
    panel.vertices = {Vec2d(-half, 0), Vec2d(half, 0), Vec2d(half, options.height), Vec2d(-half, options.height)};
    for (int i = 0; i < 4; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 4});
    panel.translation = Vec3d(0, options.y, options.z);
    panel.is_mirrored = options.is_back;
    return panel;
}

// Front and back, sewn along both sides to a tube. Seam 0 is on the body's left.
inline Pattern tube(double width, double height, double y, double distance) {
    Pattern pattern;
    pattern.name = "tube";
    pattern.panels = {rectangle("front", {.width = width, .height = height, .y = y, .z = distance}),
                      rectangle("back", {.width = width, .height = height, .y = y, .z = -distance, .is_back = true})};
    pattern.seams = {{.first = {0, 1}, .second = {1, 3}}, {.first = {0, 3}, .second = {1, 1}}};
    return pattern;
}

// Front and back, sewn along their upper edges to a tabard.
inline Pattern tabard(double width, double height, double y, double distance) {
    Pattern pattern = tube(width, height, y, distance);
    pattern.name = "tabard";
    pattern.seams = {{.first = {0, 2}, .second = {1, 2}}};
    return pattern;
}

}  // namespace selvedge::sim::test
