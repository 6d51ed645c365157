#include <gtest/gtest.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "sim/collide/body_collider.h"
#include "sim/collide/collider.h"
#include "sim/core/parallel.h"
#include "sim/core/simd_level.h"
#include "tests/sim/collide/support.h"
#include "tests/support/bodies.h"

namespace selvedge::sim {
namespace {

constexpr double kBallRadius = 0.08;

Body ball() {
    return shapes::sphere({0.01, 0.9, -0.02}, kBallRadius, 24);
}
Vec3f ball_centre() {
    return {0.01F, 0.9F, -0.02F};
}

Vec3f random_direction(std::mt19937& random) {
    std::normal_distribution<float> normal;
    const float x = normal(random);
    const float y = normal(random);
    return Vec3f(x, y, normal(random)).normalized();
}

// Points from `depth` below to `height` above the ball's surface.
std::vector<Vec3f> points_near_ball(int count, float depth, float height) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> along(-depth, height);
    std::vector<Vec3f> points;
    for (int i = 0; i < count; ++i)
        points.emplace_back(ball_centre() + (float(kBallRadius) + along(random)) * random_direction(random));
    return points;
}

TEST(DistanceField, is_within_a_sixth_of_a_millimetre_near_a_smooth_surface) {
    const SurfaceBvh bvh(ball());
    const DistanceField field(bvh);
    std::vector<float> errors;
    for (const Vec3f& p : points_near_ball(5000, 0.011F, 0.011F)) {
        const float exact = bvh.closest(p, kFar)->distance;
        const FieldSample sample = field.sample(p);
        errors.push_back(std::abs(sample.distance - exact));
        if (std::abs(exact) > field.max_error()) {
            EXPECT_EQ(sample.distance < 0, exact < 0);
        }
    }
    std::sort(errors.begin(), errors.end());
    EXPECT_LT(errors[errors.size() * 99 / 100], 0.00015F);
    EXPECT_LT(errors.back(), 0.0003F);
}

TEST(DistanceField, its_gradient_is_the_way_out) {
    const DistanceField field{SurfaceBvh(ball())};
    for (const Vec3f& p : points_near_ball(2000, 0.011F, 0.011F)) {
        const FieldSample sample = field.sample(p);
        EXPECT_NEAR(sample.gradient.norm(), 1, 0.05);
        EXPECT_GT(sample.gradient.normalized().dot((p - ball_centre()).normalized()), 0.98F);
    }
}

TEST(DistanceField, knows_the_side_of_points_beyond_the_band) {
    const DistanceField field{SurfaceBvh(ball())};
    std::mt19937 random(3);
    for (int i = 0; i < 3000; ++i) {
        const Vec3f direction = random_direction(random);
        std::uniform_real_distribution<float> inner(0, float(kBallRadius) - 0.013F),
            outer(float(kBallRadius) + 0.013F, 0.6F);
        const FieldSample deep = field.sample(ball_centre() + inner(random) * direction);
        EXPECT_EQ(deep.distance, -field.band());
        EXPECT_EQ(deep.gradient, Vec3f::Zero());
        const FieldSample away = field.sample(ball_centre() + outer(random) * direction);
        EXPECT_EQ(away.distance, field.band());
        EXPECT_EQ(away.gradient, Vec3f::Zero());
    }
    EXPECT_EQ(field.sample(Vec3f::Constant(1e30F)).distance, field.band());
    EXPECT_EQ(field.sample(Vec3f::Constant(std::nanf(""))).distance, field.band());
}

TEST(DistanceField, tells_inside_from_outside_in_a_hollow_shell) {
    // The cavity in the shell is outside, although it is closed.
    Body hollow = shapes::sphere(Vec3d::Zero(), 0.08, 20);
    for (auto& triangle : hollow.triangles) std::swap(triangle[0], triangle[1]);
    const Body shell = shapes::together(shapes::sphere(Vec3d::Zero(), 0.15, 20), hollow);
    const DistanceField field{SurfaceBvh(shell)};
    EXPECT_EQ(field.sample({0, 0, 0}).distance, field.band());
    EXPECT_EQ(field.sample({0.115F, 0, 0}).distance, -field.band());
    EXPECT_EQ(field.sample({0.2F, 0, 0}).distance, field.band());
}

TEST(DistanceField, max_error_is_no_less_than_any_error_on_the_surface) {
    const SurfaceBvh bvh(shapes::box(Vec3d::Zero(), Vec3d(0.1, 0.2, 0.1), 5));
    const DistanceField field(bvh);
    EXPECT_GT(field.max_error(), 0.0002F);  // a box's edges are sharp
    EXPECT_LT(field.max_error(), 0.0026F);  // half the cell's diagonal bounds any distance field's error
    for (const Vec3f& p : bvh.points()) EXPECT_LE(std::abs(field.sample(p).distance), field.max_error());
}

TEST(DistanceField, is_sound_where_nodes_lie_in_a_face) {
    // Nodes in a face have distance 0, which once counted as "nothing found". The box's height puts a layer of nodes
    // exactly into its top face for some of its depths.
    const DistanceFieldOptions options;
    const double margin = double(options.band + std::numbers::sqrt3_v<float> * options.cell);
    for (int i = 0; i < 40; ++i) {
        const Vec3d low(-0.04 - 0.001 * i, 1.4 - 0.0007 * i, -0.03);
        const double top = low.y() + 20 * double(options.cell) - margin;
        const SurfaceBvh bvh(shapes::box(low, {0.05, top, 0.03}, 1));
        EXPECT_LT(DistanceField(bvh, options).max_error(), 0.0026F);
    }
}

TEST(DistanceField, has_the_same_bits_for_any_number_of_threads) {
    const SurfaceBvh bvh(shapes::box(Vec3d::Zero(), Vec3d(0.1, 0.2, 0.1), 5));
    const auto sample_all = [&](int threads) {
        const ThreadLimit limit(threads);
        const DistanceField field(bvh);
        std::vector<float> values{field.max_error(), float(field.bytes())};
        std::mt19937 random(11);
        std::uniform_real_distribution<float> along(-0.05F, 0.25F);
        for (int i = 0; i < 5000; ++i) {
            const float x = along(random);
            const float y = along(random);
            values.push_back(field.sample({x, y, along(random)}).distance);
        }
        return values;
    };
    EXPECT_EQ(sample_all(1), sample_all(4));
}

TEST(DistanceField, of_an_empty_body_is_outside_everywhere) {
    const DistanceField field{SurfaceBvh(Body{})};
    EXPECT_EQ(field.sample({0, 0, 0}).distance, field.band());
}

TEST(BodyCollider, asks_the_exact_surface_at_edges_and_corners) {
    const Vec3d low = Vec3d::Zero();
    const Vec3d high(0.1, 0.1, 0.1);
    const Body body = shapes::box(low, high, 4);
    const BodyCollider collider(body);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> along(-0.002F, 0.004F);
    std::vector<double> errors;
    for (int i = 0; i < 2000; ++i) {
        const float x = along(random);
        const Vec3f p = Vec3f(0.1F + x, 0.1F + along(random), 0.05F);
        const Contact contact = collider.contact(p);
        errors.push_back(std::abs(contact.distance - shapes::box_distance(p.cast<double>(), low, high)));
        EXPECT_NEAR(contact.normal.norm(), 1, 1e-4);
    }
    std::sort(errors.begin(), errors.end());
    EXPECT_LT(errors[errors.size() / 2], 0.0001);
    EXPECT_LT(errors.back(), collider.max_error());
}

TEST(BodyCollider, pushes_a_vertex_out_from_however_deep) {
    const Body body = ball();
    const BodyCollider collider(body);
    for (const Vec3f& p : points_near_ball(2000, 0.078F, 0.0F)) {
        const Contact contact = collider.contact(p);
        ASSERT_LT(contact.distance, collider.max_error());
        const Vec3f out = p + (0.003F - contact.distance) * contact.normal;
        EXPECT_NEAR((out - ball_centre()).norm(), kBallRadius + 0.003, 0.0006);
    }
}

TEST(BodyCollider, says_band_and_no_normal_far_away) {
    const Body body = ball();
    const BodyCollider collider(body);
    const Contact contact = collider.contact({1, 1, 1});
    EXPECT_EQ(contact.distance, collider.band());
    EXPECT_EQ(contact.normal, Vec3f::Zero());
}

const CylinderShape kDrum{.centre = {0.1F, 0.5F, -0.2F}, .axis = {3, 0, 4}, .radius = 0.2F, .half_length = 0.3F};

std::vector<Vec3f> points_about(const Vec3f& centre, int count) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> along(-0.6F, 0.6F);
    std::vector<Vec3f> points;
    for (int i = 0; i < count; ++i) {
        const float x = along(random);
        const float y = along(random);
        points.emplace_back(centre + Vec3f(x, y, along(random)));
    }
    return points;
}

// The point `distance` back along the normal is on the surface, and the distance changes by no more than the
// displacement between two points: so it is exact.
void expect_true_distances(const Collider& collider, const Vec3f& centre) {
    const std::vector<Vec3f> points = points_about(centre, 400);
    Vec3f last = centre;
    for (const Vec3f& p : points) {
        const Contact contact = collider.contact(p);
        EXPECT_NEAR(contact.normal.norm(), 1, 1e-5);
        EXPECT_NEAR(collider.contact(p - contact.normal * contact.distance).distance, 0, 1e-5);
        EXPECT_LE(std::abs(contact.distance - collider.contact(last).distance), (p - last).norm() + 1e-5F);
        last = p;
    }
}

// A hit is on the surface and on the segment. A segment that crosses the surface has a hit, and none lies before it.
void expect_true_hits(const Collider& collider, const Vec3f& centre) {
    const std::vector<Vec3f> points = points_about(centre, 800);
    int hits = 0;
    for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
        const auto hit = collider.first_hit(points[i], points[i + 1]);
        const bool starts_inside = collider.contact(points[i]).distance < 0;
        const bool ends_inside = collider.contact(points[i + 1]).distance < 0;
        if (starts_inside != ends_inside) {
            EXPECT_TRUE(hit);
        }
        if (!hit) continue;
        ++hits;
        EXPECT_NEAR(collider.contact(hit->point).distance, 0, 1e-5);
        EXPECT_TRUE(hit->point.isApprox(points[i] + hit->fraction * (points[i + 1] - points[i]), 1e-4F));
        EXPECT_GT(collider.contact(hit->point + hit->normal * 1e-3F).distance, 0);
        for (const float t : {0.1F, 0.5F, 0.9F}) {
            const Vec3f before = points[i] + t * (hit->point - points[i]);
            EXPECT_EQ(collider.contact(before).distance < 0, starts_inside);
        }
    }
    EXPECT_GT(hits, 50);
}

TEST(SphereCollider, knows_distance_and_way_out_everywhere) {
    const SphereCollider sphere({0, 1, 0}, 0.25F);
    EXPECT_FLOAT_EQ(sphere.contact({0, 1.5F, 0}).distance, 0.25F);
    EXPECT_FLOAT_EQ(sphere.contact({0.05F, 1, 0}).distance, -0.2F);
    EXPECT_FLOAT_EQ(sphere.contact({0, 1, 0}).distance, -0.25F);
    expect_true_distances(sphere, {0, 1, 0});
}

TEST(SphereCollider, is_hit_where_a_segment_enters_or_leaves_it) {
    const SphereCollider sphere({0, 1, 0}, 0.25F);
    expect_true_hits(sphere, {0, 1, 0});
    EXPECT_FALSE(sphere.first_hit({0, 2, 0}, {0, 2, 0}));
    EXPECT_FALSE(sphere.first_hit({0, 1.1F, 0}, {0, 0.9F, 0}));
}

TEST(CylinderCollider, knows_distance_and_way_out_everywhere) {
    const CylinderCollider drum(kDrum);
    expect_true_distances(drum, kDrum.centre);
    const Vec3f axis = kDrum.axis.normalized();
    EXPECT_NEAR(drum.contact(kDrum.centre + 0.4F * axis).distance, 0.1F, 1e-6F);
    EXPECT_NEAR(drum.contact(kDrum.centre + 0.27F * axis).distance, -0.03F, 1e-6F);
    EXPECT_NEAR(drum.contact(kDrum.centre + Vec3f(0, 0.23F, 0) + 0.34F * axis).distance, 0.05F, 1e-6F);
}

TEST(CylinderCollider, is_hit_on_its_side_and_on_its_ends) {
    const CylinderCollider drum(kDrum);
    expect_true_hits(drum, kDrum.centre);
    const Vec3f axis = kDrum.axis.normalized();
    const auto end = drum.first_hit(kDrum.centre + axis, kDrum.centre);
    ASSERT_TRUE(end);
    EXPECT_NEAR(end->fraction, 0.7F, 1e-6F);
    EXPECT_TRUE(end->normal.isApprox(axis, 1e-5F));
}

TEST(CylinderCollider, without_ends_goes_on_for_ever) {
    const CylinderCollider pipe({.axis = {1, 0, 0}, .radius = 0.1F});
    EXPECT_NEAR(pipe.contact({500, 0.3F, 0}).distance, 0.2F, 1e-6F);
    EXPECT_NEAR(pipe.contact({-500, 0.04F, 0}).distance, -0.06F, 1e-6F);
    EXPECT_FALSE(pipe.first_hit({-1, 0, 0}, {1, 0, 0}));
    EXPECT_TRUE(pipe.first_hit({-1, 0.2F, 0}, {1, 0, 0}));
    expect_true_distances(pipe, {0, 0, 0});
    expect_true_hits(pipe, {0, 0, 0});
}

TEST(NoBody, is_never_touched) {
    const NoBody nothing;
    EXPECT_GE(nothing.contact({0, 0, 0}).distance, nothing.band());
    EXPECT_EQ(nothing.contact({0, 0, 0}).normal, Vec3f::Zero());
    EXPECT_FALSE(nothing.first_hit({0, 0, 0}, {0, 1, 0}));
}

TEST(Collider, answers_many_points_as_it_does_one) {
    const SphereCollider sphere({0, 1, 0}, 0.25F);
    const std::vector<Vec3f> points = points_about({0, 1, 0}, 3 * kContactLanes);
    std::array<ContactBlock, 3> blocks;
    for (std::size_t i = 0; i < points.size(); ++i) {
        blocks[i / kContactLanes].set_point(i % kContactLanes, points[i]);
    }
    sphere.contacts(blocks, 1.0F);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ContactBlock& block = blocks[i / kContactLanes];
        const std::size_t lane = i % kContactLanes;
        const Contact one = sphere.contact(points[i]);
        EXPECT_EQ(block.distance[lane], one.distance);
        EXPECT_EQ(Vec3f(block.nx[lane], block.ny[lane], block.nz[lane]), one.normal);
    }
}

}  // namespace

// Batches: every kernel gives the same bits as single points.

namespace {

// A smooth part, edges and corners, and thin parts that touch: an apple on a crate with a slit beside it.
Body still_life() {
    const Body apple = shapes::sphere({0.05, 0.17, 0.05}, 0.06, 12);
    const Body crate = shapes::box({0, 0, 0}, {0.1, 0.1, 0.1}, 4);
    return shapes::together(shapes::together(apple, crate), shapes::box({0.106, 0, 0}, {0.112, 0.1, 0.1}, 4));
}

// Points about the body, some far away and some NaN.
std::vector<ContactBlock> random_points(std::size_t blocks) {
    std::mt19937 random(17);
    std::uniform_real_distribution<float> along(-0.06F, 0.26F);
    std::vector<ContactBlock> queried(blocks);
    for (ContactBlock& block : queried)
        for (std::size_t i = 0; i < kContactLanes; ++i) {
            block.x[i] = along(random);
            block.y[i] = along(random);
            block.z[i] = along(random);
        }
    queried[0].x[3] = kFar;
    queried[0].y[4] = -1e30F;
    queried[0].z[5] = std::nanf("");
    return queried;
}

std::vector<std::uint32_t> bits_of(const ContactBlock& block) {
    std::vector<std::uint32_t> bits;
    for (const ContactBlock::Lanes* row : {&block.distance, &block.nx, &block.ny, &block.nz})
        for (const float value : *row) bits.push_back(std::bit_cast<std::uint32_t>(value));
    return bits;
}

class ContactsAtLevel : public testing::TestWithParam<SimdLevel> {
 protected:
    void SetUp() override {
        if (GetParam() > detected_simd_level()) GTEST_SKIP() << "not on this processor";
    }
    std::vector<ContactBlock> ask(float reach) const {
        const SimdLimit limit(GetParam());
        std::vector<ContactBlock> blocks = random_points(700);
        collider_.contacts(blocks, reach);
        return blocks;
    }

    const Body body_ = still_life();
    const BodyCollider collider_{body_};
};

TEST_P(ContactsAtLevel, have_the_bits_of_one_contact) {
    for (const ContactBlock& block : ask(kFar)) {
        ContactBlock one_by_one = block;
        for (std::size_t i = 0; i < kContactLanes; ++i) one_by_one.set(i, collider_.contact(block.point(i)));
        ASSERT_EQ(bits_of(block), bits_of(one_by_one));
    }
}

TEST_P(ContactsAtLevel, within_the_reach_have_them_too_and_beyond_it_are_never_too_large) {
    constexpr float kReach = 0.003F;
    int near = 0;
    int too_small = 0;
    for (const ContactBlock& block : ask(kReach))
        for (std::size_t i = 0; i < kContactLanes; ++i) {
            const Contact one = collider_.contact(block.point(i));
            if (block.distance[i] < kReach) {
                ++near;
                EXPECT_EQ(block.distance[i], one.distance);
                EXPECT_EQ(Vec3f(block.nx[i], block.ny[i], block.nz[i]), one.normal);
                continue;
            }
            const auto exact = collider_.surface().closest(block.point(i), kFar);
            if (!exact) continue;
            EXPECT_LE(block.distance[i], exact->distance + collider_.max_error());
            too_small += block.distance[i] < one.distance;
        }
    EXPECT_GT(near, 500);
    EXPECT_GT(too_small, 0);  // otherwise the reach saved nothing here
}

std::string level_name(const testing::TestParamInfo<SimdLevel>& info) {
    return std::string(name_of(info.param));
}
INSTANTIATE_TEST_SUITE_P(Kernels, ContactsAtLevel,
                         testing::Values(SimdLevel::Plain, SimdLevel::Avx2, SimdLevel::Avx512), level_name);

}  // namespace

}  // namespace selvedge::sim
