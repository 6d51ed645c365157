#include "sim/body/skin.h"

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/mannequin/mannequin.h"
#include "sim/repair/load_body.h"
#include "tests/support/bodies.h"

namespace selvedge::sim {
namespace {

// A post of two bones, the upper of which starts at half its height, with a smooth joint.
Body jointed_post() {
    Body post = shapes::box({-0.1, 0, -0.1}, {0.1, 1.6, 0.1}, 8);
    post.bones = {{.name = "lower", .parent = -1, .joint = {0, 0, 0}},
                  {.name = "upper", .parent = 0, .joint = {0, 0.8, 0}}};
    set_rest_from_joints(post.bones);
    for (const Vec3d& p : post.x) {
        const float upper = std::clamp(float(p.y() - 0.6) / 0.4F, 0.0F, 1.0F);
        post.skin.push_back(upper > 0 ? SkinWeights{{1, 0}, {upper, 1 - upper}} : SkinWeights{{0}, {1}});
    }
    return post;
}

TEST(Skin, in_the_rest_pose_gives_the_surface_of_the_body) {
    const Body body = make_mannequin({.subdivisions = 1}).body;
    const std::vector<Vec3d> x = skin(body, rest_pose(body));
    for (std::size_t v = 0; v < x.size(); ++v) EXPECT_LT((x[v] - body.x[v]).norm(), 1e-7);
}

TEST(Skin, turns_what_hangs_on_a_joint_about_it) {
    const Body post = jointed_post();
    Pose pose = rest_pose(post);
    turn_joint(pose, 1, Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Vec3d::UnitX())));
    const std::vector<Vec3d> x = skin(post, pose);
    for (std::size_t v = 0; v < x.size(); ++v) {
        const Vec3d& p = post.x[v];
        if (p.y() < 0.6) {
            EXPECT_LT((x[v] - p).norm(), 1e-12);
        } else if (p.y() > 1.01) {
            EXPECT_LT((x[v] - Vec3d(p.x(), 0.8 - p.z(), p.y() - 0.8)).norm(), 1e-7);
        }
    }
}

TEST(Skin, in_single_precision_follows_the_definition) {
    const Body body = make_mannequin({.subdivisions = 1}).body;
    Pose pose = rest_pose(body);
    for (int bone = 0; bone < int(body.bones.size()); ++bone)
        turn_joint(pose, bone,
                   Eigen::Quaterniond(Eigen::AngleAxisd(0.2 + 0.01 * bone, Vec3d(1, bone, 2).normalized())));
    std::vector<Vec3f> x;
    SkinnedSurface(body).positions(body, pose, x);
    const std::vector<Vec3d> wanted = skin(body, pose);
    ASSERT_EQ(x.size(), wanted.size());
    for (std::size_t v = 0; v < x.size(); ++v) EXPECT_LT((x[v].cast<double>() - wanted[v]).norm(), 2e-6);
}

TEST(Skin, bound_in_another_pose_still_gives_the_surface_at_rest) {
    Body post = jointed_post();
    const std::vector<Vec3d> at_rest = post.x;
    post.bones[1].rest.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Vec3d::UnitZ()));
    post.bones[0].rest.scale = Vec3d::Constant(2);
    bind_at_rest(post);
    const std::vector<Vec3d> x = skin(post, rest_pose(post));
    double apart = 0;
    for (std::size_t v = 0; v < x.size(); ++v) {
        EXPECT_LT((x[v] - at_rest[v]).norm(), 1e-12);
        apart = std::max(apart, (post.bind[v] - at_rest[v]).norm());
    }
    EXPECT_GT(apart, 0.1);
}

TEST(Skin, in_centimetres_under_a_bone_that_scales_it_is_bound_in_metres) {
    Body post = jointed_post();
    const std::vector<Vec3d> at_rest = post.x;
    for (Bone& bone : post.bones) bone.inverse_bind = bone.inverse_bind * Eigen::Scaling(0.01);
    bind_at_rest(post);
    const std::vector<Vec3d> x = skin(post, rest_pose(post));
    for (std::size_t v = 0; v < x.size(); ++v) {
        EXPECT_LT((x[v] - at_rest[v]).norm(), 1e-9);
        EXPECT_LT((post.bind[v] - at_rest[v]).norm(), 1e-9);
    }
}

TEST(Skin, that_a_bone_squeezes_to_nothing_is_refused_by_name) {
    Body post = jointed_post();
    post.file = "post.glb";
    post.bones[1].rest.scale = Vec3d(1, 0, 1);
    try {
        bind_at_rest(post);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "post.glb: bone 'upper': it squeezes the skin to nothing: is its scale 0?");
    }
}

TEST(Skin, velocity_is_the_way_per_second) {
    const std::vector<Vec3f> before{{0, 1, 0}}, after{{0.1F, 1, -0.2F}};
    EXPECT_LT((velocities(before, after, 0.5F).front() - Vec3f(0.2F, 0, -0.4F)).norm(), 1e-6F);
}

TEST(Pose, between_two_poses_is_in_proportion) {
    const Body post = jointed_post();
    const Pose a = rest_pose(post);
    Pose b = a;
    turn_joint(b, 1, Eigen::Quaterniond(Eigen::AngleAxisd(1.2, Vec3d::UnitZ())));
    b.bones[0].translation = Vec3d(0, 0.4, 0.8);
    b.bones[0].scale = Vec3d::Constant(3);
    const Pose quarter = blend(a, b, 0.25);
    EXPECT_NEAR(quarter.bones[1].rotation.angularDistance(a.bones[1].rotation), 0.3, 1e-12);
    EXPECT_NEAR(quarter.bones[1].rotation.angularDistance(b.bones[1].rotation), 0.9, 1e-12);
    EXPECT_LT((quarter.bones[0].translation - Vec3d(0, 0.1, 0.2)).norm(), 1e-12);
    EXPECT_NEAR(quarter.bones[0].scale.x(), 1.5, 1e-12);
    // A rotation and its negative are the same: the way is never the long one.
    Pose negative = b;
    negative.bones[1].rotation.coeffs() *= -1;
    EXPECT_NEAR(blend(a, negative, 0.25).bones[1].rotation.angularDistance(quarter.bones[1].rotation), 0, 1e-7);
}

}  // namespace
}  // namespace selvedge::sim
