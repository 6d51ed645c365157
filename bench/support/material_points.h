#pragma once
// Points of a cloth named by their material coordinates, so that a gauge length means the same on any mesh.
#include <vector>

#include "sim/cloth/cloth.h"
#include "sim/core/vec.h"

namespace selvedge {

// Where the panel's point u (m) is now: interpolated in its leaf triangle, or in the nearest one when u lies a rounding
// error outside all of them.
Vec3d material_point(const Cloth& cloth, int panel, const Vec2d& u);

// The mean place of `count` points spread evenly from u to v, both ends included.
Vec3d mean_material_point(const Cloth& cloth, int panel, const Vec2d& u, const Vec2d& v, int count = 9);

}  // namespace selvedge
