#include "tests/support/parted_body.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "sim/body/joint_names.h"
#include "sim/core/assert.h"
#include "sim/core/disjoint_sets.h"
#include "tests/support/bodies.h"

namespace selvedge::sim::shapes {

namespace {

// A bone and its name in Mixamo's words; `with`: the bone whose shell holds what belongs to it.
struct RiggedBone {
    Joint joint;
    const char* name;
    Joint with;
};
constexpr std::array<RiggedBone, kJointCount> kRig{
    {{Joint::Hips, "mixamorig:Hips", Joint::Hips},
     {Joint::Spine, "mixamorig:Spine", Joint::Spine},
     {Joint::Chest, "mixamorig:Spine2", Joint::Chest},
     {Joint::Neck, "mixamorig:Neck", Joint::Head},
     {Joint::Head, "mixamorig:Head", Joint::Head},
     {Joint::LeftShoulder, "mixamorig:LeftShoulder", Joint::Chest},
     {Joint::LeftUpperArm, "mixamorig:LeftArm", Joint::LeftUpperArm},
     {Joint::LeftLowerArm, "mixamorig:LeftForeArm", Joint::LeftLowerArm},
     {Joint::LeftHand, "mixamorig:LeftHand", Joint::LeftHand},
     {Joint::LeftUpperLeg, "mixamorig:LeftUpLeg", Joint::LeftUpperLeg},
     {Joint::LeftLowerLeg, "mixamorig:LeftLeg", Joint::LeftLowerLeg},
     {Joint::LeftFoot, "mixamorig:LeftFoot", Joint::LeftFoot},
     {Joint::LeftToe, "mixamorig:LeftToeBase", Joint::LeftFoot},
     {Joint::RightShoulder, "mixamorig:RightShoulder", Joint::Chest},
     {Joint::RightUpperArm, "mixamorig:RightArm", Joint::RightUpperArm},
     {Joint::RightLowerArm, "mixamorig:RightForeArm", Joint::RightLowerArm},
     {Joint::RightHand, "mixamorig:RightHand", Joint::RightHand},
     {Joint::RightUpperLeg, "mixamorig:RightUpLeg", Joint::RightUpperLeg},
     {Joint::RightLowerLeg, "mixamorig:RightLeg", Joint::RightLowerLeg},
     {Joint::RightFoot, "mixamorig:RightFoot", Joint::RightFoot},
     {Joint::RightToe, "mixamorig:RightToeBase", Joint::RightFoot}}};

const RiggedBone* rigged(const Bone& bone) {
    const auto found =
        std::ranges::find_if(kRig, [&](const RiggedBone& one) { return joint_name(one.joint) == bone.name; });
    return found == kRig.end() ? nullptr : &*found;
}

int bone_of(const Body& mannequin, Joint joint) {
    const auto found = std::ranges::find(mannequin.bones, joint_name(joint), &Bone::name);
    SELVEDGE_ASSERT(found != mannequin.bones.end());
    return int(found - mannequin.bones.begin());
}

// The bone to whose shell a vertex belongs.
int shell_of(const Body& mannequin, std::size_t v) {
    const SkinWeights& skin = mannequin.skin[v];
    const auto largest = std::ranges::max_element(skin.weights) - skin.weights.begin();
    const int bone = skin.bones[std::size_t(largest)];
    const RiggedBone* one = rigged(mannequin.bones[std::size_t(bone)]);
    return one ? bone_of(mannequin, one->with) : bone;
}

// Closes each loop of open edges by a fan about its middle.
void close_loops(Body& shell) {
    std::map<std::pair<int, int>, bool> is_open;
    for (const std::array<int, 3>& triangle : shell.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = triangle[k], b = triangle[(k + 1) % 3];
            if (is_open.erase({b, a}) == 0) is_open[{a, b}] = true;
        }
    }
    DisjointSets loops(shell.x.size());
    for (const auto& [edge, open] : is_open) loops.join(edge.first, edge.second);
    std::map<int, std::vector<std::pair<int, int>>> edges_of;
    for (const auto& [edge, open] : is_open) edges_of[loops.find(edge.first)].push_back(edge);
    for (const auto& [loop, edges] : edges_of) {
        const int middle = int(shell.x.size());
        Vec3d sum = Vec3d::Zero();
        for (const auto& [a, b] : edges) {
            sum += shell.x[std::size_t(a)];
            shell.triangles.push_back({b, a, middle});
        }
        shell.x.emplace_back(sum / double(edges.size()));
    }
}

Body shell_round(const Body& mannequin, const std::vector<int>& shells, int bone) {
    Body shell;
    std::vector<int> place(mannequin.x.size(), -1);
    for (std::array<int, 3> triangle : mannequin.triangles) {
        if (!std::ranges::all_of(triangle, [&](int v) { return shells[std::size_t(v)] == bone; })) continue;
        for (int& v : triangle) {
            int& at = place[std::size_t(v)];
            if (at < 0) {
                at = int(shell.x.size());
                shell.x.push_back(mannequin.x[std::size_t(v)]);
            }
            v = at;
        }
        shell.triangles.push_back(triangle);
    }
    close_loops(shell);
    return shell;
}

Body ball_at(const Body& mannequin, const Vec3d& joint) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3d& p : mannequin.x) nearest = std::min(nearest, (p - joint).norm());
    constexpr int kCells = 8;
    return sphere(joint, nearest, kCells);
}

void add(const Body& part, int bone, Body& body) {
    const int first = int(body.x.size());
    body.x.insert(body.x.end(), part.x.begin(), part.x.end());
    for (const auto& [a, b, c] : part.triangles) body.triangles.push_back({first + a, first + b, first + c});
    body.skin.resize(body.x.size(), {.bones = {std::uint16_t(bone)}, .weights = {1}});
}

}  // namespace

Body in_parts(const Body& mannequin, Joints joints) {
    Body body;
    body.name = "parts";
    body.bones = mannequin.bones;
    body.frame = mannequin.frame;
    for (Bone& bone : body.bones)
        if (const RiggedBone* one = rigged(bone)) bone.name = one->name;
    std::vector<int> shells;
    for (std::size_t v = 0; v < mannequin.x.size(); ++v) shells.push_back(shell_of(mannequin, v));
    for (const RiggedBone& one : kRig) {
        const int bone = bone_of(mannequin, one.joint);
        if (one.with == one.joint) add(shell_round(mannequin, shells, bone), bone, body);
        if (joints == Joints::Balls) add(ball_at(mannequin, mannequin.bones[std::size_t(bone)].joint), bone, body);
    }
    return body;
}

}  // namespace selvedge::sim::shapes
