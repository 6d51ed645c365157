// The fixed mesh of an adaptive cloth: on cloths adapted at random, its samples equal those that a search through all
// leaves finds, and its topology never changes.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <random>
#include <set>

#include "sim/adaptive/adapt.h"
#include "sim/adaptive/check.h"
#include "sim/cloth/fixed_mesh.h"
#include "tests/sim/adaptive/fixtures.h"
#include "tests/sim/cloth/fixtures.h"
#include "tests/support/right_wrong.h"

namespace selvedge::sim::test {
namespace {

GarmentMesh with_names(GarmentMesh mesh) {
    for (const GarmentTriangle& t : mesh.triangles) {
        if (static_cast<std::size_t>(t.panel) < mesh.panel_names.size()) continue;
        mesh.panel_names.resize(static_cast<std::size_t>(t.panel) + 1, "panel");
        mesh.panel_grain_angles.resize(mesh.panel_names.size(), 0.2);
    }
    return mesh;
}

Cloth cloth_of(const GarmentMesh& mesh, int max_level) {
    return make_cloth(mesh, std::vector<Fabric>(mesh.panel_names.size(), find_fabric("cotton_shirting")),
                      {.max_level = max_level});
}

struct SpoilingMidpoints {
    Cloth& cloth;

    void on_capacity(std::size_t capacity) { size_state(cloth, capacity); }
    void on_split(VertexId c, VertexId a, VertexId b) { cloth.x[c.value] = (cloth.x[a.value] + cloth.x[b.value]) / 2; }
    void on_rejoin(VertexId c) { cloth.x[c.value].setConstant(1e9F); }  // nothing may read it
};

void adapt_at_random(Cloth& cloth, std::mt19937& random) {
    SpoilingMidpoints state{cloth};
    adapt(cloth.mesh, state, {}, RandomCriterion{random, 0.5, 0.4});
    ASSERT_TRUE(check(cloth.mesh).empty());
}

void move_at_random(Cloth& cloth, std::mt19937& random) {
    for (const VertexId v : cloth.mesh.leaf_vertices())
        for (int axis = 0; axis < 3; ++axis) cloth.x[v.value][axis] += draw(random, -0.02F, 0.02F);
}

// Barycentric coordinates of p in the triangle.
Vec3d barycentric(const std::array<Vec2f, 3>& u, const Vec2f& p) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k)
        corners.col(k) = Vec3d(u[static_cast<std::size_t>(k)].x(), u[static_cast<std::size_t>(k)].y(), 1);
    return corners.inverse() * Vec3d(p.x(), p.y(), 1);
}

// By a search through the leaves of that panel, in material coordinates. Pre: no two points of the panel have the same.
std::optional<Vec3d> found_in_leaves(const Cloth& cloth, std::uint16_t panel, const Vec2f& u) {
    for (const LeafTriangle& t : cloth.mesh.leaf_triangles()) {
        if (t.panel != panel) continue;
        const Vec3d weights = barycentric(t.u, u);
        if (weights.minCoeff() < -1e-5) continue;
        Vec3d x = Vec3d::Zero();
        for (std::size_t k = 0; k < 3; ++k)
            x += weights[static_cast<int>(k)] * cloth.x[t.v[k].value].head<3>().cast<double>();
        return x;
    }
    return std::nullopt;
}

double largest_difference_from_leaves(const FixedMesh& fixed, const Cloth& cloth) {
    std::vector<Vec3f> x;
    sample(fixed, cloth, x);
    double largest = 0;
    for (std::size_t t = 0; t < fixed.mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto expected = found_in_leaves(cloth, fixed.mesh.panel[t], fixed.mesh.u[t][k]);
            if (!expected) return 1e9;
            largest = std::max(largest, (x[fixed.mesh.triangles[t][k]].cast<double>() - *expected).norm());
        }
    }
    return largest;
}

GarmentMesh as_garment(const DrawMesh& mesh) {
    GarmentMesh garment;
    for (const Vec3f& x : mesh.x) garment.x.push_back(x.cast<double>());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        GarmentTriangle triangle{.panel = mesh.panel[t]};
        for (std::size_t k = 0; k < 3; ++k) {
            triangle.vertices[k] = static_cast<int>(mesh.triangles[t][k]);
            triangle.u[k] = mesh.u[t][k].cast<double>();
        }
        garment.triangles.push_back(triangle);
    }
    garment.panel_names = mesh.panel_names;
    garment.panel_grain_angles.assign(mesh.panel_names.size(), 0.0);
    return garment;
}

TEST(FixedMesh, of_randomly_adapted_cloth_equals_a_search_through_its_leaves) {
    GarmentMesh base = with_names(front_and_back(3, 1.05));
    for (GarmentTriangle& t : base.triangles)  // near the origin, where floats are finer
        for (Vec2d& u : t.u) u -= t.panel * Vec2d(7, 5);
    for (const int level : {0, 1, 2, 3, 4}) {
        std::mt19937 random(static_cast<unsigned>(7 + level));
        Cloth cloth = cloth_of(base, 3);
        const FixedMesh fixed = make_fixed_mesh(cloth, base.panel_names, level);
        std::set<Configuration> configurations;
        for (int i = 0; i < 12; ++i) {
            adapt_at_random(cloth, random);
            move_at_random(cloth, random);
            for (int deep = 0; deep < cloth.mesh.max_level(); ++deep)
                for (const TriangleId t : cloth.mesh.refined_triangles(deep))
                    configurations.insert(cloth.mesh.triangle(t).configuration);
            ASSERT_LT(largest_difference_from_leaves(fixed, cloth), 2e-6) << "level " << level << ", act " << i;
        }
        EXPECT_EQ(configurations.size(), kConfigurations - 1);
    }
}

TEST(FixedMesh, reproduces_a_linear_field_at_every_level) {
    Cloth cloth = make_patch(find_fabric("cotton_shirting"), {.side = 0.8, .quads = 3});
    std::mt19937 random(3);
    Eigen::Matrix3f map = Eigen::Matrix3f::Random();
    for (const VertexId v : cloth.mesh.leaf_vertices())
        cloth.x[v.value].head<3>() = (map * cloth.x[v.value].head<3>()).eval();
    std::vector<FixedMesh> meshes;
    for (int level = 0; level <= kFinestFixedLevel; ++level) meshes.push_back(make_fixed_mesh(cloth, {"patch"}, level));
    for (int i = 0; i < 20; ++i) {
        adapt_at_random(cloth, random);
        for (const FixedMesh& fixed : meshes) {
            std::vector<Vec3f> x;
            sample(fixed, cloth, x);
            for (std::size_t v = 0; v < x.size(); ++v) ASSERT_LT((x[v] - fixed.mesh.x[v]).norm(), 2e-6F);
        }
    }
}

// The corner of each material point, by panel and rounded material coordinates.
using CornerKey = std::array<long, 3>;
CornerKey key_of(std::uint16_t panel, const Vec2f& u) {
    return {panel, std::lround(1e5 * double(u.x())), std::lround(1e5 * double(u.y()))};
}

TEST(FixedMesh, of_the_deepest_level_has_every_vertex_of_the_cloth_to_the_bit) {
    const GarmentMesh base = with_names(front_and_back(4, 1.0));
    Cloth cloth = cloth_of(base, 3);
    std::mt19937 random(11);
    for (int i = 0; i < 6; ++i) adapt_at_random(cloth, random);
    move_at_random(cloth, random);
    const FixedMesh fixed = make_fixed_mesh(cloth, base.panel_names, 3);
    std::map<CornerKey, std::uint32_t> vertex_at;
    for (std::size_t t = 0; t < fixed.mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            vertex_at[key_of(fixed.mesh.panel[t], fixed.mesh.u[t][k])] = fixed.mesh.triangles[t][k];
    std::set<VertexId> met;
    for (const LeafTriangle& t : cloth.mesh.leaf_triangles()) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto at = vertex_at.find(key_of(t.panel, t.u[k]));
            ASSERT_NE(at, vertex_at.end());
            EXPECT_EQ(fixed.mesh.x[at->second], Vec3f(cloth.x[t.v[k].value].head<3>()));
            met.insert(t.v[k]);
        }
    }
    EXPECT_EQ(met.size(), cloth.mesh.leaf_vertices().size());
    EXPECT_GT(met.size(), base.x.size() + 50);
}

TEST(FixedMesh, is_a_sound_mesh_welded_along_seams_at_every_level) {
    for (const GarmentMesh& bare : {front_and_back(3, 1.1), tube(5, 3), octahedron()}) {
        const GarmentMesh base = with_names(bare);
        const Cloth cloth = cloth_of(base, 2);
        for (int level = 0; level <= kFinestFixedLevel; ++level) {
            const FixedMesh fixed = make_fixed_mesh(cloth, base.panel_names, level);
            const std::size_t n = std::size_t{1} << level;
            EXPECT_EQ(fixed.mesh.triangles.size(), base.triangles.size() * n * n);
            EXPECT_EQ(fixed.mesh.x.size(), cloth.mesh.base_vertex_count() + cloth.mesh.base_edge_count() * (n - 1) +
                                               cloth.mesh.base_triangle_count() * ((n - 1) * (n - 1) - (n - 1)) / 2);
            for (std::size_t v = 0; v < base.x.size(); ++v) EXPECT_EQ(fixed.mesh.x[v], base.x[v].cast<float>());
            EXPECT_TRUE(check_mesh(as_garment(fixed.mesh)).empty()) << check_mesh(as_garment(fixed.mesh)).front();
        }
    }
}

TEST(FixedMesh, has_one_material_coordinate_per_vertex_and_panel_and_keeps_the_area) {
    const GarmentMesh base = with_names(front_and_back(3, 1.07));
    const Cloth cloth = cloth_of(base, 2);
    const FixedMesh fixed = make_fixed_mesh(cloth, base.panel_names, 3);
    std::map<std::pair<std::uint32_t, std::uint16_t>, Vec2f> u_of;
    double area = 0, base_area = 0;
    for (std::size_t t = 0; t < fixed.mesh.triangles.size(); ++t) {
        area += double(material_area(fixed.mesh.u[t]));
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& [at, is_new] =
                u_of.try_emplace({fixed.mesh.triangles[t][k], fixed.mesh.panel[t]}, fixed.mesh.u[t][k]);
            EXPECT_EQ(at->second, fixed.mesh.u[t][k]);
        }
    }
    for (const LeafTriangle& t : cloth.mesh.leaf_triangles()) base_area += double(material_area(t.u));
    EXPECT_NEAR(area, base_area, 1e-6);
    EXPECT_EQ(fixed.mesh.panel_names, base.panel_names);
    EXPECT_EQ(fixed.mesh.panel_grain_angles, cloth.material.grain_angles);
}

TEST(FixedMesh, marks_the_corners_whose_normal_looks_to_the_wrong_side) {
    const GarmentMesh base = moebius_band(3);
    Cloth cloth = cloth_of(base, 2);
    std::mt19937 random(5);
    for (int i = 0; i < 5; ++i) adapt_at_random(cloth, random);
    const FixedMesh fixed = make_fixed_mesh(cloth, base.panel_names, 2);
    ASSERT_EQ(fixed.mesh.turned_corners.size(), fixed.mesh.triangles.size());
    EXPECT_TRUE(std::ranges::any_of(fixed.mesh.turned_corners, [](std::uint8_t turned) { return turned != 0; }));
    EXPECT_TRUE(check_mesh(as_garment(fixed.mesh)).empty());
    // The cloth's new vertices lie in the middle of their edges, so the surface is still that of the base mesh.
    const FixedMesh unadapted = make_fixed_mesh(cloth_of(base, 2), base.panel_names, 2);
    for (std::size_t v = 0; v < fixed.mesh.x.size(); ++v)
        EXPECT_LT((fixed.mesh.x[v] - unadapted.mesh.x[v]).norm(), 1e-6F);
}

TEST(FixedMesh, takes_the_finest_level_within_a_number_of_triangles) {
    const Cloth cloth = make_patch(find_fabric("cotton_shirting"), {.quads = 4});  // 32 triangles
    EXPECT_EQ(fixed_level_for(cloth, 0), 0);
    EXPECT_EQ(fixed_level_for(cloth, 127), 0);
    EXPECT_EQ(fixed_level_for(cloth, 128), 1);
    EXPECT_EQ(fixed_level_for(cloth, 2048), 3);
    EXPECT_EQ(fixed_level_for(cloth, 100'000'000), kFinestFixedLevel);
}

}  // namespace
}  // namespace selvedge::sim::test
