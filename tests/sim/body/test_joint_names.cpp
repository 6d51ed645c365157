#include <gtest/gtest.h>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/body/joint_names.h"
#include "sim/core/error.h"
#include "sim/mannequin/mannequin.h"
#include "sim/repair/load_body.h"

namespace selvedge::sim {
namespace {

struct NamedBone {
    const char* name;
    int parent;
    const char* joint;  // empty: of no joint
};

// Finds the joints of the rig and expects each bone's joint.
void expect_joints(const std::vector<NamedBone>& rig) {
    std::vector<Bone> bones;
    for (const NamedBone& bone : rig) bones.push_back({.name = bone.name, .parent = bone.parent});
    const JointBones joints = find_joints(bones);
    for (std::size_t b = 0; b < rig.size(); ++b) {
        std::string found;
        for (std::size_t i = 0; i < kJointCount; ++i)
            if (joints.bone[i] == int(b)) found += joint_name(Joint(i));
        EXPECT_EQ(found, rig[b].joint) << rig[b].name;
    }
}

TEST(JointNames, of_the_mannequin_are_its_bones) {
    const Body body = make_mannequin({.subdivisions = 1}).body;
    const JointBones joints = find_joints(body.bones);
    for (std::size_t i = 0; i < kJointCount; ++i) {
        EXPECT_EQ(joints.bone[i], int(i)) << joint_name(Joint(i));
        EXPECT_EQ(find_joint(joint_name(Joint(i))), Joint(i));
        EXPECT_EQ(mirrored(mirrored(Joint(i))), Joint(i));
    }
    EXPECT_FALSE(find_joint("tail"));
}

TEST(JointNames, of_cmu_are_found) {
    expect_joints({{"Hips", -1, "hips"},
                   {"LHipJoint", 0, ""},
                   {"LeftUpLeg", 1, "left_upper_leg"},
                   {"LeftLeg", 2, "left_lower_leg"},
                   {"LeftFoot", 3, "left_foot"},
                   {"LeftToeBase", 4, "left_toe"},
                   {"RHipJoint", 0, ""},
                   {"RightUpLeg", 6, "right_upper_leg"},
                   {"RightLeg", 7, "right_lower_leg"},
                   {"RightFoot", 8, "right_foot"},
                   {"LowerBack", 0, "spine"},
                   {"Spine", 10, ""},
                   {"Spine1", 11, "chest"},
                   {"Neck", 12, "neck"},
                   {"Neck1", 13, ""},
                   {"Head", 14, "head"},
                   {"LeftShoulder", 12, "left_shoulder"},
                   {"LeftArm", 16, "left_upper_arm"},
                   {"LeftForeArm", 17, "left_lower_arm"},
                   {"LeftHand", 18, "left_hand"},
                   {"LThumb", 19, ""},
                   {"RightShoulder", 12, "right_shoulder"},
                   {"RightArm", 21, "right_upper_arm"}});
}

TEST(JointNames, of_mixamo_and_motionbuilder_are_found_behind_their_prefixes_and_pivots) {
    expect_joints({{"mixamorig:Hips_$AssimpFbx$_Translation", -1, ""},
                   {"mixamorig:Hips", 0, "hips"},
                   {"mixamorig:Spine_$AssimpFbx$_PreRotation", 1, ""},
                   {"mixamorig:Spine", 2, "spine"},
                   {"mixamorig:Spine1", 3, ""},
                   {"mixamorig:Spine2", 4, "chest"},
                   {"mixamorig:LeftShoulder", 5, "left_shoulder"},
                   {"mixamorig:LeftArm", 6, "left_upper_arm"},
                   {"mixamorig:RightArm", 5, "right_upper_arm"},
                   {"mixamorig:LeftUpLeg", 1, "left_upper_leg"},
                   {"mixamorig:HeadTop_End", 5, ""}});
    expect_joints({{"Character1_Reference", -1, ""},
                   {"Character1_Hips", 0, "hips"},
                   {"Character1_LeftUpLeg", 1, "left_upper_leg"},
                   {"Character1_LeftLeg", 2, "left_lower_leg"}});
}

TEST(JointNames, of_unreal_and_mesh2motion_are_found) {
    expect_joints({{"root", -1, ""},
                   {"pelvis", 0, "hips"},
                   {"spine_01", 1, "spine"},
                   {"spine_02", 2, ""},
                   {"spine_03", 3, "chest"},
                   {"clavicle_l", 4, "left_shoulder"},
                   {"upperarm_l", 5, "left_upper_arm"},
                   {"upperarm_twist_01_l", 6, ""},
                   {"lowerarm_l", 6, "left_lower_arm"},
                   {"hand_l", 8, "left_hand"},
                   {"upperarm_r", 4, "right_upper_arm"},
                   {"neck_01", 4, "neck"},
                   {"head", 11, "head"},
                   {"thigh_r", 1, "right_upper_leg"},
                   {"calf_r", 13, "right_lower_leg"},
                   {"foot_r", 14, "right_foot"},
                   {"ball_r", 15, "right_toe"},
                   {"ik_foot_root", 0, ""},
                   {"ik_foot_l", 17, ""}});
}

TEST(JointNames, of_makehuman_and_blender_are_found_without_hips_of_their_own) {
    expect_joints({{"root", -1, "hips"},
                   {"pelvis.L", 0, ""},
                   {"upperleg01.L", 1, "left_upper_leg"},
                   {"upperleg02.L", 2, ""},
                   {"lowerleg01.L", 3, "left_lower_leg"},
                   {"foot.L", 4, "left_foot"},
                   {"toe1-1.L", 5, "left_toe"},
                   {"pelvis.R", 0, ""},
                   {"upperleg01.R", 7, "right_upper_leg"},
                   {"spine05", 0, "spine"},
                   {"spine01", 9, "chest"},
                   {"clavicle.L", 10, "left_shoulder"},
                   {"shoulder01.L", 11, ""},
                   {"upperarm01.L", 12, "left_upper_arm"},
                   {"wrist.L", 13, "left_hand"},
                   {"upperarm01.R", 10, "right_upper_arm"}});
    expect_joints({{"DEF-spine", -1, "hips"},
                   {"DEF-spine.001", 0, "spine"},
                   {"DEF-spine.003", 1, "chest"},
                   {"DEF-upper_arm.L", 2, "left_upper_arm"},
                   {"DEF-forearm.L", 3, "left_lower_arm"},
                   {"DEF-upper_arm.R", 2, "right_upper_arm"},
                   {"DEF-thigh.L", 0, "left_upper_leg"},
                   {"DEF-shin.L", 6, "left_lower_leg"},
                   {"DEF-thigh.R", 0, "right_upper_leg"}});
}

TEST(JointNames, that_mean_one_joint_or_the_next_are_told_by_their_neighbours) {
    expect_joints({{"Hips", -1, "hips"},  // of the joints and not of the bones, as in older BVH files and SMPL
                   {"LeftHip", 0, "left_upper_leg"},
                   {"LeftKnee", 1, "left_lower_leg"},
                   {"LeftAnkle", 2, "left_foot"},
                   {"LeftFoot", 3, "left_toe"},
                   {"Chest", 0, "chest"},
                   {"LeftCollar", 5, "left_shoulder"},
                   {"LeftShoulder", 6, "left_upper_arm"},
                   {"LeftElbow", 7, "left_lower_arm"},
                   {"LeftWrist", 8, "left_hand"},
                   {"RightShoulder", 5, "right_upper_arm"},
                   {"RightElbow", 10, "right_lower_arm"}});
    expect_joints({{"Bip01", -1, ""},
                   {"Bip01 Pelvis", 0, "hips"},
                   {"Bip01 L Thigh", 1, "left_upper_leg"},
                   {"Bip01 L Calf", 2, "left_lower_leg"},
                   {"lForeArm", 0, "left_lower_arm"},
                   {"rthigh", 1, "right_upper_leg"}});
    expect_joints({{"torso_joint_1", -1, "hips"},
                   {"leg_joint_L_1", 0, "left_upper_leg"},
                   {"leg_joint_L_2", 1, "left_lower_leg"},
                   {"leg_joint_L_3", 2, "left_foot"},
                   {"leg_joint_L_5", 3, "left_toe"},
                   {"leg_joint_R_1", 0, "right_upper_leg"},
                   {"torso_joint_2", 0, "spine"},
                   {"torso_joint_3", 6, "chest"},
                   {"neck_joint_1", 7, "neck"},
                   {"neck_joint_2", 8, "head"},
                   {"arm_joint_L__4_", 7, "left_upper_arm"},
                   {"arm_joint_L__3_", 10, "left_lower_arm"},
                   {"arm_joint_L__2_", 11, "left_hand"},
                   {"arm_joint_R", 7, "right_upper_arm"}});
}

TEST(JointNames, of_smpl_are_found_behind_the_name_of_its_model) {
    for (const std::string prefix : {"", "m_avg_", "f_avg_", "SMPLX_"}) {
        std::vector<std::string> names{"Pelvis", "L_Hip", "L_Knee", "L_Ankle", "L_Foot", "R_Hip", "Spine1", "L_Collar"};
        for (std::string& name : names) name = prefix + name;
        expect_joints({{names[0].c_str(), -1, "hips"},
                       {names[1].c_str(), 0, "left_upper_leg"},
                       {names[2].c_str(), 1, "left_lower_leg"},
                       {names[3].c_str(), 2, "left_foot"},
                       {names[4].c_str(), 3, "left_toe"},
                       {names[5].c_str(), 0, "right_upper_leg"},
                       {names[6].c_str(), 0, ""},
                       {names[7].c_str(), 6, ""}});
    }
}

TEST(JointNames, none_of_which_is_known_are_listed_in_one_line) {
    Body body;
    body.file = "crane.glb";
    for (const char* name : {"Boom", "Jib\n", "Hook"})
        body.bones.push_back({.name = name, .parent = int(body.bones.size()) - 1});
    try {
        require_joints(body);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(
            error.what(),
            "crane.glb: bones: none is known by its name as hips, leg or arm; they are 'Boom', 'Jib ', 'Hook'");
    }
    body.bones.clear();
    EXPECT_THROW(require_joints(body), InputError);
}

TEST(JointNames, of_real_bodies_are_found) {
    const char* data = std::getenv("SELVEDGE_TEST_DATA");
    if (!data) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set";
    for (const char* file : {"mh_female_cmu01_01.glb", "CesiumMan.glb", "RiggedFigure.gltf"}) {
        const BodyClips motion = load_motion(std::filesystem::path(data) / "bodies" / file);
        const JointBones joints = find_joints(motion.body.bones);
        for (std::size_t i = 0; i < kJointCount; ++i) {
            const bool has_collarbones = std::string(file).starts_with("mh");
            if (!has_collarbones && (Joint(i) == Joint::LeftShoulder || Joint(i) == Joint::RightShoulder)) continue;
            EXPECT_GE(joints.bone[i], 0) << file << ": " << joint_name(Joint(i));
        }
    }
}

}  // namespace
}  // namespace selvedge::sim
