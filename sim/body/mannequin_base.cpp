#include "sim/body/mannequin_base.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim/body/mannequin_weights.h"

namespace selvedge {

namespace {

constexpr double kNegligibleWeight = 1e-4;

// Positions and weights in one mesh, so that they are subdivided alike.
QuadMesh fill_cage(const Cage& cage, const MannequinTable& table) {
    constexpr auto kWeights = static_cast<Eigen::Index>(kJointCount);
    QuadMesh mesh{.values = VertexRows(cage.vertex_count, 3 + kWeights), .quads = cage.quads};
    for (std::size_t v = 0; v < cage.left.size(); ++v) {
        // The twin first: on the midplane it is the vertex itself.
        mesh.values.row(cage.mirror[v]).head<3>() = mirrored(table.left_points[v]).transpose();
        mesh.values.row(static_cast<Eigen::Index>(v)).head<3>() = table.left_points[v].transpose();
    }
    mesh.values.rightCols<kWeights>() = cage_weights(cage, table);
    return mesh;
}

// Stood on the floor.
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

// Halfway between front and back, near the midplane, at each height.
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

// Nine-point moving mean, the ends held.
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
    return base;
}

}  // namespace selvedge
