#pragma once
// Test patterns and panels, and checks that every edited pattern must pass.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include "editor/geometry/draft.h"
#include "editor/geometry/panel_edit.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/pattern_file.h"
#include "tests/support/checkout.h"

namespace selvedge::editor {

inline sim::Pattern shipped_pattern(const std::string& name) {
    return sim::load_pattern(std::filesystem::path(source_folder()) / "patterns" / (name + ".json")).pattern;
}

// A square with sides of 1 m; edges: bottom, right, top, left.
inline sim::Panel unit_square(const std::string& name = "square") {
    sim::Panel panel = make_rectangle({0, 0}, {1, 1});
    panel.name = name;
    return panel;
}

// Two squares: the right side of `left` (edge 1) is sewn to the left side of `right` (edge 3).
inline sim::Pattern two_squares() {
    sim::Pattern pattern;
    pattern.panels = {unit_square("left"), unit_square("right")};
    pattern.panels[1].translation.x() = 1.5;
    pattern.seams = {{.first = {0, 1}, .second = {1, 3}, .name = "middle"}};
    return pattern;
}

// symmetric_copies of one panel; returns the copy.
inline int symmetric_copy(sim::Pattern& pattern, int panel, bool is_linked, const Vec2d& shift) {
    return symmetric_copies(pattern, {panel}, is_linked, shift).front();
}

inline double edge_length(const sim::Pattern& pattern, const sim::SeamSide& side) {
    const sim::Panel& panel = pattern.panels[static_cast<std::size_t>(side.panel)];
    return outline_length(panel, panel.edges[static_cast<std::size_t>(side.edge)]);
}

inline Vec2d edge_point(const sim::Pattern& pattern, const sim::SeamSide& side, double t) {
    const sim::Panel& panel = pattern.panels[static_cast<std::size_t>(side.panel)];
    return outline_point(panel, panel.edges[static_cast<std::size_t>(side.edge)], t);
}

// Whether the pattern, saved and loaded again, has no error and the same panels and seams.
inline ::testing::AssertionResult can_be_saved(const sim::Pattern& pattern) {
    const std::string text = sim::write_pattern({pattern, {}});
    for (const sim::Fault& fault : sim::check_pattern_text(text, "draft.json")) {
        if (fault.severity == sim::Severity::Error) return ::testing::AssertionFailure() << describe(fault);
    }
    const sim::Pattern again = sim::parse_pattern(text, "draft.json").pattern;
    if (again.panels.size() != pattern.panels.size()) return ::testing::AssertionFailure() << "other panels";
    for (std::size_t i = 0; i < pattern.panels.size(); ++i) {
        if (again.panels[i].edges.size() != pattern.panels[i].edges.size() ||
            again.panels[i].notches.size() != pattern.panels[i].notches.size() ||
            again.panels[i].is_mirrored != pattern.panels[i].is_mirrored) {
            return ::testing::AssertionFailure() << "panel " << pattern.panels[i].name << " came back otherwise";
        }
    }
    if (again.seams != pattern.seams) return ::testing::AssertionFailure() << "other seams";
    return ::testing::AssertionSuccess();
}

}  // namespace selvedge::editor
