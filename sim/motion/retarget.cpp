#include "sim/motion/retarget.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <string>

#include "sim/body/joint_names.h"
#include "sim/body/soles.h"
#include "sim/core/error.h"

namespace selvedge::sim {
namespace {

using Rotation = Eigen::Quaterniond;

// From each bone's frame to ours, without scales.
std::vector<Rotation> bone_rotations(const Body& body, const Pose& pose) {
    const Rotation root = rotation_of(body.frame);
    std::vector<Rotation> rotations;
    rotations.reserve(body.bones.size());
    for (std::size_t i = 0; i < body.bones.size(); ++i) {
        const int parent = body.bones[i].parent;
        rotations.push_back((parent < 0 ? root : rotations[std::size_t(parent)]) * pose.bones[i].rotation);
    }
    return rotations;
}

// A skeleton in its rest pose.
struct Rest {
    const Body& body;
    JointBones joints;
    std::vector<Eigen::Affine3d> frames;
    std::vector<Rotation> rotations;
    Rotation to_ours = Rotation::Identity();  // to x left, y up, z front

    bool has(Joint joint) const { return joints.has(joint); }
    Vec3d at(Joint joint) const { return to_ours * frames[std::size_t(joints[joint])].translation(); }
};

constexpr std::array kLeftJoints{Joint::LeftShoulder, Joint::LeftUpperArm, Joint::LeftLowerArm,
                                 Joint::LeftUpperLeg, Joint::LeftLowerLeg, Joint::LeftFoot};

// The axis nearest to a direction, except the axis `other`.
int nearest_axis(const Vec3d& direction, int other) {
    int best = other == 0 ? 1 : 0;
    for (int axis = 0; axis < 3; ++axis)
        if (axis != other && std::abs(direction[axis]) > std::abs(direction[best])) best = axis;
    return best;
}

// The turn that brings the person's left to x and its head upward: by right angles, for the joints of a person are not
// quite symmetrical, unless it faces obliquely.
Rotation turn_to_ours(const Rest& rest) {
    Vec3d left = Vec3d::Zero(), up = Vec3d::Zero();
    for (const Joint joint : kLeftJoints)
        if (rest.has(joint) && rest.has(mirrored(joint))) left += rest.at(joint) - rest.at(mirrored(joint));
    for (const Joint side : {Joint::LeftFoot, Joint::RightFoot, Joint::LeftLowerLeg, Joint::RightLowerLeg})
        if (rest.has(Joint::Hips) && rest.has(side)) up += rest.at(Joint::Hips) - rest.at(side);
    for (const Joint high : {Joint::Chest, Joint::Neck, Joint::Head})
        if (rest.has(Joint::Hips) && rest.has(high)) up += rest.at(high) - rest.at(Joint::Hips);
    if (!(left.norm() > 0) || !(up.norm() > 0)) return Rotation::Identity();
    const int y = nearest_axis(up, -1), x = nearest_axis(left, y);
    Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
    turn(0, x) = left[x] < 0 ? -1 : 1;
    turn(1, y) = up[y] < 0 ? -1 : 1;
    turn.row(2) = turn.row(0).cross(turn.row(1));
    Vec3d across =
        Vec3d::Zero();  // of the trunk: hands and feet of a rest pose that was taken from a walk do not count
    for (const Joint joint : {Joint::LeftUpperArm, Joint::LeftUpperLeg})
        if (rest.has(joint) && rest.has(mirrored(joint))) across += turn * (rest.at(joint) - rest.at(mirrored(joint)));
    constexpr double kOblique = 20 * std::numbers::pi / 180;  // rad
    const double yaw = std::atan2(across.z(), across.x());
    if (std::abs(yaw) < kOblique) return Rotation(turn);
    return Rotation(Eigen::AngleAxisd(yaw, Vec3d::UnitY())) * Rotation(turn);
}

Rest rest_of(const Body& body) {
    const Pose pose = rest_pose(body);
    Rest rest{.body = body,
              .joints = require_joints(body),
              .frames = bone_frames(body, pose),
              .rotations = bone_rotations(body, pose)};
    rest.to_ours = turn_to_ours(rest);
    return rest;
}

// The joint at the far end of a bone of a limb.
std::optional<Joint> next_joint(Joint joint) {
    const auto i = std::size_t(joint);
    const Joint left = i < kMiddleJoints + kSideJoints ? joint : mirrored(joint);
    const bool has_next = left == Joint::LeftUpperArm || left == Joint::LeftLowerArm || left == Joint::LeftUpperLeg ||
                          left == Joint::LeftLowerLeg || left == Joint::LeftFoot;
    return has_next ? std::optional(Joint(i + 1)) : std::nullopt;
}

bool is_foot(Joint joint) {
    return joint == Joint::LeftFoot || joint == Joint::RightFoot;
}

bool is_trunk(Joint joint) {
    return std::size_t(joint) < kMiddleJoints;
}

// Turns each joint of the target from its own rest direction to that of the source. Trunk and collarbones have the
// posture of a standing person in any rest pose. The slope of a foot depends on where its joints were put above the
// sole, which is level: only its heading counts. Hands and toes go with what they hang on.
std::array<Rotation, kJointCount> alignment(const Rest& source, const Rest& target) {
    std::array<Rotation, kJointCount> turns;
    for (std::size_t i = 0; i < kJointCount; ++i) {
        const Joint joint = Joint(i);
        turns[i] = Rotation::Identity();
        if (is_trunk(joint) || joint == Joint::LeftShoulder || joint == Joint::RightShoulder) continue;
        const std::optional<Joint> next = next_joint(joint);
        const bool hangs_on_limb = joint != Joint::LeftUpperArm && joint != Joint::RightUpperArm &&
                                   joint != Joint::LeftUpperLeg && joint != Joint::RightUpperLeg;
        if (hangs_on_limb && !is_foot(joint)) turns[i] = turns[std::size_t(*joint_parent(joint))];
        if (!next || !source.has(joint) || !source.has(*next) || !target.has(joint) || !target.has(*next)) continue;
        Vec3d from = target.at(*next) - target.at(joint), to = source.at(*next) - source.at(joint);
        if (is_foot(joint)) from.y() = to.y() = 0;
        if (from.norm() > 0 && to.norm() > 0) turns[i] = Rotation::FromTwoVectors(from, to);
    }
    return turns;
}

// How a part of the trunk lies by its joints, in our axes: its left from one side to the other, its up to the next
// joint.
struct TrunkAxes {
    const JointBones& joints;
    Rotation to_ours;
    Joint bottom, top;
    Joint side;  // the left one

    bool are_known() const {
        return joints.has(bottom) && joints.has(top) && joints.has(side) && joints.has(mirrored(side));
    }
    Vec3d left(const std::vector<Eigen::Affine3d>& frames) const { return way(frames, mirrored(side), side); }
    Rotation axes(const std::vector<Eigen::Affine3d>& frames) const {
        const Vec3d x = left(frames).normalized();
        const Vec3d z = x.cross(way(frames, bottom, top)).normalized();
        Eigen::Matrix3d all;
        all << x, z.cross(x), z;
        return Rotation(all).normalized();
    }

 private:
    Vec3d way(const std::vector<Eigen::Affine3d>& frames, Joint from, Joint to) const {
        return to_ours *
               (frames[std::size_t(joints[to])].translation() - frames[std::size_t(joints[from])].translation());
    }
};

TrunkAxes pelvis_of(const Rest& rest) {
    return {rest.joints, rest.to_ours, Joint::Hips, rest.has(Joint::Chest) ? Joint::Chest : Joint::Neck,
            Joint::LeftUpperLeg};
}

// Some skeletons have their neck in the chest.
TrunkAxes chest_of(const Rest& rest) {
    constexpr double kApart = 0.1;  // of the way from hips to chest
    const bool has_neck = rest.has(Joint::Chest) && rest.has(Joint::Neck) &&
                          (rest.at(Joint::Neck) - rest.at(Joint::Chest)).norm() >
                              kApart * (rest.at(Joint::Chest) - rest.at(Joint::Hips)).norm();
    return {rest.joints, rest.to_ours, Joint::Chest, has_neck ? Joint::Neck : Joint::Head, Joint::LeftUpperArm};
}

// Whether bones between the hips and the thighs turn, as those called "LHipJoint" may: then the trunk is not turned as
// its bones are, but as its joints lie.
bool has_turning_hip_joints(const Rest& source, const Clip& clip) {
    constexpr double kRigid = 10 * std::numbers::pi / 180;  // rad: of rounded keys and of hips that stretch a little
    constexpr int kLooks = 30;
    const TrunkAxes pelvis = pelvis_of(source);
    if (!pelvis.are_known()) return false;
    const auto in_hips = [&](const std::vector<Eigen::Affine3d>& frames) -> Vec3d {
        return frames[std::size_t(source.joints[Joint::Hips])].linear().inverse() *
               (source.to_ours.inverse() * pelvis.left(frames));
    };
    const Vec3d at_rest = in_hips(source.frames);
    for (int i = 0; i <= kLooks; ++i) {
        const Pose pose = sample(source.body, clip, clip.seconds * i / kLooks);
        const Vec3d now = in_hips(bone_frames(source.body, pose));
        if (std::atan2(at_rest.cross(now).norm(), at_rest.dot(now)) > kRigid) return true;
    }
    return false;
}

// A bone of the target between two of the trunk that are driven: it takes its share of the turn from one to the other.
struct Between {
    int bone = 0;
    Joint from = Joint::Hips;
    Joint to = Joint::Hips;
    double share = 0;
};

std::vector<Between> bones_between(const Rest& source, const Rest& target) {
    std::vector<Joint> driven;
    for (std::size_t i = 0; i < kMiddleJoints; ++i)
        if (source.has(Joint(i)) && target.has(Joint(i))) driven.push_back(Joint(i));
    std::vector<Between> all;
    for (std::size_t k = 1; k < driven.size(); ++k) {
        std::vector<int> path;
        int bone = target.body.bones[std::size_t(target.joints[driven[k]])].parent;
        for (; bone > target.joints[driven[k - 1]]; bone = target.body.bones[std::size_t(bone)].parent)
            path.push_back(bone);
        if (bone != target.joints[driven[k - 1]]) continue;
        for (std::size_t i = 0; i < path.size(); ++i)
            all.push_back({.bone = path[i],
                           .from = driven[k - 1],
                           .to = driven[k],
                           .share = double(path.size() - i) / double(path.size() + 1)});
    }
    return all;
}

// A bone of no joint, such as that of a finger, with the same name in both skeletons.
struct Namesake {
    int source = 0;
    int target = 0;
    Joint above = Joint::Hips;  // the nearest joint that the target's bone hangs on
};

std::vector<Namesake> namesakes(const Rest& source, const Rest& target) {
    std::map<std::string, int> of_name;
    for (std::size_t i = 0; i < source.body.bones.size(); ++i) of_name.try_emplace(source.body.bones[i].name, int(i));
    std::vector<std::optional<Joint>> above(target.body.bones.size());
    std::vector<bool> is_source_joint(source.body.bones.size(), false);
    for (std::size_t i = 0; i < kJointCount; ++i) {
        if (target.has(Joint(i))) above[std::size_t(target.joints[Joint(i)])] = Joint(i);
        if (source.has(Joint(i))) is_source_joint[std::size_t(source.joints[Joint(i)])] = true;
    }
    std::vector<Namesake> all;
    for (std::size_t i = 0; i < target.body.bones.size(); ++i) {
        const Bone& bone = target.body.bones[i];
        if (above[i] || bone.parent < 0) continue;
        above[i] = above[std::size_t(bone.parent)];
        const auto found = of_name.find(bone.name);
        if (above[i] && found != of_name.end() && !is_source_joint[std::size_t(found->second)])
            all.push_back({.source = found->second, .target = int(i), .above = *above[i]});
    }
    return all;
}

double leg_length(const Rest& rest) {
    double sum = 0;
    int legs = 0;
    for (const Joint thigh : {Joint::LeftUpperLeg, Joint::RightUpperLeg}) {
        const Joint shin = *next_joint(thigh), foot = *next_joint(shin);
        if (!rest.has(thigh) || !rest.has(shin) || !rest.has(foot)) continue;
        sum += (rest.at(shin) - rest.at(thigh)).norm() + (rest.at(foot) - rest.at(shin)).norm();
        ++legs;
    }
    return legs == 0 ? 0 : sum / legs;
}

// 0 where a skeleton has no leg: then the hips stay.
double leg_ratio(const Rest& source, const Rest& target) {
    const double length = leg_length(source);
    return length > 0 ? leg_length(target) / length : 0;
}

// All times of the clip's keys that are apart, and others between, so that no two are farther apart than 1/30 s. If
// there are more than 240 in a second, every 1/120 s instead.
std::vector<double> sample_times(const Clip& clip) {
    constexpr double kStep = 1.0 / 30, kFineStep = 1.0 / 120, kMostPerSecond = 240, kApart = 1e-6;
    std::vector<double> keys{0, clip.seconds};
    for (const Track& track : clip.tracks)
        for (const std::vector<double>* times : {&track.rotation.times, &track.translation.times})
            for (const double t : *times)
                if (t < clip.seconds) keys.push_back(t);
    std::ranges::sort(keys);
    const auto end = std::unique(keys.begin(), keys.end(), [](double a, double b) { return b - a < kApart; });
    keys.erase(end, keys.end());
    double step = kStep;
    if (double(keys.size()) > kMostPerSecond * (clip.seconds + 1)) {
        keys = {0, clip.seconds};
        step = kFineStep;
    }
    std::vector<double> times{keys.front()};
    for (std::size_t k = 1; k < keys.size(); ++k) {
        const double gap = keys[k] - keys[k - 1];
        const int pieces = std::max(1, int(std::ceil(gap / step - kApart)));
        for (int i = 1; i < pieces; ++i) times.push_back(keys[k - 1] + gap * i / pieces);
        times.push_back(keys[k]);
    }
    return times;
}

class Retargeter {
 public:
    Retargeter(const Body& source, const Clip& clip, const Body& target)
        : clip_(clip),
          source_(rest_of(source)),
          target_(rest_of(target)),
          alignment_(alignment(source_, target_)),
          between_(bones_between(source_, target_)),
          namesakes_(namesakes(source_, target_)),
          ratio_(leg_ratio(source_, target_)),
          has_turning_hip_joints_(has_turning_hip_joints(source_, clip)),
          source_soles_(source, source_.joints, source_.to_ours),
          target_soles_(target, target_.joints, target_.to_ours) {
        tracks_.resize(target.bones.size());
        is_driven_.assign(target.bones.size(), false);
        for (std::size_t i = 0; i < kJointCount; ++i) {
            if (!source_.has(Joint(i)) || !target_.has(Joint(i))) continue;
            driven_.push_back(Joint(i));
            is_driven_[std::size_t(target_.joints[Joint(i)])] = true;
        }
        for (const Between& bone : between_) is_driven_[std::size_t(bone.bone)] = true;
        for (const Namesake& bone : namesakes_) is_driven_[std::size_t(bone.target)] = true;
    }

    std::size_t driven_bones() const { return std::size_t(std::ranges::count(is_driven_, true)); }
    bool moves_hips() const { return ratio_ > 0 && source_.has(Joint::Hips) && target_.has(Joint::Hips); }

    void add_key(double t) {
        const Pose pose = sample(source_.body, clip_, t);
        const std::vector<Eigen::Affine3d> frames = bone_frames(source_.body, pose);
        turn_bones(t, bone_rotations(source_.body, pose), frames);
        if (!moves_hips()) return;
        hips_.push_back(way_of(Joint::Hips, frames));
        if (has_soles()) foot_heights_.push_back(source_soles_.height(frames));
    }

    Clip finish(const std::vector<double>& times, const RetargetOptions& options) {
        if (moves_hips()) move_hips(times, options);
        Clip result{.name = clip_.name, .seconds = clip_.seconds, .is_loop = clip_.is_loop};
        if (has_turning_hip_joints_)
            result.notes.emplace_back(
                "joints between hips and thighs of the motion's skeleton turn against its hips: its trunk lies as its "
                "joints do, and its head may face elsewhere");
        for (std::size_t i = 0; i < tracks_.size(); ++i) {
            if (!is_driven_[i]) continue;
            tracks_[i].bone = int(i);
            result.tracks.push_back(std::move(tracks_[i]));
        }
        if (!clip_.is_loop || !moves_hips()) return result;
        result.travel_bone = target_.joints[Joint::Hips];
        result.travel = hips_parent().linear().inverse() * to_target(hips_.back() - hips_.front());
        return result;
    }

 private:
    // How far a joint of the source is from its place at rest, in the source's unit and our axes.
    Vec3d way_of(Joint joint, const std::vector<Eigen::Affine3d>& frames) const {
        return source_.to_ours * frames[std::size_t(source_.joints[joint])].translation() - source_.at(joint);
    }

    Vec3d to_target(const Vec3d& way) const { return target_.to_ours.inverse() * (ratio_ * way); }

    void turn_bones(double t, const std::vector<Rotation>& source, const std::vector<Eigen::Affine3d>& frames) {
        // In the world, in our axes.
        const auto turn_of = [&](int bone, Joint aligned) {
            return source_.to_ours * source[std::size_t(bone)] * source_.rotations[std::size_t(bone)].inverse() *
                   source_.to_ours.inverse() * alignment_[std::size_t(aligned)];
        };
        std::array<Rotation, kJointCount> turns;
        turns.fill(Rotation::Identity());
        for (const Joint joint : driven_) turns[std::size_t(joint)] = turn_of(source_.joints[joint], joint);
        if (has_turning_hip_joints_) turn_trunk_by_joints(frames, turns);
        std::vector<Rotation> goal(target_.body.bones.size());
        const auto set_goal = [&](int bone, const Rotation& turn) {
            goal[std::size_t(bone)] =
                target_.to_ours.inverse() * turn * target_.to_ours * target_.rotations[std::size_t(bone)];
        };
        for (const Joint joint : driven_) set_goal(target_.joints[joint], turns[std::size_t(joint)]);
        for (const Between& bone : between_)
            set_goal(bone.bone, turns[std::size_t(bone.from)].slerp(bone.share, turns[std::size_t(bone.to)]));
        for (const Namesake& bone : namesakes_) set_goal(bone.target, turn_of(bone.source, bone.above));
        const Rotation root = rotation_of(target_.body.frame);
        for (std::size_t i = 0; i < goal.size(); ++i) {
            const int parent = target_.body.bones[i].parent;
            const Rotation& above = parent < 0 ? root : goal[std::size_t(parent)];
            if (!is_driven_[i]) {
                goal[i] = above * target_.body.bones[i].rest.rotation;
                continue;
            }
            tracks_[i].rotation.times.push_back(t);
            tracks_[i].rotation.values.push_back((above.inverse() * goal[i]).normalized());
        }
    }

    void turn_trunk_by_joints(const std::vector<Eigen::Affine3d>& frames,
                              std::array<Rotation, kJointCount>& turns) const {
        const auto set = [&](const TrunkAxes& part, Joint joint) {
            if (part.are_known()) turns[std::size_t(joint)] = part.axes(frames) * part.axes(source_.frames).inverse();
        };
        set(pelvis_of(source_), Joint::Hips);
        set(chest_of(source_), Joint::Chest);
        turns[std::size_t(Joint::Spine)] = turns[std::size_t(Joint::Hips)].slerp(0.5, turns[std::size_t(Joint::Chest)]);
    }

    Eigen::Affine3d hips_parent() const {
        const int parent = target_.body.bones[std::size_t(target_.joints[Joint::Hips])].parent;
        return parent < 0 ? target_.body.frame : target_.frames[std::size_t(parent)];
    }

    bool has_soles() const { return !source_soles_.empty() && !target_soles_.empty(); }

    // How high the target's feet are over its floor at a key, in its unit, while its hips stay at rest.
    double target_foot_height(std::size_t key) const {
        Pose pose = rest_pose(target_.body);
        for (std::size_t i = 0; i < tracks_.size(); ++i)
            if (is_driven_[i]) pose.bones[i].rotation = tracks_[i].rotation.values[key];
        return target_soles_.height(bone_frames(target_.body, pose));
    }

    // The least of the source's foot heights. The rest pose stands on the source's floor, unless its feet never come
    // near to where they are at rest, as with BVH files whose rest pose has its hips at 0.
    double floor_height() const {
        const double lowest = std::ranges::min(foot_heights_);
        return std::abs(lowest) > 0.25 * leg_length(source_) ? lowest : 0;
    }

    // By the same way of the hips, knees that bend between bones of other proportions would lift the feet off the
    // floor, or put them through it: they are kept between the floor and the height of the source's, by the ratio of
    // the legs.
    void keep_feet_over_floor() {
        if (!has_soles()) return;
        const double floor = floor_height();
        for (std::size_t k = 0; k < hips_.size(); ++k) {
            const double source = foot_heights_[k] - floor, below_hips = target_foot_height(k) / ratio_;
            const double height = hips_[k].y() - floor + below_hips;
            hips_[k].y() = std::clamp(height, std::min(0.0, source), std::max(0.0, source)) - below_hips;
        }
    }

    void move_hips(const std::vector<double>& times, const RetargetOptions& options) {
        keep_feet_over_floor();
        Vec3d shift = Vec3d::Zero();
        if (options.starts_at_rest) shift -= Vec3d(hips_.front().x(), 0, hips_.front().z());
        const auto bone = std::size_t(target_.joints[Joint::Hips]);
        const Eigen::Affine3d to_parent = hips_parent().inverse();
        Keys<Vec3d>& keys = tracks_[bone].translation;
        keys.times = times;
        for (const Vec3d& way : hips_)
            keys.values.push_back(to_parent * (target_.frames[bone].translation() + to_target(way + shift)));
    }

    const Clip& clip_;
    Rest source_;
    Rest target_;
    std::array<Rotation, kJointCount> alignment_;
    std::vector<Between> between_;
    std::vector<Namesake> namesakes_;
    double ratio_;
    bool has_turning_hip_joints_;
    Soles source_soles_, target_soles_;
    std::vector<Joint> driven_;
    std::vector<bool> is_driven_;       // by bone of the target
    std::vector<Track> tracks_;         // by bone of the target
    std::vector<Vec3d> hips_;           // way_of() at each key
    std::vector<double> foot_heights_;  // of the source at each key, over its floor, in its unit
};

}  // namespace

Clip retarget(const Body& source, const Clip& clip, const Body& target, const RetargetOptions& options,
              const ClipLimits& limits) {
    Retargeter retargeter(source, clip, target);
    const std::vector<double> times = sample_times(clip);
    if (times.size() > limits.keys / (retargeter.driven_bones() + 1))
        throw InputError(source.file.empty() ? source.name : source.file, "clip '" + clip.name + "'",
                         "it is too long for another skeleton: " + std::to_string(times.size()) + " keys for each of " +
                             std::to_string(retargeter.driven_bones()) + " bones");
    for (const double t : times) retargeter.add_key(t);
    Clip result = retargeter.finish(times, options);
    check_clip(result, target.bones, source.file.empty() ? source.name : source.file, limits);
    return result;
}

}  // namespace selvedge::sim
