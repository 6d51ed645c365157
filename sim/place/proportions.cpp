#include "sim/place/proportions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "sim/body/joint_names.h"

namespace selvedge::sim {
namespace {

constexpr double kHips = 0.525, kShoulders = 0.800;  // of the stature

// The mean height of the joints of both sides, m; none if one is not named.
std::optional<double> height_of_joints(const Body& body, const JointBones& joints, Joint left, Joint right) {
    if (!joints.has(left) || !joints.has(right)) return std::nullopt;
    const auto y = [&](Joint joint) { return body.bones[static_cast<std::size_t>(joints[joint])].joint.y(); };
    return (y(left) + y(right)) / 2;
}

}  // namespace

double Proportions::at(double share) const {
    if (is_usual) return floor + share * (crown - floor);
    if (share < kHips) return std::lerp(floor, hips, share / kHips);
    if (share < kShoulders) return std::lerp(hips, shoulders, (share - kHips) / (kShoulders - kHips));
    return std::lerp(shoulders, crown, (share - kShoulders) / (1 - kShoulders));
}

double Proportions::stature_by_trunk() const {
    return is_usual ? crown - floor : (shoulders - hips) / (kShoulders - kHips);
}

Proportions find_proportions(const Body& body, const Stature& stature) {
    // Of the stature, from the usual share: on skeletons of people of many builds, joints lie within 0.03 of it.
    constexpr double kUsual = 0.06;
    Proportions found{.floor = stature.floor, .hips = 0, .shoulders = 0, .crown = stature.crown};
    found.hips = found.at(kHips);
    found.shoulders = found.at(kShoulders);
    const JointBones joints = find_joints(body.bones);
    const auto hips = height_of_joints(body, joints, Joint::LeftUpperLeg, Joint::RightUpperLeg);
    const auto shoulders = height_of_joints(body, joints, Joint::LeftUpperArm, Joint::RightUpperArm);
    if (!hips || !shoulders) return found;
    const bool is_in_order = stature.floor < *hips && *hips < *shoulders && *shoulders < stature.crown;
    const double farthest = std::max(std::abs(*hips - found.hips), std::abs(*shoulders - found.shoulders));
    if (!is_in_order || farthest <= kUsual * stature.height()) return found;
    found.hips = *hips;
    found.shoulders = *shoulders;
    found.is_usual = false;
    return found;
}

}  // namespace selvedge::sim
