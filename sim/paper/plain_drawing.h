#pragma once
// A drawing without a pattern program's own structure: shapes, texts and marks on one sheet, as SVG and DXF without
// blocks have them. Which shapes are parts, and which are page frames, letters or lines in a part, plain_parts.h finds.
#include <optional>
#include <string>
#include <vector>

#include "sim/paper/drawing.h"

namespace selvedge::sim {

// A group or a layer on the way from the sheet to a shape.
struct PlainGroup {
    int number = 0;  // in the drawing, for comparing
    std::string id = {};
    std::string label = {};  // as its program shows it; empty: it has only an id
    bool is_layer = false;

    bool operator==(const PlainGroup&) const = default;
};

struct PlainShape {
    DrawnPath path;  // of kind Unknown where the file does not say
    std::vector<PlainGroup> groups = {};
    std::string classes = {};
    std::string style = {};       // equal for lines that are drawn alike: colour, dashes
    bool is_filled_only = false;  // without a line round it
};

struct PlainDrawing {
    std::vector<PlainShape> shapes = {};
    std::vector<DrawnText> texts = {};
    std::vector<DrawnMark> marks = {};
    std::optional<double> metres_per_unit = {};
    Eigen::AlignedBox2d page = {};  // empty: the file states none
};

}  // namespace selvedge::sim
