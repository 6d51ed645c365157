#pragma once
// Turns the triangles of an imported file into closed surfaces with outward orientation: welds vertices on open edges,
// drops degenerate and duplicate triangles, cuts where too many triangles meet, orients pieces, caps small holes.
// RepairReport counts each change. Also here: the parts that it uses (connected pieces, vertex welding).
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/core/math.h"
#include "sim/repair/crowded_edges.h"

namespace selvedge::sim {

struct Surface {
    std::vector<Vec3d> x;  // m
    std::vector<std::array<int, 3>> triangles;
    std::vector<int> origin;  // per vertex: its index before welding; for a cap's centre, that of one rim vertex
};

struct RepairOptions {
    double weld_distance = 1e-6;  // m, vertices on open edges at most this far apart are merged
    double largest_hole =
        0.6;  // m round, as a tape goes: an open neck or eye is capped, a missing half of the body is not
    std::optional<Vec3d> main_at = {};     // m, of a vertex of the piece that is the body; none: the largest piece is
    std::optional<double> head_from = {};  // m, height above which a round hole is a crown that a scan did not see
};

struct RepairReport {
    int welded_vertices = 0;
    int dropped_triangles = 0;  // degenerate after welding, or duplicates
    EdgeCuts cuts;
    int turned_triangles = 0;
    int capped_holes = 0;
    int capped_crowns = 0;                    // of them, closed with a dome
    int pieces = 0;                           // connected pieces that remain
    std::vector<std::string> dropped_pieces;  // one description with the reason per piece
};

// Drops pieces that cannot be closed and pieces that lie wholly inside the largest piece. Throws InputError with `file`
// when the largest piece cannot be closed or when no triangle is left. Deterministic.
Surface repair(Surface surface, const std::string& file, const RepairOptions& options, RepairReport& report);

// Its first half: welds vertices on open edges that are at most `distance` apart (in the unit of the surface), drops
// degenerate and duplicate triangles, and cuts where too many meet. Fills in `origin`.
void weld_surface(Surface& surface, double distance, RepairReport& report);

// Connected pieces of a triangle soup: adjacency, orientation and holes.

using Triangles = std::vector<std::array<int, 3>>;

struct SurfacePiece {
    std::vector<int> triangles;           // triangle indices, ascending
    std::string flaw;                     // why the piece cannot be part of a closed surface; empty when it can
    std::vector<std::vector<int>> holes;  // vertices in order around each hole, directed as the surface's own edges
};

// Flips triangles in place so that neighbours within each piece have consistent orientation; it may still be inward.
// Pieces are ordered by their first triangle. Pre: the three corners of each triangle are different vertices; at most
// two triangles meet at any edge.
std::vector<SurfacePiece> find_pieces(Triangles& triangles);

// Six times the signed volume under the piece's triangles, m^3: positive for a closed piece with outward orientation.
double signed_volume6(const std::vector<Vec3d>& x, const Triangles& triangles, const SurfacePiece& piece);

double area(const std::vector<Vec3d>& x, const Triangles& triangles, const SurfacePiece& piece);

// Vertex welding.

// Maps each point to its representative: the first representative at most `distance` (m) away, or the point itself when
// there is none. Pre: distance > 0.
std::vector<int> weld(const std::vector<Vec3d>& x, double distance);

}  // namespace selvedge::sim
