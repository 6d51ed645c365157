#pragma once
// The thesis' other design of an edge: an Edge-Pair of two adaptive half-edges, one per adjacent triangle, each with
// its own copy of what they share. PointerMesh has the Edge-Trio: one edge with two side records.  (thesis 3.2.4,
// fig. 3.3, listings 3.1 and 3.2)
#include <array>
#include <vector>

#include "bench/thesis/pointer_mesh.h"

namespace selvedge::bench {

struct PairTriangle;
using PairVertex = VertexOf<PairTriangle>;

//      start --------- centre --------- twin's start       children[0] starts at start, children[1] at the centre
struct HalfEdge {
    PairVertex* start = nullptr;
    PairVertex* centre = nullptr;  // the same in both halves of a pair
    HalfEdge* twin = nullptr;      // none at a boundary
    std::array<HalfEdge*, 2> children{};
    PairTriangle* triangle = nullptr;
    float rest_length = 0;  // m, the same in both
    int level = 0;
};

struct PairTriangle {
    std::array<PairVertex*, 3> vertices{};
    std::array<HalfEdge*, 3> edges{};  // edges[k] starts at vertices[k]
    std::array<PairTriangle*, 4> internal_triangles{};
    std::array<HalfEdge*, 6> internal_edges{};  // three pairs
    std::array<Vec2f, 3> u{Vec2f::Zero(), Vec2f::Zero(), Vec2f::Zero()};
    int level = 0;
};

// Refines and coarsens uniformly, as PointerMesh does, with elements from pools.
class EdgePairMesh {
 public:
    explicit EdgePairMesh(const sim::GarmentMesh& base);
    ~EdgePairMesh();
    EdgePairMesh(const EdgePairMesh&) = delete;
    EdgePairMesh& operator=(const EdgePairMesh&) = delete;

    int level() const { return static_cast<int>(levels_.size()) - 1; }
    void refine();
    void coarsen();  // pre: level() > 0

    // Of the whole hierarchy. A pair is one edge.
    std::size_t vertex_count() const { return vertex_count_; }
    std::size_t edge_count() const;
    std::size_t half_edge_count() const;
    std::size_t triangle_count() const;

    const std::vector<HalfEdge*>& finest_edges() const { return levels_.back().edges; }

 private:
    struct Level {
        std::vector<HalfEdge*> edges;
        std::vector<PairTriangle*> triangles;
    };
    HalfEdge* make_half(PairVertex* start, float rest_length, int level, Level& finer);
    void split(HalfEdge* half, Level& finer);
    void fill(PairTriangle* parent, Level& finer);
    void clear(PairTriangle* parent);

    PoolsOf<PairVertex, HalfEdge, PairTriangle> store_;
    std::vector<PairVertex*> base_vertices_;
    std::vector<Level> levels_;
    std::size_t vertex_count_ = 0;
};

}  // namespace selvedge::bench
