#pragma once
// The connected pieces of a triangle soup: who borders whom, which way round, where the holes are.
#include <array>
#include <string>
#include <vector>

#include "sim/core/vec.h"

namespace selvedge {

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

}  // namespace selvedge
