#pragma once
// Balls and tubes of coloured triangles, by which things are marked on cloth.
#include <vector>

#include "render/scene/scene.h"
#include "sim/mesh/plain_mesh.h"

namespace selvedge::render {

// Triangles of a ball: 20 of an icosahedron, each cut in four so many times.
enum class BallDetail { Coarse = 1, Fine = 2 };

void add_ball(SolidItem& solid, const Vec3f& centre, float radius, const sim::Rgb8& colour, BallDetail detail);

// Along a path of points, round its bends, with round ends. Points that coincide with the one before are passed over.
void add_tube(SolidItem& solid, const std::vector<Vec3f>& path, float radius, const sim::Rgb8& colour);

// A straight tube without ends, for what is thin. Nothing where they coincide.
void add_rod(SolidItem& solid, const Vec3f& from, const Vec3f& to, float radius, const sim::Rgb8& colour);

// The edges of one triangle, as thin as that: three straight tubes.
void add_outline(SolidItem& solid, const std::array<Vec3f, 3>& triangle, float radius, const sim::Rgb8& colour);

// The triangle hierarchy as a model to be looked at: the panels lie flat, and beside them the levels are stacked above
// each other, every triangle of level l at height l.  (thesis fig. 3.17)

// Where the stack stands, seen from the flat panels.
enum class StackSide { Right, Behind };

struct HierarchyModel {
    sim::PlainMesh mesh;  // leaves, twice: flat on y = 0, and in the stack; levels are kept
    struct Outline {
        std::array<Vec3f, 3> x;
        int level = 0;
    };
    std::vector<Outline> refined;  // in the stack
    float panel_size = 1;          // m, the greater side of all panels laid out
};

// Panels are laid out in rows, as they are in their material coordinates. Pre: hierarchy is not empty.
HierarchyModel model_hierarchy(const sim::TriangleHierarchy& hierarchy, StackSide side);

}  // namespace selvedge::render
