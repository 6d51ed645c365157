// What pictures show of a garment beside its positions: levels, the hierarchy, strain and clearance as plain data.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/cloth/stretch.h"
#include "sim/dress/clearance.h"
#include "sim/dress/hierarchy.h"
#include "sim/dress/inspect.h"
#include "sim/mesh/assemble.h"
#include "sim/mesh/mesh_strain.h"
#include "tests/sim/body/shapes.h"
#include "tests/sim/dress/shapes.h"

namespace selvedge::test {
namespace {

Cloth flat_tube() {
    Pattern pattern = tube(0.4, 0.3, 0.8, 0.15);
    pattern.seams.clear();
    return make_cloth(assemble(pattern), {Fabric{}, Fabric{}});
}

void split_all_base_edges(Cloth& cloth) {
    for (std::size_t e = 0; e < cloth.mesh.base_edge_count(); ++e)
        cloth.mesh.split(EdgeId(static_cast<std::uint32_t>(e)));
    cloth.mesh.retriangulate(0);
    cloth.mesh.refresh_lists();
    size_state(cloth, cloth.mesh.vertex_capacity());
}

TEST(Hierarchy, lists_every_triangle_once_each_before_what_it_was_refined_to) {
    Cloth cloth = flat_tube();
    const std::size_t base = cloth.mesh.base_triangle_count();
    EXPECT_EQ(triangle_hierarchy(cloth).size(), base);
    split_all_base_edges(cloth);
    const TriangleHierarchy all = triangle_hierarchy(cloth);
    ASSERT_EQ(all.size(), 5 * base);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(all[i].level, i % 5 == 0 ? 0 : 1) << i;
        EXPECT_EQ(all[i].is_leaf, i % 5 != 0) << i;
        EXPECT_EQ(all[i].panel, all[i - i % 5].panel) << i;
    }
}

TEST(PlainMeshOfCloth, vertices_carry_the_level_that_they_were_born_at) {
    Cloth cloth = flat_tube();
    split_all_base_edges(cloth);
    const PlainMesh mesh = plain_mesh(cloth, {"front", "back"});
    ASSERT_EQ(mesh.vertex_level.size(), mesh.x.size());
    const auto base = std::count(mesh.vertex_level.begin(), mesh.vertex_level.end(), 0);
    EXPECT_EQ(static_cast<std::size_t>(base), cloth.mesh.base_vertex_count());
    EXPECT_EQ(mesh.x.size(), cloth.mesh.base_vertex_count() + cloth.mesh.base_edge_count());
}

TEST(MeshStrainOfCloth, is_what_the_solver_measures) {
    Cloth cloth = flat_tube();
    cloth.material.grain_angles = {0.3F, -0.8F};
    for (Vec4f& x : cloth.x) x = Vec4f(1.04F * x.x() + 0.1F * x.y(), 0.98F * x.y(), x.z() + 0.2F * x.x(), 0);
    const std::vector<TriangleStrain> expected = measure_strain(cloth);
    const std::vector<MeshStrain> strain = measure_strain(plain_mesh(cloth, {"front", "back"}));
    ASSERT_EQ(strain.size(), expected.size());
    for (std::size_t i = 0; i < strain.size(); ++i) {
        EXPECT_NEAR(strain[i].warp, expected[i].warp, 1e-4F);
        EXPECT_NEAR(strain[i].weft, expected[i].weft, 1e-4F);
    }
}

TEST(Clearance, is_the_distance_to_the_surface_and_negative_inside) {
    const Body ball = shapes::sphere(Vec3d(0, 1, 0), 0.2, 48);
    const std::vector<float> distances =
        measure_clearance({Vec3f(0, 1.25F, 0), Vec3f(0.5F, 1, 0), Vec3f(0, 1, 0.19F), Vec3f(0, 6, 0)}, ball);
    ASSERT_EQ(distances.size(), 4U);
    EXPECT_NEAR(distances[0], 0.05F, 1e-3F);
    EXPECT_NEAR(distances[1], 0.30F, 1e-3F);
    EXPECT_NEAR(distances[2], -0.01F, 1e-3F);
    EXPECT_NEAR(distances[3], 4.80F, 1e-3F);
}

}  // namespace
}  // namespace selvedge::test
