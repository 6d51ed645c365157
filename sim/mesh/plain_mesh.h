#pragma once
// A mesh as drawn or exported: what is left of a garment when nothing moves any more. Whoever has leaves hands them
// over as this; renderer and exporters know no cloth.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/core/vec.h"

namespace selvedge {

struct PlainMesh {
    std::vector<Vec3f> x;        // positions, m
    std::vector<Vec3f> normals;  // per vertex, unit
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<Vec2f, 3>> u;  // per corner, m; empty when there are none
    std::vector<std::uint16_t> panel;     // per triangle; empty: one group
    std::vector<std::uint8_t> level;      // per triangle; empty: all 0
    std::vector<std::string> panel_names;
    std::vector<float> panel_grain_angles;  // rad
};

}  // namespace selvedge
