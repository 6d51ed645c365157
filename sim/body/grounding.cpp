#include "sim/body/grounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/body/joint_names.h"
#include "sim/body/skin.h"

namespace selvedge::sim {
namespace {

double lowest_of(const std::vector<Vec3f>& x) {
    float lowest = std::numeric_limits<float>::infinity();
    for (const Vec3f& p : x) lowest = std::min(lowest, p.y());
    return double(lowest);
}

// A way in our frame, in the frame of the root bones.
Vec3d in_root_frame(const Body& body, const Vec3d& way) {
    return body.frame.linear().inverse() * way;
}

// The least height of the joints of the feet, m; infinite if there are none.
double lowest_foot(const Body& body, const JointBones& joints, const Pose& pose) {
    const std::vector<Eigen::Affine3d> frames = bone_frames(body, pose);
    double lowest = std::numeric_limits<double>::infinity();
    for (const Joint joint : {Joint::LeftFoot, Joint::RightFoot, Joint::LeftToe, Joint::RightToe})
        if (joints[joint] >= 0) lowest = std::min(lowest, frames[std::size_t(joints[joint])].translation().y());
    return lowest;
}

}  // namespace

double lowest_point(const Body& body, const Pose& pose) {
    std::vector<Vec3f> x;
    SkinnedSurface(body).positions(body, pose, x);
    return lowest_of(x);
}

double lowest_point(const Body& body, const Clip& clip) {
    constexpr double kRate = 30;  // 1/s
    constexpr int kMostSamples = 3000;
    const int intervals = std::clamp(int(std::ceil(clip.seconds * kRate)), 1, kMostSamples);
    const SkinnedSurface surface(body);
    std::vector<Vec3f> x;
    double lowest = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= intervals; ++i) {
        surface.positions(body, sample(body, clip, clip.seconds * i / intervals), x);
        lowest = std::min(lowest, lowest_of(x));
    }
    return lowest;
}

double stand_on_floor(const Body& body, Pose& pose) {
    const double lift = -lowest_point(body, pose);
    shift(body, pose, Vec3d(0, lift, 0));
    return lift;
}

double stand_on_floor(const Body& body, Clip& clip) {
    const double lift = -lowest_point(body, clip);
    const Vec3d way = in_root_frame(body, Vec3d(0, lift, 0));
    for (std::size_t i = 0; i < body.bones.size(); ++i) {
        if (body.bones[i].parent >= 0) continue;
        auto track = std::ranges::find(clip.tracks, int(i), &Track::bone);
        if (track == clip.tracks.end()) track = clip.tracks.insert(track, Track{.bone = int(i)});
        if (track->translation.times.empty()) track->translation = {{0.0}, {body.bones[i].rest.translation}};
        for (Vec3d& value : track->translation.values) value += way;
    }
    return lift;
}

Vec3d hips_of(const Body& body, const Pose& pose) {
    const int hips = std::max(0, find_joints(body.bones)[Joint::Hips]);
    return bone_frames(body, pose)[static_cast<std::size_t>(hips)].translation();
}

Vec3d way_over_floor(const Body& body, const Pose& from, const Pose& to) {
    const Vec3d way = hips_of(body, to) - hips_of(body, from);
    return {way.x(), 0, way.z()};
}

Pose blend_on_floor(const Body& body, const Pose& a, const Pose& b, double share) {
    Pose pose = blend(a, b, share);
    const JointBones joints = find_joints(body.bones);
    const double now = lowest_foot(body, joints, pose);
    if (!std::isfinite(now)) return pose;
    const double wanted = (1 - share) * lowest_foot(body, joints, a) + share * lowest_foot(body, joints, b);
    shift(body, pose, Vec3d(0, wanted - now, 0));
    return pose;
}

void shift(const Body& body, Pose& pose, const Vec3d& by) {
    const Vec3d way = in_root_frame(body, by);
    for (std::size_t i = 0; i < pose.bones.size(); ++i)
        if (body.bones[i].parent < 0) pose.bones[i].translation += way;
}

}  // namespace selvedge::sim
