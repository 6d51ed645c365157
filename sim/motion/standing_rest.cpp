#include "sim/motion/standing_rest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "sim/body/joint_names.h"
#include "sim/core/error.h"
#include "sim/motion/clip_jumps.h"

namespace selvedge::sim {
namespace {

using Frames = std::vector<Eigen::Affine3d>;

constexpr int kMostLooks = 300;  // at a clip
// Cosines to the vertical. A trunk that leans by 45 degrees no longer stands; the legs of someone who sits do not hang
// upward.
constexpr double kUprightTrunk = 0.7, kHangingLeg = -0.2;
// Of the mean over a clip. Below, the person lies, rolls or turns cartwheels, and the motion does not show what is up.
constexpr double kClearlyUpright = 0.6;

// The parts of a person that show which way is up.
class Uprightness {
 public:
    explicit Uprightness(const JointBones& joints) : joints_(joints) {
        for (const Joint top : {Joint::Head, Joint::Neck, Joint::Chest})
            if (joints.has(top) && top_ == Joint::Hips) top_ = top;
    }

    bool is_known() const { return joints_.has(Joint::Hips) && top_ != Joint::Hips && has_leg(); }

    // Unit, from the hips to the head.
    Vec3d trunk(const Frames& frames) const { return way(frames, Joint::Hips, top_); }

    // From the feet to the head, of length 0 to 2.
    Vec3d up(const Frames& frames) const {
        Vec3d legs = Vec3d::Zero();
        int count = 0;
        for (const Leg& leg : kLegs) {
            const Joint end = end_of(leg);
            if (!joints_.has(leg.thigh) || end == leg.thigh) continue;
            legs += way(frames, end, leg.thigh);
            ++count;
        }
        return trunk(frames) + legs / std::max(1, count);
    }

    // How much a moment is like a rest pose: the mean cosine of the trunk's parts, the legs' and the upper arms' to the
    // vertical, and of the shoulders to the hips.
    double straightness(const Frames& frames, const Vec3d& up) const {
        double sum = 0;
        int count = 0;
        const auto add = [&](Joint low, Joint high) {
            if (!joints_.has(low) || !joints_.has(high)) return;
            sum += way(frames, low, high).dot(up);
            ++count;
        };
        Joint below = Joint::Hips;
        for (const Joint joint : {Joint::Chest, Joint::Neck, Joint::Head})
            if (joints_.has(joint)) add(std::exchange(below, joint), joint);
        for (const Leg& leg : kLegs) {
            add(leg.shin, leg.thigh);
            add(leg.foot, leg.shin);
        }
        add(Joint::LeftLowerArm, Joint::LeftUpperArm);
        add(Joint::RightLowerArm, Joint::RightUpperArm);
        if (has_both(Joint::LeftUpperArm) && has_both(Joint::LeftUpperLeg)) {
            sum += way(frames, Joint::RightUpperArm, Joint::LeftUpperArm)
                       .dot(way(frames, Joint::RightUpperLeg, Joint::LeftUpperLeg));
            ++count;
        }
        return sum / std::max(1, count);
    }
    bool stands(const Frames& frames, const Vec3d& up) const {
        return trunk(frames).dot(up) > kUprightTrunk && leg_straightness(frames, up) > kHangingLeg;
    }

    // Whether the legs point up beside a trunk that is upright.
    bool is_folded(const Frames& frames, const Vec3d& up) const {
        double legs = 0;
        for (const Leg& leg : kLegs)
            if (joints_.has(leg.thigh) && end_of(leg) != leg.thigh) legs += way(frames, end_of(leg), leg.thigh).dot(up);
        return trunk(frames).dot(up) > kUprightTrunk && legs < 2 * kHangingLeg;
    }

    // To the person's left, not normalised.
    Vec3d left(const Frames& frames) const {
        Vec3d sum = Vec3d::Zero();
        for (const Joint joint : {Joint::LeftUpperArm, Joint::LeftUpperLeg, Joint::LeftShoulder})
            if (has_both(joint)) sum += way(frames, mirrored(joint), joint);
        return sum;
    }

 private:
    struct Leg {
        Joint thigh, shin, foot;
    };
    static constexpr std::array<Leg, 2> kLegs{{{Joint::LeftUpperLeg, Joint::LeftLowerLeg, Joint::LeftFoot},
                                               {Joint::RightUpperLeg, Joint::RightLowerLeg, Joint::RightFoot}}};

    bool has_both(Joint left) const { return joints_.has(left) && joints_.has(mirrored(left)); }
    Joint end_of(const Leg& leg) const {
        return joints_.has(leg.foot) ? leg.foot : joints_.has(leg.shin) ? leg.shin : leg.thigh;
    }
    bool has_leg() const {
        return std::ranges::any_of(kLegs,
                                   [&](const Leg& leg) { return joints_.has(leg.thigh) && end_of(leg) != leg.thigh; });
    }
    Vec3d at(const Frames& frames, Joint joint) const {
        return frames[static_cast<std::size_t>(joints_[joint])].translation();
    }
    // Unit; zero where both joints are at one place.
    Vec3d way(const Frames& frames, Joint from, Joint to) const {
        return (at(frames, to) - at(frames, from)).normalized();
    }
    double leg_straightness(const Frames& frames, const Vec3d& up) const {
        double least = 1;
        for (const Leg& leg : kLegs)
            for (const auto& [high, low] : {std::array{leg.thigh, leg.shin}, std::array{leg.shin, leg.foot}})
                if (joints_.has(high) && joints_.has(low)) least = std::min(least, way(frames, low, high).dot(up));
        return least;
    }

    JointBones joints_;
    Joint top_ = Joint::Hips;
};

// The axis nearest to a direction; its sign counts.
Vec3d nearest_axis(const Vec3d& direction) {
    Eigen::Index axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    return direction[axis] < 0 ? Vec3d(-Vec3d::Unit(axis)) : Vec3d(Vec3d::Unit(axis));
}

std::string axis_text(const Vec3d& axis) {
    Eigen::Index index = 0;
    axis.cwiseAbs().maxCoeff(&index);
    return std::string(axis[index] < 0 ? "-" : "") + "xyz"[index];
}

std::vector<double> looks_at(const Clip& clip, double seconds_between) {
    const int intervals = std::clamp(int(std::ceil(clip.seconds / seconds_between)), 1, kMostLooks);
    std::vector<double> times;
    for (int i = 0; i <= intervals; ++i) times.push_back(clip.seconds * i / intervals);
    return times;
}

// The turn by right angles about a level axis that brings `up` to y.
Eigen::Quaterniond turn_to_y(const Vec3d& up) {
    if (up.y() < -0.5) return Eigen::Quaterniond(0, 1, 0, 0);  // half a turn about x
    return Eigen::Quaterniond::FromTwoVectors(up, Vec3d::UnitY());
}

// The turn that brings `up` to y and the person's left to x.
Eigen::Quaterniond turn_to_front(const Vec3d& up, const Vec3d& left) {
    const Vec3d level = left - up * up.dot(left);
    if (!(level.norm() > 1e-6)) return turn_to_y(up);
    Eigen::Matrix3d turn;
    turn.row(0) = level.normalized();
    turn.row(1) = up;
    turn.row(2) = turn.row(0).cross(turn.row(1));
    return Eigen::Quaterniond(turn).normalized();
}

// Keys for what a clip leaves to the rest pose, which will be another one.
void hold_rest(const Body& skeleton, Clip& clip) {
    for (std::size_t i = 0; i < skeleton.bones.size(); ++i) {
        auto track = std::ranges::find(clip.tracks, int(i), &Track::bone);
        if (track == clip.tracks.end()) track = clip.tracks.insert(track, Track{.bone = int(i)});
        const Transform& rest = skeleton.bones[i].rest;
        if (track->rotation.times.empty()) track->rotation = {{0.0}, {rest.rotation}};
        if (track->translation.times.empty()) track->translation = {{0.0}, {rest.translation}};
        if (track->scale.times.empty()) track->scale = {{0.0}, {rest.scale}};
    }
}

void turn_roots(const Body& skeleton, const Eigen::Quaterniond& turn, Clip& clip) {
    for (Track& track : clip.tracks) {
        if (skeleton.bones[static_cast<std::size_t>(track.bone)].parent >= 0) continue;
        for (Eigen::Quaterniond& rotation : track.rotation.values) rotation = turn * rotation;
        for (Vec3d& place : track.translation.values) place = turn * place;
    }
}

void set_rest(const Pose& pose, const Eigen::Quaterniond& turn, Body& skeleton) {
    for (std::size_t i = 0; i < skeleton.bones.size(); ++i) {
        Bone& bone = skeleton.bones[i];
        bone.rest = pose.bones[i];
        if (bone.parent >= 0) continue;
        bone.rest.rotation = turn * bone.rest.rotation;
        bone.rest.translation = turn * bone.rest.translation;
    }
    const Frames frames = bone_frames(skeleton, rest_pose(skeleton));
    for (std::size_t i = 0; i < skeleton.bones.size(); ++i) skeleton.bones[i].joint = frames[i].translation();
}

}  // namespace

void stand_up(Body& skeleton, Clip& clip) {
    const Uprightness stance(find_joints(skeleton.bones));
    if (!stance.is_known()) return;
    const Frames rest = bone_frames(skeleton, rest_pose(skeleton));
    const Vec3d rest_up = nearest_axis(stance.trunk(rest));
    const bool rest_stands = stance.stands(rest, rest_up);

    constexpr double kBetweenLooks = 1.0 / 30;  // s
    const std::vector<double> times = looks_at(clip, kBetweenLooks);
    Vec3d mean = Vec3d::Zero();
    for (const double t : times) mean += stance.up(bone_frames(skeleton, sample(skeleton, clip, t))) / 2;
    mean /= double(times.size());
    const Vec3d mean_up = nearest_axis(mean);
    const bool motion_stands = mean.dot(mean_up) > kClearlyUpright;
    const Vec3d up = motion_stands ? mean_up : rest_stands ? rest_up : Vec3d(Vec3d::UnitY());
    const auto refuse = [&](const char* problem) {
        throw InputError(skeleton.file.empty() ? skeleton.name : skeleton.file, "clip '" + clip.name + "'", problem);
    };
    const auto folded = std::ranges::count_if(
        times, [&](double t) { return stance.is_folded(bone_frames(skeleton, sample(skeleton, clip, t)), up); });
    if (std::size_t(folded) > times.size() / 2) refuse("its legs point upward beside a trunk that is upright");
    if (rest_stands && up == rest_up) return;

    Pose reference = rest_pose(skeleton);
    if (rest_stands) {
        clip.notes.push_back("the rest pose of the motion's skeleton stands along " + axis_text(rest_up) +
                             ", the motion along " + axis_text(up) + ": turned upright");
    } else {
        double straightest = -2, when = 0;  // below any mean of cosines
        for (const double t : times) {
            const Frames frames = bone_frames(skeleton, sample(skeleton, clip, t));
            const double straight = stance.straightness(frames, up);
            if (straight <= straightest || !stance.stands(frames, up)) continue;
            straightest = straight;
            when = t;
        }
        reference = sample(skeleton, clip, when);
        if (straightest < -1) refuse("neither its rest pose nor any moment of it stands: head above hips above feet");
        clip.notes.push_back("the rest pose of the motion's skeleton does not stand: taken from the motion, at " +
                             moment_text(when));
    }
    const Frames frames = bone_frames(skeleton, reference);
    const Vec3d reference_up = rest_stands ? rest_up : up;
    hold_rest(skeleton, clip);
    turn_roots(skeleton, turn_to_y(up), clip);
    set_rest(reference, turn_to_front(reference_up, stance.left(frames)), skeleton);
}

}  // namespace selvedge::sim
