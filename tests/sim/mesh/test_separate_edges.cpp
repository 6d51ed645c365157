#include <gtest/gtest.h>

#include "sim/mesh/assemble.h"
#include "sim/mesh/check_mesh.h"
#include "sim/mesh/separate_edges.h"
#include "tests/sim/mesh/shapes.h"

namespace selvedge {
namespace {

// One square of two triangles, and its corner vertices in order.
void add_square(GarmentMesh& mesh, const Vec3d& shift) {
    const auto first = static_cast<int>(mesh.x.size());
    const std::vector<Vec2d> u{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (const Vec2d& p : u) mesh.x.push_back(Vec3d(p.x(), p.y(), 0) + shift);
    mesh.triangles.push_back({{first, first + 1, first + 2}, {u[0], u[1], u[2]}, 0});
    mesh.triangles.push_back({{first, first + 2, first + 3}, {u[0], u[2], u[3]}, 0});
}

GarmentMesh named(GarmentMesh mesh) {
    mesh.panel_names = {"square"};
    mesh.panel_grain_angles = {0};
    return mesh;
}

double total_area(const GarmentMesh& mesh) {
    double area = 0;
    for (const GarmentTriangle& t : mesh.triangles) area += area_of(t.u);
    return area;
}

TEST(SeparateCoincidingEdges, leaves_a_mesh_alone_that_sews_well) {
    GarmentMesh mesh = named({});
    add_square(mesh, {0, 0, 0});
    add_square(mesh, {1, 0, 0});
    mesh.links = {{1, 4, 0}, {2, 7, 0}};
    EXPECT_EQ(separate_coinciding_edges(mesh), 0);
    EXPECT_EQ(mesh.triangles.size(), 4U);
}

TEST(SeparateCoincidingEdges, keeps_two_diagonals_apart_whose_ends_are_sewn_together) {
    GarmentMesh mesh = named({});
    add_square(mesh, {0, 0, 0});
    add_square(mesh, {0, 0, 0});
    mesh.links = {{0, 6, 0}, {1, 5, 0}, {2, 4, 0}};  // the diagonals 0-2 and 4-6 would become one edge
    EXPECT_FALSE(check_mesh(merge_seams(mesh).mesh).empty());
    EXPECT_EQ(separate_coinciding_edges(mesh), 2);
    const GarmentMesh sewn = merge_seams(mesh).mesh;
    const auto faults = check_mesh(sewn);
    EXPECT_TRUE(faults.empty()) << faults[0];
    EXPECT_NEAR(total_area(sewn), 2, 1e-12);
}

TEST(SeparateCoincidingEdges, saves_a_corner_triangle_whose_two_outline_edges_are_sewn_together) {
    GarmentMesh mesh = named({});
    add_square(mesh, {0, 0, 0});
    mesh.links = {{0, 2, 0}};  // 0-1 onto 2-1: the diagonal 0-2 would vanish
    EXPECT_FALSE(check_mesh(merge_seams(mesh).mesh).empty());
    EXPECT_GT(separate_coinciding_edges(mesh), 1);
    const GarmentMesh sewn = merge_seams(mesh).mesh;
    const auto faults = check_mesh(sewn);
    EXPECT_EQ(faults.size(), 0U) << faults[0];
    EXPECT_NEAR(total_area(sewn), 1, 1e-12);
}

}  // namespace
}  // namespace selvedge
