#pragma once
// Where a vertical line meets a surface.
#include <array>
#include <optional>

#include "sim/core/math.h"

namespace selvedge::sim {

struct VerticalMeeting {
    double y = 0;           // m
    bool faces_up = false;  // the triangle, by its winding
};

// Where the vertical line through (x, z), m, meets the triangle; none beside it, or if it is upright.
std::optional<VerticalMeeting> meet_vertical(const std::array<Vec3d, 3>& corners, double x, double z);

}  // namespace selvedge::sim
