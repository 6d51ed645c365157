#include "sim/mesh/plain_mesh.h"

#include <gtest/gtest.h>

namespace selvedge::sim {
namespace {

// Two triangles that share an edge along y: one faces +z, the other, with twice the area, faces +x.
PlainMesh ridge() {
    PlainMesh mesh;
    mesh.x = {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, -2}};
    mesh.triangles = {{0, 1, 2}, {0, 3, 1}};
    return mesh;
}

TEST(VertexNormals, point_to_the_side_from_which_triangles_run_counter_clockwise) {
    const std::vector<Vec3f> normals = vertex_normals(ridge());
    ASSERT_EQ(normals.size(), 4U);
    EXPECT_TRUE(normals[2].isApprox(Vec3f(0, 0, 1))) << normals[2].transpose();
    EXPECT_TRUE(normals[3].isApprox(Vec3f(1, 0, 0))) << normals[3].transpose();
}

TEST(VertexNormals, are_unit_and_lean_to_the_larger_triangle) {
    const std::vector<Vec3f> normals = vertex_normals(ridge());
    EXPECT_TRUE(normals[0].isApprox(Vec3f(2, 0, 1).normalized())) << normals[0].transpose();
}

TEST(VertexNormals, point_up_where_a_vertex_has_no_area_round_it) {
    const std::vector<Vec3f> normals = vertex_normals({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 5, 5}}, {{0, 1, 2}});
    EXPECT_EQ(normals, std::vector<Vec3f>(4, Vec3f(0, 1, 0)));
}

TEST(VertexNormals, are_the_meshs_own_where_it_has_one_for_each_vertex) {
    PlainMesh mesh = ridge();
    mesh.normals.assign(4, Vec3f::UnitX());
    EXPECT_EQ(vertex_normals(mesh), mesh.normals);
    mesh.normals.pop_back();
    EXPECT_EQ(vertex_normals(mesh), vertex_normals(ridge()));
}

}  // namespace
}  // namespace selvedge::sim
