#include "sim/inspection/rolled_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/inspection/cloth_neighbours.h"

namespace selvedge::sim {
namespace {

// How far along a limb's joints the point is nearest to them, m from the first; on, straight, beyond the last.
double length_along(const Limb& limb, const Vec3d& x) {
    const std::vector<LimbJoint>& joints = limb.joints;
    double length = 0, nearest = 0, least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        const Vec3d along = joints[i + 1].centre - joints[i].centre;
        if (!(along.norm() > 0)) continue;
        const bool is_last = i + 2 == joints.size();
        const double free_share = along.dot(x - joints[i].centre) / along.squaredNorm();
        const double share = std::clamp(free_share, 0.0, is_last ? std::numeric_limits<double>::infinity() : 1.0);
        const double distance = (joints[i].centre + share * along - x).norm();
        if (distance < least) {
            least = distance;
            nearest = length + share * along.norm();
        }
        length += along.norm();
    }
    return nearest;
}

constexpr double kWithin = 0.3;   // m along the cloth: as deep as a hem rolls
constexpr double kInward = 0.7;   // of the way along the cloth: placed within 45 degrees of straight inward
constexpr double kRolled = 0.03;  // m beyond it: a hem of 2 to 3 cm stays where it is folded, wrinkles go less deep

}  // namespace

std::vector<double> inward_of(std::span<const Vec3d> x, const Limb* arm) {
    std::vector<double> inward;
    inward.reserve(x.size());
    for (const Vec3d& point : x) inward.push_back(arm ? -length_along(*arm, point) : point.y());
    return inward;
}

RolledEdge measure_rolled_edge(const GarmentMesh& sewn, const Opening& edge, std::span<const double> placed,
                               std::span<const double> draped) {
    const ClothNeighbours neighbours = cloth_neighbours(sewn);
    RolledEdge rolled;
    int count = 0;
    for (const int vertex : edge.vertices) {
        const auto v = static_cast<std::size_t>(vertex);
        double by = 0;
        for (const auto& [p, distance] : distances_along(neighbours, std::span(&vertex, 1), kWithin)) {
            if (placed[p] > placed[v] + kInward * distance) by = std::max(by, draped[v] - draped[p]);
        }
        if (by <= kRolled) continue;
        ++count;
        if (by <= rolled.by) continue;
        rolled.by = by;
        rolled.vertex = v;
    }
    if (!edge.vertices.empty()) rolled.share = static_cast<double>(count) / static_cast<double>(edge.vertices.size());
    return rolled;
}

}  // namespace selvedge::sim
