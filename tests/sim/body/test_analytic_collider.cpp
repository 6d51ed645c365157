#include "sim/body/analytic_collider.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace selvedge {
namespace {

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

// The point one distance back along the normal lies on the surface, and no step brings it nearer by more than its
// length: then the distance is the distance.
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

// A hit lies on the surface and on the segment; a segment from one side to the other has one, and none lies before it.
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
}  // namespace selvedge
