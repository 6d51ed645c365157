#include "sim/exchange/thick_cloth.h"

#include <gtest/gtest.h>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim/exchange/mesh_file.h"
#include "tests/sim/exchange/two_panels.h"

namespace selvedge::sim {
namespace {

// Each edge has two triangles, which have it in opposite directions.
void expect_closed(const DrawMesh& solid) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const auto& triangle : solid.triangles)
        for (std::size_t k = 0; k < 3; ++k) ++uses[{triangle[k], triangle[(k + 1) % 3]}];
    for (const auto& [edge, count] : uses) {
        EXPECT_EQ(count, 1) << edge.first << " to " << edge.second;
        EXPECT_TRUE(uses.contains({edge.second, edge.first})) << edge.first << " to " << edge.second;
    }
}

double volume(const DrawMesh& solid) {
    double sum = 0;
    for (const auto& [a, b, c] : solid.triangles)
        sum += solid.x[a].cast<double>().dot(solid.x[b].cast<double>().cross(solid.x[c].cast<double>())) / 6;
    return sum;
}

double area(const DrawMesh& mesh) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        sum += 0.5 * (mesh.x[b] - mesh.x[a]).cross(mesh.x[c] - mesh.x[a]).cast<double>().norm();
    return sum;
}

DrawMesh flat() {
    DrawMesh mesh = two_panels();
    for (Vec3f& x : mesh.x) x.z() = 0;
    return mesh;
}

constexpr std::array kThickness{0.002F, 0.002F};

TEST(ThickCloth, is_a_closed_solid_of_the_clothes_area_times_its_thickness) {
    const DrawMesh mesh = flat();
    const DrawMesh solid = with_thickness(mesh, kThickness);
    EXPECT_EQ(solid.x.size(), 2 * mesh.x.size());
    EXPECT_EQ(solid.triangles.size(), 2 * mesh.triangles.size() + 2 * 6U) << "six border edges; the seam has no wall";
    expect_closed(solid);
    EXPECT_NEAR(volume(solid), area(mesh) * 0.002, 1e-8);
}

TEST(ThickCloth, has_its_sides_half_a_thickness_from_the_mesh) {
    const DrawMesh mesh = flat();
    const DrawMesh solid = with_thickness(mesh, kThickness);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3f& at = mesh.x[mesh.triangles[t][k]];
            const std::uint32_t front = solid.triangles[t][k];
            const std::uint32_t back = solid.triangles[mesh.triangles.size() + t][(3 - k) % 3];
            EXPECT_LT((solid.x[front] - at - Vec3f(0, 0, 0.001F)).norm(), 1e-7F);
            EXPECT_LT((solid.x[back] - at + Vec3f(0, 0, 0.001F)).norm(), 1e-7F);
            EXPECT_EQ(solid.normals[front], Vec3f(0, 0, 1));
            EXPECT_EQ(solid.normals[back], Vec3f(0, 0, -1));
        }
    }
}

TEST(ThickCloth, has_the_panels_and_material_coordinates_of_the_cloth_on_both_sides_and_the_walls) {
    const DrawMesh mesh = two_panels();
    const DrawMesh solid = with_thickness(mesh, kThickness);
    ASSERT_EQ(solid.u.size(), solid.triangles.size());
    ASSERT_EQ(solid.panel.size(), solid.triangles.size());
    EXPECT_EQ(solid.panel_names, mesh.panel_names);
    EXPECT_EQ(solid.panel_sett_offsets, mesh.panel_sett_offsets);
    const std::size_t count = mesh.triangles.size();
    for (std::size_t t = 0; t < count; ++t) {
        EXPECT_EQ(solid.u[t], mesh.u[t]);
        EXPECT_EQ(solid.panel[t], mesh.panel[t]);
        EXPECT_EQ(solid.panel[count + t], mesh.panel[t]);
        for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(solid.u[count + t][k], mesh.u[t][(3 - k) % 3]);
    }
    std::vector<PanelPart> thin = split_by_panel(mesh), thick = split_by_panel(solid);
    pack_panels(thin, {});
    pack_panels(thick, {});
    for (std::size_t panel = 0; panel < 2; ++panel) EXPECT_EQ(thin[panel].chart, thick[panel].chart);
}

TEST(ThickCloth, has_its_front_on_the_right_side_of_each_panel_where_a_seam_joins_right_to_wrong) {
    const DrawMesh mesh = sewn_right_to_wrong();
    const DrawMesh solid = with_thickness(mesh, kThickness);
    expect_closed(solid);
    EXPECT_EQ(solid.triangles.size(), 2 * mesh.triangles.size() + 2 * 6U);
    for (std::size_t t = 0; t < 2 * mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = solid.triangles[t];
        const Vec3f normal = (solid.x[b] - solid.x[a]).cross(solid.x[c] - solid.x[a]);
        for (const std::uint32_t v : {a, b, c}) EXPECT_GT(normal.dot(solid.normals[v]), 0) << "triangle " << t;
    }
}

TEST(ThickCloth, is_closed_where_parts_of_the_cloth_meet_only_in_a_vertex) {
    DrawMesh mesh;
    mesh.x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0.1F}, {0, -1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
    const DrawMesh solid = with_thickness(mesh, std::array{0.01F});
    EXPECT_EQ(solid.x.size(), 12U);
    EXPECT_TRUE(solid.u.empty());
    expect_closed(solid);
}

TEST(ThickCloth, is_as_thick_at_a_seam_as_its_panels_are_by_their_areas) {
    const DrawMesh mesh = flat();
    const DrawMesh solid = with_thickness(mesh, std::array{0.001F, 0.003F});
    const auto thickness_at = [&](std::size_t t, std::size_t k) {
        const std::uint32_t front = solid.triangles[t][k];
        return (solid.x[front] - solid.x[front ^ 1U]).norm();
    };
    EXPECT_NEAR(thickness_at(0, 0), 0.001, 1e-7);
    EXPECT_NEAR(thickness_at(2, 1), 0.003, 1e-7);
    EXPECT_NEAR(thickness_at(2, 0), (0.001 + 2 * 0.003) / 3, 1e-7) << "one triangle of the front, two of the sleeve";
    EXPECT_NEAR(thickness_at(0, 1), thickness_at(2, 0), 0) << "the same vertex";
}

}  // namespace
}  // namespace selvedge::sim
