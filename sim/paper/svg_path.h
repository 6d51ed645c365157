#pragma once
// Path data, basic shapes and transforms of SVG.  (W3C, "Scalable Vector Graphics 2", chapters 8 to 10; the conversion
// of elliptical arcs is that of its appendix B.2)
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/paper/drawing.h"
#include "sim/paper/path_builder.h"

namespace selvedge::sim {

// Draws path data, coordinates as in the file. keeps_circles: circular arcs stay arcs, for a map that keeps circles;
// otherwise all arcs become cubics. Returns what is wrong with the text, and where it begins; empty if all is well.
std::string draw_path_data(std::string_view data, bool keeps_circles, PathBuilder& pen);

// A closed ellipse with that centre.
void draw_ellipse(const Vec2d& centre, const Vec2d& radii, bool keeps_circles, PathBuilder& pen);

// "translate(2, 3) rotate(30)"; none if the text is wrong.
std::optional<Eigen::Affine2d> parse_transform(std::string_view text);

// A CSS transform: lengths in px, angles in deg, rad, grad or turn; also translateX() and its like. Nullopt for others.
std::optional<Eigen::Affine2d> parse_css_transform(std::string_view text);

// All numbers of a text, separated by blanks and commas; stops where there is none.
std::vector<double> parse_numbers(std::string_view text);

// A number with its unit: "210mm" gives 210 and "mm".
struct SvgLength {
    double value = 0;
    std::string_view unit = {};
};
std::optional<SvgLength> parse_length(std::string_view text);

}  // namespace selvedge::sim
