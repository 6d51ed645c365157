#include "sim/mannequin/base.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim/core/assert.h"
#include "sim/mannequin/table.h"

namespace selvedge::sim {
namespace {

constexpr double kNegligibleWeight = 1e-4;

// Positions and weights in one mesh, so that they are subdivided together.
QuadMesh fill_cage(const Cage& cage, const MannequinTable& table) {
    constexpr auto kWeights = static_cast<Eigen::Index>(kJointCount);
    QuadMesh mesh{.values = VertexRows(cage.vertex_count, 3 + kWeights), .quads = cage.quads};
    for (std::size_t v = 0; v < cage.left.size(); ++v) {
        // The mirror vertex first: on the midplane it is the vertex itself, whose own point must win.
        mesh.values.row(cage.mirror[v]).head<3>() = mirrored(table.left_points[v]).transpose();
        mesh.values.row(static_cast<Eigen::Index>(v)).head<3>() = table.left_points[v].transpose();
    }
    mesh.values.rightCols<kWeights>() = cage_weights(cage, table);
    return mesh;
}

// Moved vertically to stand on the floor.
std::vector<Vec3d> positions(const QuadMesh& mesh) {
    const double floor = mesh.values.col(1).minCoeff();
    std::vector<Vec3d> x;
    x.reserve(static_cast<std::size_t>(mesh.values.rows()));
    for (Eigen::Index v = 0; v < mesh.values.rows(); ++v) {
        x.emplace_back(mesh.values(v, 0), mesh.values(v, 1) - floor, mesh.values(v, 2));
    }
    return x;
}

VertexRows pruned_weights(const QuadMesh& mesh) {
    VertexRows weights = mesh.values.rightCols<static_cast<Eigen::Index>(kJointCount)>();
    for (Eigen::Index v = 0; v < weights.rows(); ++v) {
        auto row = weights.row(v);
        row = (row.array() < kNegligibleWeight).select(0.0, row).eval();
        row /= row.sum();
    }
    return weights;
}

double trunk_share(const VertexRows& weights, std::size_t vertex) {
    return weights.row(static_cast<Eigen::Index>(vertex)).head<kMiddleJoints>().sum();
}

// z halfway between front and back near the midplane, per height.
std::vector<double> mid_depths(const MannequinBase& base, std::size_t count) {
    constexpr double kHalfWidth = 0.03;   // m
    constexpr double kHalfHeight = 0.02;  // m
    const double spacing = (base.axis.high - base.axis.low) / static_cast<double>(count - 1);
    std::vector<double> front(count, -1);
    std::vector<double> back(count, 1);
    for (std::size_t v = 0; v < base.surface.x.size(); ++v) {
        const Vec3d& x = base.surface.x[v];
        if (std::abs(x.x()) >= kHalfWidth || trunk_share(base.weights, v) <= 0.5) continue;
        for (std::size_t i = 0; i < count; ++i) {
            if (std::abs(x.y() - (base.axis.low + spacing * static_cast<double>(i))) >= kHalfHeight) continue;
            front[i] = std::max(front[i], x.z());
            back[i] = std::min(back[i], x.z());
        }
    }
    for (std::size_t i = 0; i < count; ++i) front[i] = 0.5 * (front[i] + back[i]);
    return front;
}

// Moving mean over nine values; end values are repeated.
std::vector<double> smoothed(const std::vector<double>& z) {
    constexpr int kReach = 4;
    const int last = static_cast<int>(z.size()) - 1;
    std::vector<double> mean(z.size(), 0);
    for (int i = 0; i <= last; ++i) {
        for (int k = -kReach; k <= kReach; ++k) {
            mean[static_cast<std::size_t>(i)] += z[static_cast<std::size_t>(std::clamp(i + k, 0, last))];
        }
        mean[static_cast<std::size_t>(i)] /= 2 * kReach + 1;
    }
    return mean;
}

}  // namespace

MannequinBase make_mannequin_base(Sex sex, int subdivisions) {
    constexpr std::size_t kAxisPoints = 60;
    const Cage cage = make_cage();
    const MannequinTable table = read_mannequin_table(sex, cage);
    QuadMesh mesh = fill_cage(cage, table);
    for (int step = 0; step < subdivisions; ++step) mesh = subdivide(mesh);
    move_to_limit(mesh);

    MannequinBase base;
    base.sex = sex;
    base.surface.x = positions(mesh);
    base.surface.triangles = split_quads(mesh);
    base.weights = pruned_weights(mesh);
    base.landmarks = {.joints = table.joints, .levels = table.levels};
    base.armpit = table.armpit;
    base.height = height_range(base.surface).high;
    base.axis.low = table.levels.crotch;
    base.axis.high = table.joints[Joint::Head].y();
    base.axis.values = smoothed(mid_depths(base, kAxisPoints));
    base.girths = measure_girths(base.surface, base.landmarks);
    base.lower_arm = lower_arm_girths(base.surface, table.joints);
    return base;
}

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

// Plane perpendicular to the bone; at the middle joint perpendicular to the mean direction of both bones.
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

namespace {

double girth_at(const Body& body, const Plane& plane) {
    const auto loop = nearest_loop(section(body, plane), plane.point);
    SELVEDGE_ASSERT(loop.has_value());
    return tape_length(*loop, plane);
}

}  // namespace

GirthValues measure_girths(const Body& body, const Landmarks& landmarks) {
    GirthValues girths;
    for (std::size_t g = 0; g < kGirthCount; ++g)
        girths.value[g] = girth_at(body, girth_plane(static_cast<Girth>(g), landmarks));
    return girths;
}

EvenTable lower_arm_girths(const Body& body, const Joints& joints) {
    constexpr std::size_t kPlaces = 9;
    EvenTable girths{.low = kForearmPosition, .high = kWristPosition, .values = std::vector<double>(kPlaces)};
    for (std::size_t i = 0; i < kPlaces; ++i) {
        const double position = girths.low + girths.step() * static_cast<double>(i);
        girths.values[i] = girth_at(body, across(left_arm(joints), position));
    }
    return girths;
}

}  // namespace selvedge::sim
