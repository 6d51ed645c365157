#pragma once
// Hems and cuffs that are rolled up or folded over: cloth that was cut to lie within the edge now lies beyond it.
//
//        | |  placed: the cloth p          | |  draped: p hangs below its hem h,
//       p| |  lies above the hem h     h,-.| |  which is rolled up, and the skirt
//       h|_|                            (  p)  hangs as a balloon
//
#include <cstddef>
#include <span>
#include <vector>

#include "sim/mesh/garment_mesh.h"
#include "sim/place/openings.h"

namespace selvedge::sim {

struct RolledEdge {
    double share = 0;        // of the edge's vertices
    double by = 0;           // m, most of them
    std::size_t vertex = 0;  // of the mesh, that is rolled by most
};

// placed, draped: how far inward of the edge each vertex lies, m: its height for a hem, for a cuff the way along the
// arm up to the shoulder. Only what was placed clearly inward of a part of the edge can lie beyond it, so an edge that
// slopes, or that was placed flat, is not taken for a rolled one. Pre: the mesh is sewn.
RolledEdge measure_rolled_edge(const GarmentMesh& sewn, const Opening& edge, std::span<const double> placed,
                               std::span<const double> draped);

}  // namespace selvedge::sim
