#pragma once
// The triangle hierarchy as a model to be looked at: the panels lie flat, and beside them the levels are stacked above
// each other, every triangle of level l at height l.  (thesis fig. 3.17)
#include <vector>

#include "sim/mesh/plain_mesh.h"
#include "sim/mesh/triangle_hierarchy.h"

namespace selvedge {

// Where the stack stands, seen from the flat panels.
enum class StackSide { Right, Behind };

struct HierarchyModel {
    PlainMesh mesh;  // leaves, twice: flat on y = 0, and in the stack; levels are kept
    struct Outline {
        std::array<Vec3f, 3> x;
        int level = 0;
    };
    std::vector<Outline> refined;  // in the stack
    float panel_size = 1;          // m, the greater side of all panels laid out
};

// Panels are laid out in rows, as they are in their material coordinates. Pre: hierarchy is not empty.
HierarchyModel model_hierarchy(const TriangleHierarchy& hierarchy, StackSide side);

}  // namespace selvedge
