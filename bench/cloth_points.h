#pragma once
// Points that move near a body as the vertices of a worn garment do: for measuring what it costs to keep them out.
#include <vector>

#include "sim/body/surface_bvh.h"

namespace selvedge {

struct ClothPointOptions {
    int points = 3100;
    int steps = 56;                 // sub-steps
    float substep = 1.0F / 840.0F;  // s
    float speed = 1.0F;             // m/s, root mean square of free points
    float offset = 0.003F;          // m, points are put back to this distance
    unsigned seed = 7;
};

struct ClothPoints {
    // [step][point]: where the point is when it is asked, and what is true there.
    std::vector<std::vector<Vec3f>> x;
    std::vector<std::vector<ClosestPoint>> exact;
    double in_contact = 0;  // share of them nearer than the offset
};

// Over the trunk, upper arms and thighs, at first 0 to 30 mm from the surface; neighbours in space are about neighbours
// in the list. Each swings at random; three in ten also fall towards the body, and now and then one leaps in by up to a
// centimetre. After a step what is nearer than the offset is put back to it and loses its speed inward.
ClothPoints move_cloth_points(const SurfaceBvh& surface, const ClothPointOptions& options = {});

}  // namespace selvedge
