#include <gtest/gtest.h>
#include <cmath>
#include <limits>

#include "sim/mesh/draw_mesh.h"
#include "sim/mesh/garment_mesh.h"
#include "tests/support/right_wrong.h"

namespace selvedge::sim {
namespace {

// Four triangles around a central vertex.
GarmentMesh pinwheel() {
    GarmentMesh mesh;
    const std::vector<Vec2d> u{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}};
    for (const Vec2d& p : u) mesh.x.emplace_back(p.x(), p.y(), 0);
    for (int i = 0; i < 4; ++i) {
        const std::array<int, 3> v{i, (i + 1) % 4, 4};
        mesh.triangles.push_back({v, {u[std::size_t(v[0])], u[std::size_t(v[1])], u[4]}, 0});
    }
    mesh.panel_names = {"front"};
    mesh.panel_grain_angles = {0};
    return mesh;
}

void expect_fault(const GarmentMesh& mesh, const std::string& text) {
    const std::vector<std::string> faults = check_mesh(mesh);
    for (const std::string& fault : faults) {
        if (fault.find(text) != std::string::npos) return;
    }
    ADD_FAILURE() << "no fault says '" << text << "' among " << faults.size()
                  << (faults.empty() ? "" : ", the first: " + faults[0]);
}

TEST(CheckMesh, finds_nothing_wrong_with_a_sound_mesh) {
    EXPECT_TRUE(check_mesh(pinwheel()).empty());
}

TEST(CheckMesh, finds_indices_out_of_range) {
    GarmentMesh mesh = pinwheel();
    mesh.triangles[2].vertices[1] = 5;
    expect_fault(mesh, "triangle 2 (front): no such vertex");
    mesh = pinwheel();
    mesh.links.push_back({0, -1, 7});
    expect_fault(mesh, "seam 7: no such vertex");
    mesh = pinwheel();
    mesh.pins = {9};
    expect_fault(mesh, "pin: no vertex 9");
    mesh = pinwheel();
    mesh.triangles[0].panel = 1;
    expect_fault(mesh, "no panel");
}

TEST(CheckMesh, finds_triangles_without_area_turned_over_or_collapsed) {
    GarmentMesh mesh = pinwheel();
    mesh.triangles[0].u[2] = {0.3, 0};
    expect_fault(mesh, "triangle 0 (front): no area");
    mesh = pinwheel();
    mesh.triangles[1].u[2] = {1.5, 0.5};
    expect_fault(mesh, "triangle 1 (front): turned over");
    mesh = pinwheel();
    mesh.triangles[3].vertices[0] = 4;
    expect_fault(mesh, "triangle 3 (front): two corners are one vertex");
}

TEST(CheckMesh, finds_sides_on_wrong_lines_where_a_panel_has_lines) {
    GarmentMesh mesh = pinwheel();
    for (int i = 0; i < 4; ++i) mesh.triangles[std::size_t(i)].lines[0].edge = i;
    EXPECT_TRUE(check_mesh(mesh).empty());
    GarmentMesh other = mesh;
    other.triangles[2].lines[0] = {};
    expect_fault(other, "edge 2-3: at the border of triangle 2 (front), but on no outline edge");
    other = mesh;
    other.triangles[2].lines[1].edge = 3;
    expect_fault(other, "edge 3-4: inside triangle 2 (front), but on an outline edge");
    other = mesh;
    other.triangles[2].lines[0].edge = 0;
    expect_fault(other, "edge 0 of front: lies in 2 pieces");
}

TEST(CheckMesh, finds_an_edge_of_three_triangles) {
    GarmentMesh mesh = pinwheel();
    mesh.x.emplace_back(0, 0, 1);
    mesh.triangles.push_back({{0, 4, 5}, mesh.triangles[0].u, 0});
    expect_fault(mesh, "edge 0-4: 3 triangles meet");
}

TEST(CheckMesh, finds_neighbours_in_a_panel_that_face_opposite_sides) {
    GarmentMesh mesh = pinwheel();
    std::swap(mesh.triangles[0].vertices[0], mesh.triangles[0].vertices[1]);
    std::swap(mesh.triangles[0].u[0], mesh.triangles[0].u[1]);
    expect_fault(mesh, "face opposite sides");
}

TEST(CheckMesh, allows_a_seam_of_right_side_to_wrong_side) {
    GarmentMesh mesh = pinwheel();
    std::swap(mesh.triangles[0].vertices[0], mesh.triangles[0].vertices[1]);
    std::swap(mesh.triangles[0].u[0], mesh.triangles[0].u[1]);
    for (Vec2d& u : mesh.triangles[0].u) u.x() = -1 - u.x();
    EXPECT_TRUE(check_mesh(mesh).empty()) << check_mesh(mesh).front();
}

TEST(CheckMesh, finds_a_triangle_given_twice) {
    GarmentMesh mesh = pinwheel();
    mesh.triangles.push_back(mesh.triangles[1]);
    expect_fault(mesh, "triangle 4 (front): same corners as triangle 1");
}

TEST(CheckMesh, finds_vertices_of_no_triangle_and_of_two_fans) {
    GarmentMesh mesh = pinwheel();
    mesh.x.emplace_back(2, 2, 0);
    expect_fault(mesh, "vertex 5: belongs to no triangle");
    mesh.x.emplace_back(2, 1, 0);
    mesh.triangles.push_back({{2, 6, 5}, mesh.triangles[0].u, 0});
    expect_fault(mesh, "vertex 2: joins triangles that share no edge");
}

TEST(CheckMesh, finds_numbers_that_are_not_finite) {
    GarmentMesh mesh = pinwheel();
    mesh.x[1].z() = std::numeric_limits<double>::quiet_NaN();
    expect_fault(mesh, "vertex 1: no finite position");
    mesh = pinwheel();
    mesh.triangles[0].u[0].x() = std::numeric_limits<double>::infinity();
    expect_fault(mesh, "triangle 0 (front): no finite material");
}

// One triangle, deformed by a linear map of the plane.
DrawMesh mapped(const Eigen::Matrix2f& map, float grain) {
    DrawMesh mesh;
    const std::array<Vec2f, 3> u{Vec2f(0.1F, 0.2F), Vec2f(1.3F, 0.1F), Vec2f(0.4F, 0.9F)};
    for (const Vec2f& at : u) {
        const Vec2f x = map * at;
        mesh.x.emplace_back(x.x(), 2.0F, x.y());
    }
    mesh.triangles = {{0, 1, 2}};
    mesh.u = {u};
    mesh.panel = {0};
    mesh.panel_grain_angles = {grain};
    return mesh;
}

TEST(MeshStrain, is_the_stretch_of_the_panels_own_threads) {
    Eigen::Matrix2f map;
    map << 1.02F, 0.05F, 0.0F, 0.97F;
    for (const float grain : {0.0F, 0.4F, -1.2F, 1.5707963F}) {
        const Vec2f warp(-std::sin(grain), std::cos(grain)), weft(std::cos(grain), std::sin(grain));
        const std::vector<MeshStrain> strain = measure_strain(mapped(map, grain));
        ASSERT_EQ(strain.size(), 1U);
        EXPECT_NEAR(strain[0].warp, (map * warp).norm() - 1, 1e-5F) << grain;
        EXPECT_NEAR(strain[0].weft, (map * weft).norm() - 1, 1e-5F) << grain;
    }
}

TEST(MeshStrain, a_triangle_without_area_in_the_material_has_none) {
    DrawMesh mesh = mapped(Eigen::Matrix2f::Identity(), 0);
    mesh.u[0] = {Vec2f(0, 0), Vec2f(1, 1), Vec2f(2, 2)};
    EXPECT_EQ(measure_strain(mesh)[0].warp, 0);
    EXPECT_EQ(smooth_in_panels(mesh, {0.5F})[0][0], 0);
}

TEST(MeshStrain, smoothing_keeps_what_is_even_weighs_by_area_and_stops_at_seams) {
    DrawMesh mesh;
    mesh.x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 3, 0}, {-1, 0, 0}};
    mesh.triangles = {{0, 1, 2}, {1, 3, 2}, {0, 2, 4}};
    for (const auto& t : mesh.triangles)
        mesh.u.push_back({mesh.x[t[0]].head<2>(), mesh.x[t[1]].head<2>(), mesh.x[t[2]].head<2>()});
    mesh.panel = {0, 0, 1};
    const auto even = smooth_in_panels(mesh, {2, 2, 2});
    for (const auto& corners : even)
        for (const float value : corners) EXPECT_FLOAT_EQ(value, 2);
    const auto corners = smooth_in_panels(mesh, {0, 4, 10});
    EXPECT_FLOAT_EQ(corners[0][0], 0) << "one triangle of its panel only";
    EXPECT_FLOAT_EQ(corners[0][1], 3) << "areas are as one to three";
    EXPECT_FLOAT_EQ(corners[1][0], 3);
    EXPECT_FLOAT_EQ(corners[2][0], 10) << "another panel";
}

}  // namespace

namespace {

// Two triangles that share an edge along y: one faces +z, the other, with twice the area, faces +x.
DrawMesh ridge() {
    DrawMesh mesh;
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

TEST(VertexNormals, are_those_of_consistent_triangles_where_some_look_the_other_way) {
    DrawMesh mesh = ridge();
    EXPECT_TRUE(find_turned_corners(mesh.triangles).empty());
    mesh.triangles[1] = {0, 1, 3};
    mesh.turned_corners = find_turned_corners(mesh.triangles);
    EXPECT_EQ(mesh.turned_corners, (std::vector<std::uint8_t>{0, 3})) << "at the common vertices";
    const std::vector<Vec3f> normals = vertex_normals(mesh);
    EXPECT_TRUE(normals[0].isApprox(Vec3f(2, 0, 1).normalized())) << normals[0].transpose();
    EXPECT_TRUE(normals[3].isApprox(Vec3f(-1, 0, 0))) << "its only triangle's right side";
}

TEST(VertexNormals, of_a_moebius_band_never_cancel) {
    const GarmentMesh band = test::moebius_band(3);
    DrawMesh mesh;
    for (const Vec3d& x : band.x) mesh.x.emplace_back(x.cast<float>());
    for (const GarmentTriangle& t : band.triangles) {
        auto& triangle = mesh.triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) triangle[k] = static_cast<std::uint32_t>(t.vertices[k]);
    }
    mesh.turned_corners = find_turned_corners(mesh.triangles);
    const std::vector<Vec3f> normals = vertex_normals(mesh);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const Vec3f right = (mesh.x[b] - mesh.x[a]).cross(mesh.x[c] - mesh.x[a]).normalized();
        for (std::size_t k = 0; k < 3; ++k) {
            const float cosine = right.dot(normals[mesh.triangles[t][k]]);
            EXPECT_GT(is_turned(mesh, t, k) ? -cosine : cosine, 0.5F) << "triangle " << t << ", corner " << k;
        }
    }
}

TEST(VertexNormals, are_the_meshs_own_where_it_has_one_for_each_vertex) {
    DrawMesh mesh = ridge();
    mesh.normals.assign(4, Vec3f::UnitX());
    EXPECT_EQ(vertex_normals(mesh), mesh.normals);
    mesh.normals.pop_back();
    EXPECT_EQ(vertex_normals(mesh), vertex_normals(ridge()));
}

}  // namespace

}  // namespace selvedge::sim
