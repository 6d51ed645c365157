#pragma once
// Meshes, observers and criteria shared by the tests of the adaptive mesh.
#include <random>
#include <set>
#include <vector>

#include "sim/adaptive/adapt.h"
#include "sim/mesh/garment_mesh.h"

namespace selvedge::sim::test {

GarmentMesh one_triangle();
inline constexpr TriangleId kOwner{0};  // its triangle, on level 0
// Two triangles that share the edge from vertex 1 to vertex 2.
GarmentMesh two_triangles();
// Two triangles that share one vertex and no edge.
GarmentMesh bow_tie();
GarmentMesh octahedron();
// One panel of columns x rows quads, each 0.1 m square, sewn to itself: u jumps by the panel's width at the seam.
GarmentMesh tube(int columns, int rows);
// Front (panel 0) and back (panel 1), each two quads wide, sewn along both sides: vertices 0-4-8.. and 2-6-10.. . The
// front's rows are 0.2 m high, the back's back_ratio times as high.
GarmentMesh front_and_back(int rows, double back_ratio);

// The edge between two vertices, split or not. Pre: there is one.
EdgeId edge_between(const AdaptiveMesh& mesh, VertexId a, VertexId b);

// An observer that stores positions by vertex id. Fails the test on an impossible split or rejoin.
struct PositionState {
    std::vector<Vec3f> x;
    std::vector<bool> is_used;

    PositionState(const GarmentMesh& base, const AdaptiveMesh& mesh);
    void on_capacity(std::size_t n);
    void on_split(VertexId centre, VertexId a, VertexId b);
    void on_rejoin(VertexId centre);
    bool operator==(const PositionState&) const = default;
};

// Random decisions; the same seed gives the same sequence.
struct RandomCriterion {
    std::mt19937& random;
    double split_share = 0.5;
    double rejoin_share = 0.5;

    bool wants_split(const AdaptiveMesh&, EdgeId) const { return draw() < split_share; }
    bool allows_rejoin(const AdaptiveMesh&, EdgeId) const { return draw() < rejoin_share; }
    double draw() const { return static_cast<double>(random()) / 4294967296.0; }
};

// Requests splits of exactly these edges.
struct ChosenEdges {
    std::set<EdgeId> chosen;

    bool wants_split(const AdaptiveMesh&, EdgeId e) const { return chosen.contains(e); }
    bool allows_rejoin(const AdaptiveMesh&, EdgeId e) const { return !chosen.contains(e); }
};

// The complete contents of a mesh, for bitwise comparison. Leaf lists are sorted by id, because their order depends on
// the history of the mesh.
struct Snapshot {
    std::vector<AdaptiveVertex> vertices;
    std::vector<AdaptiveEdge> edges;
    std::vector<AdaptiveTriangle> triangles;
    LeafLists leaves;

    explicit Snapshot(const AdaptiveMesh& mesh);
    // The elements with ids below the counts of `base`, with the leaf lists; vertex areas are cut likewise.
    Snapshot cut_to(const AdaptiveMesh& base) const;
    bool operator==(const Snapshot&) const = default;
};

}  // namespace selvedge::sim::test
