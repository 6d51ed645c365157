#pragma once
// The thin parts of a body: fingers, toes, ears. Cloth that falls on them can be so coarse that they pass through the
// middle of a triangle, and a new vertex there would choose the wrong side of them.
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

bool is_near(std::span<const ThinPart> parts, const Eigen::AlignedBox3f& box);

}  // namespace selvedge::sim
