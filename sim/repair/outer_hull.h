#pragma once
// One closed surface round a body of several closed pieces, as games build them: a shell of armour, balls at the
// joints, a head that sits on a trunk. Cloth must not meet the walls of pieces that lie inside others, and what follows
// limbs along the surface must find them joined. What the pieces wind round at least once is inside, as are the hollows
// that they enclose (Jacobson, Kavan and Sorkine-Hornung 2013, Robust inside-outside segmentation using generalized
// winding numbers; of closed pieces the number is whole, and lines through them count it).
//
//      pieces             lines of a grid            the hull
//     .--.  .---.         |  |  |  |  |             .--------.
//     |  |==|   |    ->  -+--+--+--+--+-     ->     |        |
//     '--'  '---'         |  |  |  |  |             '--------'
#include "sim/repair/surface_repair.h"

namespace selvedge::sim {

// Whether pieces beside the largest one make up a part of the surface that counts: a hand of a person has 2.3 % of the
// skin (Amirsheybani et al. 2001: palm and fingers together 0.8 %, hand about 2 %), both eyes have 0.3 %.
bool is_of_parts(const Surface& pieces);

struct OuterHullOptions {
    double cell = 0.008;            // m, of the grid
    double widest_gap = 0.05;       // m, over which parts that are apart are joined, the nearest ones first
    double highest_groove = 0.035;  // m, between what is above and below it, that is filled
};

// The surface's vertices are means of the places where lines of a grid pass through the pieces (Gibson 1998,
// Constrained elastic surface nets), so that a limb of radius R is thinner by less than cell^2 / (2 R). What is thinner
// than a cell may be lost, and what is nearer to another part than a cell may be joined to it. `origin` is that of the
// corner nearest to a vertex, of a triangle there. Post: closed, each piece manifold, facing outward. Deterministic.
// Pre: each piece is closed and faces outward; cell > 0, and small enough that the surface has an inside.
Surface outer_hull(const Surface& pieces, const OuterHullOptions& options = {});

// The weights of its vertices, from those of the pieces by `origin`, evened out along the surface: stiff pieces turn
// past each other at a joint, while one surface round them would fold over there.
std::vector<SkinWeights> hull_skin(const Surface& hull, const std::vector<SkinWeights>& of_pieces);

}  // namespace selvedge::sim
