#pragma once
// Flat lists of the leaf elements: all that the inner loops of simulation and drawing read.  (SPEC 1.4, table 3.6)
// Their order depends on the topology alone: level by level, children in their parents' order.
#include <array>
#include <cstdint>
#include <vector>

#include "sim/core/ids.h"
#include "sim/core/vec.h"

namespace selvedge {

class AdaptiveMesh;

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

struct LeafLists {
    std::vector<VertexId> vertices;
    std::vector<LeafEdge> edges;
    std::vector<LeafTriangle> triangles;
    std::vector<Hinge> hinges;
    std::vector<float> vertex_areas;  // m^2, by vertex id, sized to the capacity: a third of the adjacent triangles'

    bool operator==(const LeafLists&) const = default;
};

// Fills the lists anew, in the capacity that they have.
void gather_leaves(const AdaptiveMesh& mesh, LeafLists& lists);

float material_area(const std::array<Vec2f, 3>& u);  // m^2

}  // namespace selvedge
