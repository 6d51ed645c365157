#pragma once
// The unit of an SVG's root and the viewports within it. Programs count a pixel differently: CSS has 96 to the inch,
// Inkscape before 0.92 had 90, Illustrator has 72.
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "sim/paper/drawing.h"

namespace selvedge::sim {

struct SvgUnit {
    double pixels_per_inch = 96;
    std::optional<double> metres_per_unit = {};  // none: the file does not say
    std::vector<DrawingUnit> likely = {};        // where it says that it counts pixels, but not which
    Vec2d viewport = Vec2d::Zero();              // width and height of the root, units; 0: not stated
    Eigen::AlignedBox2d page = {};               // of the drawing, y down; empty: not stated
    std::string note = {};                       // of what was read from the program's own marks
};

SvgUnit svg_unit(const pugi::xml_document& document, const pugi::xml_node& root, bool is_freesewing);

// A length as units of the coordinates around it: "50%" of a reference, "3mm" by the pixels of an inch. 0 for text that
// is no length.
double svg_length(std::string_view text, double reference, double pixels_per_inch);

// The map from a viewport's own coordinates to those around it. box: its viewBox, four numbers, or empty for none;
// `fit` is its preserveAspectRatio.
Eigen::Affine2d viewport_map(const std::vector<double>& box, const Eigen::AlignedBox2d& place, std::string_view fit);

}  // namespace selvedge::sim
