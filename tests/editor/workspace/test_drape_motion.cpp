// What the drape asks of its session: poses and motions that are looked for in the background, played and put back.
#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "editor/workspace/workspace.h"
#include "sim/body/yielding_flesh.h"
#include "sim/core/error.h"
#include "sim/motion/motion_file.h"
#include "sim/pattern/pattern_file.h"
#include "sim/session/animation.h"
#include "tests/support/checkout.h"

namespace selvedge::editor {
namespace {

class DrapeOnMovingBody : public testing::Test {
 protected:
    DrapeOnMovingBody() {
        workspace_.drape.options().max_level = 0;
        update(2);
    }
    void update(int frames) {
        for (int i = 0; i < frames; ++i) workspace_.drape.update(*workspace_.document, workspace_.messages);
    }
    void settle() {
        drape().session().start();
        drape().session().advance(600);
        ASSERT_EQ(frame()->stage, sim::SessionStage::Settled);
    }
    Drape& drape() { return workspace_.drape; }
    std::shared_ptr<const sim::SessionFrame> frame() { return drape().frame(); }

    std::vector<std::string> sought_;
    Workspace workspace_{sim::load_pattern(std::filesystem::path(source_folder()) / "patterns" / "two_squares.json"),
                         sim::SessionDrive::Caller, make_mannequin_body,
                         [this](const std::string& text, const sim::Body& body) {
                             sought_.push_back(text);
                             return sim::find_motion(text, body);
                         }};
};

TEST_F(DrapeOnMovingBody, goes_to_a_pose_and_back) {
    settle();
    drape().choose_pose("stride");
    update(60);
    EXPECT_EQ(sought_, std::vector<std::string>{"stride"});
    EXPECT_FALSE(frame()->motion.is_at_rest);
    EXPECT_EQ(workspace_.messages.count(), 0U);
    drape().choose_pose("");
    update(60);
    EXPECT_TRUE(frame()->motion.is_at_rest);
}

TEST_F(DrapeOnMovingBody, goes_on_when_a_pose_is_chosen_while_it_is_paused) {
    settle();
    drape().session().pause();
    update(1);
    drape().choose_pose("T");
    update(10);
    EXPECT_TRUE(frame()->is_running);
    EXPECT_NE(frame()->motion.x, nullptr);
}

TEST_F(DrapeOnMovingBody, does_not_sew_because_a_pose_is_chosen) {
    drape().choose_pose("T");
    update(5);
    EXPECT_EQ(frame()->stage, sim::SessionStage::Placed);
    EXPECT_TRUE(frame()->motion.is_waiting);
}

TEST_F(DrapeOnMovingBody, sews_to_play_a_motion_and_plays_it_when_the_garment_hangs) {
    EXPECT_FALSE(drape().can_play());
    drape().play();
    update(1);
    EXPECT_FALSE(frame()->is_running) << "there is no motion";
    drape().choose_motion("walk");
    drape().play();
    update(5);
    EXPECT_TRUE(frame()->is_running);
    EXPECT_TRUE(frame()->motion.is_playing);
    EXPECT_TRUE(frame()->motion.is_waiting);
    drape().session().advance(600);
    EXPECT_FALSE(frame()->motion.is_waiting);
    EXPECT_GT(frame()->motion.way.norm(), 1);
    drape().pause_motion();
    update(1);
    EXPECT_FALSE(frame()->motion.is_playing);
}

TEST_F(DrapeOnMovingBody, takes_the_speed_and_seeks) {
    settle();
    drape().choose_motion("walk");
    drape().set_playback({.speed = 0.5, .is_loop = false});
    update(2);
    drape().seek(0.4);
    update(60);
    EXPECT_NEAR(frame()->motion.seconds, 0.4, 1e-9);
    EXPECT_TRUE(frame()->motion.is_in_motion);
    drape().play();
    update(31);
    EXPECT_NEAR(frame()->motion.seconds, 0.9, 0.05);
}

TEST_F(DrapeOnMovingBody, is_dressed_again_at_once_back_at_the_start) {
    settle();
    const std::vector<Vec3f> dressed = frame()->mesh.x;
    drape().choose_pose("T");
    update(40);
    drape().back_to_start();
    update(2);
    EXPECT_EQ(frame()->mesh.x, dressed);
    EXPECT_EQ(drape().activity().pose, "");
    drape().choose_pose("T");
    update(3);
    EXPECT_NE(frame()->motion.x, nullptr) << "the same pose again";
}

TEST_F(DrapeOnMovingBody, has_neither_pose_nor_motion_that_cannot_be_found_and_says_why) {
    settle();
    drape().choose_motion("no_such_motion.bvh");
    drape().play();
    update(3);
    EXPECT_EQ(drape().activity().motion, "");
    ASSERT_NE(workspace_.messages.shown(), nullptr);
    EXPECT_EQ(workspace_.messages.shown()->kind, MessageKind::Error);
    EXPECT_NE(workspace_.messages.shown()->text.find("no_such_motion"), std::string::npos);
    update(3);
    EXPECT_EQ(sought_.size(), 1U) << "not again and again";
    EXPECT_FALSE(frame()->motion.is_playing);
}

TEST_F(DrapeOnMovingBody, puts_another_body_into_the_same_pose_and_motion) {
    settle();
    drape().choose_pose("T");
    drape().choose_motion("walk");
    update(3);
    drape().show_body("mannequin:sex=male");
    update(5);
    EXPECT_EQ(sought_, (std::vector<std::string>{"T", "walk", "T", "walk"}));
    EXPECT_GT(frame()->motion.length, 0.5);
}

TEST(DrapeOnAnimatedBody, plays_the_first_motion_of_its_file_if_none_is_chosen) {
    const auto made = [](const std::string& text) {
        sim::MadeBody made_body = make_mannequin_body(text).made();
        for (const char* name : {"", "turns", "waves"}) {
            made_body.clips.push_back(sim::find_motion("walk", *made_body.body));
            made_body.clips.back().name = name;
        }
        return current_body(std::move(made_body));
    };
    Workspace workspace(sim::load_pattern(std::filesystem::path(source_folder()) / "patterns" / "two_squares.json"),
                        sim::SessionDrive::Caller, made);
    Drape& drape = workspace.drape;
    EXPECT_FALSE(drape.can_play()) << "no body is ready";
    drape.update(*workspace.document, workspace.messages);
    EXPECT_TRUE(drape.can_play());
    drape.play();
    EXPECT_EQ(drape.activity().motion, "turns") << "what has no name cannot be chosen";
    for (int i = 0; i < 5; ++i) drape.update(*workspace.document, workspace.messages);
    EXPECT_TRUE(drape.frame()->motion.is_playing);
}

TEST(DrapeOnTPose, has_its_own_pose_chosen_and_goes_back_to_the_one_in_which_it_is_dressed) {
    const auto made = [](const std::string& text) {
        const CurrentBody usual = make_mannequin_body(kDefaultBody);
        const sim::Pose pose = sim::find_pose("T", *usual.body());
        return current_body({.source = text, .body = std::make_shared<const sim::Body>(posed(*usual.body(), pose))});
    };
    Workspace workspace(sim::load_pattern(std::filesystem::path(source_folder()) / "patterns" / "two_squares.json"),
                        sim::SessionDrive::Caller, made);
    Drape& drape = workspace.drape;
    drape.options().max_level = 0;
    const auto update = [&](int frames) {
        for (int i = 0; i < frames; ++i) drape.update(*workspace.document, workspace.messages);
    };
    const auto arm = [&] { return angles_of(*drape.angles(), drape.current_body().joints[6])[1]; };  // rad
    update(2);
    EXPECT_EQ(drape.activity().pose, kOwnPose);
    drape.session().start();
    update(700);
    EXPECT_FALSE(drape.frame()->motion.is_at_rest) << "it went into its own pose";
    drape.back_to_start();
    update(20);
    EXPECT_EQ(drape.activity().pose, "");
    EXPECT_TRUE(drape.frame()->motion.is_at_rest);
    EXPECT_LT(arm(), 1) << "lowered";
    drape.choose_pose(kOwnPose);
    update(100);
    EXPECT_FALSE(drape.frame()->motion.is_at_rest);
    EXPECT_GT(arm(), 1.3);
    drape.reset();
    EXPECT_EQ(drape.activity().pose, kOwnPose);
}

// The mannequin's joint of that title.
BodyJoint joint_of(const Drape& drape, const std::string& title) {
    return *std::ranges::find(drape.current_body().joints, title, &BodyJoint::title);
}

TEST(BodyJoints, are_listed_by_plain_names_with_other_bones_last) {
    sim::Body body = *make_mannequin_body(kDefaultBody).body();
    body.bones[static_cast<std::size_t>(sim::find_joints(body.bones)[sim::Joint::LeftHand])].name = "claw";
    const std::vector<BodyJoint> joints = joints_of(body);
    EXPECT_EQ(joints.size(), body.bones.size());
    EXPECT_EQ(joints.front().title, "Hips");
    EXPECT_FALSE(joints.front().above.has_value());
    const auto elbow = std::ranges::find(joints, "Left elbow", &BodyJoint::title);
    ASSERT_NE(elbow, joints.end());
    EXPECT_EQ(joints.at(elbow->above.value()).title, "Left shoulder");
    EXPECT_EQ(joints.back().title, "claw");
    EXPECT_FALSE(joints.back().joint.has_value());
    body.skin.clear();
    EXPECT_TRUE(joints_of(body).empty()) << "nothing to turn";
}

TEST_F(DrapeOnMovingBody, turns_joints_from_the_pose_that_was_chosen_and_resets_them) {
    settle();
    drape().choose_pose("stride");
    update(1);
    EXPECT_EQ(drape().angles(), nullptr) << "the pose is looked for";
    update(60);
    ASSERT_NE(drape().angles(), nullptr);
    const sim::PoseAngles stride = *drape().angles();
    const BodyJoint elbow = joint_of(drape(), "Left elbow"), other = joint_of(drape(), "Right elbow");
    sim::PoseAngles turned = stride;
    set_angles(turned, elbow, Vec3d(1, 0, 0), true);
    drape().turn(turned);
    update(90);
    EXPECT_EQ(*drape().angles(), turned);
    ASSERT_NE(frame()->motion.pose, nullptr);
    const sim::PoseAngles shown = pose_angles(*drape().current_body().body(), *frame()->motion.pose);
    EXPECT_NEAR(angles_of(shown, elbow)[0], 1, 1e-3) << "the body went there";
    EXPECT_NEAR(angles_of(shown, other)[0], 1, 1e-3);
    drape().reset_angles(elbow, false);
    EXPECT_EQ(angles_of(*drape().angles(), elbow), angles_of(stride, elbow));
    EXPECT_EQ(angles_of(*drape().angles(), other)[0], 1);
    drape().reset_angles();
    update(90);
    EXPECT_FALSE(drape().activity().turned.has_value());
    EXPECT_EQ(drape().activity().pose, "stride");
    const sim::PoseAngles again = pose_angles(*drape().current_body().body(), *frame()->motion.pose);
    EXPECT_LT((angles_of(again, elbow) - angles_of(stride, elbow)).norm(), 1e-3);
}

TEST_F(DrapeOnMovingBody, forgets_turned_joints_when_it_plays_and_back_at_the_start) {
    settle();
    sim::PoseAngles turned = *drape().angles();
    set_angles(turned, joint_of(drape(), "Neck"), Vec3d(0.3, 0, 0), true);
    drape().turn(turned);
    drape().choose_motion("walk");
    update(10);
    drape().play();
    EXPECT_FALSE(drape().activity().turned.has_value());
    update(60);
    EXPECT_TRUE(frame()->motion.is_playing);
    ASSERT_NE(drape().angles(), nullptr);
    drape().turn(*drape().angles());
    update(5);
    EXPECT_FALSE(frame()->motion.is_playing) << "a turn stops the motion where it is";
    drape().back_to_start();
    update(1);
    EXPECT_FALSE(drape().activity().turned.has_value());
    EXPECT_TRUE(frame()->motion.is_at_rest);
}

TEST_F(DrapeOnMovingBody, puts_another_body_into_the_turned_pose) {
    settle();
    const BodyJoint elbow = joint_of(drape(), "Left elbow");
    sim::PoseAngles turned = *drape().angles();
    set_angles(turned, elbow, Vec3d(1, 0, 0), true);
    drape().turn(turned);
    update(60);
    drape().show_body("mannequin:sex=female,bust=94");
    update(400);
    ASSERT_NE(frame()->motion.pose, nullptr);
    const sim::PoseAngles shown = pose_angles(*drape().current_body().body(), *frame()->motion.pose);
    EXPECT_NEAR(angles_of(shown, elbow)[0], 1, 1e-3);
}

}  // namespace
}  // namespace selvedge::editor
