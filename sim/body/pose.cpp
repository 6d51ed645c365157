#include "sim/body/pose.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim/core/assert.h"
#include "sim/core/error.h"

namespace selvedge::sim {

Pose rest_pose(const Body& body) {
    Pose pose;
    pose.bones.reserve(body.bones.size());
    for (const Bone& bone : body.bones) pose.bones.push_back(bone.rest);
    return pose;
}

Transform blend(const Transform& a, const Transform& b, double share) {
    return {.rotation = a.rotation.slerp(share, b.rotation),
            .translation = a.translation + share * (b.translation - a.translation),
            .scale = a.scale + share * (b.scale - a.scale)};
}

Pose blend(const Pose& a, const Pose& b, double share) {
    SELVEDGE_ASSERT(a.bones.size() == b.bones.size());
    Pose pose;
    pose.bones.reserve(a.bones.size());
    for (std::size_t i = 0; i < a.bones.size(); ++i) pose.bones.push_back(blend(a.bones[i], b.bones[i], share));
    return pose;
}

void turn_joint(Pose& pose, int bone, const Eigen::Quaterniond& rotation) {
    Eigen::Quaterniond& turned = pose.bones[std::size_t(bone)].rotation;
    turned = (turned * rotation).normalized();
}

Eigen::Quaterniond rotation_of(const Eigen::Affine3d& frame) {
    const Eigen::Matrix3d turn = frame.linear().colwise().normalized();
    return turn.allFinite() ? Eigen::Quaterniond(turn).normalized() : Eigen::Quaterniond::Identity();
}

std::vector<Eigen::Affine3d> bone_frames(const Body& body, const Pose& pose) {
    SELVEDGE_ASSERT(pose.bones.size() == body.bones.size());
    std::vector<Eigen::Affine3d> frames;
    frames.reserve(body.bones.size());
    for (std::size_t i = 0; i < body.bones.size(); ++i) {
        const int parent = body.bones[i].parent;
        frames.push_back((parent < 0 ? body.frame : frames[std::size_t(parent)]) * pose.bones[i].matrix());
    }
    return frames;
}

std::vector<Eigen::Affine3d> skin_transforms(const Body& body, const Pose& pose) {
    std::vector<Eigen::Affine3d> transforms = bone_frames(body, pose);
    for (std::size_t i = 0; i < transforms.size(); ++i) transforms[i] = transforms[i] * body.bones[i].inverse_bind;
    return transforms;
}

int find_bone(const Body& body, const std::string& name) {
    const auto found = std::ranges::find(body.bones, name, &Bone::name);
    return found == body.bones.end() ? -1 : int(found - body.bones.begin());
}

void set_rest_from_joints(std::vector<Bone>& bones) {
    for (Bone& bone : bones) {
        const Vec3d from = bone.parent < 0 ? Vec3d(Vec3d::Zero()) : bones[std::size_t(bone.parent)].joint;
        bone.rest = {.translation = bone.joint - from};
        bone.inverse_bind = Eigen::Affine3d(Eigen::Translation3d(-bone.joint));
    }
}

namespace {

// Relative to the product of the columns' lengths, which it cannot exceed: 0 where the columns lie in a plane.
bool is_invertible(const Eigen::Matrix3d& m) {
    constexpr double kLeast = 1e-6;  // positions in float lose all their digits near 1e-7
    const double lengths = m.col(0).norm() * m.col(1).norm() * m.col(2).norm();
    return std::isfinite(lengths) && lengths > 0 && std::abs(m.determinant()) > kLeast * lengths;
}

std::size_t strongest_slot(const SkinWeights& skin) {
    return std::size_t(std::ranges::max_element(skin.weights) - skin.weights.begin());
}

void check_bones(const Body& body, const std::vector<Eigen::Affine3d>& transforms) {
    std::vector<bool> is_used(body.bones.size(), false);
    for (const SkinWeights& skin : body.skin)
        for (std::size_t k = 0; k < 4; ++k)
            if (skin.weights[k] > 0) is_used[skin.bones[k]] = true;
    for (std::size_t i = 0; i < body.bones.size(); ++i)
        if (is_used[i] && !is_invertible(transforms[i].linear()))
            throw InputError(body.file, "bone '" + body.bones[i].name + "'",
                             "it squeezes the skin to nothing: is its scale 0?");
}

// Twice the area of the surface, in the square of the unit of x.
double size_of(const Body& body, const std::vector<Vec3d>& x) {
    double sum = 0;
    for (const auto& t : body.triangles) {
        const Vec3d &a = x[std::size_t(t[0])], &b = x[std::size_t(t[1])], &c = x[std::size_t(t[2])];
        sum += (b - a).cross(c - a).norm();
    }
    return sum;
}

// A file may have its skin in centimetres, under a joint that scales it: the surface is bound at the size that it has.
void bind_in_metres(Body& body) {
    const double scale = std::sqrt(size_of(body, body.x) / size_of(body, body.bind));
    if (!std::isfinite(scale) || !(scale > 0)) return;
    for (Vec3d& x : body.bind) x *= scale;
    for (Bone& bone : body.bones) bone.inverse_bind = bone.inverse_bind * Eigen::Scaling(1 / scale);
}

}  // namespace

void bind_at_rest(Body& body) {
    const std::vector<Eigen::Affine3d> transforms = skin_transforms(body, rest_pose(body));
    check_bones(body, transforms);
    body.bind.assign(body.x.begin(), body.x.end());
    for (std::size_t v = 0; v < body.skin.size(); ++v) {
        SkinWeights& skin = body.skin[v];
        Eigen::Matrix<double, 3, 4> sum = Eigen::Matrix<double, 3, 4>::Zero();
        for (std::size_t k = 0; k < 4; ++k)
            sum += double(skin.weights[k]) * transforms[skin.bones[k]].affine().topRows<3>();
        if (!is_invertible(sum.leftCols<3>())) {
            const std::uint16_t bone = skin.bones[strongest_slot(skin)];
            skin = {.bones = {bone}, .weights = {1}};
            sum = transforms[bone].affine().topRows<3>();
        }
        body.bind[v] = sum.leftCols<3>().inverse() * (body.x[v] - sum.col(3));
    }
    bind_in_metres(body);
}

}  // namespace selvedge::sim
