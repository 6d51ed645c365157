#include "sim/body/mannequin_girths.h"

#include "sim/core/assert.h"

namespace selvedge {

namespace {

constexpr double kThighBelowCrotch = 0.03;  // m

struct Limb {
    Vec3d root;
    Vec3d middle;
    Vec3d end;
};

Limb left_arm(const Joints& joints) {
    return {joints[Joint::LeftUpperArm], joints[Joint::LeftLowerArm], joints[Joint::LeftHand]};
}

Limb left_leg(const Joints& joints) {
    return {joints[Joint::LeftUpperLeg], joints[Joint::LeftLowerLeg], joints[Joint::LeftFoot]};
}

// Across the bone; at the middle joint, halfway between the planes across both bones.
Plane across(const Limb& limb, double position) {
    const Vec3d upper = (limb.middle - limb.root).normalized();
    const Vec3d lower = (limb.end - limb.middle).normalized();
    if (position < 1) return {limb.root + position * (limb.middle - limb.root), upper};
    if (position > 1) return {limb.middle + (position - 1) * (limb.end - limb.middle), lower};
    return {limb.middle, (upper + lower).normalized()};
}

Plane level(double y) {
    return {Vec3d(0, y, 0), Vec3d::UnitY()};
}

Plane neck_plane(const Joints& joints) {
    const Vec3d& neck = joints[Joint::Neck];
    return {neck + kNeckPosition * (joints[Joint::Head] - neck), Vec3d(0, 1, 0.35).normalized()};
}

Plane thigh_plane(const Landmarks& landmarks) {
    return {across(left_leg(landmarks.joints), thigh_position(landmarks)).point, Vec3d::UnitY()};
}

}  // namespace

double thigh_position(const Landmarks& landmarks) {
    const Limb leg = left_leg(landmarks.joints);
    return (leg.root.y() - (landmarks.levels.crotch - kThighBelowCrotch)) / (leg.root.y() - leg.middle.y());
}

Plane girth_plane(Girth girth, const Landmarks& landmarks) {
    const Limb arm = left_arm(landmarks.joints);
    const Limb leg = left_leg(landmarks.joints);
    switch (girth) {
        case Girth::Bust:
            return level(landmarks.levels.bust);
        case Girth::Underbust:
            return level(landmarks.levels.underbust);
        case Girth::Waist:
            return level(landmarks.levels.waist);
        case Girth::HighHip:
            return level(landmarks.levels.high_hip);
        case Girth::Hip:
            return level(landmarks.levels.hip);
        case Girth::Neck:
            return neck_plane(landmarks.joints);
        case Girth::Biceps:
            return across(arm, kBicepsPosition);
        case Girth::Elbow:
            return across(arm, 1);
        case Girth::Forearm:
            return across(arm, kForearmPosition);
        case Girth::Wrist:
            return across(arm, kWristPosition);
        case Girth::Thigh:
            return thigh_plane(landmarks);
        case Girth::MidThigh:
            return across(leg, kMidThighPosition);
        case Girth::Knee:
            return across(leg, 1);
        case Girth::Calf:
            return across(leg, kCalfPosition);
        case Girth::Ankle:
            return across(leg, kAnklePosition);
    }
    SELVEDGE_ASSERT(false);
}

GirthValues measure_girths(const Body& body, const Landmarks& landmarks) {
    GirthValues girths;
    for (std::size_t g = 0; g < kGirthCount; ++g) {
        const Plane plane = girth_plane(static_cast<Girth>(g), landmarks);
        const auto loop = nearest_loop(section(body, plane), plane.point);
        SELVEDGE_ASSERT(loop.has_value());
        girths.value[g] = tape_length(*loop, plane);
    }
    return girths;
}

}  // namespace selvedge
