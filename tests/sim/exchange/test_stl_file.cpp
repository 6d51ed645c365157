#include "sim/exchange/stl_file.h"

#include <gtest/gtest.h>
#include <cstring>
#include <string>

#include "tests/sim/exchange/two_panels.h"
#include "tests/support/bodies.h"

namespace selvedge::sim {
namespace {

Vec3f vector_at(const std::string& bytes, std::size_t triangle, std::size_t vector) {
    float v[3];
    std::memcpy(v, bytes.data() + 84 + 50 * triangle + 12 * vector, sizeof v);
    return {v[0], v[1], v[2]};
}

TEST(StlFile, holds_triangles_in_millimetres_with_their_normals) {
    const DrawMesh mesh = two_panels();
    const std::string bytes = garment_stl(mesh);
    ASSERT_EQ(bytes.size(), 84U + 50U * 4U);
    EXPECT_FALSE(bytes.starts_with("solid"));
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, sizeof count);
    EXPECT_EQ(count, 4U);
    for (std::size_t t = 0; t < 4; ++t) {
        Vec3f corners[3];
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] = vector_at(bytes, t, 1 + k);
            EXPECT_LT((corners[k] - 1000 * mesh.x[mesh.triangles[t][k]]).norm(), 1e-3F);
        }
        const Vec3f normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
        EXPECT_LT((vector_at(bytes, t, 0) - normal).norm(), 1e-5F);
    }
}

TEST(StlFile, of_a_triangle_without_area_has_a_normal_of_zero) {
    DrawMesh mesh = two_panels();
    mesh.x[1] = mesh.x[0];
    EXPECT_EQ(vector_at(garment_stl(mesh), 0, 0), Vec3f(0, 0, 0));
}

TEST(StlFile, holds_the_body_after_the_cloth_when_asked_to_and_says_where_it_begins) {
    const Body box = shapes::box({0, 0, 0}, {1, 1, 1}, 1);
    const std::string cloth = garment_stl(two_panels()), both = garment_stl(two_panels(), {.body = &box});
    EXPECT_TRUE(both.starts_with("Selvedge: millimetres, y up; cloth: first 4 triangles, then the body ")) << both;
    ASSERT_EQ(both.size(), 84 + 50 * (4 + box.triangles.size()));
    std::uint32_t count = 0;
    std::memcpy(&count, both.data() + 80, sizeof count);
    EXPECT_EQ(count, 4 + box.triangles.size());
    EXPECT_EQ(both.substr(84, 200), cloth.substr(84));
    EXPECT_EQ(both.substr(284), body_stl(box).substr(84));
}

TEST(StlFile, holds_a_body_too) {
    const Body box = shapes::box({0, 0, 0}, {1, 1, 1}, 1);
    EXPECT_EQ(body_stl(box).size(), 84 + 50 * box.triangles.size());
}

}  // namespace
}  // namespace selvedge::sim
