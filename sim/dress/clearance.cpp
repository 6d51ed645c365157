#include "sim/dress/clearance.h"

#include <limits>

#include "sim/body/surface_bvh.h"
#include "sim/core/parallel.h"

namespace selvedge {

std::vector<float> measure_clearance(const std::vector<Vec3f>& points, const Body& body) {
    const SurfaceBvh surface(body);
    std::vector<float> distances(points.size(), std::numeric_limits<float>::infinity());
    constexpr std::size_t kGrain = 256;
    parallel_for(points.size(), kGrain, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const auto closest = surface.closest(points[i], std::numeric_limits<float>::infinity());
            if (closest) distances[i] = closest->distance;
        }
    });
    return distances;
}

}  // namespace selvedge
