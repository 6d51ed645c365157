// Poses and motions in the Body tab.
#include <gtest/gtest.h>

#include <algorithm>

#include "editor/inspectors/motion_names.h"
#include "tests/editor/inspectors/inspector_support.h"

namespace selvedge::editor {
namespace {

int index_of(const MotionChoices& choices, const std::string& text) {
    return static_cast<int>(std::ranges::find(choices.texts, text) - choices.texts.begin());
}

TEST(MotionNames, list_what_ships_once_each_and_the_file_that_is_chosen) {
    Workspace workspace(empty_garment(), sim::SessionDrive::Caller, make_mannequin_body);
    MotionChoices motions = motion_choices(workspace.drape);
    EXPECT_EQ(motions.shown, "No motion");
    EXPECT_EQ(motions.texts.front(), "");
    EXPECT_EQ(motions.texts.size(), motions.titles.size());
    EXPECT_NE(std::ranges::find(motions.titles, "Walk"), motions.titles.end());
    workspace.drape.choose_motion("clips/dance.bvh");
    motions = motion_choices(workspace.drape);
    EXPECT_EQ(motions.shown, "dance.bvh");
    EXPECT_EQ(motions.texts.back(), "clips/dance.bvh");
    EXPECT_EQ(title_of("arms_up"), "Arms up");
    EXPECT_EQ(title_of("T"), "T-pose");
}

TEST(MotionNames, offer_each_pose_once) {
    Workspace workspace(empty_garment(), sim::SessionDrive::Caller, make_mannequin_body);
    std::vector<std::string> texts = pose_choices(workspace.drape).texts;
    std::ranges::sort(texts);
    EXPECT_EQ(std::ranges::adjacent_find(texts), texts.end());
    EXPECT_GE(texts.size(), 6U);
}

TEST(BodyInspector, chooses_a_pose_and_a_motion_and_plays_it) {
    InspectorFixture inspector(shipped_pattern("two_squares.json"), draw_body);
    Drape& drape = inspector.workspace.drape;
    drape.update(inspector.document(), inspector.workspace.messages);
    inspector.frame();
    inspector.click("body.pose");
    inspector.frame();
    inspector.click("body.pose." + std::to_string(index_of(pose_choices(drape), "T")));
    EXPECT_EQ(drape.activity().pose, "T");
    inspector.frame();
    inspector.click("body.play");
    EXPECT_FALSE(drape.frame()->is_running) << "there is no motion yet";
    inspector.click("body.motion");
    inspector.frame();
    inspector.click("body.motion." + std::to_string(index_of(motion_choices(drape), "walk")));
    EXPECT_EQ(drape.activity().motion, "walk");
    inspector.frame();
    inspector.click("body.play");
    for (int i = 0; i < 4; ++i) drape.update(inspector.document(), inspector.workspace.messages);
    EXPECT_TRUE(drape.frame()->is_running);
    EXPECT_TRUE(drape.frame()->motion.is_playing);
    EXPECT_LE(inspector.overhang_px(), 0.5F);
}

class JointsInInspector : public testing::Test {
 protected:
    JointsInInspector() {
        drape().update(inspector_.document(), inspector_.workspace.messages);
        inspector_.frame();
    }
    Drape& drape() { return inspector_.workspace.drape; }
    const BodyJoint& joint(const std::string& title) {
        return *std::ranges::find(drape().current_body().joints, title, &BodyJoint::title);
    }
    Vec3d angles(const std::string& title) { return angles_of(*drape().angles(), joint(title)); }
    void choose(const std::string& title) {
        inspector_.workspace.joint.bone = joint(title).bone;
        inspector_.frame();
    }
    void type(const std::string& box, const std::string& text) {
        inspector_.click(box);
        inspector_.type(text);
        inspector_.key(Key::Enter);
        inspector_.frame();
    }

    InspectorFixture inspector_{shipped_pattern("two_squares.json"), draw_body};
};

TEST_F(JointsInInspector, are_chosen_from_a_list_and_turned_by_degrees_on_both_sides) {
    EXPECT_FALSE(inspector_.widgets.contains("joint.bend")) << "none is chosen";
    inspector_.click("joint.list");
    inspector_.frame();
    const auto index = &joint("Left elbow") - drape().current_body().joints.data();
    inspector_.click("joint.list." + std::to_string(index));
    inspector_.frame();
    EXPECT_EQ(inspector_.workspace.joint.bone, joint("Left elbow").bone);
    type("joint.bend", "90");
    EXPECT_NEAR(angles("Left elbow")[0], 3.14159265358979 / 2, 1e-9);
    EXPECT_EQ(angles("Right elbow"), angles("Left elbow"));
    EXPECT_EQ(pose_choices(drape()).shown, "Turned by hand");
    inspector_.click("joint.both");
    inspector_.frame();
    type("joint.twist", "20");
    EXPECT_NE(angles("Right elbow")[2], angles("Left elbow")[2]);
    EXPECT_FALSE(inspector_.document().can_undo()) << "a pose is no part of the pattern";
    EXPECT_LE(inspector_.overhang_px(), 0.5F);
}

TEST_F(JointsInInspector, are_turned_by_dragging_a_label_and_reset) {
    choose("Left knee");
    const Vec3d left = angles("Left knee"), right = angles("Right knee");
    inspector_.drag("drag joint.bend", 60);
    EXPECT_GT(angles("Left knee")[0], left[0] + 0.2);
    inspector_.let_go();
    inspector_.frame();
    inspector_.click("joint.reset");
    EXPECT_EQ(angles("Left knee"), left);
    EXPECT_EQ(angles("Right knee"), right);
    inspector_.frame();
    inspector_.click("joint.reset_all");
    EXPECT_FALSE(drape().activity().turned.has_value());
}

TEST_F(JointsInInspector, are_shown_in_the_3d_view_by_a_switch) {
    inspector_.click("joint.show");
    EXPECT_TRUE(inspector_.workspace.look.has_joints);
}

}  // namespace
}  // namespace selvedge::editor
