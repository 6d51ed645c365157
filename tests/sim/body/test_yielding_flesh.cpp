#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <numbers>
#include <string>

#include "sim/body/yielding_flesh.h"
#include "sim/motion/motion_file.h"
#include "sim/repair/load_body.h"
#include "sim/repair/self_intersections.h"
#include "tests/support/mannequin.h"

namespace selvedge::sim {
namespace {

// Adds a closed tube about a vertical axis, from height 0 to 0.6 m, moved by one bone.
void add_tube(Body& body, double radius, double middle, std::uint16_t bone) {
    constexpr int kRound = 32, kRings = 41;
    const int first = int(body.x.size());
    for (int ring = 0; ring < kRings; ++ring) {
        for (int i = 0; i < kRound; ++i) {
            const double angle = 2 * std::numbers::pi * i / kRound;
            body.x.emplace_back(middle + radius * std::cos(angle), 0.6 * ring / (kRings - 1), radius * std::sin(angle));
        }
    }
    const auto at = [&](int ring, int i) { return first + ring * kRound + i % kRound; };
    for (int ring = 0; ring + 1 < kRings; ++ring) {
        for (int i = 0; i < kRound; ++i) {
            body.triangles.push_back({at(ring, i), at(ring + 1, i), at(ring, i + 1)});
            body.triangles.push_back({at(ring, i + 1), at(ring + 1, i), at(ring + 1, i + 1)});
        }
    }
    for (const int ring : {0, kRings - 1}) {
        const int centre = int(body.x.size());
        body.x.emplace_back(middle, ring == 0 ? 0 : 0.6, 0);
        for (int i = 0; i < kRound; ++i)
            body.triangles.push_back(ring == 0 ? std::array{centre, at(ring, i), at(ring, i + 1)}
                                               : std::array{centre, at(ring, i + 1), at(ring, i)});
    }
    while (body.skin.size() < body.x.size()) body.skin.push_back({.bones = {bone}, .weights = {1}});
}

// A trunk of 12 cm radius and an arm of 4 cm beside it, 20 cm apart.
Body trunk_and_arm() {
    Body body;
    body.bones = {{.name = "trunk"}, {.name = "arm", .parent = 0}};
    set_rest_from_joints(body.bones);
    add_tube(body, 0.12, 0, 0);
    add_tube(body, 0.04, 0.36, 1);
    return body;
}

// Near the sharp edges of the tubes.
bool is_at_end(const Vec3f& x) {
    return std::abs(x.y() - 0.3F) > 0.27F;
}

// With the arm so far from the trunk, m; less than 0: in it.
Pose with_gap(const Body& body, double gap) {
    Pose pose = rest_pose(body);
    pose.bones[1].translation.x() += gap - 0.2;
    return pose;
}

// Between the surfaces of both at half their height, along x, m.
double gap_of(const Body& body, const std::vector<Vec3f>& x) {
    float trunk = -1, arm = 1;
    for (std::size_t v = 0; v < x.size(); ++v) {
        if (std::abs(x[v].y() - 0.3F) > 0.01F || std::abs(x[v].z()) > 0.002F) continue;
        if (body.skin[v].bones[0] == 0) trunk = std::max(trunk, x[v].x());
        if (body.skin[v].bones[0] == 1) arm = std::min(arm, x[v].x());
    }
    return double(arm - trunk);
}

TEST(YieldingFlesh, leaves_sides_with_room_as_they_are) {
    const Body body = trunk_and_arm();
    std::vector<Vec3f> x, skinned;
    for (const double gap : {0.2, 0.03, 0.015}) {
        FleshSurface(body).positions(body, with_gap(body, gap), x);
        SkinnedSurface(body).positions(body, with_gap(body, gap), skinned);
        for (std::size_t v = 0; v < x.size(); ++v) {
            if (is_at_end(x[v])) continue;
            EXPECT_EQ(x[v], skinned[v]) << gap;
        }
    }
}

TEST(YieldingFlesh, makes_room_between_sides_that_overlap) {
    const Body body = trunk_and_arm();
    std::vector<Vec3f> x;
    for (const double gap : {0.004, -0.01, -0.03}) {
        FleshSurface(body).positions(body, with_gap(body, gap), x);
        EXPECT_NEAR(gap_of(body, x), 0.008, 0.002) << gap;
        Body posed = body;
        std::ranges::transform(x, posed.x.begin(), [](const Vec3f& p) { return Vec3d(p.cast<double>()); });
        for (const auto& pair : self_intersections(posed)) {
            const Vec3f& at = x[std::size_t(posed.triangles[std::size_t(pair[0])][0])];
            EXPECT_TRUE(is_at_end(at)) << gap << ": " << at.transpose();
        }
    }
}

TEST(YieldingFlesh, gives_way_in_a_region_as_it_does_in_the_whole_body) {
    const Body body = trunk_and_arm();
    std::vector<Vec3f> skinned, whole;
    SkinnedSurface(body).positions(body, with_gap(body, -0.02), skinned);
    const YieldingFlesh flesh(body);
    flesh.give_way(whole = skinned);
    std::vector<Vec3f> above;
    for (const Vec3f& p : skinned)
        if (p.y() > 0.45F) above.push_back(p);
    const Region region(above, 0.02F);
    std::vector<Vec3f> x = skinned;
    flesh.give_way(x, region);
    int gone_back = 0, left = 0;
    for (std::size_t v = 0; v < x.size(); ++v) {
        if (region.contains(skinned[v])) {
            EXPECT_EQ(x[v], whole[v]);
            gone_back += x[v] != skinned[v] ? 1 : 0;
        }
        left += x[v] == skinned[v] && whole[v] != skinned[v] ? 1 : 0;
    }
    EXPECT_GT(gone_back, 10);
    EXPECT_GT(left, 10) << "far from the region";
}

TEST(YieldingFlesh, goes_back_farther_where_it_is_thicker) {
    const Body body = trunk_and_arm();
    std::vector<Vec3f> x, skinned;
    FleshSurface(body).positions(body, with_gap(body, -0.02), x);
    SkinnedSurface(body).positions(body, with_gap(body, -0.02), skinned);
    double most[2] = {0, 0};
    for (std::size_t v = 0; v < x.size(); ++v) {
        double& of = most[body.skin[v].bones[0]];
        of = std::max(of, double((x[v] - skinned[v]).norm()));
    }
    EXPECT_NEAR(most[0] / most[1], 0.2 / 0.08, 0.8);  // thicknesses: a trunk counts as 20 cm at most
}

TEST(YieldingFlesh, changes_little_when_the_pose_does) {
    const Body body = trunk_and_arm();
    const FleshSurface surface(body);
    std::vector<Vec3f> last, x;
    surface.positions(body, with_gap(body, 0.02), last);
    for (double gap = 0.0198; gap > -0.07; gap -= 0.0002) {
        surface.positions(body, with_gap(body, gap), x);
        float farthest = 0;
        for (std::size_t v = 0; v < x.size(); ++v) farthest = std::max(farthest, (x[v] - last[v]).norm());
        EXPECT_LT(farthest, gap > -0.045 ? 0.002F : 0.015F) << gap;  // a deeper arm is let go
        last = x;
    }
}

TEST(YieldingFlesh, keeps_the_surface_that_the_skin_was_bound_in) {
    const Body& body = test::mannequin();
    std::vector<Vec3f> x;
    FleshSurface(body).positions(body, rest_pose(body), x);
    for (std::size_t v = 0; v < x.size(); ++v) ASSERT_LT((x[v].cast<double>() - body.x[v]).norm(), 2e-5);
}

TEST(YieldingFlesh, leaves_a_surface_that_is_not_finite_as_it_is) {
    const Body body = trunk_and_arm();
    std::vector<Vec3f> x;
    SkinnedSurface(body).positions(body, with_gap(body, -0.02), x);
    for (Vec3f& p : x) p.y() = std::numeric_limits<float>::quiet_NaN();
    const float first = x.front().x();
    YieldingFlesh(body).give_way(x);
    EXPECT_EQ(x.front().x(), first);
}

TEST(YieldingFlesh, of_a_moving_body_goes_between_the_times_at_which_it_is_found) {
    const Body body = trunk_and_arm();
    const auto pose_at = [&](double seconds) { return with_gap(body, 0.01 - 0.3 * seconds); };
    MovingFlesh moving(body);
    std::vector<Vec3f> x, wanted;
    for (int step = 0; step <= 12; ++step) {
        const double seconds = step * MovingFlesh::kFleshSeconds / 2;
        moving.positions(body, pose_at, seconds, Region(), x);
        FleshSurface(body).positions(body, pose_at(seconds), wanted);
        float farthest = 0;
        for (std::size_t v = 0; v < x.size(); ++v) farthest = std::max(farthest, (x[v] - wanted[v]).norm());
        EXPECT_LT(farthest, step % 2 == 0 ? 1e-6F : 0.0008F) << step;
    }
}

TEST(YieldingFlesh, takes_the_arms_of_a_recorded_motion_out_of_the_trunk) {
    const char* data = std::getenv("SELVEDGE_TEST_DATA");
    if (!data) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set";
    const BodyClips own = load_moving_body(std::filesystem::path(data) / "bodies/mh_female_cmu01_01.glb");
    const auto part = [&](int triangle) {
        const SkinWeights& skin = own.body.skin[std::size_t(own.body.triangles[std::size_t(triangle)][0])];
        return own.body.bones[skin.bones[std::size_t(std::ranges::max_element(skin.weights) - skin.weights.begin())]]
            .name;
    };
    const auto is_arm = [](const std::string& name) { return name.ends_with("Arm") || name.ends_with("Hand"); };
    const auto arm_cuts = [&](const std::vector<Vec3f>& x) {
        Body posed;
        for (const Vec3f& p : x) posed.x.emplace_back(p.cast<double>());
        posed.triangles = own.body.triangles;
        return std::ranges::count_if(self_intersections(posed), [&](const std::array<int, 2>& pair) {
            return is_arm(part(pair[0])) != is_arm(part(pair[1]));
        });
    };
    const FleshSurface surface(own.body);
    const SkinnedSurface skin(own.body);
    std::vector<Vec3f> x, skinned;
    long before = 0, after = 0;
    for (const double seconds : {3.5, 6.0, 9.9, 10.5}) {
        const Pose pose = sample(own.body, own.clips.front(), seconds);
        skin.positions(own.body, pose, skinned);
        surface.positions(own.body, pose, x);
        before += arm_cuts(skinned);
        after += arm_cuts(x);
    }
    EXPECT_GT(before, 100);
    EXPECT_LT(after, before / 20);
}

}  // namespace
}  // namespace selvedge::sim
