#pragma once
// The edge-based adaptive mesh: a hierarchy of edges and triangles over a sewn base mesh, changed one edge at a time.
// It stores topology, levels and material coordinates. Positions and all other state are kept outside, in flat arrays
// indexed by vertex id. adapt() in sim/adaptive/adapt.h decides which edges to split and rejoin.  (thesis 3.2-3.4)
//
// Orientation. Every triangle is anticlockwise seen from its fabric's right side. A seam may join the right side of one
// panel to the wrong side of another (a lapel, see Seam::is_reversed). The triangles on both sides of such an edge have
// it in the same direction; the edge is then right_wrong. Flipping whole panels instead would not do, because a loop of
// panels with an odd number of such seams cannot be oriented (a Moebius band).
//
//          B
//        / ^ \       Side 0 of the edge AB has the corners A B C in this order, anticlockwise.
//       C 0|1 D      Side 1 has B A D. If the edge is right_wrong, it has A B D.
//        \ | /
//          A
//
// Quantities that are averaged over triangles, such as normals, need one orientation of the surface: `turned` triangles
// have theirs opposite to the fabric's right side. It changes at every right_wrong edge, except at cuts: right_wrong
// edges at which a surface that cannot be oriented has two equal sides. See sim/adaptive/surface_normals.h.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "sim/adaptive/configuration.h"
#include "sim/adaptive/leaf_tracker.h"
#include "sim/core/math.h"
#include "sim/core/pool.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/mesh/sew.h"

namespace selvedge::sim {

// Which diagonal a triangle gets when two of its edges are split and both diagonals conform. The default is the minimal
// change from the present configuration.  (thesis fig. 3.9; bench/thesis measures its alternatives)

struct Diagonal {
    VertexId a, b;
    Vec2f u_a, u_b;  // m
};

// A choice has    float cost(const Diagonal&) const;    the lower cost wins; at equal cost the minimal change
struct MinimalChange {};

// The elements of the adaptive mesh, as stored in its pools.  (thesis 3.2, Edge-Trio)

// AdaptiveMesh::triangles_at() finds the leaf triangles at a vertex by walking round it from edge to edge.
struct AdaptiveVertex {
    EdgeId parent;           // the edge whose centre it is; none in the base mesh
    std::uint8_t level = 0;  // of the child edges created with it; 0 in the base mesh
    bool on_cut = false;     // at an end of, or on, a cut: see the top of this file

    bool operator==(const AdaptiveVertex&) const = default;
};

//      A --------- C --------- B        Split: children AC and CB, in this order, each directed as its parent.
struct AdaptiveEdge {
    std::array<VertexId, 2> ends;
    VertexId centre;  // none: unsplit
    std::array<EdgeId, 2> children;
    std::array<TriangleId, 2> sides;  // at the edge's own level; [0] has A to B anticlockwise. None: boundary
    float rest_length = 0.0F;         // m
    std::uint8_t level = 0;
    bool rejoining = false;    // counts as unsplit; the next retriangulate() frees its children
    bool right_wrong = false;  // both sides exist, and [1] has A to B anticlockwise as well

    // Makes it an unsplit edge. Assigns field by field: copying a temporary edge would stall on store forwarding.
    void set(const std::array<VertexId, 2>& new_ends, const std::array<TriangleId, 2>& new_sides, float length,
             std::uint8_t new_level) {
        ends = new_ends;
        centre = {};
        children = {};
        sides = new_sides;
        rest_length = length;
        level = new_level;
        rejoining = false;
        right_wrong = false;
    }

    bool operator==(const AdaptiveEdge&) const = default;
};

struct AdaptiveTriangle {
    std::array<VertexId, 3> vertices;  // anticlockwise seen from the fabric's right side
    std::array<EdgeId, 3> edges;       // edges[k] joins vertices[k] and vertices[k+1]
    std::array<Vec2f, 3> u{Vec2f::Zero(), Vec2f::Zero(), Vec2f::Zero()};  // material coordinates per corner, m
    std::array<TriangleId, 4> internal_triangles;                         // in the slots of the configuration's layout
    std::array<EdgeId, 3> internal_edges;
    std::uint16_t panel = 0;
    std::uint8_t level = 0;
    Configuration configuration : 4 = Configuration::C0;
    bool regular : 1 = true;  // a base triangle or a child of C10: only these may be refined
    bool marked : 1 = false;  // the next retriangulate() processes it
    bool turned : 1 = false;  // the surface's orientation is opposite to the fabric's right side

    bool operator==(const AdaptiveTriangle&) const = default;
};

constexpr bool is_leaf(const AdaptiveTriangle& t) {
    return t.configuration == Configuration::C0;
}

// The corner of t that is v, 0..2. Pre: v is a vertex of t.
inline std::size_t corner_at(const AdaptiveTriangle& t, VertexId v) {
    return t.vertices[0] == v ? 0 : (t.vertices[1] == v ? 1 : 2);
}

// The index of e among the external edges of t, 0..2. Pre: e is one of them.
inline std::size_t index_of(const AdaptiveTriangle& t, EdgeId e) {
    return t.edges[0] == e ? 0 : (t.edges[1] == e ? 1 : 2);
}

inline constexpr int kDeepestLevel = 15;

struct AdaptiveMeshOptions {
    int max_level = 3;  // the deepest level, 0..kDeepestLevel; edges of this level are not split
    // A seam edge takes its sides' mean length if they differ by no more, else the shorter.
    float seam_ease = static_cast<float>(kSeamEase);
};

// A transition observer that does nothing.
struct NoObserver {
    void before(TriangleId) {}
    void after(TriangleId) {}
};

// How often each transition was made, indexed by (from, to).  (thesis table 3.1)
struct TransitionCounts {
    std::array<std::array<std::uint64_t, kConfigurations>, kConfigurations> by_configuration{};

    std::uint64_t between_states(std::size_t from, std::size_t to) const;  // S0..S7
};

class AdaptiveMesh {
 public:
    // Base vertices and triangles keep their indices as ids. Pre: the triangles' vertices are 0 to vertex_count - 1.
    // Throws InputError if an edge joins a vertex to itself, or has more than two triangles.
    AdaptiveMesh(std::size_t vertex_count, std::span<const GarmentTriangle> triangles,
                 const AdaptiveMeshOptions& options = {});
    // The same over a sewn garment. Pre: base has no links.
    explicit AdaptiveMesh(const GarmentMesh& base, const AdaptiveMeshOptions& options = {});

    int max_level() const { return options_.max_level; }
    std::size_t base_vertex_count() const { return base_vertices_; }
    std::size_t base_edge_count() const { return base_edges_; }
    std::size_t base_triangle_count() const { return base_triangles_; }

    // All elements of the hierarchy, leaves included. Pre (for single elements): the id is alive.
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

    // The size for state arrays. It grows only by whole blocks, and ids never change.
    std::size_t vertex_capacity() const { return vertices_.capacity(); }

    // Whether a base edge is right_wrong; whether the surface can be oriented only with cuts; whether this edge is, or
    // lies on, a cut.
    bool has_right_wrong_edges() const { return has_right_wrong_edges_; }
    bool has_cuts() const { return has_cuts_; }
    bool is_cut(EdgeId e) const;

    // The leaf triangle on one side of an unsplit edge; none at a boundary. It may be one level deeper than the edge.
    TriangleId leaf_at(EdgeId e, int side) const;

    // The line of its panel on which the external edge k of a base triangle lies. See sim/adaptive/panel_lines.h.
    const SideLine& base_line(TriangleId t, std::size_t k) const { return base_lines_[t.value][k]; }

    // The side, 0 or 1, of the external edge k of a triangle on which the triangle lies: it is leaf_at() that side, or
    // sides[] that side.
    int side_of(TriangleId t, std::size_t k) const;

    // for (TriangleId t : mesh.triangles_at(v)): the leaf triangles round a vertex, anticlockwise as seen from the
    // right side of the first one; at a boundary from one boundary edge to the other (clockwise if no end of the fan
    // allows anticlockwise). No adjacency list is stored: the iterator uses the sides of the edges.
    class TrianglesAt;
    TrianglesAt triangles_at(VertexId v) const;

    // Leaf lists, as of the last refresh_lists().
    std::span<const VertexId> leaf_vertices() const { return leaves().vertices; }
    std::span<const LeafEdge> leaf_edges() const { return leaves().edges; }
    std::span<const LeafTriangle> leaf_triangles() const { return leaves().triangles; }
    std::span<const Hinge> hinges() const { return leaves().hinges; }
    std::span<const float> vertex_areas() const { return leaves().vertex_areas; }  // m^2, by vertex id
    const Hinge* hinge(EdgeId e) const { return tracker_.hinge(e); }               // of a leaf edge; null at a boundary
    const LeafLists& leaves() const { return tracker_.lists(); }

    // How the last refresh_lists(), and so the last adaptation, changed them.
    const LeafChanges& changes() const { return tracker_.changes(); }

    // The elements of one level, 0..max_level, as of the last retriangulate(). Empty at the deepest level, where no
    // edge may be split.
    std::span<const EdgeId> unsplit_edges(int level) const { return levels_.unsplit(level); }
    std::span<const EdgeId> split_edges(int level) const { return levels_.split(level); }
    std::span<const TriangleId> refined_triangles(int level) const { return levels_.refined(level); }

    // Memory per element, alive or free, with its list positions but without the lists themselves.  (thesis table 3.11)
    struct BytesPerElement {
        std::size_t vertex, edge, triangle;
    };
    static constexpr BytesPerElement bytes_per_element();

    // Permissions.  (thesis fig. 3.11)
    bool may_split(EdgeId e) const;
    bool may_rejoin(EdgeId e) const;
    bool has_leaf_children(EdgeId e) const;  // pre: e is split; a necessary condition for a rejoin

    // Changes. split() and rejoin() only mark the triangles on both sides. retriangulate() then makes one transition
    // per marked triangle, however many of its edges changed, and returns the number of transitions (thesis 3.3.3).
    // Between two calls only edges of one level may change. Pre: the change is permitted. split() returns the centre;
    // the centre of a rejoined edge is freed by retriangulate().
    VertexId split(EdgeId e);
    void rejoin(EdgeId e);
    int retriangulate(int level, TransitionCounts* counts = nullptr);

    // The same with another choice where two configurations conform, see MinimalChange. Calls
    // watch.before(t) and watch.after(t) around each transition.
    template <class Choice, class Watch>
    int retriangulate(int level, TransitionCounts* counts, const Choice& choice, Watch& watch);

    // Updates the leaf lists in place with all changes since the last call, and records them in changes().
    void refresh_lists() { tracker_.refresh(*this); }

    // A single transition, for tests and benchmarks. The caller is responsible for conformity.
    // Pre: t is regular, the edges that `to` has split are split, no internal element is refined.
    void change_configuration(TriangleId id, Configuration to);

 private:
    struct Change;  // the transitions, one function each

    void add_base_edges(std::span<const GarmentTriangle> base);
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

    // Walking round a vertex. The direction as seen from the right side of the present triangle changes where the walk
    // crosses a right_wrong edge.
    struct FanStep {
        TriangleId triangle;
        bool is_clockwise = false;
    };
    FanStep first_at(VertexId v, std::size_t fan) const;  // of a fan
    FanStep next_at(VertexId v, FanStep at) const;
    TriangleId first_inside(TriangleId owner, VertexId v) const;
    FanStep base_neighbour(VertexId v, FanStep at) const;
    FanStep start_of_fan(VertexId v, TriangleId t, std::vector<bool>& is_visited) const;
    void orient_base();

    AdaptiveMeshOptions options_;
    std::vector<std::array<SideLine, 3>> base_lines_;  // by base triangle
    std::size_t base_vertices_ = 0;
    std::size_t base_edges_ = 0;
    std::size_t base_triangles_ = 0;
    bool has_right_wrong_edges_ = false;
    bool has_cuts_ = false;
    Pool<AdaptiveVertex, VertexId> vertices_;
    Pool<AdaptiveEdge, EdgeId> edges_;
    Pool<AdaptiveTriangle, TriangleId> triangles_;
    // The first base triangle of each fan of a base vertex. A vertex normally has one fan, and several where parts of
    // the surface meet only in that vertex. Those of v are fans_[fan_starts_[v]] to fans_[fan_starts_[v + 1] - 1].
    std::vector<FanStep> fans_;
    std::vector<std::uint32_t> fan_starts_;
    std::vector<TriangleId> marked_;
    std::vector<EdgeId> splitting_;
    std::vector<EdgeId> rejoining_;
    LevelLists levels_;
    LeafTracker tracker_;
    std::size_t listed_capacity_ = 0;  // total capacity of the pools when the lists were last resized
};

constexpr AdaptiveMesh::BytesPerElement AdaptiveMesh::bytes_per_element() {
    return {decltype(vertices_)::kBytesPerElement + LeafTracker::kBytesPerId + LeafTracker::kBytesPerArea,
            decltype(edges_)::kBytesPerElement + LeafTracker::kBytesPerId + LevelLists::kBytesPerId,
            decltype(triangles_)::kBytesPerElement + LeafTracker::kBytesPerId + LevelLists::kBytesPerId};
}

// choose(triangle, split mask) returns the new configuration of a marked triangle.
template <class Choose, class Watch>
int AdaptiveMesh::retriangulate_marked(int level, TransitionCounts* counts, const Choose& choose, Watch& watch) {
    list_split();
    // Coarsening frees ids in reverse order, so that a later refinement gets the same ids in the same order.
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
            return minimal_change(t.configuration, split);
        } else {
            return chosen(t, split, choice);
        }
    };
    return retriangulate_marked(level, counts, choose, watch);
}

template <class Choice>
Configuration AdaptiveMesh::chosen(const AdaptiveTriangle& t, SplitMask split, const Choice& choice) const {
    const Configuration least = minimal_change(t.configuration, split);
    if (least == t.configuration || !is_ambiguous(split)) return least;
    const AmbiguousSplit ways = ambiguous_split(split);
    const float first = choice.cost(diagonal(t, ways.diagonals[0]));
    const float second = choice.cost(diagonal(t, ways.diagonals[1]));
    if (first == second) return least;
    return ways.configurations[first < second ? 0 : 1];
}

class AdaptiveMesh::TrianglesAt {
 public:
    class Iterator {
     public:
        Iterator(const AdaptiveMesh& mesh, VertexId v, FanStep at)
            : mesh_(&mesh), vertex_(v), first_(at.triangle), at_(at), starts_clockwise_(at.is_clockwise) {}
        TriangleId operator*() const { return at_.triangle; }
        // Whether the right side of this triangle is on the other side of the surface than that of the fan's first one.
        bool is_turned() const { return at_.is_clockwise != starts_clockwise_; }
        Iterator& operator++() {
            at_ = mesh_->next_at(vertex_, at_);
            if (at_.triangle && at_.triangle != first_) return *this;
            at_ = mesh_->first_at(vertex_, ++fan_);
            first_ = at_.triangle;
            starts_clockwise_ = at_.is_clockwise;
            return *this;
        }
        bool operator!=(const Iterator& other) const { return at_.triangle != other.at_.triangle; }

     private:
        const AdaptiveMesh* mesh_;
        VertexId vertex_;
        TriangleId first_;
        FanStep at_;
        bool starts_clockwise_;
        std::size_t fan_ = 0;
    };

    TrianglesAt(const AdaptiveMesh& mesh, VertexId v) : mesh_(mesh), vertex_(v) {}
    Iterator begin() const { return {mesh_, vertex_, mesh_.first_at(vertex_, 0)}; }
    Iterator end() const { return {mesh_, vertex_, FanStep{}}; }

 private:
    const AdaptiveMesh& mesh_;
    VertexId vertex_;
};

inline AdaptiveMesh::TrianglesAt AdaptiveMesh::triangles_at(VertexId v) const {
    return {*this, v};
}

}  // namespace selvedge::sim
