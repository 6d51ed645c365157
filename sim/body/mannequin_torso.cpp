#include "sim/body/mannequin_torso.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace selvedge {

namespace {

constexpr double kFigureHeight = 1.6;  // m, of the body that the lengths below were chosen on

// How much of the upper chest's scale is that of the shoulder's width; the rest is the rib cage's.
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

// Legs, trunk and head each keep their own proportions; the head's length follows head_scale().
Pchip height_map(const MannequinBase& base, const ShapeParameters& shape) {
    const double crotch = base.landmarks.levels.crotch;
    const double neck = base.landmarks.joints[Joint::Neck].y();
    const double head = base.landmarks.joints[Joint::Head].y();
    const double head_length = (base.height - head) * head_scale(shape);
    const double head_at = shape.height - head_length;
    const double trunk = head_at / head;
    const double leg = shape.inseam / crotch;
    const double neck_at = shape.inseam + (head_at - shape.inseam) * (neck - crotch) / (head - crotch);
    return Pchip({-0.1, 0, 0.12 * crotch, 0.9 * crotch, crotch + 0.03, neck, head, base.height, base.height + 0.3},
                 {-0.1 * leg, 0, 0.12 * shape.inseam, 0.9 * shape.inseam, shape.inseam + 0.03 * trunk, neck_at, head_at,
                  shape.height, shape.height + 0.3 * head_scale(shape)});
}

// The scale of the chest without the breasts: mostly that of the rib cage below them.
double chest_scale(const ShapeParameters& shape, Sex sex) {
    const double bust = shape.scale[Girth::Bust];
    if (sex == Sex::Male) return bust;
    return std::pow(shape.scale[Girth::Underbust], 0.7) * std::pow(bust, 0.3);
}

double shoulder_width_scale(const ShapeParameters& shape, Sex sex) {
    return std::max(shape.shoulder, least_shoulder(shape, sex));
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

// A profile through the levels' scales, blurred so that no level shows as a crease.
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

// Belly and breasts grow to the front, the seat a little to the back.
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

// Solves width = clearance * upper chest, where the upper chest is part trunk, part 0.3 width.
double least_shoulder(const ShapeParameters& shape, Sex sex) {
    return shape.clearance * trunk_part_of_upper_chest(shape, sex) / (1 - shape.clearance * kShoulderPart);
}

TorsoShape::TorsoShape(const MannequinBase& base, const ShapeParameters& shape)
    : base_(base),
      stature_(shape.stature),
      levels_(torso_levels(base)),
      heights_(height_map(base, shape)),
      radial_(blurred_profile(levels_, level_scales(shape, base.sex), 0.022 * base.height / kFigureHeight)),
      front_bias_(levels_, front_biases(base.sex)),
      widening_(levels_, widenings(shape, base.sex)),
      lobes_(lobe_height(shape, base.sex)) {}

// Breasts: at 37 degrees to either side of the front, rounder below the bust level than above it.
double TorsoShape::lobe(double dy, double cosine) const {
    const double reach = (dy > 0 ? 0.062 : 0.038) * base_.height / kFigureHeight;
    const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
    return std::exp(-std::pow(dy / reach, 2) - std::pow((angle - 0.64) / 0.52, 2));
}

Vec3d TorsoShape::bend(const Vec3d& x) const {
    const double y = std::clamp(x.y(), levels_.front(), levels_.back());
    const double axis = base_.axis.at(y);
    const double depth = x.z() - axis;
    const double cosine = depth / (std::hypot(x.x(), depth) + 1e-9);  // of the angle from the front
    const double slice = radial_.at(y);
    const double bias = front_bias_(y) * cosine * (slice > 1 ? 1.0 : 0.6);
    double scale = 1 + (slice - 1) * (1 + bias);
    if (lobes_ != 0) scale *= 1 + lobes_ * lobe(x.y() - base_.landmarks.levels.bust, cosine);
    return {x.x() * scale * widening_(y), heights_(x.y()), axis * stature_ + depth * scale};
}

}  // namespace selvedge
