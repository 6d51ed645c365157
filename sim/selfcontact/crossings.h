#pragma once
// Crossings: edges that pierce triangles. The signs of volumes are computed in double precision from float positions.
// An edge that meets the border of a triangle crosses it; an edge that lies in the plane of a triangle, to the rounding
// of the positions, does not.
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/core/math.h"
#include "sim/selfcontact/pair_search.h"
#include "sim/selfcontact/surface.h"

namespace selvedge::sim {

// Where an edge pierces a triangle.
struct Crossing {
    std::uint32_t edge = 0;  // indices into ContactSurface
    std::uint32_t triangle = 0;
    float along = 0;                 // 0..1, from the edge's first end
    std::array<float, 3> corners{};  // barycentric coordinates in the triangle
};

// The ends of the edge, then the corners of the triangle.
std::array<std::uint32_t, 5> vertices_of(const Crossing& crossing, const ContactSurface& surface);

// points: by vertex, four floats each. The edge and the triangle must not share a vertex.
std::optional<Crossing> find_crossing(const ContactSurface& surface, const float* points, std::uint32_t edge,
                                      std::uint32_t triangle);

// All crossings of these pairs of triangles of a search, in their order. Edges that share a (sewn) vertex with a
// triangle do not cross it.
std::vector<Crossing> find_crossings(const ContactSurface& surface, const PairSearch& search,
                                     std::span<const TrianglePair> pairs, const float* points);

// The pairs of triangles that cross each other, and share no vertex, in a fixed order: an exact test of all pairs.
// (Ericson, Real-Time Collision Detection, 5.2.10: edges of each against the other; sweep and prune along x)
std::vector<TrianglePair> find_crossing_triangles(const ContactSurface& surface, const float* points);

// The total length of the segments in which such pairs cut each other, m.
double contour_length(const ContactSurface& surface, const float* points, std::span<const TrianglePair> pairs);

}  // namespace selvedge::sim
