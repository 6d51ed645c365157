#pragma once
// Makes one closed, outward surface of the triangles that a file holds, as far as that can be done without guessing:
// welds, drops triangles without area, turns pieces outward, caps small holes. What it does it counts.
#include <array>
#include <string>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

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

// The connected pieces of a triangle soup: who borders whom, which way round, where the holes are.

using Triangles = std::vector<std::array<int, 3>>;

struct SurfacePiece {
    std::vector<int> triangles;           // indices, ascending
    std::string flaw;                     // why it can be no part of a closed surface; empty when sound
    std::vector<std::vector<int>> holes;  // vertices in order round each, as the surface's own edges run
};

// Turns triangles (in place) so that neighbours agree within each piece; which side is out is left open.
// Pieces come in the order of their first triangles. Pre: the corners of a triangle are three different vertices.
std::vector<SurfacePiece> find_pieces(Triangles& triangles);

// Six times the signed volume under the piece's triangles, m^3: positive when it is closed and turned outward.
double signed_volume6(const std::vector<Vec3d>& x, const Triangles& triangles, const SurfacePiece& piece);

double area(const std::vector<Vec3d>& x, const Triangles& triangles, const SurfacePiece& piece);

// Which points are the same point.

// For each point the first one no farther than `distance` (m) from it that stands for itself. Pre: distance > 0.
std::vector<int> weld(const std::vector<Vec3d>& x, double distance);

}  // namespace selvedge::sim
