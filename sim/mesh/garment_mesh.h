#pragma once
// All panels of a garment as one mesh: 3D positions on vertices, 2D material coordinates on triangle corners, for
// they jump at a seam where the position does not.  (SPEC 3.2)
#include <array>
#include <string>
#include <vector>

#include "sim/core/vec.h"

namespace selvedge {

struct GarmentTriangle {
    std::array<int, 3> vertices{};  // counter-clockwise seen from the fabric's right side
    std::array<Vec2d, 3> u{Vec2d::Zero(), Vec2d::Zero(), Vec2d::Zero()};  // per corner, m, own panel's held frame
    int panel = 0;
};

// Two vertices that a seam brings together.
struct SeamLink {
    int a = 0;
    int b = 0;
    int seam = 0;  // index into Pattern::seams
};

// Unsewn (links not empty: the panels are apart) or sewn (links empty: linked vertices are one).
struct GarmentMesh {
    std::vector<Vec3d> x;  // positions, m
    std::vector<GarmentTriangle> triangles;
    std::vector<SeamLink> links;
    std::vector<int> pins;  // vertices that do not move
    std::vector<std::string> panel_names;
    std::vector<double> panel_grain_angles;   // rad, see Panel::grain_angle
    std::vector<Vec2d> panel_sett_offsets{};  // m, see Panel::sett_offset; empty: none is moved
};

}  // namespace selvedge
