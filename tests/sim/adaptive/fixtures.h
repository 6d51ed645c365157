#pragma once
// Meshes, observers and criteria that the tests of the adaptive mesh share.
#include <random>
#include <set>
#include <vector>

#include "sim/adaptive/adapt.h"
#include "sim/mesh/garment_mesh.h"

namespace selvedge::sim::test {

GarmentMesh one_triangle();
// Two triangles that share the edge from vertex 1 to vertex 2.
GarmentMesh two_triangles();
// Two triangles that share one vertex and no edge.
GarmentMesh bow_tie();
GarmentMesh octahedron();
// One panel of columns x rows quads, each 0.1 m square, sewn to itself: u jumps by the panel's width at the seam.
GarmentMesh tube(int columns, int rows);
// Front and back, two quads wide each and sewn along both sides, 0-4-8.. and 2-6-10..; the front's rows are 0.2 m high,
// the back's by this ratio higher. Panel 1 is the back.
GarmentMesh front_and_back(int rows, double back_ratio);

// The id of the unsplit or split edge between two vertices. Pre: there is one.
EdgeId edge_between(const AdaptiveMesh& mesh, VertexId a, VertexId b);

// Positions by vertex id; fails the test when it is told of a split or rejoin that cannot be.
struct PositionState {
    std::vector<Vec3f> x;
    std::vector<bool> is_used;

    PositionState(const GarmentMesh& base, const AdaptiveMesh& mesh);
    void on_capacity(std::size_t n);
    void on_split(VertexId centre, VertexId a, VertexId b);
    void on_rejoin(VertexId centre);
    bool operator==(const PositionState&) const = default;
};

// Asks at random, the same for the same seed.
struct RandomCriterion {
    std::mt19937& random;
    double split_share = 0.5;
    double rejoin_share = 0.5;

    bool wants_split(const AdaptiveMesh&, EdgeId) const { return draw() < split_share; }
    bool allows_rejoin(const AdaptiveMesh&, EdgeId) const { return draw() < rejoin_share; }
    double draw() const { return static_cast<double>(random()) / 4294967296.0; }
};

// Wants exactly these edges split.
struct ChosenEdges {
    std::set<EdgeId> chosen;

    bool wants_split(const AdaptiveMesh&, EdgeId e) const { return chosen.contains(e); }
    bool allows_rejoin(const AdaptiveMesh&, EdgeId e) const { return !chosen.contains(e); }
};

// All that a mesh holds, to compare bit by bit; its leaf lists sorted by id, for their order is history.
struct Snapshot {
    std::vector<AdaptiveVertex> vertices;
    std::vector<AdaptiveEdge> edges;
    std::vector<AdaptiveTriangle> triangles;
    LeafLists leaves;

    explicit Snapshot(const AdaptiveMesh& mesh);
    // The part below these counts, with the leaf lists; vertex areas are sized to the capacity and are cut too.
    Snapshot cut_to(const AdaptiveMesh& base) const;
    bool operator==(const Snapshot&) const = default;
};

}  // namespace selvedge::sim::test
