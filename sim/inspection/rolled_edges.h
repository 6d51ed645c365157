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
#include "sim/place/limbs.h"
#include "sim/place/openings.h"

namespace selvedge::sim {

struct RolledEdge {
    double share = 0;        // of the edge's vertices
    double by = 0;           // m, most of them
    std::size_t vertex = 0;  // of the mesh, that is rolled by most
};

// How far inward each point lies, m from a place that is the same for all: its height for a hem; for a cuff, along the
// line of the arm, less the way from the shoulder. arm: null for a hem.
std::vector<double> inward_of(std::span<const Vec3d> x, const Limb* arm);

// placed, draped: inward_of() each vertex. Only what was placed clearly inward of a part of the edge can lie beyond it,
// so an edge that slopes, or that was placed flat, is not taken for a rolled one. Pre: the mesh is sewn.
RolledEdge measure_rolled_edge(const GarmentMesh& sewn, const Opening& edge, std::span<const double> placed,
                               std::span<const double> draped);

}  // namespace selvedge::sim
