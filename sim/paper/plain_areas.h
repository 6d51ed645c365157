#pragma once
// The closed shapes of a plain drawing as areas that lie in each other.
#include <optional>
#include <string>
#include <vector>

#include "sim/paper/plain_drawing.h"

namespace selvedge::sim {

struct PlainArea {
    std::size_t shape = 0;
    std::vector<Vec2d> points = {};  // of the outline, without the last, which would repeat the first
    Eigen::AlignedBox2d box = {};
    double area = 0;
    std::optional<std::size_t> parent = {};  // the smallest area around it
    bool is_left_out = false;                // it is no part, nor a line in one
};

// In the order of the shapes. An outline that is drawn twice is one area. Throws InputError for more than 3,000.
std::vector<PlainArea> find_areas(const std::vector<PlainShape>& shapes, const std::string& file);

// Whether one area runs inside another at a nearly constant distance: the sewing line in the cut line.
bool is_inset(const PlainArea& inner, const PlainArea& outer);

// As is_inset(), with the same distance everywhere: lines that a program drew beside each other. Sizes are uneven.
bool is_even_inset(const PlainArea& inner, const PlainArea& outer);

// Whether an area fills most of its box, as a frame with round corners, or with a notch for its title, does.
bool fills_its_box(const PlainArea& area);

// Whether straight edges, each along an axis, enclose a rectangle; within a hundredth of its size.
bool is_upright_rectangle(const PlainArea& area, const PlainShape& shape);

}  // namespace selvedge::sim
