#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <random>
#include <set>
#include <string>

#include "bench/thesis/limb_cylinders.h"
#include "sim/body/skin.h"
#include "sim/collide/moving_body.h"
#include "sim/motion/motion_file.h"
#include "sim/repair/load_body.h"
#include "tests/support/mannequin.h"

namespace selvedge::bench {
namespace {

std::vector<Vec2d> random_points(std::mt19937& random, int count) {
    std::uniform_real_distribution<double> along(-1, 1);
    std::vector<Vec2d> points;
    for (int i = 0; i < count; ++i) {
        const double x = along(random);
        points.emplace_back(x, along(random));
    }
    return points;
}

bool encloses_all(const Circle& circle, const std::vector<Vec2d>& points) {
    return std::ranges::all_of(
        points, [&](const Vec2d& p) { return (p - circle.centre).norm() <= circle.radius * (1 + 1e-9); });
}

// The smallest circle about a pair of points that encloses all others; none: radius 0.  (thesis fig. 5.3)
Circle circle_by_pairs(const std::vector<Vec2d>& points) {
    Circle best;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const Circle circle{.centre = (points[i] + points[j]) / 2, .radius = (points[i] - points[j]).norm() / 2};
            if (encloses_all(circle, points) && (best.radius == 0 || circle.radius < best.radius)) best = circle;
        }
    }
    return best;
}

// The smallest circle through three points that encloses all others, by trying all.
Circle circle_by_triples(const std::vector<Vec2d>& points) {
    Circle best{.radius = 1e9};
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            for (std::size_t k = 0; k < j; ++k) {
                const Vec2d a = points[j] - points[i], b = points[k] - points[i];
                Eigen::Matrix2d rows;
                rows << a.transpose(), b.transpose();
                const Vec2d centre = rows.inverse() * Vec2d(a.squaredNorm() / 2, b.squaredNorm() / 2);
                const Circle circle{.centre = points[i] + centre, .radius = centre.norm()};
                if (circle.radius < best.radius && encloses_all(circle, points)) best = circle;
            }
        }
    }
    return best;
}

TEST(LimbCylinders, the_smallest_circle_is_that_of_a_pair_of_points_or_of_three) {
    std::mt19937 random(5);
    int by_pairs = 0, by_triples = 0;
    for (int run = 0; run < 60; ++run) {
        const std::vector<Vec2d> points = random_points(random, 3 + run % 12);
        const Circle circle = smallest_circle(points), pairs = circle_by_pairs(points);
        EXPECT_TRUE(encloses_all(circle, points));
        const Circle expected = pairs.radius > 0 ? pairs : circle_by_triples(points);
        (pairs.radius > 0 ? by_pairs : by_triples) += 1;
        EXPECT_NEAR(circle.radius, expected.radius, 1e-9);
        EXPECT_LT((circle.centre - expected.centre).norm(), 1e-6);
    }
    EXPECT_GT(by_pairs, 5);
    EXPECT_GT(by_triples, 5);
}

TEST(LimbCylinders, the_smallest_circle_of_few_or_aligned_points) {
    EXPECT_EQ(smallest_circle({Vec2d(1, 2)}).radius, 0);
    EXPECT_NEAR(smallest_circle({Vec2d(0, 0), Vec2d(0, 0), Vec2d(3, 4)}).radius, 2.5, 1e-12);
    EXPECT_NEAR(smallest_circle({Vec2d(0, 0), Vec2d(1, 0), Vec2d(2, 0), Vec2d(5, 0)}).radius, 2.5, 1e-12);
}

// An arm of two bones along x: a tube of radius 4 cm whose elbow, 6 cm wide, follows both.
sim::Body make_arm() {
    constexpr int kRings = 61, kAround = 24;
    sim::Body body;
    body.bones.resize(2);
    body.bones[0].joint = Vec3d(0, 1, 0);
    body.bones[1].joint = Vec3d(0.3, 1, 0);
    body.bones[1].parent = 0;
    for (int i = 0; i < kRings; ++i) {
        const double x = 0.01 * i;
        const double share = std::clamp((x - 0.27) / 0.06, 0.0, 1.0);
        for (int j = 0; j < kAround; ++j) {
            const double angle = 2 * std::numbers::pi * j / kAround;
            body.x.emplace_back(x, 1 + 0.04 * std::cos(angle), 0.03 * std::sin(angle) + 0.01 * std::cos(9 * x));
            sim::SkinWeights skin;
            skin.bones = {0, 1, 0, 0};
            skin.weights = {static_cast<float>(1 - share), static_cast<float>(share), 0, 0};
            body.skin.push_back(skin);
        }
    }
    const auto at = [](int i, int j) { return i * kAround + j % kAround; };
    for (int i = 0; i + 1 < kRings; ++i) {
        for (int j = 0; j < kAround; ++j) {
            body.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
            body.triangles.push_back({at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
        }
    }
    sim::set_rest_from_joints(body.bones);
    return body;
}

sim::Pose bent(const sim::Body& arm, double angle) {
    sim::Pose pose = rest_pose(arm);
    turn_joint(pose, 0, Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vec3d(1, 2, 3).normalized())));
    turn_joint(pose, 1, Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vec3d::UnitZ())));
    return pose;
}

struct Search {
    int points = 0;
    int missed = 0;   // farther than the nearest triangle by over 0.1 mm
    float worst = 0;  // m
    std::size_t candidates = 0;
};

// Points that are up to `height` above or below the middle of some triangle.
Search search(const sim::Body& body, const sim::Pose& pose, const LimbOptions& options, float height) {
    std::vector<Vec3f> x;
    const sim::SkinnedSurface surface(body);
    surface.positions(body, pose, x);
    LimbBounds limbs(body, options);
    limbs.move_to(body, pose, x);
    sim::MovingBodyCollider exact(body);
    exact.place(x);
    std::mt19937 random(11);
    std::uniform_real_distribution<float> share(0, 1), above(-height, height);
    Search result;
    std::vector<std::uint32_t> triangles;
    for (int i = 0; i < 4000; ++i) {
        const auto t = static_cast<std::uint32_t>(random() % body.triangles.size());
        const auto [a, b, c] = exact.surface().triangles()[t];
        const float u = share(random), v = (1 - u) * share(random);
        const Vec3f p = x[a] + u * (x[b] - x[a]) + v * (x[c] - x[a]) + above(random) * exact.surface().face_normal(t);
        triangles.clear();
        limbs.collect_from_cylinders(p, triangles);
        limbs.collect_from_spheres(p, triangles);
        EXPECT_EQ(std::set<std::uint32_t>(triangles.begin(), triangles.end()).size(), triangles.size()) << "none twice";
        result.candidates += triangles.size();
        const auto found = limbs.nearest(p, triangles);
        const float nearest = std::abs(exact.surface().closest(p, 1)->distance);
        const float off = found ? std::abs(found->distance) - nearest : 1;
        EXPECT_GT(off, -1e-5F) << "nothing is nearer than the nearest";
        result.worst = std::max(result.worst, off);
        result.missed += off > 1e-4F ? 1 : 0;
        ++result.points;
    }
    return result;
}

TEST(LimbCylinders, find_the_nearest_triangle_of_a_bent_arm) {
    const sim::Body arm = make_arm();
    for (const double angle : {0.0, 0.6, 1.4}) {
        const Search found = search(arm, bent(arm, angle), {}, 0.006F);
        EXPECT_EQ(found.missed, 0) << "bent by " << angle << ", worst " << found.worst;
        EXPECT_LT(found.candidates / 4000, arm.triangles.size() / 10) << "a small part of the surface";
    }
}

TEST(LimbCylinders, without_a_margin_some_triangles_in_the_next_slice_are_missed) {
    const sim::Body arm = make_arm();
    const Search with = search(arm, bent(arm, 0.6), {}, 0.006F);
    const Search without = search(arm, bent(arm, 0.6), {.margin = 0, .slack = 0}, 0.006F);
    EXPECT_GT(without.missed, 0);
    EXPECT_LT(without.candidates, with.candidates);
}

TEST(LimbCylinders, are_fixed_to_their_bones) {
    const sim::Body arm = make_arm();
    LimbBounds limbs(arm, {.rigid_weight = 0.999F});
    ASSERT_EQ(limbs.cylinders().size(), 2U);
    const auto local = [&](const std::vector<Vec3f>& x) {
        std::vector<Vec3f> all;
        for (const LimbBounds::Cylinder& cylinder : limbs.cylinders()) {
            for (std::size_t t = 0; t < arm.triangles.size(); ++t) {
                if (limbs.bone_map()[t] != cylinder.bone) continue;
                for (const int v : arm.triangles[t])
                    all.emplace_back(cylinder.axes * (x[static_cast<std::size_t>(v)] - cylinder.origin));
            }
        }
        return all;
    };
    std::vector<Vec3f> x;
    const sim::SkinnedSurface surface(arm);
    surface.positions(arm, rest_pose(arm), x);
    const std::vector<Vec3f> before = local(x);
    for (const LimbBounds::Cylinder& cylinder : limbs.cylinders()) {
        EXPECT_LT((cylinder.axes * cylinder.axes.transpose() - Eigen::Matrix3f::Identity()).norm(), 1e-5F);
        EXPECT_NEAR(cylinder.radius, 0.04F, 0.005F);
        EXPECT_EQ(cylinder.stacks.size(), 14U) << "27 cm of rigid triangles in stacks of 2 cm";
    }
    const sim::Pose pose = bent(arm, 1.2);
    surface.positions(arm, pose, x);
    limbs.move_to(arm, pose, x);
    const std::vector<Vec3f> after = local(x);
    for (std::size_t i = 0; i < before.size(); ++i) ASSERT_LT((after[i] - before[i]).norm(), 1e-5F);
}

TEST(LimbCylinders, enclose_their_triangles_and_spheres_follow_the_pose) {
    const sim::Body arm = make_arm();
    LimbBounds limbs(arm, {.rigid_weight = 0.999F});
    const sim::Pose pose = bent(arm, 1.2);
    std::vector<Vec3f> x;
    sim::SkinnedSurface(arm).positions(arm, pose, x);
    limbs.move_to(arm, pose, x);
    const auto corner = [&](std::uint32_t t, std::size_t k) {
        return x[static_cast<std::size_t>(arm.triangles[t][k])];
    };
    std::set<std::uint32_t> seen;
    for (const LimbBounds::Sphere& sphere : limbs.spheres()) {
        for (std::uint32_t i = sphere.first; i < sphere.end; ++i) {
            const std::uint32_t t = limbs.deformable()[i];
            EXPECT_TRUE(seen.insert(t).second);
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_LE((corner(t, k) - sphere.centre).norm(), sphere.radius * 1.00001F);
        }
    }
    for (const LimbBounds::Cylinder& cylinder : limbs.cylinders()) {
        for (const std::uint32_t t : cylinder.listed) {
            seen.insert(t);
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3f p = cylinder.axes * (corner(t, k) - cylinder.origin);
                EXPECT_LE((p.head<2>() - cylinder.centre).norm(), cylinder.radius * 1.0001F);
                EXPECT_GE(p.z(), cylinder.low - 1e-5F);
                EXPECT_LE(p.z(), cylinder.high + 1e-5F);
            }
        }
    }
    EXPECT_EQ(seen.size(), arm.triangles.size()) << "each triangle is in a cylinder or a sphere";
}

TEST(LimbCylinders, find_the_nearest_triangles_of_a_walking_mannequin) {
    const sim::Body& body = sim::test::mannequin();
    const sim::Clip walk = sim::find_motion("walk", body);
    for (const double time : {0.0, 0.35, 0.8}) {
        const Search found = search(body, sample(body, walk, time), {}, 0.006F);
        EXPECT_EQ(found.missed, 0) << "worst " << found.worst;
    }
}

// With slack: rigid triangles whose weights are below 1 leave their bone a little.
TEST(LimbCylinders, without_slack_some_triangles_of_a_bent_mannequin_are_missed) {
    const sim::Body& body = sim::test::mannequin();
    const sim::Pose seated = sim::find_pose("sit", body);
    const Search with = search(body, seated, {}, 0.006F);
    const Search without = search(body, seated, {.rigid_weight = 0.5F, .slack = 0}, 0.006F);
    EXPECT_LE(with.missed, with.points / 1000) << "worst " << with.worst;
    EXPECT_GT(without.missed, with.missed);
}

TEST(LimbCylinders, find_the_nearest_triangles_of_a_body_from_a_file) {
    const char* data = std::getenv("SELVEDGE_TEST_DATA");
    if (data == nullptr) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set: without a body of other origin";
    const std::filesystem::path file = std::filesystem::path(data) / "bodies" / "mh_female_cmu01_01.glb";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "SELVEDGE_TEST_DATA has no " << file;
    const sim::BodyClips moving = sim::load_moving_body(file);
    const Search found = search(moving.body, sample(moving.body, moving.clips.at(0), 0.5), {}, 0.006F);
    EXPECT_LE(found.missed, found.points / 1000) << "worst " << found.worst;
}

}  // namespace
}  // namespace selvedge::bench
