// Centre lines of limbs, by the skeleton and by the surface alone.
#include "sim/place/limbs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "sim/collide/surface_bvh.h"
#include "sim/repair/load_body.h"
#include "tests/support/bodies.h"
#include "tests/support/mannequin.h"
#include "tests/support/posed_body.h"

namespace selvedge::sim::test {
namespace {

Body without_bones(Body body) {
    body.bones.clear();
    body.skin.clear();
    return body;
}

Vec3d joint_of(const Body& body, const std::string& name) {
    return std::ranges::find(body.bones, name, &Bone::name)->joint;
}

TEST(Limbs, of_a_mannequin_follow_its_skeleton) {
    const BodyLimbs limbs = find_limbs(mannequin());
    ASSERT_TRUE(limbs.found().all());
    EXPECT_EQ(limbs[LimbKind::LeftArm].joints[1].centre, joint_of(mannequin(), "left_lower_arm"));
    EXPECT_EQ(limbs[LimbKind::RightLeg].joints[2].centre, joint_of(mannequin(), "right_foot"));
    EXPECT_NEAR(limbs[LimbKind::RightLeg].joints[3].centre.y(), 0, 1e-9);
    EXPECT_NEAR(limbs[LimbKind::LeftLeg].joints[0].radius, 0.08, 0.02) << "half a thigh";
    EXPECT_NEAR(limbs[LimbKind::LeftArm].joints[1].radius, 0.035, 0.01) << "half a forearm";
    for (std::size_t i = 1; i < limbs.torso.size(); ++i)
        EXPECT_GT(limbs.torso[i].centre.y(), limbs.torso[i - 1].centre.y());
}

TEST(Limbs, of_a_body_without_bones_are_found_on_its_surface) {
    const BodyLimbs known = find_limbs(mannequin()), found = find_limbs(without_bones(mannequin()));
    ASSERT_TRUE(found.found().all());
    for (const LimbKind limb : {LimbKind::LeftArm, LimbKind::RightArm, LimbKind::LeftLeg, LimbKind::RightLeg}) {
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_LT((found[limb].joints[i].centre - known[limb].joints[i].centre).norm(), 0.1)
                << name_of(limb) << ", joint " << i;
        }
    }
}

TEST(Limbs, of_a_body_in_a_t_pose_are_found_with_the_arms_level) {
    const BodyLimbs limbs = find_limbs(shapes::in_t_pose(mannequin()));
    ASSERT_TRUE(limbs.found().all());
    for (const LimbKind arm : {LimbKind::LeftArm, LimbKind::RightArm}) {
        const std::vector<LimbJoint>& joints = limbs[arm].joints;
        for (const LimbJoint& joint : joints) EXPECT_NEAR(joint.centre.y(), joints[0].centre.y(), 0.08) << name_of(arm);
        EXPECT_GT(std::abs(joints[3].centre.x()), 0.6) << name_of(arm);
        EXPECT_EQ(joints[3].centre.x() > 0, arm == LimbKind::LeftArm);
    }
}

TEST(Limbs, that_a_body_does_not_have_are_not_found) {
    const Body column = shapes::box(Vec3d(-0.15, 0, -0.1), Vec3d(0.15, 1.7, 0.1), 12);
    const BodyLimbs limbs = find_limbs(column);
    EXPECT_EQ(limbs.torso.size(), 4U);
    LimbSet head;
    head.set(index_of(LimbKind::Head));
    EXPECT_EQ(limbs.found(), head);
    EXPECT_TRUE(find_limbs(Body{}).torso.empty());
    EXPECT_TRUE(find_limbs(Body{}).found().none());
}

TEST(Limbs, without_an_arm_have_the_other_one) {
    Body body = shapes::in_t_pose(mannequin());
    for (Vec3d& x : body.x) x.x() = std::max(x.x(), -0.2);  // flattened to a stump
    const LimbSet found = find_limbs(body).found();
    EXPECT_TRUE(found[index_of(LimbKind::LeftArm)]);
    EXPECT_FALSE(found[index_of(LimbKind::RightArm)]);
}

TEST(Limbs, take_no_sliver_between_the_thighs_for_a_leg) {
    Body body = mannequin();
    body.bones.clear();
    body.skin.clear();
    const Limb expected = find_limbs(body)[LimbKind::LeftLeg];
    const double thigh = find_stature(body).floor + 0.4 * find_stature(body).height();
    const Body sliver = shapes::box({0.011, thigh - 0.02, 0.03}, {0.014, thigh + 0.02, 0.05}, 1);
    const int first = static_cast<int>(body.x.size());
    body.x.insert(body.x.end(), sliver.x.begin(), sliver.x.end());
    for (const auto& t : sliver.triangles) body.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    const Limb found = find_limbs(body)[LimbKind::LeftLeg];
    ASSERT_EQ(found.joints.size(), expected.joints.size());
    EXPECT_EQ(found.joints[0].centre, expected.joints[0].centre);
}

TEST(Limbs, name_places_on_the_body) {
    const BodyLimbs limbs = find_limbs(mannequin());
    EXPECT_EQ(place_on_body(limbs, joint_of(mannequin(), "left_foot") + Vec3d(0.04, 0.01, 0)), "left ankle");
    EXPECT_EQ(place_on_body(limbs, joint_of(mannequin(), "right_hand")), "right wrist");
    EXPECT_EQ(place_on_body(limbs, limbs.torso[1].centre + Vec3d(0, 0, 0.1)), "waist");
    const Vec3d thigh = (limbs[LimbKind::LeftLeg].joints[0].centre + limbs[LimbKind::LeftLeg].joints[1].centre) / 2;
    EXPECT_EQ(place_on_body(limbs, thigh), "left thigh");
    EXPECT_EQ(place_on_body(limbs, Vec3d(0, limbs.height.high, 0.05)), "head");
    EXPECT_EQ(place_on_body(find_limbs(Body{}), Vec3d::Zero()), "");
}

// Depth of the shallowest point of an arm's line but its end, m; negative outside.
double least_depth(const Body& body, const Limb& arm) {
    const SurfaceBvh surface(body);
    double least = 1;
    for (std::size_t i = 0; i + 1 < arm.line.size(); ++i) {
        for (const double share : {0.0, 0.25, 0.5, 0.75}) {
            const Vec3d p = arm.line[i] + share * (arm.line[i + 1] - arm.line[i]);
            least = std::min(least, -static_cast<double>(surface.closest(p.cast<float>(), 1.0F)->distance));
        }
    }
    return least;
}

TEST(Limbs, have_lines_that_stay_within_the_body) {
    std::vector<Body> bodies{without_bones(mannequin()), shapes::in_t_pose(mannequin())};
    const char* data = std::getenv("SELVEDGE_TEST_DATA");
    for (const char* file : {"mh_female.obj", "mh_female_cc1.obj"}) {
        if (data) bodies.push_back(load_body(std::filesystem::path(data) / "bodies" / file));
    }
    for (const Body& body : bodies) {
        const BodyLimbs limbs = find_limbs(body);
        for (const LimbKind arm : {LimbKind::LeftArm, LimbKind::RightArm})
            EXPECT_GT(least_depth(body, limbs[arm]), 0) << name_of(arm);
    }
    if (!data) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set: without bodies whose arms are bent";
}

// As characters of games are: a shell of closed parts over a skeleton with the names of another program.
TEST(Limbs, of_separate_parts_are_at_the_joints_that_the_skeleton_names) {
    Body parts = mannequin();
    const auto bone = [&](const char* name) -> Bone& { return *std::ranges::find(parts.bones, name, &Bone::name); };
    for (const auto& [name, other] :
         {std::pair("left_upper_arm", "mixamorig:LeftArm"), std::pair("left_lower_arm", "mixamorig:LeftForeArm"),
          std::pair("left_hand", "mixamorig:LeftHand"), std::pair("right_upper_arm", "mixamorig:RightArm"),
          std::pair("right_lower_arm", "mixamorig:RightForeArm"), std::pair("right_hand", "mixamorig:RightHand"),
          std::pair("left_foot", "mixamorig:LeftFoot"), std::pair("hips", "mixamorig:Hips"),
          std::pair("left_upper_leg", "mixamorig:LeftUpLeg")})
        bone(name).name = other;
    // Without the triangles across the elbows, the forearms are parts of their own.
    const double elbow = bone("mixamorig:LeftForeArm").joint.x();
    std::erase_if(parts.triangles, [&](const std::array<int, 3>& triangle) {
        const auto [low, high] = std::minmax({std::abs(parts.x[static_cast<std::size_t>(triangle[0])].x()),
                                              std::abs(parts.x[static_cast<std::size_t>(triangle[1])].x()),
                                              std::abs(parts.x[static_cast<std::size_t>(triangle[2])].x())});
        return low <= elbow && elbow < high;
    });
    const BodyLimbs whole = find_limbs(mannequin()), found = find_limbs(parts);
    for (const LimbKind arm : {LimbKind::LeftArm, LimbKind::RightArm}) {
        ASSERT_TRUE(found[arm].is_found) << name_of(arm);
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_LT((found[arm].joints[i].centre - whole[arm].joints[i].centre).norm(), 0.01) << name_of(arm) << i;
    }
    EXPECT_TRUE(found.found().all());
    EXPECT_FALSE(find_limbs(without_bones(parts))[LimbKind::LeftArm].is_found) << "the surface does not show it";
}

TEST(Limbs, of_scanned_and_modelled_bodies_are_all_found) {
    const char* data = std::getenv("SELVEDGE_TEST_DATA");
    if (!data) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set";
    for (const char* file : {"mh_female.obj", "mh_female_cc1.obj", "CesiumMan.glb", "RiggedFigure.gltf"}) {
        const BodyLimbs limbs = find_limbs(load_body(std::filesystem::path(data) / "bodies" / file));
        EXPECT_TRUE(limbs.found().all()) << file;
        for (const LimbKind arm : {LimbKind::LeftArm, LimbKind::RightArm}) {
            if (!limbs[arm].is_found) continue;
            const double tip = limbs[arm].joints[3].centre.x();
            EXPECT_GT(arm == LimbKind::LeftArm ? tip : -tip, 0.35) << file;
        }
    }
}

}  // namespace
}  // namespace selvedge::sim::test
