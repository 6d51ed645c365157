#include "sim/motion/clear_arms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "sim/body/joint_names.h"
#include "sim/body/pose.h"
#include "sim/body/skin.h"

namespace selvedge::sim {
namespace {

constexpr int kFrames = 12;                           // of the clip that are looked at
constexpr double kStep = 2 * std::numbers::pi / 180;  // rad
constexpr double kSlice = 0.03;                       // m, length of the slices of an arm

// A piece of an arm: a ball about its centre, which moves with a bone.
struct Slice {
    int bone = 0;
    Vec3d centre = Vec3d::Zero();  // in the bone's frame at rest, m
    double radius = 0;             // m, the median distance of its vertices
};

struct Arm {
    int shoulder = 0;    // the bone of the upper arm
    double outward = 1;  // sign of the angle about the chest's front
    std::vector<Slice> slices;
};

int strongest_bone(const SkinWeights& skin) {
    return skin.bones[std::size_t(std::ranges::max_element(skin.weights) - skin.weights.begin())];
}

// The bones of a body by the parts that a person sees: a finger is of its hand, and a hip joint of the hips.
struct PartsOfBody {
    JointBones joints;
    std::vector<Eigen::Affine3d> rest;  // frames of the bones
    std::vector<int> of_bone;           // the nearest Joint at or above each bone; -1: none

    explicit PartsOfBody(const Body& body)
        : joints(find_joints(body.bones)), rest(bone_frames(body, rest_pose(body))), of_bone(body.bones.size(), -1) {
        for (std::size_t joint = 0; joint < kJointCount; ++joint)
            if (joints.bone[joint] >= 0) of_bone[std::size_t(joints.bone[joint])] = int(joint);
        for (std::size_t bone = 0; bone < of_bone.size(); ++bone)
            if (const int parent = body.bones[bone].parent; of_bone[bone] < 0 && parent >= 0)
                of_bone[bone] = of_bone[std::size_t(parent)];
    }

    Vec3d joint_at(Joint joint) const { return rest[std::size_t(joints[joint])].translation(); }
};

// The slice of these vertices, which move with one bone.
Slice slice_of(const Body& body, const Eigen::Affine3d& frame, int bone, const std::vector<int>& vertices) {
    Vec3d centre = Vec3d::Zero();
    for (const int v : vertices) centre += body.x[std::size_t(v)] / double(vertices.size());
    std::vector<double> distances;
    for (const int v : vertices) distances.push_back((body.x[std::size_t(v)] - centre).norm());
    const auto middle = distances.begin() + std::ptrdiff_t(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return {.bone = bone, .centre = frame.inverse() * centre, .radius = *middle};
}

// Slices a part of the arm across, from `start` (m from its joint) to its end. Each bone of the part has its own
// slices, because fingers bend.
void add_slices(const Body& body, const PartsOfBody& parts, Joint part, const Vec3d& along, double start, Arm& arm) {
    std::map<std::pair<int, int>, std::vector<int>> slices;  // vertices by bone and slice
    for (std::size_t v = 0; v < body.x.size(); ++v) {
        const int bone = strongest_bone(body.skin[v]);
        if (parts.of_bone[std::size_t(bone)] != int(part)) continue;
        const double at = (body.x[v] - parts.joint_at(part)).dot(along) - start;
        if (at >= 0) slices[{bone, int(at / kSlice)}].push_back(int(v));
    }
    for (const auto& [key, slice] : slices)
        if (slice.size() >= 4)
            arm.slices.push_back(slice_of(body, parts.rest[std::size_t(key.first)], key.first, slice));
}

Arm arm_of(const Body& body, const PartsOfBody& parts, Joint upper) {
    const Joint lower = Joint(int(upper) + 1), hand = Joint(int(upper) + 2);
    const Vec3d upper_way = parts.joint_at(lower) - parts.joint_at(upper);
    const Vec3d lower_way = parts.joint_at(hand) - parts.joint_at(lower);
    Arm arm{.shoulder = parts.joints[upper], .outward = upper == Joint::LeftUpperArm ? 1.0 : -1.0, .slices = {}};
    add_slices(body, parts, upper, upper_way.normalized(), 0.5 * upper_way.norm(), arm);
    add_slices(body, parts, lower, lower_way.normalized(), 0, arm);
    add_slices(body, parts, hand, lower_way.normalized(), 0, arm);
    return arm;
}

bool is_obstacle(int part) {
    return std::ranges::any_of(
        std::array{Joint::Hips, Joint::Spine, Joint::Chest, Joint::LeftUpperLeg, Joint::RightUpperLeg},
        [&](Joint joint) { return part == int(joint); });
}

// The axis about which arms are opened: the chest's front, in our frame.
Vec3d front_of(const std::vector<Eigen::Affine3d>& frames, const std::vector<Eigen::Affine3d>& rest, int chest) {
    const Eigen::Matrix3d turn = frames[std::size_t(chest)].linear() * rest[std::size_t(chest)].linear().inverse();
    return (turn * Vec3d::UnitZ()).normalized();
}

// How deep the arms are in the body at one time of the clip, for any angle by which they are opened.
class ClipFrame {
 public:
    ClipFrame(const Body& body, const Pose& pose, const std::array<Arm, 2>& arms, const PartsOfBody& parts) {
        const std::vector<Eigen::Affine3d> frames = bone_frames(body, pose);
        front_ = front_of(frames, parts.rest, parts.joints[Joint::Chest]);
        std::vector<Vec3f> x;
        SkinnedSurface(body).positions(body, pose, x);
        for (std::size_t v = 0; v < x.size(); ++v)
            if (is_obstacle(parts.of_bone[std::size_t(strongest_bone(body.skin[v]))])) obstacles_.push_back(x[v]);
        for (const Arm& arm : arms)
            for (const Slice& slice : arm.slices)
                balls_.push_back({frames[std::size_t(arm.shoulder)].translation(),
                                  frames[std::size_t(slice.bone)] * slice.centre, slice.radius, arm.outward});
    }

    double overlap(double angle, double gap) const {
        double deepest = 0;
        for (const Ball& ball : balls_) {
            const Eigen::AngleAxisd turn(ball.outward * angle, front_);
            const Vec3f centre = (ball.joint + turn * (ball.centre - ball.joint)).cast<float>();
            float nearest = std::numeric_limits<float>::infinity();
            for (const Vec3f& p : obstacles_) nearest = std::min(nearest, (p - centre).squaredNorm());
            deepest = std::max(deepest, ball.radius + gap - std::sqrt(double(nearest)));
        }
        return deepest;
    }

 private:
    struct Ball {
        Vec3d joint;
        Vec3d centre;
        double radius;
        double outward;
    };
    Vec3d front_;
    std::vector<Vec3f> obstacles_;
    std::vector<Ball> balls_;
};

// From the widest angle inward as long as the arms are clear, for a centre that is deep in the trunk is far from its
// surface too.
double best_angle(const std::vector<ClipFrame>& frames, const ClearArmsOptions& options) {
    double best = options.most;
    double least = std::numeric_limits<double>::infinity();
    for (int step = int(std::floor(options.most / kStep)); step >= 0; --step) {
        double overlap = 0;
        for (const ClipFrame& frame : frames) overlap = std::max(overlap, frame.overlap(step * kStep, options.gap));
        if (least == 0 && overlap > 0) break;
        if (overlap > least) continue;
        least = overlap;
        best = step * kStep;
    }
    return best;
}

void open_arm(const Body& body, const PartsOfBody& parts, const Arm& arm, double angle, Clip& clip) {
    const auto track = std::ranges::find(clip.tracks, arm.shoulder, &Track::bone);
    if (track == clip.tracks.end()) return;
    const int parent = body.bones[std::size_t(arm.shoulder)].parent;
    Keys<Eigen::Quaterniond> opened = track->rotation;
    for (std::size_t k = 0; k < opened.times.size(); ++k) {
        const std::vector<Eigen::Affine3d> frames = bone_frames(body, sample(body, clip, opened.times[k]));
        const Eigen::Matrix3d above = (parent < 0 ? body.frame : frames[std::size_t(parent)]).linear();
        const Eigen::Quaterniond to_world(Eigen::Matrix3d(above.colwise().normalized()));
        const Vec3d axis = to_world.inverse() * front_of(frames, parts.rest, parts.joints[Joint::Chest]);
        opened.values[k] = (Eigen::AngleAxisd(arm.outward * angle, axis.normalized()) * opened.values[k]).normalized();
    }
    track->rotation = std::move(opened);
}

bool has_all(const JointBones& joints) {
    return std::ranges::all_of(
        std::array{Joint::Hips, Joint::Chest, Joint::LeftUpperArm, Joint::LeftLowerArm, Joint::LeftHand,
                   Joint::RightUpperArm, Joint::RightLowerArm, Joint::RightHand},
        [&](Joint joint) { return joints.has(joint); });
}

}  // namespace

double clear_arms(const Body& body, Clip& clip, const ClearArmsOptions& options) {
    if (body.skin.empty()) return 0;
    const PartsOfBody parts(body);
    if (!has_all(parts.joints)) return 0;
    const std::array<Arm, 2> arms{arm_of(body, parts, Joint::LeftUpperArm), arm_of(body, parts, Joint::RightUpperArm)};
    std::vector<ClipFrame> frames;
    const int intervals = clip.seconds > 0 ? kFrames : 1;
    for (int i = 0; i < intervals + (clip.seconds > 0 ? 1 : 0); ++i)
        frames.emplace_back(body, sample(body, clip, clip.seconds * i / intervals), arms, parts);
    const double angle = best_angle(frames, options);
    if (angle > 0)
        for (const Arm& arm : arms) open_arm(body, parts, arm, angle, clip);
    return angle;
}

}  // namespace selvedge::sim
