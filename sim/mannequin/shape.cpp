#include "sim/mannequin/shape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "sim/core/parallel.h"
#include "sim/mannequin/measures.h"

namespace selvedge::sim {
namespace {

// Arms keep their direction; legs follow the hips' widening in part; heights follow the torso's height map.
Joints bend_joints(const MannequinBase& base, const ShapeParameters& shape, const TorsoShape& torso) {
    const Joints& from = base.landmarks.joints;
    Joints to;
    for (const Joint joint : {Joint::Hips, Joint::Spine, Joint::Chest, Joint::Neck, Joint::Head, Joint::LeftShoulder,
                              Joint::LeftUpperArm, Joint::LeftUpperLeg}) {
        to[joint] = torso.bend(from[joint]);
    }
    to[Joint::LeftLowerArm] =
        to[Joint::LeftUpperArm] + shape.arm * (from[Joint::LeftLowerArm] - from[Joint::LeftUpperArm]);
    to[Joint::LeftHand] = to[Joint::LeftLowerArm] + shape.arm * (from[Joint::LeftHand] - from[Joint::LeftLowerArm]);

    const Vec3d& hip = from[Joint::LeftUpperLeg];
    const Vec3d new_hip = to[Joint::LeftUpperLeg];
    const double widening = new_hip.x() / hip.x();
    const auto set_leg = [&](Joint joint, double follow) {
        const Vec3d& x = from[joint];
        to[joint] = {x.x() * std::lerp(shape.stature, widening, follow), torso.height_of(x.y()),
                     new_hip.z() + (x.z() - hip.z()) * shape.stature};
    };
    set_leg(Joint::LeftLowerLeg, 0.5);
    set_leg(Joint::LeftFoot, 0.35);
    set_leg(Joint::LeftToe, 0.35);
    set_stance(to, shape.stance);
    mirror_left_side(to);
    return to;
}

// One bone of an arm or leg: scaled along its axis, and across it by a profile over the limb's length.
struct LimbBone {
    Joint joint;
    Vec3d from = Vec3d::Zero();
    Vec3d axis = Vec3d::UnitY();
    double length = 0;
    Vec3d to = Vec3d::Zero();
    Vec3d new_axis = Vec3d::UnitY();
    double new_length = 0;
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    double offset = 0;  // position of its root joint in the profile: 0 or 1

    Vec3d bend(const Vec3d& x, const Pchip& profile, double least, double most) const {
        const double t = (x - from).dot(axis) / length;
        const Vec3d across = x - from - t * length * axis;
        return to + t * new_length * new_axis + profile(std::clamp(t + offset, least, most)) * (turn * across);
    }
};

LimbBone make_limb_bone(Joint root, Joint tip, double offset, const Joints& from, const Joints& to) {
    LimbBone bone{.joint = root, .from = from[root], .to = to[root], .offset = offset};
    bone.length = (from[tip] - from[root]).norm();
    bone.axis = (from[tip] - from[root]) / bone.length;
    bone.new_length = (to[tip] - to[root]).norm();
    bone.new_axis = (to[tip] - to[root]) / bone.new_length;
    bone.turn = Eigen::Quaterniond::FromTwoVectors(bone.axis, bone.new_axis).toRotationMatrix();
    return bone;
}

// A left limb of two bones; positions along it as defined in base.h.
struct LimbShape {
    std::array<LimbBone, 2> bones;
    Pchip profile;
    double least = 0;
    double most = 0;
};

// A wrist that is wider than that widens the lower arm as it tapers, not by the same factor: the girth that the wrist
// gets beyond is added less, the nearer a place is to the girth of the forearm. Scaled instead, the arm would stay as
// wide as the forearm down to the hand. `usual`: the profile with the usual wrist.
void taper_lower_arm(const MannequinBase& base, const GirthValues& scale, const Pchip& usual,
                     std::vector<double>& positions, std::vector<double>& values) {
    const EvenTable& girths = base.lower_arm;
    const auto usual_girth = [&](std::size_t i) {
        return girths.values[i] * usual(girths.low + girths.step() * static_cast<double>(i));
    };
    const std::size_t last = girths.values.size() - 1;
    const double forearm = usual_girth(0), wrist = usual_girth(last);
    const double added = girths.values[last] * scale[Girth::Wrist] - wrist;
    const auto wrist_at = std::ranges::find(positions, kWristPosition);
    auto position = wrist_at;
    auto value = values.begin() + (wrist_at - positions.begin());
    for (std::size_t i = 1; i < last; ++i) {
        const double share = std::clamp((forearm - usual_girth(i)) / (forearm - wrist), 0.0, 1.0);
        const double at = girths.low + girths.step() * static_cast<double>(i);
        position = positions.insert(position, at) + 1;
        value = values.insert(value, (usual_girth(i) + share * added) / girths.values[i]) + 1;
    }
}

LimbShape make_arm(const MannequinBase& base, const ShapeParameters& shape, const Joints& to) {
    const Joints& from = base.landmarks.joints;
    const GirthValues& scale = shape.scale;
    const double root = 0.5 * (shoulder_slope_scale(shape) + scale[Girth::Biceps]);
    constexpr double kMin = -0.12;
    constexpr double kMax = 2.15;
    std::vector<double> positions{kMin, 0.18, kBicepsPosition, 1, kForearmPosition, kWristPosition, kMax};
    std::vector<double> values{root,
                               scale[Girth::Biceps],
                               scale[Girth::Biceps],
                               scale[Girth::Elbow],
                               scale[Girth::Forearm],
                               scale[Girth::Wrist],
                               shape.stature};
    const double usual_wrist = kUsualWrist * scale[Girth::Forearm];
    if (shape.has_wide_wrist && scale[Girth::Wrist] > usual_wrist) {
        std::vector<double> usual = values;
        usual[5] = usual_wrist;
        taper_lower_arm(base, scale, Pchip(positions, usual), positions, values);
    }
    return {.bones = {make_limb_bone(Joint::LeftUpperArm, Joint::LeftLowerArm, 0, from, to),
                      make_limb_bone(Joint::LeftLowerArm, Joint::LeftHand, 1, from, to)},
            .profile = Pchip(std::move(positions), std::move(values)),
            .least = kMin,
            .most = kMax};
}

LimbShape make_leg(const MannequinBase& base, const ShapeParameters& shape, const Joints& to) {
    const Joints& from = base.landmarks.joints;
    const GirthValues& scale = shape.scale;
    const double root = 0.5 * (scale[Girth::Thigh] + scale[Girth::Hip]);
    constexpr double kMin = -0.1;
    constexpr double kMax = 2.1;
    return {.bones = {make_limb_bone(Joint::LeftUpperLeg, Joint::LeftLowerLeg, 0, from, to),
                      make_limb_bone(Joint::LeftLowerLeg, Joint::LeftFoot, 1, from, to)},
            .profile =
                Pchip({kMin, thigh_position(base.landmarks), kMidThighPosition, 1, kCalfPosition, kAnklePosition, kMax},
                      {root, scale[Girth::Thigh], scale[Girth::MidThigh], scale[Girth::Knee], scale[Girth::Calf],
                       scale[Girth::Ankle], shape.stature}),
            .least = kMin,
            .most = kMax};
}

class BodyShape {
 public:
    BodyShape(const MannequinBase& base, const ShapeParameters& shape)
        : base_(base),
          shape_(shape),
          torso_(base, shape),
          joints_(bend_joints(base, shape, torso_)),
          arm_(make_arm(base, shape, joints_)),
          leg_(make_leg(base, shape, joints_)) {}

    Landmarks landmarks() const {
        const TrunkLevels& level = base_.landmarks.levels;
        return {.joints = joints_,
                .levels = {.bust = torso_.height_of(level.bust),
                           .underbust = torso_.height_of(level.underbust),
                           .waist = torso_.height_of(level.waist),
                           .high_hip = torso_.height_of(level.high_hip),
                           .hip = torso_.height_of(level.hip),
                           .crotch = torso_.height_of(level.crotch)}};
    }

    Vec3d bend(std::size_t vertex) const {
        const Vec3d& x = base_.surface.x[vertex];
        const auto weights = base_.weights.row(static_cast<Eigen::Index>(vertex));
        const auto weight = [&](Joint joint) { return weights[static_cast<Eigen::Index>(joint)]; };
        Vec3d sum = Vec3d::Zero();
        const double trunk = weight(Joint::Hips) + weight(Joint::Spine) + weight(Joint::Chest) + weight(Joint::Neck) +
                             weight(Joint::LeftShoulder) + weight(Joint::RightShoulder);
        if (trunk > 0) sum += trunk * torso_.bend(x);
        if (weight(Joint::Head) > 0) sum += weight(Joint::Head) * bend_head(x);
        sum += bend_left_limbs(x, weight);
        sum += mirrored(bend_left_limbs(mirrored(x), [&](Joint joint) { return weight(mirrored(joint)); }));
        return keep_side(x, sum);
    }

 private:
    Vec3d bend_head(const Vec3d& x) const {
        return joints_[Joint::Head] + head_scale(shape_) * (x - base_.landmarks.joints[Joint::Head]);
    }

    // Keeps the soles on the floor.
    Vec3d bend_foot(const Vec3d& x) const {
        const Vec3d& from = base_.landmarks.joints[Joint::LeftFoot];
        const Vec3d& to = joints_[Joint::LeftFoot];
        Vec3d bent = to + shape_.stature * (x - from);
        bent.y() = x.y() * to.y() / from.y();
        return bent;
    }

    Vec3d bend_hand(const Vec3d& x) const {
        return joints_[Joint::LeftHand] + shape_.stature * (x - base_.landmarks.joints[Joint::LeftHand]);
    }

    // Weighted sum over the joints of the left limbs; the right limbs use it mirrored.
    template <class Weight>
    Vec3d bend_left_limbs(const Vec3d& x, const Weight& weight) const {
        Vec3d sum = Vec3d::Zero();
        for (const LimbShape* limb : {&arm_, &leg_}) {
            for (const LimbBone& bone : limb->bones) {
                const double share = weight(bone.joint);
                if (share > 0) sum += share * bone.bend(x, limb->profile, limb->least, limb->most);
            }
        }
        const double foot = weight(Joint::LeftFoot) + weight(Joint::LeftToe);
        if (foot > 0) sum += foot * bend_foot(x);
        if (weight(Joint::LeftHand) > 0) sum += weight(Joint::LeftHand) * bend_hand(x);
        return sum;
    }

    // Thick thighs are compressed towards the midplane, in monotone order, so that they do not pass through each other.
    static Vec3d keep_side(const Vec3d& x, Vec3d bent) {
        constexpr double kOnMidplane = 1e-6;
        constexpr double kGap = 0.003;  // m
        const double side = x.x() > 0 ? 1 : -1;
        const double distance = std::abs(x.x());
        if (distance <= kOnMidplane) {
            bent.x() = 0;
            return bent;
        }
        const double gap = std::min(kGap, distance);
        const double excess = (side * bent.x() - gap) / gap;
        if (excess < 0) bent.x() = side * gap * std::exp(std::max(excess, -3.0));
        return bent;
    }

    const MannequinBase& base_;
    const ShapeParameters& shape_;
    TorsoShape torso_;
    Joints joints_;
    LimbShape arm_;
    LimbShape leg_;
};

}  // namespace

double arm_length(const Joints& joints) {
    return (joints[Joint::LeftLowerArm] - joints[Joint::LeftUpperArm]).norm() +
           (joints[Joint::LeftHand] - joints[Joint::LeftLowerArm]).norm();
}

DeformedBody bend_body(const MannequinBase& base, const ShapeParameters& shape) {
    const BodyShape bent(base, shape);
    DeformedBody body{.x = std::vector<Vec3d>(base.surface.x.size()), .landmarks = bent.landmarks()};
    parallel_for(body.x.size(), 1024, [&](std::size_t first, std::size_t last) {
        for (std::size_t v = first; v < last; ++v) body.x[v] = bent.bend(v);
    });
    return body;
}

namespace {

constexpr double kReferenceHeight = 1.6;  // m, height of the body on which the lengths below were chosen

// Share of the shoulder width in the upper chest's scale; the rest is the rib cage's.
constexpr double kShoulderPart = 0.3;

// Crotch, hip, high hip, waist, underbust, bust, upper chest, shoulder, neck base, neck, head.
constexpr std::size_t kLevelCount = 11;

std::vector<double> torso_levels(const MannequinBase& base) {
    const TrunkLevels& level = base.landmarks.levels;
    const Joints& joints = base.landmarks.joints;
    const double neck = joints[Joint::Neck].y();
    const double head = joints[Joint::Head].y();
    return {level.crotch - 0.01,
            level.hip,
            level.high_hip,
            level.waist,
            level.underbust,
            level.bust,
            base.armpit + 0.035,
            joints[Joint::LeftUpperArm].y() + 0.03,
            neck + 0.015,
            std::lerp(neck, head, kNeckPosition),
            head};
}

// Legs, trunk and head keep their own proportions; the head's length follows head_scale().
Pchip height_map(const MannequinBase& base, const ShapeParameters& shape) {
    const double crotch = base.landmarks.levels.crotch;
    const double neck = base.landmarks.joints[Joint::Neck].y();
    const double head = base.landmarks.joints[Joint::Head].y();
    const double head_length = (base.height - head) * head_scale(shape);
    const double head_at = shape.height - head_length;
    const double trunk = head_at / head;
    const double leg = shape.inseam / crotch;
    const double waist = base.landmarks.levels.waist;
    const double lower_trunk = shape.waist ? (*shape.waist - shape.inseam) / (waist - crotch) : trunk;
    const double neck_at = shape.inseam + (head_at - shape.inseam) * (neck - crotch) / (head - crotch);
    std::vector<double> from{-0.1, 0,    0.12 * crotch, 0.9 * crotch,     crotch + 0.03,
                             neck, head, base.height,   base.height + 0.3};
    std::vector<double> to{-0.1 * leg,
                           0,
                           0.12 * shape.inseam,
                           0.9 * shape.inseam,
                           shape.inseam + 0.03 * lower_trunk,
                           neck_at,
                           head_at,
                           shape.height,
                           shape.height + 0.3 * head_scale(shape)};
    if (shape.waist) {
        constexpr std::ptrdiff_t kAboveCrotch = 5;  // index of the neck's
        from.insert(from.begin() + kAboveCrotch, waist);
        to.insert(to.begin() + kAboveCrotch, *shape.waist);
    }
    return {std::move(from), std::move(to)};
}

// The scale of the chest without the breasts: for women mostly that of the underbust.
double chest_scale(const ShapeParameters& shape, Sex sex) {
    const double bust = shape.scale[Girth::Bust];
    if (sex == Sex::Male) return bust;
    return std::pow(shape.scale[Girth::Underbust], 0.7) * std::pow(bust, 0.3);
}

double shoulder_width_scale(const ShapeParameters& shape, Sex sex) {
    return std::max(shape.shoulder, min_shoulder(shape, sex));
}

double trunk_part_of_upper_chest(const ShapeParameters& shape, Sex sex) {
    return 0.5 * shape.scale[Girth::Underbust] + 0.2 * chest_scale(shape, sex);
}

double upper_chest_scale(const ShapeParameters& shape, Sex sex) {
    return trunk_part_of_upper_chest(shape, sex) + kShoulderPart * shoulder_width_scale(shape, sex);
}

std::vector<double> level_scales(const ShapeParameters& shape, Sex sex) {
    const GirthValues& scale = shape.scale;
    const double slope = shoulder_slope_scale(shape);
    return {0.5 * (scale[Girth::Hip] + scale[Girth::Thigh]),
            scale[Girth::Hip],
            scale[Girth::HighHip],
            scale[Girth::Waist],
            scale[Girth::Underbust],
            chest_scale(shape, sex),
            upper_chest_scale(shape, sex),
            slope,
            0.7 * scale[Girth::Neck] + 0.3 * slope,
            scale[Girth::Neck],
            head_scale(shape)};
}

// A profile through the levels' scales, smoothed by a Gaussian so that no level shows as a crease.
EvenTable blurred_profile(const std::vector<double>& levels, const std::vector<double>& scales, double blur) {
    constexpr int kPoints = 240;
    constexpr int kReach = 40;
    const Pchip profile(levels, scales);
    EvenTable sharp{.low = levels.front(), .high = levels.back(), .values = std::vector<double>(kPoints)};
    const double step = sharp.step();
    for (std::size_t i = 0; i < kPoints; ++i) sharp.values[i] = profile(sharp.low + step * static_cast<double>(i));

    std::vector<double> kernel;
    double sum = 0;
    for (int k = -kReach; k <= kReach; ++k) {
        kernel.push_back(std::exp(-0.5 * std::pow(k * step / blur, 2)));
        sum += kernel.back();
    }
    EvenTable soft = sharp;
    for (int i = 0; i < kPoints; ++i) {
        double value = 0;
        for (int k = -kReach; k <= kReach; ++k) {
            value += kernel[static_cast<std::size_t>(k + kReach)] *
                     sharp.values[static_cast<std::size_t>(std::clamp(i + k, 0, kPoints - 1))];
        }
        soft.values[static_cast<std::size_t>(i)] = value / sum;
    }
    return soft;
}

// Belly and breasts grow to the front, the seat slightly to the back.
std::vector<double> front_biases(Sex sex) {
    return {0, -0.05, 0.20, 0.30, 0.10, sex == Sex::Female ? 0.15 : 0.20, 0.15, 0, 0, 0, 0};
}

std::vector<double> widenings(const ShapeParameters& shape, Sex sex) {
    std::vector<double> widening(kLevelCount, 1);
    const double width = shoulder_width_scale(shape, sex);
    widening[6] = 1 + 0.35 * (width / upper_chest_scale(shape, sex) - 1);
    widening[7] = width / shoulder_slope_scale(shape);
    return widening;
}

double lobe_height(const ShapeParameters& shape, Sex sex) {
    if (sex == Sex::Male) return 0;
    return std::clamp((shape.scale[Girth::Bust] / chest_scale(shape, sex) - 1) / 0.5, -0.3, 1.2);
}

}  // namespace

double head_scale(const ShapeParameters& shape) {
    return std::sqrt(shape.stature);
}

double shoulder_slope_scale(const ShapeParameters& shape) {
    return shape.stature * std::pow(shape.bust_ratio, 0.45);
}

// Solves width = clearance * upper chest, where upper chest = trunk part + 0.3 width.
double min_shoulder(const ShapeParameters& shape, Sex sex) {
    return shape.clearance * trunk_part_of_upper_chest(shape, sex) / (1 - shape.clearance * kShoulderPart);
}

TorsoShape::TorsoShape(const MannequinBase& base, const ShapeParameters& shape)
    : base_(base),
      stature_(shape.stature),
      levels_(torso_levels(base)),
      heights_(height_map(base, shape)),
      radial_(blurred_profile(levels_, level_scales(shape, base.sex), 0.022 * base.height / kReferenceHeight)),
      front_share_(levels_, front_biases(base.sex)),
      widening_(levels_, widenings(shape, base.sex)),
      lobes_(lobe_height(shape, base.sex)) {}

// Breast profile, centred 37 degrees (0.64 rad) to either side of the front, with a smaller extent below the bust level
// than above.
double TorsoShape::lobe(double dy, double cosine) const {
    const double reach = (dy > 0 ? 0.062 : 0.038) * base_.height / kReferenceHeight;
    const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
    return std::exp(-std::pow(dy / reach, 2) - std::pow((angle - 0.64) / 0.52, 2));
}

Vec3d TorsoShape::bend(const Vec3d& x) const {
    const double y = std::clamp(x.y(), levels_.front(), levels_.back());
    const double axis = base_.axis.at(y);
    const double depth = x.z() - axis;
    const double cosine = depth / (std::hypot(x.x(), depth) + 1e-9);  // of the angle from the front
    const double slice = radial_.at(y);
    const double bias = front_share_(y) * cosine * (slice > 1 ? 1.0 : 0.6);
    double scale = 1 + (slice - 1) * (1 + bias);
    if (lobes_ != 0) scale *= 1 + lobes_ * lobe(x.y() - base_.landmarks.levels.bust, cosine);
    return {x.x() * scale * widening_(y), heights_(x.y()), axis * stature_ + depth * scale};
}

}  // namespace selvedge::sim
