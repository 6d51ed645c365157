#pragma once
// Places the panels of a garment in the unit square of a texture: one chart per panel, all at one scale, turned by a
// quarter turn or not at all, so that yarns stay along the rows or columns of the texture.
//
// The bounding boxes are packed by the skyline method, bottom-left (Jylänki 2010, "A Thousand Ways to Pack the Bin",
// 2.3), longest side first. A bisection finds the largest scale at which all of them fit. Boxes begin and end at whole
// texels. The result is the same for the same boxes.
#include <span>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

struct AtlasOptions {
    int size_px = 2048;  // side of the square, 16 to 16384
    int margin_px = 8;   // round each chart: charts are two margins apart, so that mipmaps do not mix them
};

// From material coordinates (m) to texture coordinates in the unit square, v upward.
struct UvChart {
    double scale = 1;              // 1/m
    bool is_turned = false;        // a quarter turn anticlockwise: along the weft is up
    Vec2d offset = Vec2d::Zero();  // texture coordinates of the material coordinates (0, 0)

    Vec2d uv(const Vec2d& material) const;
    Vec2d material(const Vec2d& uv) const;

    bool operator==(const UvChart&) const = default;
};

// Whether the numbers of a chart that was read can be those of a garment, so that coordinates stay finite.
bool is_sound(const UvChart& chart);

using MaterialBox = Eigen::AlignedBox2d;  // m, not empty

// One chart per box, in their order, all of the same scale; a box without area is a point or a line.
// Throws InputError("", "texture size", ...) if the size has no room for so many charts with their margins.
// Pre: sizes are in range and numbers are finite.
std::vector<UvChart> pack_charts(std::span<const MaterialBox> boxes, const AtlasOptions& options = {});

}  // namespace selvedge::sim
