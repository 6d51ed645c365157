// Edges and faces inside a body, with all vertices outside.
#include "sim/collide/penetration.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "tests/support/bodies.h"

namespace selvedge::sim::test {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// An upright post of 6 x 6 cm about the y axis.
Body post() {
    return shapes::box(Vec3d(-0.03, 0, -0.03), Vec3d(0.03, 1, 0.03), 8);
}

TEST(Penetration, finds_an_edge_through_a_thin_limb_whose_ends_are_outside) {
    const std::vector<Vec3f> x{{-0.06F, 0.5F, 0.01F}, {0.06F, 0.5F, 0.01F}, {0, 0.52F, 0.2F}};
    const Penetration found = find_penetration(x, Triangles{{0, 1, 2}}, SurfaceBvh(post()));
    EXPECT_EQ(found.vertices, 0);
    EXPECT_EQ(found.edges, 1);
    EXPECT_EQ(found.faces, 1);
    ASSERT_EQ(found.passing.size(), 1U);
    EXPECT_NEAR(found.passing[0].depth, 0.02F, 2e-4F);
    EXPECT_NEAR(found.passing[0].at.z(), 0.01F, 1e-4F);
    EXPECT_NEAR(found.deepest, 0.02F, 0.01F);
}

TEST(Penetration, does_not_take_a_shallow_cut_for_a_passage) {
    const Body ball = shapes::sphere(Vec3d::Zero(), 0.1, 32);
    const std::vector<Vec3f> x{{-0.05F, 0.097F, 0}, {0.05F, 0.097F, 0}, {0, 0.15F, 0}};
    const Penetration found = find_penetration(x, Triangles{{0, 1, 2}}, SurfaceBvh(ball));
    EXPECT_EQ(found.vertices, 0);
    EXPECT_EQ(found.edges, 1);
    EXPECT_NEAR(found.deepest, 0.003F, 3e-4F);
    EXPECT_TRUE(found.passing.empty());
}

TEST(Penetration, finds_a_bump_that_pierces_a_face_between_its_edges) {
    const Body bump = shapes::sphere(Vec3d::Zero(), 0.02, 16);
    const std::vector<Vec3f> x{{-0.1F, 0.018F, -0.06F}, {0.1F, 0.018F, -0.06F}, {0.01F, 0.018F, 0.12F}};
    const Penetration found = find_penetration(x, Triangles{{0, 2, 1}}, SurfaceBvh(bump));
    EXPECT_EQ(found.vertices, 0);
    EXPECT_EQ(found.edges, 0);
    EXPECT_EQ(found.faces, 1);
    EXPECT_NEAR(found.deepest, 0.002F, 4e-4F);
    EXPECT_LT(found.at.norm(), 0.025F);
}

TEST(Penetration, finds_nothing_in_cloth_that_keeps_its_distance) {
    const Body ball = shapes::sphere(Vec3d::Zero(), 0.1, 32);
    Body cloth = shapes::sphere(Vec3d::Zero(), 0.103, 16);
    std::vector<Vec3f> x;
    Triangles triangles;
    for (const Vec3d& p : cloth.x) x.push_back(p.cast<float>());
    for (const auto& [a, b, c] : cloth.triangles)
        triangles.push_back({std::uint32_t(a), std::uint32_t(b), std::uint32_t(c)});
    const Penetration found = find_penetration(x, triangles, SurfaceBvh(ball));
    EXPECT_EQ(found.vertices + found.edges + found.faces, 0);
    EXPECT_EQ(found.deepest, 0);
}

TEST(Penetration, names_the_deep_faces_with_their_deepest_points) {
    const Body bump = shapes::sphere(Vec3d::Zero(), 0.02, 16);
    const std::vector<Vec3f> x{
        {-0.1F, 0.018F, -0.06F}, {0.1F, 0.018F, -0.06F}, {0.01F, 0.018F, 0.12F}, {0.2F, 0.018F, 0.12F}};
    const Penetration found = find_penetration(x, Triangles{{1, 2, 3}, {0, 2, 1}}, SurfaceBvh(bump));
    ASSERT_EQ(found.deep_faces.size(), 1U);
    EXPECT_EQ(found.deep_faces[0].triangle, 1U);
    EXPECT_EQ(found.deep_faces[0].depth, found.deepest);
    EXPECT_EQ(found.deep_faces[0].at, found.at);
}

TEST(Penetration, forgives_less_than_half_a_millimetre) {
    const std::vector<Vec3f> x{{-0.02F, 0.5F, 0.0297F}, {0.02F, 0.5F, 0.0297F}, {0, 0.52F, 0.0297F}};
    const Penetration found = find_penetration(x, Triangles{{0, 1, 2}}, SurfaceBvh(post()));
    EXPECT_EQ(found.vertices, 3);
    EXPECT_NEAR(found.deepest_vertex, 0.0003F, 1e-5F);
    EXPECT_EQ(found.edges + found.faces, 0);
}

}  // namespace
}  // namespace selvedge::sim::test
