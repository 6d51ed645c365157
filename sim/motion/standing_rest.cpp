#include "sim/motion/standing_rest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
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
    // Not of someone who sits, kneels or crawls.
    bool stands_straight(const Frames& frames, const Vec3d& up) const {
        return std::min(trunk(frames).dot(up), leg_straightness(frames, up)) > kUprightTrunk;
    }
    // Along an axis, the place of the joint that is the farthest down, in the skeleton's unit.
    double lowest(const Frames& frames, const Vec3d& up) const {
        double least = std::numeric_limits<double>::infinity();
        for (const int bone : joints_.bone)
            if (bone >= 0) least = std::min(least, frames[static_cast<std::size_t>(bone)].translation().dot(up));
        return least;
    }
    double leg_length(const Frames& frames) const {
        double most = 0;
        for (const Leg& leg : kLegs) {
            double length = 0;
            for (const auto& [high, low] : {std::array{leg.thigh, leg.shin}, std::array{leg.shin, leg.foot}})
                if (joints_.has(high) && joints_.has(low)) length += (at(frames, high) - at(frames, low)).norm();
            most = std::max(most, length);
        }
        return most;
    }
    const JointBones& joints() const { return joints_; }

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

// Whether the motion of someone who stands along `up` in it, if its file has other axes than its rest pose, which
// stands along `rest_up`, is such a one: and not of someone who crawls, lies or falls. Who stands has straight legs at
// times, and feet that stay on one floor. Who hops or climbs has straight legs too, but leaves the floor: it counts
// against `up` only where the legs are seldom straight, or where someone stands straight along `rest_up` too, as before
// a fall.
class AxesEvidence {
 public:
    AxesEvidence(const Uprightness& stance, const std::vector<Frames>& moments) : stance_(stance), moments_(moments) {}

    bool speaks_for(const Vec3d& up, const Vec3d& rest_up) const {
        constexpr double kOften = 0.25;   // share of the moments in which who walks has straight legs
        constexpr double kClearly = 0.5;  // times as even
        constexpr double kEven = 0.1;     // leg lengths: what rolling feet and bent toes do
        const bool is_often_straight = double(straight_moments(up)) > kOften * double(moments_.size());
        if (is_often_straight && straight_moments(rest_up) == 0) return true;
        const double floor = unevenness(up), rest_floor = unevenness(rest_up);
        if (floor > kEven * stance_.leg_length(moments_.front()) && rest_floor < kClearly * floor) return false;
        return is_often_straight || floor < rest_floor;
    }

    // The same where no rest pose stands, and `guess` is only what most files have.
    bool speaks_against_guess(const Vec3d& up, const Vec3d& guess) const {
        const bool stands_so =
            std::ranges::any_of(moments_, [&](const Frames& frames) { return stance_.stands(frames, guess); });
        return (!stands_so && straight_moments(up) > 0) || speaks_for(up, guess);
    }

 private:
    std::ptrdiff_t straight_moments(const Vec3d& up) const {
        return std::ranges::count_if(moments_,
                                     [&](const Frames& frames) { return stance_.stands_straight(frames, up); });
    }

    // By how much the lowest joint rises and falls, but for a tenth of the time above and below.
    double unevenness(const Vec3d& up) const {
        std::vector<double> lowest;
        for (const Frames& frames : moments_) lowest.push_back(stance_.lowest(frames, up));
        std::ranges::sort(lowest);
        const std::size_t tenth = lowest.size() / 10;
        return lowest[lowest.size() - 1 - tenth] - lowest[tenth];
    }

    const Uprightness& stance_;
    const std::vector<Frames>& moments_;
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

// Turns a bone in the skeleton's frame, but not what hangs on these joints.
void turn_in_place(const Body& skeleton, int bone, const Eigen::Quaterniond& turn, const JointBones& joints,
                   std::initializer_list<Joint> kept, Pose& pose) {
    const Frames before = bone_frames(skeleton, pose);
    const auto above = [&](int child, const Frames& frames) {
        const int parent = skeleton.bones[static_cast<std::size_t>(child)].parent;
        return rotation_of(parent < 0 ? skeleton.frame : frames[static_cast<std::size_t>(parent)]);
    };
    const auto set = [&](int child, const Eigen::Quaterniond& goal, const Frames& frames) {
        pose.bones[static_cast<std::size_t>(child)].rotation = (above(child, frames).inverse() * goal).normalized();
    };
    set(bone, turn * rotation_of(before[static_cast<std::size_t>(bone)]), before);
    for (const Joint joint : kept) {
        if (!joints.has(joint)) continue;
        const Frames after = bone_frames(skeleton, pose);
        set(joints[joint], rotation_of(before[static_cast<std::size_t>(joints[joint])]), after);
    }
}

// The turn that brings the ways `left` and `up`, which need not be at right angles, to those of the person.
Eigen::Quaterniond turn_between(const Vec3d& left, const Vec3d& up, const Vec3d& person_left, const Vec3d& person_up) {
    return turn_to_front(person_up, person_left).inverse() * turn_to_front(up.normalized(), left);
}

// Straightens the trunk of someone who leans, bends or turns the shoulders: from hips to chest and from chest to neck
// it is along `up`, with hips and shoulders to the left. Head, arms and legs keep their directions: who leans looks
// ahead. Returns the largest turn, rad.
double straighten_trunk(const Body& skeleton, const JointBones& joints, const Vec3d& up, const Vec3d& left,
                        Pose& pose) {
    double largest = 0;
    const auto straighten = [&](Joint joint, Joint next, Joint side, std::initializer_list<Joint> kept) {
        if (!joints.has(joint) || !joints.has(next)) return;
        const Frames frames = bone_frames(skeleton, pose);
        const auto at = [&](Joint which) -> Vec3d {
            return frames[static_cast<std::size_t>(joints[which])].translation();
        };
        const Vec3d way = at(next) - at(joint);
        if (!(way.norm() > 0)) return;
        Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(way, up);
        if (joints.has(side) && joints.has(mirrored(side)))
            turn = turn_between(at(side) - at(mirrored(side)), way, left, up);
        turn_in_place(skeleton, joints[joint], turn, joints, kept, pose);
        largest = std::max(largest, turn.angularDistance(Eigen::Quaterniond::Identity()));
    };
    const Joint above_hips = joints.has(Joint::Chest)  ? Joint::Chest
                             : joints.has(Joint::Neck) ? Joint::Neck
                                                       : Joint::Head;
    const Joint above_chest = joints.has(Joint::Neck) ? Joint::Neck : Joint::Head;
    straighten(Joint::Hips, above_hips, Joint::LeftUpperLeg,
               {Joint::LeftUpperLeg, Joint::RightUpperLeg, Joint::LeftUpperArm, Joint::RightUpperArm, Joint::Neck,
                Joint::Head});
    straighten(Joint::Chest, above_chest, Joint::LeftUpperArm,
               {Joint::LeftUpperArm, Joint::RightUpperArm, Joint::Neck, Joint::Head});
    return largest;
}

std::vector<Frames> frames_at(const Body& skeleton, const Clip& clip, const std::vector<double>& times) {
    std::vector<Frames> moments;
    for (const double t : times) moments.push_back(bone_frames(skeleton, sample(skeleton, clip, t)));
    return moments;
}

struct UpAxes {
    Vec3d rest;  // along which the trunk of the rest pose is
    bool rest_stands = false;
    Vec3d motion;  // upright in it
};

UpAxes find_up_axes(const Uprightness& stance, const Frames& rest, const std::vector<Frames>& moments,
                    const StandUpOptions& options) {
    UpAxes axes{.rest = nearest_axis(stance.trunk(rest)), .motion = Vec3d::UnitY()};
    axes.rest_stands = stance.stands(rest, axes.rest);
    if (axes.rest_stands) axes.motion = axes.rest;
    if (axes.rest_stands && options.is_y_up && axes.rest == Vec3d(Vec3d::UnitY())) return axes;
    Vec3d mean = Vec3d::Zero();
    for (const Frames& frames : moments) mean += stance.up(frames) / (2 * double(moments.size()));
    const Vec3d mean_up = nearest_axis(mean);
    if (mean_up == axes.motion || mean.dot(mean_up) <= kClearlyUpright) return axes;
    const AxesEvidence evidence(stance, moments);
    if (axes.rest_stands ? evidence.speaks_for(mean_up, axes.rest)
                         : evidence.speaks_against_guess(mean_up, axes.motion))
        axes.motion = mean_up;
    return axes;
}

// The moment that stands straightest; none if no one stands.
std::optional<std::size_t> straightest_moment(const Uprightness& stance, const std::vector<Frames>& moments,
                                              const Vec3d& up) {
    std::optional<std::size_t> best;
    double straightest = 0;
    for (std::size_t k = 0; k < moments.size(); ++k) {
        const double straight = stance.straightness(moments[k], up);
        if ((best && straight <= straightest) || !stance.stands(moments[k], up)) continue;
        straightest = straight;
        best = k;
    }
    return best;
}

}  // namespace

void stand_up(Body& skeleton, Clip& clip, const StandUpOptions& options) {
    const Uprightness stance(find_joints(skeleton.bones));
    if (!stance.is_known()) return;
    constexpr double kBetweenLooks = 1.0 / 30;  // s
    const std::vector<double> times = looks_at(clip, kBetweenLooks);
    const std::vector<Frames> moments = frames_at(skeleton, clip, times);
    const UpAxes up = find_up_axes(stance, bone_frames(skeleton, rest_pose(skeleton)), moments, options);
    const auto refuse = [&](const char* problem) {
        throw InputError(skeleton.file.empty() ? skeleton.name : skeleton.file, "clip '" + clip.name + "'", problem);
    };
    const auto folded =
        std::ranges::count_if(moments, [&](const Frames& frames) { return stance.is_folded(frames, up.motion); });
    if (std::size_t(folded) > moments.size() / 2) refuse("its legs point upward beside a trunk that is upright");
    if (up.rest_stands && up.motion == up.rest) return;

    Pose reference = rest_pose(skeleton);
    if (up.rest_stands) {
        clip.notes.push_back("the rest pose of the motion's skeleton stands along " + axis_text(up.rest) +
                             ", the motion along " + axis_text(up.motion) + ": turned upright");
    } else {
        const std::optional<std::size_t> best = straightest_moment(stance, moments, up.motion);
        if (!best) refuse("neither its rest pose nor any moment of it stands: head above hips above feet");
        reference = sample(skeleton, clip, times[*best]);
        const double turn =
            straighten_trunk(skeleton, stance.joints(), up.motion, stance.left(moments[*best]), reference);
        constexpr double kNotable = 0.1;  // rad
        clip.notes.push_back("the rest pose of the motion's skeleton does not stand: taken from the motion, at " +
                             moment_text(times[*best]) + (turn > kNotable ? ", with its trunk straightened" : ""));
    }
    const Vec3d left = stance.left(bone_frames(skeleton, reference));
    hold_rest(skeleton, clip);
    turn_roots(skeleton, turn_to_y(up.motion), clip);
    set_rest(reference, turn_to_front(up.rest_stands ? up.rest : up.motion, left), skeleton);
}

}  // namespace selvedge::sim
