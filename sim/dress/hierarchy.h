#pragma once
// The triangles of a cloth's adaptive mesh as plain data.
#include "sim/cloth/cloth.h"
#include "sim/mesh/triangle_hierarchy.h"

namespace selvedge {

// Base triangles in their order, each before what it was refined to.
TriangleHierarchy triangle_hierarchy(const Cloth& cloth);

}  // namespace selvedge
