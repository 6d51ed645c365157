#include <gtest/gtest.h>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "sim/body/joint_names.h"
#include "sim/body/skin.h"
#include "sim/body/soles.h"
#include "sim/core/error.h"
#include "sim/motion/grounding.h"
#include "sim/motion/retarget.h"
#include "sim/repair/load_body.h"
#include "tests/support/mannequin.h"

namespace selvedge::sim {
namespace {

Eigen::Quaterniond about(const Vec3d& axis, double angle) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis.normalized()));
}

// Every bone of the mannequin turns, and its hips walk.
Clip lively_clip(const Body& body) {
    Clip clip{.name = "lively", .seconds = 0.5};
    for (std::size_t i = 0; i < body.bones.size(); ++i) {
        Track track{.bone = int(i)};
        for (int k = 0; k <= 30; ++k) {
            track.rotation.times.push_back(k / 60.0);
            track.rotation.values.push_back(
                about({1, double(i % 3), 2.0 * double(i % 2)}, 0.5 * std::sin(k / 6.0 + double(i))));
        }
        clip.tracks.push_back(track);
    }
    clip.tracks[0].translation = {{0, 0.5}, {body.bones[0].rest.translation, {0.1, 0.8, 0.7}}};
    return clip;
}

Vec3d joint_at(const Body& body, const Pose& pose, const std::string& bone) {
    return bone_frames(body, pose)[std::size_t(find_bone(body, bone))].translation();
}

Vec3d direction(const Body& body, const Pose& pose, const std::string& from, const std::string& to) {
    return (joint_at(body, pose, to) - joint_at(body, pose, from)).normalized();
}

// A stick figure in T-pose of cm, z up, facing -y, in the names and with the zero pose of a BVH file; its legs are half
// as long as those of a person.
Body t_pose_figure() {
    Body body;
    body.name = "figure";
    const auto add = [&](const char* name, int parent, const Vec3d& joint) {
        body.bones.push_back({.name = name, .parent = parent, .joint = joint});
    };
    add("Hips", -1, {0, 0, 50});
    add("Spine", 0, {0, 0, 60});
    add("Spine1", 1, {0, 0, 70});
    add("Head", 2, {0, 0, 100});
    for (const double side : {1.0, -1.0}) {
        const std::string name = side > 0 ? "Left" : "Right";
        const int first = int(body.bones.size());
        add((name + "Arm").c_str(), 2, {15 * side, 0, 90});
        add((name + "ForeArm").c_str(), first, {40 * side, 0, 90});
        add((name + "Hand").c_str(), first + 1, {60 * side, 0, 90});
        add((name + "UpLeg").c_str(), 0, {10 * side, 0, 45});
        add((name + "Leg").c_str(), first + 3, {10 * side, 0, 25});
        add((name + "Foot").c_str(), first + 4, {10 * side, 0, 5});
        add((name + "ToeBase").c_str(), first + 5, {10 * side, -12, 1});
    }
    set_rest_from_joints(body.bones);
    return body;
}

// Bones called "LHipJoint" and "RHipJoint" turn against the hips by as much as these turn.
TEST(Retarget, turns_the_pelvis_as_its_thighs_lie_where_joints_between_turn_too) {
    Body figure = t_pose_figure();
    const std::vector<Bone> bones = figure.bones;
    figure.bones.clear();
    std::vector<int> index(bones.size());
    for (std::size_t i = 0; i < bones.size(); ++i) {
        Bone bone = bones[i];
        if (bone.parent >= 0) bone.parent = index[std::size_t(bone.parent)];
        if (bone.name == "LeftUpLeg" || bone.name == "RightUpLeg" || bone.name == "Spine") {
            figure.bones.push_back({.name = bone.name + "Holder", .parent = bone.parent, .joint = bones[0].joint});
            bone.parent = int(figure.bones.size()) - 1;
        }
        index[i] = int(figure.bones.size());
        figure.bones.push_back(bone);
    }
    set_rest_from_joints(figure.bones);
    Clip clip{.name = "turned hips", .seconds = 1};
    clip.tracks.push_back({.bone = 0, .rotation = {{0.0}, {about({0, 0, 1}, 1.4)}}});
    for (std::size_t i = 0; i < figure.bones.size(); ++i)
        if (figure.bones[i].name.ends_with("Holder"))
            clip.tracks.push_back({.bone = int(i), .rotation = {{0.0}, {about({0, 0, 1}, -1.4)}}});
    const Body& body = test::mannequin();
    const Clip played = retarget(figure, clip, body);
    const Pose pose = sample(body, played, 0.5);
    EXPECT_GT(direction(body, pose, "right_upper_leg", "left_upper_leg").x(), 0.99);
    EXPECT_LT(direction(body, pose, "left_upper_leg", "left_foot").y(), -0.98);
    EXPECT_EQ(played.notes.size(), 1U);
}

TEST(Retarget, of_a_rest_pose_that_faces_obliquely_faces_the_front) {
    Body figure = t_pose_figure();
    for (Bone& bone : figure.bones) bone.joint = about({0, 0, 1}, 0.7) * bone.joint;
    set_rest_from_joints(figure.bones);
    const Clip clip{.name = "rest", .seconds = 1};
    const Body& body = test::mannequin();
    const Pose pose = sample(body, retarget(figure, clip, body), 0.5);
    EXPECT_GT(direction(body, pose, "right_upper_arm", "left_upper_arm").x(), 0.99);
    EXPECT_GT(direction(body, pose, "left_upper_arm", "left_hand").x(), 0.97);
    EXPECT_LT(direction(body, pose, "right_upper_arm", "right_hand").x(), -0.97);
}

TEST(Retarget, of_a_rest_pose_in_the_middle_of_a_step_keeps_its_heading) {
    Body figure = t_pose_figure();
    for (Bone& bone : figure.bones) {  // 70 cm from foot to foot
        const double side = bone.name.starts_with("Left") ? 1 : bone.name.starts_with("Right") ? -1 : 0;
        if (bone.name.ends_with("Foot") || bone.name.ends_with("ToeBase")) bone.joint.y() += 35 * side;
        if (bone.name.ends_with("ForeArm")) bone.joint = {18 * side, 0, 70};
        if (bone.name.ends_with("Hand")) bone.joint = {18 * side, 0, 50};
    }
    set_rest_from_joints(figure.bones);
    const Clip clip{.name = "rest", .seconds = 1};
    const Body& body = test::mannequin();
    const Pose pose = sample(body, retarget(figure, clip, body), 0.5);
    EXPECT_GT(direction(body, pose, "right_upper_leg", "left_upper_leg").x(), 0.99);
    EXPECT_NEAR(direction(body, pose, "left_lower_leg", "left_foot").x(), 0, 0.1);
}

TEST(Retarget, to_its_own_skeleton_gives_the_clip_itself) {
    const Body& body = test::mannequin();
    const Clip clip = lively_clip(body);
    const Clip same = retarget(body, clip, body, {.starts_at_rest = false});
    EXPECT_EQ(same.seconds, clip.seconds);
    for (int k = 0; k <= 30; ++k) {
        const Pose wanted = sample(body, clip, k / 60.0), pose = sample(body, same, k / 60.0);
        for (std::size_t i = 0; i < body.bones.size(); ++i) {
            EXPECT_LT(pose.bones[i].rotation.angularDistance(wanted.bones[i].rotation), 1e-7) << body.bones[i].name;
            EXPECT_LT((pose.bones[i].translation - wanted.bones[i].translation).norm(), 1e-9) << body.bones[i].name;
        }
    }
}

TEST(Retarget, from_a_t_pose_in_other_axes_gives_bones_the_directions_of_the_source) {
    const Body& body = test::mannequin();  // in an A-pose
    const Body figure = t_pose_figure();
    Clip clip{.name = "wave", .seconds = 1};
    for (const char* bone : {"LeftArm", "LeftForeArm", "RightUpLeg", "RightLeg", "Spine1"})
        clip.tracks.push_back({.bone = find_bone(figure, bone),
                               .rotation = {{0, 1}, {Eigen::Quaterniond::Identity(), about({0.4, 1, 0.3}, 0.9)}}});
    const Clip onto = retarget(figure, clip, body);
    const auto in_ours = [](const Vec3d& v) { return Vec3d(v.x(), v.z(), -v.y()); };
    const std::vector<std::array<std::string, 4>> bones{
        {"LeftArm", "LeftForeArm", "left_upper_arm", "left_lower_arm"},
        {"LeftForeArm", "LeftHand", "left_lower_arm", "left_hand"},
        {"RightArm", "RightForeArm", "right_upper_arm", "right_lower_arm"},
        {"RightUpLeg", "RightLeg", "right_upper_leg", "right_lower_leg"},
        {"RightLeg", "RightFoot", "right_lower_leg", "right_foot"},
        {"LeftLeg", "LeftFoot", "left_lower_leg", "left_foot"}};
    for (const double t : {0.0, 0.5, 1.0}) {
        const Pose source = sample(figure, clip, t), pose = sample(body, onto, t);
        for (const auto& [from, to, our_from, our_to] : bones)
            EXPECT_LT((direction(body, pose, our_from, our_to) - in_ours(direction(figure, source, from, to))).norm(),
                      1e-6)
                << our_from << " at " << t;
    }
    // A foot keeps its slope, which is that of its joints, and takes the heading.
    const Vec3d foot = direction(body, sample(body, onto, 0), "left_foot", "left_toe");
    EXPECT_NEAR(foot.x(), 0, 1e-6);
    EXPECT_NEAR(foot.y(), direction(body, rest_pose(body), "left_foot", "left_toe").y(), 1e-6);
}

TEST(Retarget, back_from_another_skeleton_gives_the_directions_of_the_first) {
    const Body& body = test::mannequin();
    const Body figure = t_pose_figure();
    const Clip clip = lively_clip(body);
    const Clip back = retarget(figure, retarget(body, clip, figure), body);
    const std::vector<std::array<std::string, 2>> bones{
        {"left_upper_arm", "left_lower_arm"}, {"right_lower_arm", "right_hand"}, {"left_upper_leg", "left_lower_leg"}};
    for (const double t : {0.0, 0.25, 0.5})
        for (const auto& [from, to] : bones)
            EXPECT_LT(
                (direction(body, sample(body, back, t), from, to) - direction(body, sample(body, clip, t), from, to))
                    .norm(),
                1e-6)
                << from;
}

TEST(Retarget, moves_the_hips_by_the_ratio_of_the_legs_and_starts_where_they_rest) {
    const Body& body = test::mannequin();
    Body figure = t_pose_figure();
    Clip clip{.name = "walk", .seconds = 1, .is_loop = true, .travel_bone = 0, .travel = {0, -40, 0}};
    clip.tracks.push_back({.bone = 0, .translation = {{0, 0.5, 1}, {{300, 20, 50}, {300, 0, 54}, {300, -20, 50}}}});
    const Clip onto = retarget(figure, clip, body);
    const auto leg = [&](const Body& of, const std::string& a, const std::string& b, const std::string& c) {
        const Pose rest = rest_pose(of);
        return (joint_at(of, rest, b) - joint_at(of, rest, a)).norm() +
               (joint_at(of, rest, c) - joint_at(of, rest, b)).norm();
    };
    const double ratio = leg(body, "left_upper_leg", "left_lower_leg", "left_foot") / 40;
    const auto way = [&](double t) {  // of the hips over the floor; of a foot, upward
        const Pose pose = sample(body, onto, t), rest = rest_pose(body);
        Vec3d moved = joint_at(body, pose, "hips") - joint_at(body, rest, "hips");
        moved.y() = joint_at(body, pose, "left_foot").y() - joint_at(body, rest, "left_foot").y();
        return moved;
    };
    EXPECT_LT(way(0).norm(), 1e-6);
    EXPECT_LT((way(0.5) - Vec3d(0, 4 * ratio, 20 * ratio)).norm(), 0.002);  // its legs are straighter than at rest
    EXPECT_LT((way(3) - Vec3d(0, 0, 120 * ratio)).norm(), 1e-6);
}

TEST(Retarget, puts_a_rest_pose_with_hips_at_zero_on_the_floor_that_the_feet_reach) {
    const Body& body = test::mannequin();
    Body figure = t_pose_figure();
    for (Bone& bone : figure.bones) bone.joint.z() -= 50;
    set_rest_from_joints(figure.bones);
    Clip clip{.name = "stand", .seconds = 1};
    clip.tracks.push_back({.bone = 0, .translation = {{0}, {{0, 0, 50}}}});
    const Clip onto = retarget(figure, clip, body);
    EXPECT_NEAR(joint_at(body, sample(body, onto, 0.5), "left_foot").y(),
                joint_at(body, rest_pose(body), "left_foot").y(), 1e-6);
}

// The thighs of the mannequin are longer than its shins, those of the figure are as long.
TEST(Retarget, keeps_the_feet_of_bent_legs_on_the_floor) {
    const Body& body = test::mannequin();
    const Body figure = t_pose_figure();
    Clip clip{.name = "squat", .seconds = 1};
    for (const std::string side : {"Left", "Right"}) {
        const auto turn = [&](const std::string& bone, double angle) {
            clip.tracks.push_back(
                {.bone = find_bone(figure, side + bone),
                 .rotation = {{0, 1}, {Eigen::Quaterniond::Identity(), about(Vec3d::UnitX(), angle)}}});
        };
        turn("UpLeg", -1.2);
        turn("Leg", 1.8);
        turn("Foot", -0.6);
    }
    const Vec3d sunk =
        joint_at(figure, sample(figure, clip, 1), "LeftFoot") - joint_at(figure, rest_pose(figure), "LeftFoot");
    clip.tracks.push_back({.bone = 0, .translation = {{0, 1}, {{0, 0, 50}, {0, 0, 50 - sunk.z()}}}});
    const Clip onto = retarget(figure, clip, body);
    const Pose squat = sample(body, onto, 1);
    EXPECT_NEAR(joint_at(body, squat, "left_foot").y(), joint_at(body, rest_pose(body), "left_foot").y(), 0.002);
    EXPECT_LT(joint_at(body, squat, "hips").y(), joint_at(body, rest_pose(body), "hips").y() - 0.2);
}

// From standing to standing with knees bent and hips lowered: half way, the legs alone would be too long for the hips.
TEST(BlendOnFloor, keeps_feet_at_their_height_on_the_way_between_two_poses) {
    const Body& body = test::mannequin();
    const Pose standing = rest_pose(body);
    Pose squat = standing;
    for (const std::string side : {"left_", "right_"}) {
        const auto turn = [&](const char* bone, double angle) {
            squat.bones[std::size_t(find_bone(body, side + bone))].rotation = about(Vec3d::UnitX(), angle);
        };
        turn("upper_leg", -1.2);
        turn("lower_leg", 1.8);
        turn("foot", -0.6);
    }
    const Soles soles(body, find_joints(body.bones));
    const auto foot = [&](const Pose& pose) { return soles.height(bone_frames(body, pose)); };
    shift(body, squat, Vec3d(0, foot(standing) - foot(squat), 0));
    EXPECT_GT(std::abs(foot(blend(standing, squat, 0.5)) - foot(standing)), 0.02);
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
        EXPECT_NEAR(foot(blend_on_floor(body, standing, squat, share)), foot(standing), 1e-6) << share;
}

TEST(Retarget, leaves_what_the_source_does_not_have_and_shares_the_turn_along_the_trunk) {
    const Body& body = test::mannequin();
    Body figure = t_pose_figure();
    for (const char* side : {"Left", "Right"})  // without arms, no chest is known
        figure.bones[std::size_t(find_bone(figure, std::string(side) + "Arm"))].name = "Thing";
    Clip clip{.name = "bow", .seconds = 1};
    clip.tracks.push_back({.bone = 3, .rotation = {{0}, {about(Vec3d::UnitX(), 0.6)}}});
    const Clip onto = retarget(figure, clip, body);
    const Pose pose = sample(body, onto, 0);
    const auto turned = [&](const char* name) {
        const auto i = std::size_t(find_bone(body, name));
        return pose.bones[i].rotation.angularDistance(body.bones[i].rest.rotation);
    };
    EXPECT_NEAR(turned("left_shoulder"), 0, 1e-9);
    // Four bones lead from the hips, which stand, to the head, which bows.
    for (const char* name : {"spine", "chest", "neck", "head"}) EXPECT_NEAR(turned(name), 0.15, 1e-6) << name;
}

TEST(Retarget, refuses_a_skeleton_without_known_joints_and_too_many_keys) {
    const Body& body = test::mannequin();
    Body crane;
    crane.bones = {{.name = "Boom"}};
    EXPECT_THROW(retarget(crane, {.name = "lift", .seconds = 1}, body), InputError);
    EXPECT_THROW(retarget(body, {.name = "wave", .seconds = 1}, crane), InputError);
    EXPECT_THROW(retarget(body, {.name = "long", .seconds = 100}, body, {}, {.seconds = 1000, .keys = 1000}),
                 InputError);
}

TEST(Retarget, of_many_keys_in_little_time_samples_them_at_120_hz) {
    const Body& body = test::mannequin();
    Clip clip{.name = "buzz", .seconds = 1};
    Track track{.bone = 3};
    for (int k = 0; k < 100'000; ++k) {
        track.rotation.times.push_back(k * 1e-5);
        track.rotation.values.push_back(about(Vec3d::UnitX(), 0.001 * (k % 7)));
    }
    clip.tracks.push_back(track);
    EXPECT_EQ(retarget(body, clip, body).tracks.front().rotation.times.size(), 121U);
}

TEST(Grounding, lifts_a_pose_and_a_whole_clip_once) {
    const Body& body = test::mannequin();
    Pose pose = rest_pose(body);
    pose.bones[0].translation.y() += 0.3;
    EXPECT_NEAR(stand_on_floor(body, pose), -0.3, 1e-5);
    EXPECT_NEAR(lowest_point(body, pose), 0, 1e-6);
    Clip jump{.name = "jump", .seconds = 1};
    const Vec3d hips = body.bones[0].rest.translation;
    jump.tracks.push_back(
        {.bone = 0, .translation = {{0, 0.5, 1}, {hips + Vec3d(0, -0.2, 0), hips + Vec3d(0, 0.4, 0), hips}}});
    EXPECT_NEAR(stand_on_floor(body, jump), 0.2, 1e-5);
    EXPECT_NEAR(lowest_point(body, sample(body, jump, 0.5)), 0.6, 1e-5);
    Clip still{.name = "still", .seconds = 1};
    EXPECT_NEAR(stand_on_floor(body, still), 0, 1e-6);
    EXPECT_NEAR(lowest_point(body, still), 0, 1e-6);
}

// Angle of a knee, rad; positive where it bends as knees do.
double knee_angle(const Body& body, const Pose& pose, const std::string& side) {
    const auto frames = bone_frames(body, pose);
    const auto rest = bone_frames(body, rest_pose(body));
    const Vec3d thigh = direction(body, pose, side + "upper_leg", side + "lower_leg");
    const Vec3d shin = direction(body, pose, side + "lower_leg", side + "foot");
    const auto bone = std::size_t(find_bone(body, side + "upper_leg"));
    const Vec3d to_left = frames[bone].linear() * rest[bone].linear().transpose() * Vec3d::UnitX();
    return std::atan2(thigh.cross(shin).dot(to_left), thigh.dot(shin));
}

TEST(Retarget, of_a_recorded_motion_keeps_feet_on_the_floor_and_bends_knees_backward) {
    const char* data = std::getenv("SELVEDGE_TEST_DATA");
    if (!data) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set: without recorded motion";
    const BodyClips source = load_moving_body(std::filesystem::path(data) / "bodies/mh_female_cmu01_01.glb");
    const Body& body = test::mannequin();
    Clip clip = retarget(source.body, source.clips.front(), body);
    stand_on_floor(body, clip);
    // While the source stands, between its jumps, the mannequin's feet are as high over the floor as the source's.
    std::vector<Vec3f> x, of_source;
    const SkinnedSurface surface(body), source_surface(source.body);
    double least = 1, most = -1;  // m, how much higher the mannequin's lowest point is than the source's
    int standing = 0;
    for (double t = 0; t < clip.seconds; t += 0.1) {
        const Pose pose = sample(body, clip, t), source_pose = sample(source.body, source.clips.front(), t);
        for (const std::string side : {"left_", "right_"}) EXPECT_GT(knee_angle(body, pose, side), -0.1) << t;
        source_surface.positions(source.body, source_pose, of_source);
        surface.positions(body, pose, x);
        const auto lowest = [](const std::vector<Vec3f>& all) {
            return std::ranges::min_element(all, {}, [](const Vec3f& p) { return p.y(); })->y();
        };
        if (std::abs(lowest(of_source) - lowest_point(source.body, rest_pose(source.body))) > 0.02F) continue;
        ++standing;
        least = std::min(least, double(lowest(x) - lowest(of_source)));
        most = std::max(most, double(lowest(x) - lowest(of_source)));
    }
    EXPECT_GT(standing, 30);
    EXPECT_LT(most - least, 0.02);
}

}  // namespace
}  // namespace selvedge::sim
