#pragma once
// What a garment is put on: a closed surface with, where it is known, a skeleton and its skin weights.
// Metres, y up, +z to the front, +x to the body's left, floor at y = 0.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

struct Bone {
    std::string name;
    int parent = -1;
    Vec3d joint = Vec3d::Zero();  // where the bone begins, m, in the rest pose
};

struct SkinWeights {
    std::array<std::uint16_t, 4> bones{};
    std::array<float, 4> weights{};  // sum 1, unused are 0
};

struct Body {
    std::string name;
    std::vector<Vec3d> x;
    std::vector<std::array<int, 3>> triangles;  // counter-clockwise seen from outside
    std::vector<Bone> bones;                    // empty when unknown
    std::vector<SkinWeights> skin;              // per vertex, empty when unknown
};

// Least and greatest y of the surface, m: the stature when it stands on the floor.
struct HeightRange {
    double low = 0;
    double high = 0;
};
HeightRange height_range(const Body& body);

}  // namespace selvedge::sim
