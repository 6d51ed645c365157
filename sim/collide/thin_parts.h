#pragma once
// The thin parts of a body: fingers, toes, ears. Cloth that falls on them can be so coarse that they pass through the
// middle of a triangle, and a new vertex there would choose the wrong side of them.
#include <cstdint>
#include <span>
#include <vector>

#include "sim/collide/distance_field.h"
#include "sim/collide/surface_bvh.h"
#include "sim/core/math.h"

namespace selvedge::sim {

// Pieces of the surface that belong together, such as the fingers of a hand: their boxes, and the box around these.
struct ThinPart {
    Eigen::AlignedBox3f box;
    std::vector<Eigen::AlignedBox3f> cells;
};

// Where the body is thinner than 1.75 times the band of the field. Deterministic; the time is linear in the triangles.
std::vector<ThinPart> find_thin_parts(const SurfaceBvh& surface, const DistanceField& field);

// The same of a body that moves: what is thinner than 3 cm, a whole hand, because triangles are as coarse as the cloth
// was before the body came near, and come from any side.
class MovingThinParts {
 public:
    // Casts a ray from each triangle through the body. Pre: the surface is closed.
    explicit MovingThinParts(const SurfaceBvh& at_rest);

    // Boxes that hold the parts on their way between these positions of all vertices, m.
    std::vector<ThinPart> between(std::span<const Vec3f> from, std::span<const Vec3f> to) const;

 private:
    using Vertices = std::vector<std::uint32_t>;
    std::vector<std::vector<Vertices>> parts_;  // each by cells
};

bool is_near(std::span<const ThinPart> parts, const Eigen::AlignedBox3f& box);

}  // namespace selvedge::sim
