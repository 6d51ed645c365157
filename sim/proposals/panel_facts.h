#pragma once
// What the evidence for seams needs to know of each panel: its role, its size, its symmetry, its mirror image.
#include <string_view>
#include <vector>

#include "sim/proposals/panel_role.h"

namespace selvedge::sim {

struct PanelFacts {
    PanelRole role;
    double axis = 0;               // x of the panel's middle, m
    double width = 0, height = 0;  // m
    bool is_symmetric = false;     // its right half mirrors its left one
    int twin = -1;                 // the panel that is its mirror image; -1: none
    bool has_other_face = false;   // another panel is the back of this front, or the front of this back
    double opening = 0;            // of a cuff: the mean length of the hems that it can edge, m; 0: not known
    bool is_outer = false;         // by its name, as in "frontOutside" and "side back"
    bool is_inner = false;         // "frontInside", "centre back"
    bool is_side = false;          // lies between front and back, as "side", at least half as high as they are
    bool has_side_panel = false;   // some panel of the garment is such a one
    bool has_opening = false;      // the garment is closed by buttons, its edges over each other; a zip joins them
    int rank = 0;                  // of panels that are numbered in a row, from 1 on: "panel3"; 0: it is of none
    int row_length = 0;            // how many these are, on one side of the body
};

inline constexpr double kWidestShoulder = 0.45;  // of the panel's width: what is left is for the neck

// Whether a point at this x, m, is at one of the panel's sides.
bool is_at_side(const PanelFacts& panel, double x);

std::vector<PanelFacts> facts_of(const Pattern& pattern, std::string_view hints);

}  // namespace selvedge::sim
