#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "sim/collide/surface_bvh.h"
#include "tests/sim/collide/support.h"
#include "tests/support/bodies.h"

namespace selvedge::sim {
namespace {

std::vector<Vec3f> random_points(int count, float half_width, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> along(-half_width, half_width);
    std::vector<Vec3f> points;
    for (int i = 0; i < count; ++i) {
        const float x = along(random);
        const float y = along(random);
        points.emplace_back(x, y, along(random));
    }
    return points;
}

// A wavy closed surface: hollows, ridges, triangles of many sizes.
Body wavy_ball() {
    Body body = shapes::sphere(Vec3d::Zero(), 0.1, 12);
    for (Vec3d& p : body.x) p *= 1 + 0.3 * std::sin(40 * p.x()) * std::cos(30 * p.y()) + 0.2 * p.z() / 0.1;
    return body;
}

// Slow and simple reference for the tree: the best of a fine sampling of the triangle, refined by halving.
double sampled_distance(const Vec3d& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    double best = std::numeric_limits<double>::infinity();
    double u = 1.0 / 3, v = 1.0 / 3;
    for (double step = 0.34; step > 1e-6; step /= 2) {
        const double u0 = u, v0 = v;
        for (int i = -4; i <= 4; ++i)
            for (int j = -4; j <= 4; ++j) {
                const double s = std::clamp(u0 + i * step / 2, 0.0, 1.0);
                const double t = std::clamp(v0 + j * step / 2, 0.0, 1.0 - s);
                const double distance = (p - (a + s * (b - a) + t * (c - a))).norm();
                if (distance < best) {
                    best = distance;
                    u = s;
                    v = t;
                }
            }
    }
    return best;
}

TEST(SurfaceBvh, finds_what_trying_every_triangle_finds) {
    const Body body = wavy_ball();
    const SurfaceBvh bvh(body);
    for (const Vec3f& p : random_points(40, 0.2F, 1)) {
        double best = std::numeric_limits<double>::infinity();
        for (const auto& [a, b, c] : body.triangles) {
            const Vec3d q = p.cast<double>();
            best = std::min(
                best, sampled_distance(q, body.x[std::size_t(a)], body.x[std::size_t(b)], body.x[std::size_t(c)]));
        }
        const auto closest = bvh.closest(p, kFar);
        ASSERT_TRUE(closest);
        EXPECT_NEAR(std::abs(closest->distance), best, 2e-6);
        EXPECT_NEAR((p - closest->point).norm(), std::abs(closest->distance), 1e-6);
    }
}

TEST(SurfaceBvh, signs_points_by_faces_edges_and_corners_of_a_box) {
    const Vec3d low(-0.1, -0.2, -0.05);
    const Vec3d high(0.1, 0.1, 0.07);
    const SurfaceBvh bvh(shapes::box(low, high, 3));
    for (const Vec3f& p : random_points(3000, 0.3F, 2)) {
        const auto closest = bvh.closest(p, kFar);
        ASSERT_TRUE(closest);
        EXPECT_NEAR(closest->distance, shapes::box_distance(p.cast<double>(), low, high), 1e-6);
    }
}

TEST(SurfaceBvh, signs_points_beside_a_sharp_spike) {
    // The nearest feature is often the needle's tip or a side edge, where the normals of adjacent faces disagree.
    Body body;
    body.x = {{0, 1, 0}, {0.01, 0, 0}, {-0.005, 0, -0.009}, {-0.005, 0, 0.009}};
    body.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
    const SurfaceBvh bvh(body);
    for (const Vec3f& p : random_points(2000, 0.1F, 3)) {
        const auto closest = bvh.closest(p + Vec3f(0, 1, 0), kFar);
        ASSERT_TRUE(closest);
        const double width = 0.01 * (1 - std::min(double(p.y()) + 1, 1.0));
        if (std::hypot(p.x(), p.z()) > width) {
            EXPECT_GT(closest->distance, 0);
        }
    }
    for (const float y : {0.1F, 0.5F, 0.9F, 0.99F}) EXPECT_LT(bvh.closest({0, y, 0}, kFar)->distance, 0);
}

TEST(SurfaceBvh, normals_point_away_from_the_body_on_both_sides) {
    const SurfaceBvh bvh(shapes::sphere(Vec3d::Zero(), 0.1, 16));
    for (const Vec3f& p : random_points(500, 0.15F, 4)) {
        if (p.norm() < 0.05F) continue;
        const auto closest = bvh.closest(p, kFar);
        ASSERT_TRUE(closest);
        EXPECT_GT(closest->normal.dot(p.normalized()), 0.99F);
        EXPECT_NEAR(closest->normal.norm(), 1, 1e-5);
    }
}

TEST(SurfaceBvh, a_point_on_the_surface_has_the_surfaces_normal) {
    const Body body = shapes::box(Vec3d::Zero(), Vec3d::Ones(), 2);
    const auto on_face = SurfaceBvh(body).closest({1.0F, 0.3F, 0.2F}, 0.01F);
    ASSERT_TRUE(on_face);
    EXPECT_TRUE(on_face->normal.isApprox(Vec3f::UnitX(), 1e-6F));
    const auto on_corner = SurfaceBvh(body).closest({1, 1, 1}, 0.01F);
    ASSERT_TRUE(on_corner);
    EXPECT_TRUE(on_corner->normal.isApprox(Vec3f::Ones().normalized(), 1e-5F));
}

TEST(SurfaceBvh, finds_nothing_beyond_the_radius) {
    const SurfaceBvh bvh(shapes::box(Vec3d::Zero(), Vec3d::Ones(), 2));
    EXPECT_FALSE(bvh.closest({1.5F, 0.5F, 0.5F}, 0.499F));
    EXPECT_TRUE(bvh.closest({1.5F, 0.5F, 0.5F}, 0.5F));
    EXPECT_FALSE(bvh.closest({0.5F, 0.5F, 0.5F}, 0.4F));
    EXPECT_FALSE(bvh.closest({std::nanf(""), 0, 0}, kFar));
}

TEST(SurfaceBvh, leaves_out_triangles_without_area) {
    Body body = shapes::box(Vec3d::Zero(), Vec3d::Ones(), 2);
    const SurfaceBvh sound(body);
    body.triangles.push_back({0, 0, 1});
    body.triangles.push_back({2, 2, 2});
    const SurfaceBvh with_degenerates(body);
    for (const Vec3f& p : random_points(200, 1.5F, 5)) {
        EXPECT_EQ(sound.closest(p, kFar)->distance, with_degenerates.closest(p, kFar)->distance);
    }
}

TEST(SurfaceBvh, an_empty_body_has_no_closest_point_and_no_hit) {
    const SurfaceBvh bvh{Body{}};
    EXPECT_FALSE(bvh.closest({0, 0, 0}, kFar));
    EXPECT_FALSE(bvh.first_hit({0, 0, 0}, {1, 0, 0}));
}

TEST(SurfaceBvh, a_segment_first_hits_the_near_side_from_outside_and_the_far_one_from_inside) {
    const SurfaceBvh bvh(shapes::box(Vec3d::Zero(), Vec3d::Ones(), 4));
    const auto in = bvh.first_hit({-1, 0.3F, 0.4F}, {3, 0.3F, 0.4F});
    ASSERT_TRUE(in);
    EXPECT_NEAR(in->fraction, 0.25F, 1e-6);
    EXPECT_TRUE(in->normal.isApprox(-Vec3f::UnitX(), 1e-6F));
    const auto out = bvh.first_hit({0.5F, 0.3F, 0.4F}, {0.5F, 0.3F, 4.4F});
    ASSERT_TRUE(out);
    EXPECT_NEAR(out->point.z(), 1, 1e-6);
    EXPECT_TRUE(out->normal.isApprox(Vec3f::UnitZ(), 1e-6F));
}

TEST(SurfaceBvh, a_segment_that_ends_before_the_surface_or_passes_by_hits_nothing) {
    const SurfaceBvh bvh(shapes::box(Vec3d::Zero(), Vec3d::Ones(), 4));
    EXPECT_FALSE(bvh.first_hit({-1, 0.5F, 0.5F}, {-0.01F, 0.5F, 0.5F}));
    EXPECT_FALSE(bvh.first_hit({-1, 1.01F, 0.5F}, {2, 1.01F, 0.5F}));
    EXPECT_FALSE(bvh.first_hit({0.4F, 0.5F, 0.5F}, {0.6F, 0.5F, 0.5F}));
}

TEST(SurfaceBvh, a_segment_does_not_slip_between_triangles) {
    const Body body = wavy_ball();
    const SurfaceBvh bvh(body);
    for (const auto& [a, b, c] : body.triangles) {
        // From the centre to an edge that two triangles share, and to a corner.
        const Vec3f edge = ((body.x[std::size_t(a)] + body.x[std::size_t(b)]) / 2).cast<float>();
        EXPECT_TRUE(bvh.first_hit(Vec3f::Zero(), 3 * edge));
        EXPECT_TRUE(bvh.first_hit(Vec3f::Zero(), 3 * body.x[std::size_t(c)].cast<float>()));
    }
}

}  // namespace

}  // namespace selvedge::sim
