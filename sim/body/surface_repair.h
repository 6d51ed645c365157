#pragma once
// Makes one closed, outward surface of the triangles that a file holds, as far as that can be done without guessing:
// welds, drops triangles without area, turns pieces outward, caps small holes. What it does it counts.
#include <array>
#include <string>
#include <vector>

#include "sim/core/vec.h"

namespace selvedge {

struct Surface {
    std::vector<Vec3d> x;  // m
    std::vector<std::array<int, 3>> triangles;
    std::vector<int> origin;  // per vertex: its index before welding; of a cap's middle: its rim's
};

struct RepairOptions {
    double weld_distance = 1e-6;  // m, vertices no farther apart become one
    double largest_hole = 0.6;    // m round: a neck or an eye is capped, a missing half is not
};

struct RepairReport {
    int welded_vertices = 0;
    int dropped_triangles = 0;  // without area, or twice there
    int turned_triangles = 0;
    int capped_holes = 0;
    int pieces = 0;                           // connected pieces that were kept
    std::vector<std::string> dropped_pieces;  // why, for each
};

// Pieces that cannot be closed, or that lie wholly inside the largest, are dropped; the largest must be sound.
// Throws InputError with `file` when it is not. Deterministic.
Surface repair(Surface surface, const std::string& file, const RepairOptions& options, RepairReport& report);

}  // namespace selvedge
