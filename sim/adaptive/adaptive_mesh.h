#pragma once
// The edge-based adaptive mesh: a hierarchy of edges and triangles over a sewn base mesh, changed one edge at a time.
// It knows topology, levels and material coordinates; positions and all other state live beside it, in flat arrays
// indexed by vertex id.  (thesis ch. 3; SPEC 1.1-1.2)  What asks for changes is adapt(), sim/adaptive/adapt.h.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "sim/adaptive/configuration.h"
#include "sim/adaptive/diagonal.h"
#include "sim/adaptive/leaf_tracker.h"
#include "sim/core/math.h"
#include "sim/core/pool.h"
#include "sim/mesh/garment_mesh.h"

namespace selvedge::sim {

// The elements of the edge-based adaptive mesh, as they stand in its pools.  (thesis 3.2, Edge-Trio; SPEC 1.1)

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

inline constexpr int kDeepestLevel = 15;

struct AdaptiveMeshOptions {
    int max_level = 3;        // edges are split down to it; 0..kDeepestLevel
    float seam_ease = 0.05F;  // a seam's sides that differ by no more share their mean length, else the shorter rules
};

// Sees transitions, and does nothing.
struct NoWatch {
    void before(TriangleId) {}
    void after(TriangleId) {}
};

// How often each transition was made, by (from, to).
struct TransitionCounts {
    std::array<std::array<std::uint64_t, kConfigurations>, kConfigurations> by_configuration{};

    std::uint64_t between_states(std::size_t from, std::size_t to) const;  // S0..S7
};

class AdaptiveMesh {
 public:
    // Base vertices and triangles keep their indices as ids. Pre: base is sewn (no links).
    // Throws InputError where an edge has more than two triangles, or two that face opposite ways.
    explicit AdaptiveMesh(const GarmentMesh& base, const AdaptiveMeshOptions& options = {});

    int max_level() const { return options_.max_level; }
    std::size_t base_vertex_count() const { return base_vertices_; }
    std::size_t base_edge_count() const { return base_edges_; }
    std::size_t base_triangle_count() const { return base_triangles_; }

    // Elements, leaves and all. Pre (for the elements): the id is alive.
    const Pool<AdaptiveVertex, VertexId>& vertices() const { return vertices_; }
    const Pool<AdaptiveEdge, EdgeId>& edges() const { return edges_; }
    const Pool<AdaptiveTriangle, TriangleId>& triangles() const { return triangles_; }
    const AdaptiveVertex& vertex(VertexId v) const { return vertices_[v]; }
    const AdaptiveEdge& edge(EdgeId e) const { return edges_[e]; }
    const AdaptiveTriangle& triangle(TriangleId t) const { return triangles_[t]; }

    VertexId end(EdgeId e, int which) const { return edges_[e].ends[static_cast<std::size_t>(which)]; }
    VertexId centre(EdgeId e) const { return edges_[e].centre; }
    bool is_split(EdgeId e) const { return edges_[e].centre && !edges_[e].rejoining; }
    int level(EdgeId e) const { return edges_[e].level; }
    float rest_length(EdgeId e) const { return edges_[e].rest_length; }

    // State arrays are sized to it; it grows only by whole blocks, and no id ever moves.
    std::size_t vertex_capacity() const { return vertices_.capacity(); }

    // The leaf triangle on one side of an unsplit edge; none at a boundary. It may be one level deeper than the edge.
    TriangleId leaf_at(EdgeId e, int side) const;

    // for (TriangleId t : mesh.triangles_at(v)): the leaf triangles round a vertex, anticlockwise from edge to edge;
    // at a boundary from one end to the other. No list is kept for it: it goes by the sides of the edges.
    class TrianglesAt;
    TrianglesAt triangles_at(VertexId v) const;

    // Leaf lists, as refresh_lists() left them.
    std::span<const VertexId> leaf_vertices() const { return leaves().vertices; }
    std::span<const LeafEdge> leaf_edges() const { return leaves().edges; }
    std::span<const LeafTriangle> leaf_triangles() const { return leaves().triangles; }
    std::span<const Hinge> hinges() const { return leaves().hinges; }
    std::span<const float> vertex_areas() const { return leaves().vertex_areas; }  // m^2, by vertex id
    const Hinge* hinge(EdgeId e) const { return tracker_.hinge(e); }               // of a leaf edge; none at a boundary
    const LeafLists& leaves() const { return tracker_.lists(); }

    // What the last refresh_lists(), and so the last adaptation, did to them.
    const LeafChanges& changes() const { return tracker_.changes(); }

    // The elements of one level, 0..max_level, as the last retriangulate() left them. At the deepest level, where no
    // edge may split, none are listed.
    std::span<const EdgeId> unsplit_edges(int level) const { return levels_.unsplit(level); }
    std::span<const EdgeId> split_edges(int level) const { return levels_.split(level); }
    std::span<const TriangleId> refined_triangles(int level) const { return levels_.refined(level); }

    // Memory per element, alive or free, with its places in the lists; not the lists themselves.
    struct BytesPerElement {
        std::size_t vertex, edge, triangle;
    };
    static constexpr BytesPerElement bytes_per_element();

    // Permissions.  (SPEC 1.2, fig. 3.11)
    bool may_split(EdgeId e) const;
    bool may_rejoin(EdgeId e) const;
    bool has_leaf_children(EdgeId e) const;  // pre: e is split; the first thing that a rejoin needs

    // Changes. Splitting or rejoining marks the triangles on both sides; retriangulate() lets each marked triangle
    // make one transition, however many of its edges changed, and returns how many did. A pass changes the edges of
    // one level only. Pre: permitted. split() returns the centre; rejoin() frees it when the pass is over.
    VertexId split(EdgeId e);
    void rejoin(EdgeId e);
    int retriangulate(int level, TransitionCounts* counts = nullptr);

    // The same, with another choice where two configurations conform: see sim/adaptive/diagonal.h. `watch` is told of
    // each transition before and after: watch.before(t), watch.after(t).
    template <class Choice, class Watch>
    int retriangulate(int level, TransitionCounts* counts, const Choice& choice, Watch& watch);

    // Brings the leaf lists up to date with what has changed since the last time, in place, and tells what it did.
    void refresh_lists() { tracker_.refresh(*this); }

    // One transition by itself, to test and to measure. Conformity is the caller's care.
    // Pre: t is regular, the edges that `to` has split are split, no internal element is refined.
    void change_configuration(TriangleId id, Configuration to);

 private:
    struct Change;  // the transitions, one function each

    void add_base_edges(const GarmentMesh& base);
    void add_base_fans();
    void list_base();
    void grow_lists();
    void grow_lists_with_pools() {
        if (vertices_.capacity() + edges_.capacity() + triangles_.capacity() != listed_capacity_) grow_lists();
    }

    SplitMask split_mask(const AdaptiveTriangle& t) const;
    bool has_leaf_children(TriangleId t) const;
    void mark_sides(EdgeId e);
    void list_split();
    void release_rejoined();
    template <class Choose, class Watch>
    int retriangulate_marked(int level, TransitionCounts* counts, const Choose& choose, Watch& watch);
    template <class Choice>
    Configuration chosen(const AdaptiveTriangle& t, SplitMask split, const Choice& choice) const;
    Diagonal diagonal(const AdaptiveTriangle& t, const InternalEdge& drawn) const;

    // Going round a vertex: the first leaf triangle of each of its fans, and the one after.
    TriangleId first_at(VertexId v, std::size_t fan) const;
    TriangleId next_at(VertexId v, TriangleId t) const;
    TriangleId first_inside(TriangleId owner, VertexId v) const;

    AdaptiveMeshOptions options_;
    std::size_t base_vertices_ = 0;
    std::size_t base_edges_ = 0;
    std::size_t base_triangles_ = 0;
    Pool<AdaptiveVertex, VertexId> vertices_;
    Pool<AdaptiveEdge, EdgeId> edges_;
    Pool<AdaptiveTriangle, TriangleId> triangles_;
    // The base triangle that each fan of a base vertex starts with: one fan as a rule, several where sheets touch in a
    // vertex alone. By vertex, those of v from fan_starts_[v] to fan_starts_[v + 1].
    std::vector<TriangleId> fans_;
    std::vector<std::uint32_t> fan_starts_;
    std::vector<TriangleId> marked_;
    std::vector<EdgeId> splitting_;
    std::vector<EdgeId> rejoining_;
    LevelLists levels_;
    LeafTracker tracker_;
    std::size_t listed_capacity_ = 0;  // of all pools, when the lists were last sized to them
};

constexpr AdaptiveMesh::BytesPerElement AdaptiveMesh::bytes_per_element() {
    return {decltype(vertices_)::kBytesPerElement + LeafTracker::kBytesPerId + LeafTracker::kBytesPerArea,
            decltype(edges_)::kBytesPerElement + LeafTracker::kBytesPerId + LevelLists::kBytesPerId,
            decltype(triangles_)::kBytesPerElement + LeafTracker::kBytesPerId + LevelLists::kBytesPerId};
}

// What each marked triangle is to become is asked of choose(triangle, split mask).
template <class Choose, class Watch>
int AdaptiveMesh::retriangulate_marked(int level, TransitionCounts* counts, const Choose& choose, Watch& watch) {
    list_split();
    // Coarsening undoes a refinement last to first, so that ids come back in the order in which they were taken.
    if (!rejoining_.empty()) std::reverse(marked_.begin(), marked_.end());
    int transitions = 0;
    for (const TriangleId id : marked_) {
        AdaptiveTriangle& t = triangles_[id];
        SELVEDGE_ASSERT(t.level == level);
        t.marked = false;
        const Configuration from = t.configuration, to = choose(t, split_mask(t));
        if (from == to) continue;
        watch.before(id);
        change_configuration(id, to);
        watch.after(id);
        if (counts != nullptr) ++counts->by_configuration[index_of(from)][index_of(to)];
        ++transitions;
    }
    marked_.clear();
    release_rejoined();
    return transitions;
}

template <class Choice, class Watch>
int AdaptiveMesh::retriangulate(int level, TransitionCounts* counts, const Choice& choice, Watch& watch) {
    const auto choose = [&](const AdaptiveTriangle& t, SplitMask split) {
        if constexpr (std::is_same_v<Choice, MinimalChange>) {
            return least_work(t.configuration, split);
        } else {
            return chosen(t, split, choice);
        }
    };
    return retriangulate_marked(level, counts, choose, watch);
}

template <class Choice>
Configuration AdaptiveMesh::chosen(const AdaptiveTriangle& t, SplitMask split, const Choice& choice) const {
    const Configuration least = least_work(t.configuration, split);
    if (least == t.configuration || !is_ambiguous(split)) return least;
    const AmbiguousSplit ways = either_way(split);
    const float first = choice.cost(diagonal(t, ways.diagonals[0]));
    const float second = choice.cost(diagonal(t, ways.diagonals[1]));
    if (first == second) return least;
    return ways.configurations[first < second ? 0 : 1];
}

class AdaptiveMesh::TrianglesAt {
 public:
    class Iterator {
     public:
        Iterator(const AdaptiveMesh& mesh, VertexId v, TriangleId t) : mesh_(&mesh), vertex_(v), first_(t), at_(t) {}
        TriangleId operator*() const { return at_; }
        Iterator& operator++() {
            at_ = mesh_->next_at(vertex_, at_);
            if (!at_ || at_ == first_) at_ = first_ = mesh_->first_at(vertex_, ++fan_);
            return *this;
        }
        bool operator!=(const Iterator& other) const { return at_ != other.at_; }

     private:
        const AdaptiveMesh* mesh_;
        VertexId vertex_;
        TriangleId first_;
        TriangleId at_;
        std::size_t fan_ = 0;
    };

    TrianglesAt(const AdaptiveMesh& mesh, VertexId v) : mesh_(mesh), vertex_(v) {}
    Iterator begin() const { return {mesh_, vertex_, mesh_.first_at(vertex_, 0)}; }
    Iterator end() const { return {mesh_, vertex_, TriangleId{}}; }

 private:
    const AdaptiveMesh& mesh_;
    VertexId vertex_;
};

inline AdaptiveMesh::TrianglesAt AdaptiveMesh::triangles_at(VertexId v) const {
    return {*this, v};
}

}  // namespace selvedge::sim
