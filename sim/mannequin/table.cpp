#include "sim/mannequin/table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <utility>

#include "sim/core/assert.h"
#include "sim/core/file.h"
#include "sim/core/json.h"

namespace selvedge::sim {
std::span<const EmbeddedFile> mannequin_files();

namespace {

constexpr double kUnit = 1e-4;  // m per unit of the table, which is 0.1 mm

constexpr std::array<const char*, kCagePartCount> kPartNames{"torso", "crown",   "bridge", "leg",     "toecap",
                                                             "arm",   "handcap", "thumb",  "thumbcap"};

// Points of one part, section after section.
std::vector<Vec3d> read_part(const JsonView& sections) {
    std::vector<Vec3d> points;
    for (std::size_t s = 0; s < sections.size(); ++s) {
        const std::vector<double> statistics = sections.at(s).numbers();
        for (std::size_t i = 0; i + 2 < statistics.size(); i += 3) {
            points.emplace_back(kUnit * statistics[i], kUnit * statistics[i + 1], kUnit * statistics[i + 2]);
        }
    }
    return points;
}

std::vector<Vec3d> read_points(const JsonView& parts, const Cage& cage) {
    std::array<std::vector<Vec3d>, kCagePartCount> points;
    for (std::size_t p = 0; p < points.size(); ++p) points[p] = read_part(parts.at(kPartNames[p]));
    std::array<std::size_t, kCagePartCount> taken{};
    std::vector<Vec3d> in_order;
    for (const CageVertex& vertex : cage.left) {
        const auto part = static_cast<std::size_t>(vertex.part);
        SELVEDGE_ASSERT(taken[part] < points[part].size());
        in_order.push_back(points[part][taken[part]++]);
    }
    for (std::size_t p = 0; p < points.size(); ++p) SELVEDGE_ASSERT(taken[p] == points[p].size());
    return in_order;
}

// The table lists the midplane's and the left side's joints; a left joint's key omits "left_".
Joints read_joints(const JsonView& view) {
    constexpr std::string_view kSide = "left_";
    Joints joints;
    for (std::size_t i = 0; i < kMiddleJoints + kSideJoints; ++i) {
        std::string_view name = joint_name(static_cast<Joint>(i));
        if (name.starts_with(kSide)) name.remove_prefix(kSide.size());
        const std::vector<double> x = view.at(name).numbers();
        SELVEDGE_ASSERT(x.size() == 3);
        joints.x[i] = kUnit * Vec3d(x[0], x[1], x[2]);
    }
    mirror_left_side(joints);
    return joints;
}

TrunkLevels read_levels(const JsonView& sex) {
    const JsonView levels = sex.at("landmarks_y");
    return {.bust = kUnit * levels.at("bust").number(),
            .underbust = kUnit * levels.at("underbust").number(),
            .waist = kUnit * levels.at("waist").number(),
            .high_hip = kUnit * levels.at("high_hip").number(),
            .hip = kUnit * levels.at("hip").number(),
            .crotch = kUnit * sex.at("crotch_y").number()};
}

}  // namespace

MannequinTable read_mannequin_table(Sex sex, const Cage& cage) {
    const EmbeddedFile& file = mannequin_files().front();
    const std::string name(file.name);
    const Json document = parse_json(file.text, name);
    const JsonView statistics = JsonView(document, name).at(sex == Sex::Female ? "female" : "male");
    return {.left_points = read_points(statistics.at("parts"), cage),
            .joints = read_joints(statistics.at("joints")),
            .levels = read_levels(statistics),
            .armpit = kUnit * statistics.at("armpit_y").number()};
}

namespace {

using Count = CageCounts;
using JointWeights = Eigen::Matrix<double, 1, static_cast<int>(kJointCount)>;

double& of(JointWeights& weights, Joint joint) {
    return weights[static_cast<Eigen::Index>(joint)];
}

// Scale relative to the body on which the lengths below were chosen, whose head joint was 1.47 m high.
double body_scale(const Joints& joints) {
    return joints[Joint::Head].y() / 1.47;
}

// Moves the given share of all weights to one joint.
void yield_share(JointWeights& weights, Joint to, double share) {
    weights *= 1 - share;
    of(weights, to) += share;
}

// Neck and head begin lower in front (jaw, throat) than at the back, and never below the shoulder or the neck ring.
JointWeights spine_weights(const CageVertex& vertex, const Vec3d& x, const Joints& joints) {
    const double h = body_scale(joints);
    const double spine = joints[Joint::Spine].y();
    const double chest = joints[Joint::Chest].y();
    const double neck = joints[Joint::Neck].y();
    const double jaw = joints[Joint::Head].y() - 0.45 * 0.04;
    const double sloped = x.y() - 0.45 * x.z();
    const double above_hips = smoothstep(x.y(), spine - 0.05 * h, spine + 0.09 * h);
    const double above_waist = smoothstep(x.y(), chest - 0.03 * h, chest + 0.12 * h);
    double above_chest = smoothstep(sloped, neck - 0.02 * h, neck + 0.04 * h);
    double above_neck = smoothstep(sloped, jaw - 0.06 * h, jaw);

    const bool is_torso = vertex.part == CagePart::Torso;
    if (vertex.part == CagePart::Crown || (is_torso && vertex.row > Count::kNeckTop)) {
        above_chest = above_neck = 1;
    } else if (is_torso && vertex.row == Count::kNeckTop) {
        above_chest = 1;
        above_neck = std::max(above_neck, 0.6);
    } else if (is_torso && vertex.row > Count::kShoulderTop + 1) {
        above_neck = std::min(above_neck, 0.25);
    } else if (is_torso) {
        above_chest = above_neck = 0;
    }

    JointWeights weights = JointWeights::Zero();
    of(weights, Joint::Hips) = 1 - above_hips;
    of(weights, Joint::Spine) = above_hips * (1 - above_waist);
    of(weights, Joint::Chest) = above_hips * above_waist * (1 - above_chest);
    of(weights, Joint::Neck) = above_hips * above_waist * above_chest * (1 - above_neck);
    of(weights, Joint::Head) = above_hips * above_waist * above_chest * above_neck;
    return weights;
}

bool is_on_armhole(const CageVertex& vertex) {
    const bool rows = Count::kArmholeRow <= vertex.row && vertex.row <= Count::kShoulderTop;
    const bool columns = Count::kArmholeFirst <= vertex.column && vertex.column <= Count::kArmholeLast;
    const bool is_side = vertex.column == Count::kArmholeFirst || vertex.column == Count::kArmholeLast;
    const bool is_end = vertex.row == Count::kArmholeRow || vertex.row == Count::kShoulderTop;
    return rows && columns && (is_side || is_end);
}

// The shoulder joint gets the outer upper chest, and the upper arm a part of the armhole's edge.
void add_shoulder(JointWeights& weights, const CageVertex& vertex, const Vec3d& x, double h) {
    if (vertex.row < Count::kArmholeRow - 3 || vertex.row > Count::kNeckBase) return;
    const double share = 0.85 * smoothstep(x.x(), 0.02 * h, 0.13 * h) *
                         smoothstep(vertex.row, Count::kArmholeRow - 3, Count::kArmholeRow + 1.5) *
                         (1 - smoothstep(vertex.row, Count::kShoulderTop + 1.5, Count::kNeckBase));
    const double moved = share * of(weights, Joint::Chest);
    of(weights, Joint::Chest) -= moved;
    of(weights, Joint::LeftShoulder) += moved;
    if (is_on_armhole(vertex)) yield_share(weights, Joint::LeftUpperArm, 0.38);
}

// The upper leg influences the lowest torso rows, less near the midplane.
void add_thigh(JointWeights& weights, const CageVertex& vertex, const Vec3d& x, double h) {
    constexpr std::array kRamp{0.55, 0.42, 0.26, 0.12, 0.04};
    const auto row = static_cast<std::size_t>(vertex.row);
    if (row >= kRamp.size()) return;
    yield_share(weights, Joint::LeftUpperLeg, kRamp[row] * (0.15 + 0.85 * smoothstep(x.x(), 0, 0.06 * h)));
}

JointWeights trunk_weights(const CageVertex& vertex, const Vec3d& x, const Joints& joints) {
    const double h = body_scale(joints);
    JointWeights weights = spine_weights(vertex, x, joints);
    if (vertex.part == CagePart::Torso) {
        add_shoulder(weights, vertex, x, h);
        add_thigh(weights, vertex, x, h);
    }
    if (vertex.part == CagePart::Bridge) {
        weights *= 0.84;
        of(weights, Joint::LeftUpperLeg) += 0.08;
        of(weights, Joint::RightUpperLeg) += 0.08;
    }
    return weights;
}

// Mean direction of the two bones that meet at a joint.
Vec3d bisector(const Vec3d& before, const Vec3d& joint, const Vec3d& after) {
    return ((joint - before).normalized() + (after - joint).normalized()).normalized();
}

double ramp_at(const CageVertex& vertex, std::initializer_list<double> first_rows) {
    const auto row = static_cast<std::size_t>(vertex.row - 1);
    return row < first_rows.size() ? first_rows.begin()[row] : 0.0;
}

JointWeights leg_weights(const CageVertex& vertex, const Vec3d& x, const Joints& joints) {
    const double h = body_scale(joints);
    const Vec3d& knee = joints[Joint::LeftLowerLeg];
    const Vec3d& ankle = joints[Joint::LeftFoot];
    const Vec3d shin = bisector(joints[Joint::LeftUpperLeg], knee, ankle);
    const bool is_cap = vertex.part == CagePart::ToeCap;
    const bool is_near_foot = is_cap || vertex.row >= Count::kAnkleRow - 4;
    const bool is_foot = is_cap || vertex.row > Count::kAnkleRow;
    const double below_knee = smoothstep((x - knee).dot(shin), -0.05 * h, 0.05 * h);
    const Vec3d instep(0, -0.8, 0.6);  // down and forward: the boundary of the foot is oblique
    const double below_ankle = is_near_foot ? smoothstep((x - ankle).dot(instep), -0.035 * h, 0.035 * h) : 0.0;
    const double in_toes = is_foot ? smoothstep(x.z() - joints[Joint::LeftToe].z(), -0.02 * h, 0.02 * h) : 0.0;
    const double in_hips =
        is_cap ? 0.0 : ramp_at(vertex, {0.34, 0.2, 0.08, 0.02}) * (1 - 0.4 * smoothstep(x.x(), 0.03 * h, 0.12 * h));

    JointWeights weights = JointWeights::Zero();
    of(weights, Joint::Hips) = in_hips;
    of(weights, Joint::LeftUpperLeg) = (1 - in_hips) * (1 - below_knee);
    of(weights, Joint::LeftLowerLeg) = below_knee * (1 - below_ankle);
    of(weights, Joint::LeftFoot) = below_knee * below_ankle * (1 - in_toes);
    of(weights, Joint::LeftToe) = below_knee * below_ankle * in_toes;
    return weights;
}

JointWeights arm_weights(const CageVertex& vertex, const Vec3d& x, const Joints& joints) {
    const double h = body_scale(joints);
    const Vec3d& elbow = joints[Joint::LeftLowerArm];
    const Vec3d& wrist = joints[Joint::LeftHand];
    const Vec3d forearm = bisector(joints[Joint::LeftUpperArm], elbow, wrist);
    const bool is_arm_ring = vertex.part == CagePart::Arm;
    const bool is_shoulder_fan = is_arm_ring && vertex.row <= Count::kShoulderFan;
    const double below_elbow = is_shoulder_fan ? 0.0 : smoothstep((x - elbow).dot(forearm), -0.04 * h, 0.04 * h);
    const double in_hand =
        below_elbow > 0.5 ? smoothstep((x - wrist).dot((wrist - elbow).normalized()), -0.03 * h, 0.02 * h) : 0.0;
    const double in_shoulder = is_arm_ring ? ramp_at(vertex, {0.38, 0.12, 0.02}) : 0.0;

    JointWeights weights = JointWeights::Zero();
    of(weights, Joint::LeftShoulder) = in_shoulder;
    of(weights, Joint::LeftUpperArm) = (1 - in_shoulder) * (1 - below_elbow);
    of(weights, Joint::LeftLowerArm) = below_elbow * (1 - in_hand);
    of(weights, Joint::LeftHand) = below_elbow * in_hand;
    return weights;
}

JointWeights left_weights(const CageVertex& vertex, const Vec3d& x, const Joints& joints) {
    switch (vertex.part) {
        case CagePart::Torso:
        case CagePart::Crown:
        case CagePart::Bridge:
            return trunk_weights(vertex, x, joints);
        case CagePart::Leg:
        case CagePart::ToeCap:
            return leg_weights(vertex, x, joints);
        default:
            return arm_weights(vertex, x, joints);
    }
}

JointWeights mirrored_weights(const JointWeights& weights) {
    JointWeights twin;
    for (std::size_t j = 0; j < kJointCount; ++j) {
        twin[static_cast<Eigen::Index>(mirrored(static_cast<Joint>(j)))] = weights[static_cast<Eigen::Index>(j)];
    }
    return twin;
}

// Each row becomes the mean of itself and the mean of its neighbours.
void smooth(VertexRows& weights, const std::vector<std::array<int, 2>>& edges) {
    VertexRows around = VertexRows::Zero(weights.rows(), weights.cols());
    Eigen::VectorXd valence = Eigen::VectorXd::Zero(weights.rows());
    for (const auto& [a, b] : edges) {
        around.row(a) += weights.row(b);
        around.row(b) += weights.row(a);
        valence[a] += 1;
        valence[b] += 1;
    }
    for (Eigen::Index v = 0; v < weights.rows(); ++v) {
        weights.row(v) = 0.5 * weights.row(v) + 0.5 * around.row(v) / valence[v];
    }
}

}  // namespace

VertexRows cage_weights(const Cage& cage, const MannequinTable& table) {
    VertexRows weights(cage.vertex_count, static_cast<Eigen::Index>(kJointCount));
    for (std::size_t v = 0; v < cage.left.size(); ++v) {
        JointWeights row = left_weights(cage.left[v], table.left_points[v], table.joints);
        row /= row.sum();
        const bool is_own_twin = cage.mirror[v] == static_cast<int>(v);
        weights.row(cage.mirror[v]) = mirrored_weights(row);
        weights.row(static_cast<Eigen::Index>(v)) =
            is_own_twin ? JointWeights(0.5 * (row + mirrored_weights(row))) : row;
    }
    const auto edges = quad_edges(cage.quads, cage.vertex_count);
    for (int pass = 0; pass < 2; ++pass) smooth(weights, edges);
    return weights;
}

namespace {

// Three-point formula, limited to avoid overshoot. h: interval widths, d: interval slopes, both from the end inwards.
double end_slope(double h0, double h1, double d0, double d1) {
    const double slope = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
    if (slope * d0 <= 0) return 0;
    if (d0 * d1 <= 0 && std::abs(slope) > 3 * std::abs(d0)) return 3 * d0;
    return slope;
}

double inner_slope(double h0, double h1, double d0, double d1) {
    if (d0 * d1 <= 0) return 0;
    const double w0 = 2 * h1 + h0;
    const double w1 = h1 + 2 * h0;
    return (w0 + w1) / (w0 / d0 + w1 / d1);
}

}  // namespace

Pchip::Pchip(std::vector<double> x, std::vector<double> y) : x_(std::move(x)), y_(std::move(y)) {
    const std::size_t n = x_.size();
    SELVEDGE_ASSERT(n >= 3 && y_.size() == n);
    std::vector<double> h;
    std::vector<double> d;
    for (std::size_t i = 0; i + 1 < n; ++i) {
        h.push_back(x_[i + 1] - x_[i]);
        SELVEDGE_ASSERT(h.back() > 0);
        d.push_back((y_[i + 1] - y_[i]) / h.back());
    }
    slope_.push_back(end_slope(h[0], h[1], d[0], d[1]));
    for (std::size_t i = 1; i + 1 < n; ++i) slope_.push_back(inner_slope(h[i - 1], h[i], d[i - 1], d[i]));
    slope_.push_back(end_slope(h[n - 2], h[n - 3], d[n - 2], d[n - 3]));
}

double Pchip::operator()(double x) const {
    const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x) - x_.begin();
    const auto i = static_cast<std::size_t>(above) - 1;
    const double h = x_[i + 1] - x_[i];
    const double t = (x - x_[i]) / h;
    const double t2 = t * t;
    const double t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * y_[i] + (t3 - 2 * t2 + t) * h * slope_[i] + (3 * t2 - 2 * t3) * y_[i + 1] +
           (t3 - t2) * h * slope_[i + 1];
}

}  // namespace selvedge::sim
