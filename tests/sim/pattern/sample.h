#pragma once
// A small garment file as text, which tests modify to create faults.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/pattern/pattern_file.h"

namespace selvedge::sim {

// Front counter-clockwise, back clockwise, each 40 x 50 cm, sewn together along both sides.
inline std::string sample_text() {
    return R"({
 "pattern": {
  "panels": {
   "front": {"translation": [-20, 90.0, 18], "rotation": [0, 0, 0],
    "vertices": [[0, 0], [40, 0], [35, 50], [5, 50]],
    "edges": [{"endpoints": [0, 1], "curvature": {"type": "quadratic", "params": [[0.5, -0.05]]}},
              {"endpoints": [1, 2]},
              {"endpoints": [2, 3], "curvature": {"type": "circle", "params": [25, 0, 1]}, "label": "lower_interface"},
              {"endpoints": [3, 0]}]},
   "back": {"translation": [-20, 90, -16], "rotation": [0, 0, 0],
    "vertices": [[0, 0], [5, 50], [35, 50], [40, 0]],
    "edges": [{"endpoints": [0, 1]},
              {"endpoints": [1, 2], "curvature": {"type": "cubic", "params": [[0.3, 0.05], [0.7, 0.05]]}},
              {"endpoints": [2, 3]},
              {"endpoints": [3, 0]}]}},
  "stitches": [[{"panel": "front", "edge": 1}, {"panel": "back", "edge": 2}],
               [{"panel": "front", "edge": 3}, {"panel": "back", "edge": 0}]],
  "panel_order": ["front", "back"]},
 "parameters": {"unknown": {"value": 1.50, "range": [1e2, -0.0]}},
 "properties": {"curvature_coords": "relative", "normalized_edge_loops": true, "units_in_meter": 100}
})";
}

// The text with the first `from` replaced by `to`; fails the test if `from` is not found.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    if (at != std::string::npos) text.replace(at, from.size(), to);
    return text;
}

// What the check of a garment's text finds, a fault each.
inline std::vector<std::string> faults_of(const std::string& text) {
    std::vector<std::string> lines;
    for (const Fault& fault : check_pattern_text(text, "f.json")) lines.push_back(describe(fault));
    return lines;
}

}  // namespace selvedge::sim
