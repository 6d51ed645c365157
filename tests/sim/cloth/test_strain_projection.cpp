// The projection onto strain limits: what is beyond comes back, and nothing else changes.
#include "sim/cloth/contact.h"
#include "sim/cloth/strain_projection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sim/cloth/fixtures.h"

namespace selvedge::sim::test {
namespace {

constexpr float kLimit = 0.03F;  // of cotton shirting
constexpr PatchOptions kPatch{.side = 0.1, .quads = 4, .height = 2.0, .max_level = 0};

StepOptions without_gravity() {
    StepOptions stepping{.gravity = Vec3f::Zero()};
    stepping.contact.floor = kNoFloor;
    return stepping;
}

// A flat patch of edges of 2.5 cm that has made one step.
Cloth patch(const Collider& body) {
    Cloth cloth = make_patch(find_fabric("cotton_shirting"), kPatch);
    refresh_contacts(cloth);
    step(cloth, body, without_gravity());
    return cloth;
}

float worst_strain(const Cloth& cloth) {
    float worst = -1;
    for (const TriangleStrain& strain : measure_strain(cloth)) worst = std::max({worst, strain.warp, strain.weft});
    return worst;
}

// The vertex in the middle of the patch.
std::size_t middle_of(const Cloth& cloth) {
    std::size_t middle = 0;
    const auto from_axis = [&](std::size_t v) { return std::hypot(cloth.x[v].x(), cloth.x[v].z()); };
    for (const VertexId v : cloth.mesh.leaf_vertices())
        middle = from_axis(v.value) < from_axis(middle) ? v.value : middle;
    return middle;
}

TEST(StrainProjection, brings_a_stretched_triangle_back_to_the_limit) {
    Cloth cloth = patch(nothing_near());
    cloth.x[middle_of(cloth)].x() += 0.005F;
    ASSERT_GT(worst_strain(cloth), 0.15F);
    const StrainProjectionOptions options;
    const StrainProjectionReport report = project_strain(cloth, nothing_near(), without_gravity(), options);
    EXPECT_LT(worst_strain(cloth), kLimit + options.tolerance + 1e-4F);
    EXPECT_NEAR(report.worst_over, worst_strain(cloth) - kLimit, 1e-4F);
    EXPECT_GT(report.iterations, 0);
}

TEST(StrainProjection, keeps_the_cloth_out_of_itself_and_of_the_body) {
    for (const bool self_contact : {false, true}) {
        Cloth cloth = patch(nothing_near());
        const Vec3f centre(0, 1, 0);  // of the ball
        for (const VertexId v : cloth.mesh.leaf_vertices()) {
            Vec4f& x = cloth.x[v.value];
            const Vec3f stretched(1.1F * x.x(), 0.153F, 1.1F * x.z());  // wound round the ball, 10 % too wide
            x = with_zero_w(Vec3f(centre + 0.1531F * stretched.normalized()));
        }
        cloth.x_prev = cloth.x;
        ASSERT_GT(worst_strain(cloth), kLimit + 0.02F);
        StepOptions stepping = without_gravity();
        if (self_contact) stepping.self_contact.emplace();
        project_strain(cloth, ball(), stepping);
        EXPECT_LT(worst_strain(cloth), kLimit + 0.011F);
        for (const VertexId v : cloth.mesh.leaf_vertices()) {
            EXPECT_GT(exact_distance(ball(), cloth.x[v.value].head<3>()), 0.003F - ball().max_error() - 1e-4F);
        }
    }
}

TEST(StrainProjection, keeps_velocities) {
    Cloth cloth = patch(nothing_near());
    for (Vec4f& x : cloth.x_prev) x -= Vec4f(1e-4F, 0, 0, 0);
    const std::vector<Vec4f> x = cloth.x, x_prev = cloth.x_prev;
    cloth.x[middle_of(cloth)].x() += 0.005F;
    cloth.x_prev[middle_of(cloth)].x() += 0.005F;
    project_strain(cloth, nothing_near(), without_gravity());
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const Vec4f was = x[v.value] - x_prev[v.value];
        EXPECT_LT((cloth.x[v.value] - cloth.x_prev[v.value] - was).norm(), 1e-6F);
    }
}

TEST(StrainProjection, leaves_cloth_within_its_limits_as_it_is) {
    Cloth cloth = patch(nothing_near());
    const std::vector<Vec4f> x = cloth.x;
    const StrainProjectionReport report = project_strain(cloth, nothing_near(), without_gravity());
    EXPECT_EQ(report.iterations, 0);
    EXPECT_EQ(cloth.x, x);
}

// Two pinned vertices that are too far apart for the cloth between them.
TEST(StrainProjection, stretches_nothing_further_where_there_is_no_solution) {
    Cloth cloth = patch(nothing_near());
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        Vec4f& x = cloth.x[v.value];
        if (std::abs(x.x()) > 0.049F) cloth.inverse_mass[v.value] = 0;
        x.x() *= 1.2F;
    }
    const float before = worst_strain(cloth);
    const StrainProjectionReport report = project_strain(cloth, nothing_near(), without_gravity());
    EXPECT_LE(worst_strain(cloth), before + 1e-4F);
    EXPECT_GT(worst_strain(cloth), 0.15F);
    EXPECT_EQ(report.iterations, StrainProjectionOptions{}.iterations);
}

}  // namespace
}  // namespace selvedge::sim::test
