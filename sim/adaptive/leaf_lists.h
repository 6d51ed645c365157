#pragma once
// Flat lists of the leaf elements: all that the inner loops of simulation and drawing read.  (SPEC 1.4, table 3.6)
// They are kept, not gathered: what changes is put in place of what went, and the last fill what stays empty. Their
// order depends on the history of the mesh, and is the same for the same history.
#include <array>
#include <cstdint>
#include <vector>

#include "sim/core/ids.h"
#include "sim/core/vec.h"

namespace selvedge {

struct LeafEdge {
    VertexId a, b;
    float rest_length = 0.0F;  // m
    EdgeId edge;

    bool operator==(const LeafEdge&) const = default;
};

struct LeafTriangle {
    std::array<VertexId, 3> v;
    std::array<Vec2f, 3> u{Vec2f::Zero(), Vec2f::Zero(), Vec2f::Zero()};  // m, own panel's coordinates
    TriangleId triangle;
    std::uint16_t panel = 0;
    std::uint8_t level = 0;

    bool operator==(const LeafTriangle&) const = default;
};

// Two leaf triangles about the edge ab, unfolded into one plane: the origin is the middle of ab, x runs from a to b,
// the left triangle has y > 0. At a seam each triangle comes in its own panel's coordinates, turned and moved so
// that the mid-points coincide.  (SPEC 3.2, fig. 4.6)
struct Hinge {
    VertexId a, b, left, right;
    float rest_length = 0.0F;        // of ab, m; a = (-rest_length/2, 0), b = (rest_length/2, 0)
    Vec2f left_at = Vec2f::Zero();   // m
    Vec2f right_at = Vec2f::Zero();  // m
    std::array<Vec2f, 2> along{Vec2f::Zero(), Vec2f::Zero()};  // unit vector a to b in the left, the right panel
    EdgeId edge;

    bool operator==(const Hinge&) const = default;
};

// Edges that have a hinge come first: hinges[i] belongs to edges[i]. The rest are boundary edges.
struct LeafLists {
    std::vector<VertexId> vertices;
    std::vector<LeafEdge> edges;
    std::vector<LeafTriangle> triangles;
    std::vector<Hinge> hinges;
    std::vector<float> vertex_areas;  // m^2, by vertex id, sized to the capacity: a third of the adjacent triangles'

    bool operator==(const LeafLists&) const = default;
};

// What the lists lost and gained. An id that went and came again stands in both: it may be another element, or have
// other content. A leaf edge that came or went with triangles at both sides came or went with its hinge; the hinges of
// edges that stayed, but whose triangles did not, are changed. refined_changed: triangles that became refined, or no
// longer are, at any level, or did both; they may be gone since.
struct LeafChanges {
    std::vector<VertexId> vertices_gone, vertices_come;
    std::vector<EdgeId> edges_gone, edges_come;
    std::vector<TriangleId> triangles_gone, triangles_come, refined_changed;
    std::vector<EdgeId> hinges_changed;

    void clear();
};

// m^2
inline float material_area(const std::array<Vec2f, 3>& u) {
    const Vec2f a = u[1] - u[0], b = u[2] - u[0];
    return 0.5F * (a.x() * b.y() - a.y() * b.x());
}

}  // namespace selvedge
