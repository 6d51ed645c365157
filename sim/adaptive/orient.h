#pragma once
// One orientation for a surface whose triangles are given as seen from their fabrics' right sides. It may have to be
// opposite to the right side on some pieces, because a seam can join right side to wrong side (AdaptiveEdge).
#include <cstdint>
#include <span>
#include <vector>

namespace selvedge::sim {

// An edge between two triangles. right_wrong: their right sides look to opposite sides of the surface.
struct OrientedEdge {
    std::uint32_t first = 0, second = 0;
    bool right_wrong = false;
};

struct OrientedTriangle {
    double area = 0;  // m^2
    int panel = 0;
};

// Per triangle, whether the surface's orientation is opposite to the right side. It is the same across ordinary edges
// and changes across right_wrong ones. Where a loop crosses an odd number of them (a Moebius band) it cannot change at
// every one; at those where it does not, the surface has a cut. In each connected part the smaller area is turned; if
// the areas differ by less than 0.1 %, the side without the part's lowest panel.
std::vector<bool> find_turned(std::span<const OrientedEdge> edges, std::span<const OrientedTriangle> triangles);

}  // namespace selvedge::sim
