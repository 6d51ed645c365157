#pragma once
// A body that a garment is dressed on: a closed surface, with a skeleton and skin weights where they are known. Metres,
// y up, +z to the front, +x to the body's left, floor at y = 0.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

// Scales, then turns, then moves: p' = rotation (scale p) + translation.
struct Transform {
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  // unit
    Vec3d translation = Vec3d::Zero();
    Vec3d scale = Vec3d::Ones();

    Eigen::Affine3d matrix() const {
        Eigen::Affine3d all = Eigen::Affine3d::Identity();
        all.linear() = rotation.toRotationMatrix() * scale.asDiagonal();
        all.translation() = translation;
        return all;
    }
};

struct Bone {
    std::string name;
    int parent = -1;                                             // precedes its children
    Vec3d joint = Vec3d::Zero();                                 // start of the bone in the rest pose, m
    Transform rest = {};                                         // to the parent's frame; of a root, to the file's
    Eigen::Affine3d inverse_bind = Eigen::Affine3d::Identity();  // from bind positions (m) to the bone's frame
};

struct SkinWeights {
    std::array<std::uint16_t, 4> bones{};
    std::array<float, 4> weights{};  // the sum is 1; unused ones are 0
};

struct Body {
    std::string name;
    std::vector<Vec3d> x;
    std::vector<std::array<int, 3>> triangles;  // counter-clockwise seen from outside
    std::vector<Bone> bones;                    // empty when unknown
    std::vector<SkinWeights> skin;              // per vertex, empty when unknown
    std::string made_from{};                    // bodies with equal text have equal surfaces; empty: unknown
    std::string file{};                         // canonical path that it was read from; empty: none
    double lift = 0;                            // m, by which it was raised from the file's frame to the floor
    Eigen::Affine3d frame = Eigen::Affine3d::Identity();  // from the frame of the root bones, the file's, to ours
    std::vector<Vec3d> bind{};                            // m, where the skin was bound to the bones; empty: at x
};

// Minimum and maximum y of the surface, m; `high` is the stature when the body stands on the floor.
struct HeightRange {
    double low = 0;
    double high = 0;
};
HeightRange height_range(const Body& body);

}  // namespace selvedge::sim
