#pragma once
// The edge-based adaptive mesh: a hierarchy of edges and triangles over a sewn base mesh, changed one edge at a time.
// It knows topology, levels and material coordinates; positions and all other state live beside it, in flat arrays
// indexed by vertex id.  (thesis ch. 3; SPEC 1.1-1.2)  What asks for changes is adapt(), sim/adaptive/adapt.h.
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/adaptive/elements.h"
#include "sim/adaptive/leaf_lists.h"
#include "sim/core/pool.h"
#include "sim/mesh/garment_mesh.h"

namespace selvedge {

inline constexpr int kDeepestLevel = 15;

struct AdaptiveMeshOptions {
    int max_level = 3;        // edges are split down to it; 0..kDeepestLevel
    float seam_ease = 0.05F;  // a seam's sides that differ by no more share their mean length, else the shorter rules
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

    // for (TriangleId t : mesh.triangles_at(v)): the leaf triangles round a vertex, by rising id.
    class TrianglesAt;
    TrianglesAt triangles_at(VertexId v) const;

    // Leaf lists, as refresh_lists() left them.
    std::span<const VertexId> leaf_vertices() const { return leaves_.vertices; }
    std::span<const LeafEdge> leaf_edges() const { return leaves_.edges; }
    std::span<const LeafTriangle> leaf_triangles() const { return leaves_.triangles; }
    std::span<const Hinge> hinges() const { return leaves_.hinges; }
    std::span<const float> vertex_areas() const { return leaves_.vertex_areas; }  // m^2, by vertex id
    const LeafLists& leaves() const { return leaves_; }

    // The elements of one level, 0..max_level, parted into leaves and parents.
    std::span<const EdgeId> unsplit_edges(int level) const { return at_level(level).unsplit; }
    std::span<const EdgeId> split_edges(int level) const { return at_level(level).split; }
    std::span<const TriangleId> leaf_triangles(int level) const { return at_level(level).leaves; }
    std::span<const TriangleId> refined_triangles(int level) const { return at_level(level).refined; }

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

    // Brings the lists of levels and leaves up to date; does nothing when nothing has changed.
    void refresh_lists();

    // One transition by itself, to test and to measure. Conformity is the caller's care.
    // Pre: t is regular, the edges that `to` has split are split, no internal element is refined.
    void change_configuration(TriangleId id, Configuration to);

 private:
    struct Level {
        std::vector<EdgeId> unsplit, split;
        std::vector<TriangleId> leaves, refined;
    };
    struct Stencil;

    const Level& at_level(int level) const { return levels_[static_cast<std::size_t>(level)]; }
    void add_base_edges(const GarmentMesh& base);

    SplitMask split_mask(const AdaptiveTriangle& t) const;
    bool has_leaf_children(TriangleId t) const;
    void mark_sides(EdgeId e);
    void release_rejoined();

    Stencil stencil_of(const AdaptiveTriangle& owner) const;
    void drop_unshared(const AdaptiveTriangle& owner, const Transition& plan);
    void keep_shared(AdaptiveTriangle& owner, const Transition& plan) const;
    void create_missing(AdaptiveTriangle& owner);
    EdgeId create_internal_edge(const AdaptiveTriangle& owner, const InternalEdge& drawn, const Stencil& stencil);
    TriangleId create_internal_triangle(const AdaptiveTriangle& owner, const InternalTriangle& drawn,
                                        const Stencil& stencil);
    void set_sides(TriangleId id, TriangleId value);
    TriangleId& next_at(TriangleId t, VertexId v);
    void link(TriangleId id);
    void unlink(TriangleId id);

    void list_level(std::size_t level);
    void list(EdgeId e, Level& into) const;
    void list(TriangleId t, Level& into) const;

    AdaptiveMeshOptions options_;
    std::size_t base_vertices_ = 0;
    std::size_t base_edges_ = 0;
    std::size_t base_triangles_ = 0;
    Pool<AdaptiveVertex, VertexId> vertices_;
    Pool<AdaptiveEdge, EdgeId> edges_;
    Pool<AdaptiveTriangle, TriangleId> triangles_;
    std::vector<TriangleId> marked_;
    std::vector<EdgeId> rejoining_;
    std::vector<Level> levels_;
    LeafLists leaves_;
    int changed_from_ = 0;  // the lists of this level and of all deeper ones are out of date or of order
};

// A range over the list that runs through the corners at one vertex.
class AdaptiveMesh::TrianglesAt {
 public:
    class Iterator {
     public:
        Iterator(const AdaptiveMesh& mesh, VertexId v, TriangleId t) : mesh_(&mesh), vertex_(v), triangle_(t) {}
        TriangleId operator*() const { return triangle_; }
        Iterator& operator++() {
            const AdaptiveTriangle& t = mesh_->triangle(triangle_);
            triangle_ = t.next[corner_at(t, vertex_)];
            return *this;
        }
        bool operator!=(const Iterator& other) const { return triangle_ != other.triangle_; }

     private:
        const AdaptiveMesh* mesh_;
        VertexId vertex_;
        TriangleId triangle_;
    };

    TrianglesAt(const AdaptiveMesh& mesh, VertexId v) : mesh_(mesh), vertex_(v) {}
    Iterator begin() const { return {mesh_, vertex_, mesh_.vertex(vertex_).first_triangle}; }
    Iterator end() const { return {mesh_, vertex_, TriangleId{}}; }

 private:
    const AdaptiveMesh& mesh_;
    VertexId vertex_;
};

inline AdaptiveMesh::TrianglesAt AdaptiveMesh::triangles_at(VertexId v) const {
    return {*this, v};
}

}  // namespace selvedge
