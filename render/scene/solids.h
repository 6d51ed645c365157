#pragma once
// Balls and tubes of coloured triangles, for marks on cloth, and the 3D model of a triangle hierarchy.
#include <vector>

#include "render/scene/scene.h"
#include "sim/mesh/draw_mesh.h"

namespace selvedge::render {

// How often the icosahedron's 20 triangles are cut into four: 80 or 320 triangles.
enum class BallDetail { Coarse = 1, Fine = 2 };

void add_ball(SolidItem& solid, const Vec3f& centre, float radius, const sim::Rgb8& colour, BallDetail detail);

// A tube along a polyline, with round ends. Points that coincide with the previous one are skipped.
void add_tube(SolidItem& solid, const std::vector<Vec3f>& path, float radius, const sim::Rgb8& colour);

// A straight tube without end caps, for thin lines. Adds nothing if both ends coincide.
void add_rod(SolidItem& solid, const Vec3f& from, const Vec3f& to, float radius, const sim::Rgb8& colour);

// The three edges of a triangle as tubes without end caps.
void add_outline(SolidItem& solid, const std::array<Vec3f, 3>& triangle, float radius, const sim::Rgb8& colour);

// The triangle hierarchy as a 3D model: the panels lie flat, and beside them the levels are stacked. The height of a
// triangle in the stack is proportional to its level.  (thesis fig. 3.17)

// Where the stack stands relative to the flat panels.
enum class StackSide { Right, Behind };

struct HierarchyModel {
    sim::DrawMesh mesh;  // the leaves twice: flat on y = 0, and in the stack; with their levels
    struct Outline {
        std::array<Vec3f, 3> x;
        int level = 0;
    };
    std::vector<Outline> refined;  // in the stack, triangles that are not leaves
    float panel_size = 1;          // m, the larger side of the layout of all panels
};

// Lays the panels out in rows by their material coordinates. Pre: hierarchy is not empty.
HierarchyModel model_hierarchy(const sim::TriangleHierarchy& hierarchy, StackSide side);

}  // namespace selvedge::render
