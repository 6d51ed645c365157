#pragma once
// BVH files of a stick figure whose skeleton is set up as one likes, for tests of what files of motions have.
#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

struct FigureJoint {
    std::string name;
    int parent = -1;
    Vec3d offset = Vec3d::Zero();
    Vec3d turn = Vec3d::Zero();  // degrees about x, then y, then z, while the figure stands with hanging arms
};

// A person of 170 cm whose every bone is along x in the zero pose, as in files of Bandai-Namco's data set: the turns
// make it stand along y and face z.
inline std::vector<FigureJoint> figure_along_x() {
    std::vector<FigureJoint> joints{{"joint_Root", -1, {0, 0, 0}, {0, 0, 0}}, {"Hips", 0, {0, 90, 0}, {0, 0, 90}},
                                    {"Spine", 1, {15, 0, 0}, {0, 0, 0}},      {"Chest", 2, {15, 0, 0}, {0, 0, 0}},
                                    {"Neck", 3, {20, 0, 0}, {0, 0, 0}},       {"Head", 4, {10, 0, 0}, {0, 0, 0}}};
    for (const double side : {-1.0, 1.0}) {  // of local y
        const std::string end = side < 0 ? "_L" : "_R";
        const int first = int(joints.size());
        joints.push_back({"Shoulder" + end, 3, {15, 3 * side, 0}, {0, 0, 90 * side}});
        joints.push_back({"UpperArm" + end, first, {14, 0, 0}, {0, 0, 90 * side}});
        joints.push_back({"LowerArm" + end, first + 1, {26, 0, 0}, {0, 0, 0}});
        joints.push_back({"Hand" + end, first + 2, {24, 0, 0}, {0, 0, 0}});
        joints.push_back({"UpperLeg" + end, 1, {0, 9 * side, 0}, {0, 0, 180}});
        joints.push_back({"LowerLeg" + end, first + 4, {42, 0, 0}, {0, 0, 0}});
        joints.push_back({"Foot" + end, first + 5, {42, 0, 0}, {0, -90, 0}});
        joints.push_back({"Toes" + end, first + 6, {13, 0, 0}, {0, 0, 0}});
    }
    return joints;
}

// The same person whose zero pose is a T-pose along y, in the names of CMU's files.
inline std::vector<FigureJoint> figure_in_t_pose() {
    std::vector<FigureJoint> joints{{"Hips", -1, {0, 0, 0}, {0, 0, 0}},
                                    {"LowerBack", 0, {0, 15, 0}, {0, 0, 0}},
                                    {"Spine1", 1, {0, 15, 0}, {0, 0, 0}},
                                    {"Neck", 2, {0, 20, 0}, {0, 0, 0}},
                                    {"Head", 3, {0, 10, 0}, {0, 0, 0}}};
    for (const double side : {1.0, -1.0}) {  // of x
        const std::string name = side > 0 ? "Left" : "Right";
        const int first = int(joints.size());
        joints.push_back({name + "Shoulder", 2, {3 * side, 15, 0}, {0, 0, 0}});
        joints.push_back({name + "Arm", first, {14 * side, 0, 0}, {0, 0, -80 * side}});
        joints.push_back({name + "ForeArm", first + 1, {26 * side, 0, 0}, {0, 0, 0}});
        joints.push_back({name + "Hand", first + 2, {24 * side, 0, 0}, {0, 0, 0}});
        joints.push_back({name + "UpLeg", 0, {9 * side, 0, 0}, {0, 0, 0}});
        joints.push_back({name + "Leg", first + 4, {0, -42, 0}, {0, 0, 0}});
        joints.push_back({name + "Foot", first + 5, {0, -42, 0}, {0, 0, 0}});
        joints.push_back({name + "ToeBase", first + 6, {0, -5, 13}, {0, 0, 0}});
    }
    return joints;
}

struct FigureFrame {
    Vec3d place = Vec3d::Zero();  // of the root
    std::vector<Vec3d> turns;     // degrees, as FigureJoint::turn
};

// The figure as it stands, at the place of its root.
inline FigureFrame standing_frame(const std::vector<FigureJoint>& joints, const Vec3d& place) {
    FigureFrame frame{.place = place, .turns = {}};
    for (const FigureJoint& joint : joints) frame.turns.push_back(joint.turn);
    return frame;
}

// With positions for the root alone. unit: of the file per cm.
inline std::filesystem::path write_bvh(const std::filesystem::path& path, const std::vector<FigureJoint>& joints,
                                       const std::vector<FigureFrame>& frames, double rate, double unit = 1) {
    std::ofstream file(path);
    const auto numbers = [&](const Vec3d& v, double factor) {
        file << ' ' << factor * v.x() << ' ' << factor * v.y() << ' ' << factor * v.z();
    };
    std::vector<std::size_t> order;  // of the channels
    const std::function<void(std::size_t)> write = [&](std::size_t i) {
        order.push_back(i);
        file << (joints[i].parent < 0 ? "ROOT " : "JOINT ") << joints[i].name << "\n{\nOFFSET";
        numbers(joints[i].offset, unit);
        file << (i == 0 ? "\nCHANNELS 6 Xposition Yposition Zposition" : "\nCHANNELS 3")
             << " Zrotation Yrotation Xrotation\n";
        bool is_end = true;
        for (std::size_t k = i + 1; k < joints.size(); ++k) {
            if (joints[k].parent != int(i)) continue;
            is_end = false;
            write(k);
        }
        if (is_end) file << "End Site\n{\nOFFSET 0 0 0\n}\n";
        file << "}\n";
    };
    file << "HIERARCHY\n";
    write(0);
    file << "MOTION\nFrames: " << frames.size() << "\nFrame Time: " << 1 / rate << '\n';
    for (const FigureFrame& frame : frames) {
        numbers(frame.place, unit);
        for (const std::size_t i : order)
            file << ' ' << frame.turns[i].z() << ' ' << frame.turns[i].y() << ' ' << frame.turns[i].x();
        file << '\n';
    }
    return path;
}

}  // namespace selvedge::sim
