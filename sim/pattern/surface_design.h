#pragma once
// What a fabric shows: a tartan, one colour, a picture, or a test pattern. It lies on the material coordinates of the
// panels: its position p is a point there, and its size s is a length there.  (thesis 3.7.2, fig. 3.19)
#include <optional>
#include <string>
#include <string_view>

#include "sim/core/math.h"

namespace selvedge::sim {

class FaultReader;
struct JsonNode;

enum class DesignKind {
    Tartan,
    Colour,
    Picture,  // PNG or JPEG
    Test,     // squares with a mark at the position, which show place, size and direction
};

struct SurfaceDesign {
    DesignKind kind = DesignKind::Tartan;
    // Tartan: name or threadcount, empty for the default; Colour: #RRGGBB; Picture: canonical path, or as it was named.
    std::string source = {};
    // m, width of one repeat (a tartan's across its warp's stripes) or of the picture; none: the tartan's own size, or
    // kUsualDesignSize.
    std::optional<double> size = {};
    Vec2d position = Vec2d::Zero();  // m, (weft, warp): the lower left corner of the first repeat
    double rotation = 0;             // rad, of a picture or test pattern about the position, counter-clockwise
    bool is_repeated = true;         // false: a picture or test pattern is placed once
    std::string ground = {};         // #RRGGBB beside and behind a picture; empty: kUsualGround

    bool operator==(const SurfaceDesign&) const = default;
};

inline constexpr double kUsualDesignSize = 0.2;                       // m, of pictures and the test pattern
inline constexpr double kSmallestDesign = 0.001, kLargestDesign = 5;  // m, of SurfaceDesign::size
inline constexpr const char* kUsualGround = "#F4F1EA";

bool is_colour_text(std::string_view text);  // #RRGGBB

// Reads {"kind", "tartan" | "colour" | "file", "size", "position", "rotation", "repeats", "ground"}
// (patterns/FORMAT.md), and records its faults.
SurfaceDesign read_design(FaultReader& reader, const JsonNode& node);

}  // namespace selvedge::sim
