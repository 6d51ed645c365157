#pragma once
// All triangles of an adaptive mesh, those that were refined too, as plain data: to be shown.  (thesis fig. 3.17)
#include <array>
#include <cstdint>
#include <vector>

#include "sim/core/vec.h"

namespace selvedge {

struct HierarchyTriangle {
    std::array<Vec2f, 3> u{Vec2f::Zero(), Vec2f::Zero(), Vec2f::Zero()};  // material coordinates, m
    std::uint16_t panel = 0;
    std::uint8_t level = 0;
    bool is_leaf = true;
};

using TriangleHierarchy = std::vector<HierarchyTriangle>;

}  // namespace selvedge
