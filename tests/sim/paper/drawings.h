#pragma once
// Small drawings as text, and comparisons, which the tests of sim/paper share.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/paper/drawing.h"

namespace selvedge::sim {

// A half front on the fold in FreeSewing's data: hem, side, armhole, shoulder, neck; a notch in the armhole.
inline std::string half_front_json() {
    return R"({"design": "test", "units": "mm", "sa": 10, "measurements": {"chest": 925, "shoulderSlope": 13},
"parts": {"test.front": {"paths": {
 "seam": {"class": "fabric", "ops": [
  {"type": "move", "to": [0, 600]}, {"type": "line", "to": [250, 600]}, {"type": "line", "to": [260, 250]},
  {"type": "curve", "to": [200, 40], "cp1": [200, 250], "cp2": [190, 120]}, {"type": "line", "to": [90, 10]},
  {"type": "curve", "to": [0, 100], "cp1": [85, 60], "cp2": [40, 100]}, {"type": "line", "to": [0, 600]},
  {"type": "close"}]},
 "sa": {"class": "fabric sa", "ops": [{"type": "move", "to": [0, 610]}, {"type": "line", "to": [260, 610]}]},
 "cutonfold": {"class": "note", "text": "plugin-annotations:cutOnFoldAndGrainline", "ops": [
  {"type": "move", "to": [0, 150]}, {"type": "line", "to": [15, 150]}, {"type": "line", "to": [15, 550]},
  {"type": "line", "to": [0, 550]}]}},
 "snippets": {"n": {"def": "bnotch", "at": [200, 40]}, "logo": {"def": "logo", "at": [9, 9]}}}}})";
}

// An SVG of that many millimetres, around some elements.
inline std::string svg(const std::string& elements, const std::string& attributes = "") {
    return "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink="
           "\"http://www.w3.org/1999/xlink\" width=\"400mm\" height=\"300mm\" viewBox=\"0 0 400 300\" " +
           attributes + ">\n" + elements + "\n</svg>\n";
}

inline bool is_finite(const Drawing& drawing) {
    for (const DrawnPart& part : drawing.parts) {
        for (const DrawnPath& path : part.paths) {
            for (const Vec2d& v : path.vertices) {
                if (!v.allFinite()) return false;
            }
            for (const OutlineEdge& edge : path.edges) {
                if (!edge.control[0].allFinite() || !edge.control[1].allFinite()) return false;
            }
        }
    }
    return true;
}

// Reads many damaged copies of a text: each gives finite numbers or an InputError. Returns how many were refused.
template <class Read>
int read_mutants(const std::string& text, int count, Read read) {
    std::mt19937 random(7);
    const auto below = [&](std::size_t most) { return static_cast<std::size_t>(random() % most); };
    int refused = 0;
    for (int i = 0; i < count; ++i) {
        std::string mutant = text;
        for (std::size_t k = 0; k <= below(3); ++k) {
            const std::size_t at = below(mutant.size()), length = std::min(below(30) + 1, mutant.size() - at);
            switch (random() % 4) {
                case 0:
                    mutant[at] = static_cast<char>(random() % 256);
                    break;
                case 1:
                    mutant.erase(at, length);
                    break;
                case 2:
                    mutant.insert(at, mutant.substr(at, length));
                    break;
                default:
                    mutant.replace(at, 1, "1e300");
                    break;
            }
            if (mutant.empty()) mutant = " ";
        }
        try {
            EXPECT_TRUE(is_finite(read(mutant))) << mutant;
        } catch (const InputError&) {
            ++refused;
        }
    }
    return refused;
}

// The one line with which a reader refuses a text; "nothing" if it takes it.
template <class Read>
std::string problem_of(const std::string& text, Read read) {
    try {
        read(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing";
}

// A group of DXF.
inline std::string dxf_group(int code, const std::string& value) {
    return std::to_string(code) + "\n" + value + "\n";
}

// The folder of real patterns; empty: there is none here.
inline std::filesystem::path real_patterns(const char* folder) {
    const char* data = std::getenv("SELVEDGE_TEST_DATA");
    return data ? std::filesystem::path(data) / folder : std::filesystem::path();
}

}  // namespace selvedge::sim
