#pragma once
// The elements of the edge-based adaptive mesh, as they stand in its pools.  (thesis 3.2, Edge-Trio; SPEC 1.1)
#include <array>
#include <cstdint>

#include "sim/adaptive/configuration.h"
#include "sim/core/ids.h"
#include "sim/core/vec.h"

namespace selvedge {

// Its leaf triangles are found by going round it from edge to edge: AdaptiveMesh::triangles_at().
struct AdaptiveVertex {
    EdgeId parent;           // whose centre it is; none in the base mesh
    std::uint8_t level = 0;  // of the edges that it was born with; 0 in the base mesh

    bool operator==(const AdaptiveVertex&) const = default;
};

//      A --------- C --------- B        Split: children AC and CB, in this order, each in the direction of its parent.
struct AdaptiveEdge {
    std::array<VertexId, 2> ends;
    VertexId centre;  // none: unsplit
    std::array<EdgeId, 2> children;
    std::array<TriangleId, 2> sides;  // at the edge's own level; [0] runs A to B anticlockwise. None: boundary
    float rest_length = 0.0F;         // m
    std::uint8_t level = 0;
    bool rejoining = false;  // counts as unsplit; its children go when the pass is over

    // An unsplit edge. Field by field: an edge made elsewhere and copied here would wait for its own stores.
    void set(const std::array<VertexId, 2>& new_ends, const std::array<TriangleId, 2>& new_sides, float length,
             std::uint8_t new_level) {
        ends = new_ends;
        centre = {};
        children = {};
        sides = new_sides;
        rest_length = length;
        level = new_level;
        rejoining = false;
    }

    bool operator==(const AdaptiveEdge&) const = default;
};

struct AdaptiveTriangle {
    std::array<VertexId, 3> vertices;  // anticlockwise seen from the fabric's right side
    std::array<EdgeId, 3> edges;       // edges[k] joins vertices[k] and vertices[k+1]
    std::array<Vec2f, 3> u{Vec2f::Zero(), Vec2f::Zero(), Vec2f::Zero()};  // material coordinates per corner, m
    std::array<TriangleId, 4> internal_triangles;                         // by the configuration's layout
    std::array<EdgeId, 3> internal_edges;
    std::uint16_t panel = 0;
    std::uint8_t level = 0;
    Configuration configuration : 4 = Configuration::C0;
    bool regular : 1 = true;  // a base triangle or a child of C10: the only ones that may be refined
    bool marked : 1 = false;  // waits for its transition

    bool operator==(const AdaptiveTriangle&) const = default;
};

constexpr bool is_leaf(const AdaptiveTriangle& t) {
    return t.configuration == Configuration::C0;
}

// Which corner of t stands on v. Pre: one does.
inline std::size_t corner_at(const AdaptiveTriangle& t, VertexId v) {
    return t.vertices[0] == v ? 0 : (t.vertices[1] == v ? 1 : 2);
}

// Which external edge of t is e. Pre: one is.
inline std::size_t place_of(const AdaptiveTriangle& t, EdgeId e) {
    return t.edges[0] == e ? 0 : (t.edges[1] == e ? 1 : 2);
}

}  // namespace selvedge
