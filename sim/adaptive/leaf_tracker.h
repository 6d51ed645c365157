#pragma once
// Flat lists of the leaf elements and of the elements of each level, updated incrementally: the cost is proportional to
// the number of changes. The mesh notes which elements it changed, and refresh() visits only those and the elements
// inside them.  (thesis 3.6.8)
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/math.h"
#include "sim/core/pool.h"

namespace selvedge::sim {

// Flat lists of the leaf elements, for loops over the mesh.  (thesis table 3.6) They are updated in place: new entries
// fill the gaps that removed ones leave, and entries from the end fill the gaps that remain. Their order depends on the
// history of the mesh; the same history gives the same order.

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
    bool turned = false;  // see AdaptiveTriangle

    bool operator==(const LeafTriangle&) const = default;
};

// Two leaf triangles about the edge ab, unfolded into one plane: the origin is the middle of ab, x runs from a to b,
// the left triangle has y > 0. At a seam each triangle is taken in its own panel's coordinates, then rotated and
// translated so that the mid-points coincide.  (thesis 4.3.2, fig. 4.6) At a right_wrong edge the right triangle is
// also mirrored at the edge: it is seen from its fabric's wrong side.
struct Hinge {
    VertexId a, b, left, right;
    float rest_length = 0.0F;        // of ab, m; a = (-rest_length/2, 0), b = (rest_length/2, 0)
    Vec2f left_at = Vec2f::Zero();   // m
    Vec2f right_at = Vec2f::Zero();  // m
    std::array<Vec2f, 2> along{Vec2f::Zero(), Vec2f::Zero()};  // unit vector a to b in the left and the right panel
    EdgeId edge;
    bool right_wrong = false;  // see AdaptiveEdge

    bool operator==(const Hinge&) const = default;
};

// Edges with a hinge come first: hinges[i] belongs to edges[i]. The remaining edges are boundary edges.
struct LeafLists {
    std::vector<VertexId> vertices;
    std::vector<LeafEdge> edges;
    std::vector<LeafTriangle> triangles;
    std::vector<Hinge> hinges;  // the solver bends triangles (sim/cloth/triangle_bending.h) and does not read these
    std::vector<float> vertex_areas;  // m^2, by vertex id up to the capacity: a third of the area of adjacent leaves

    bool operator==(const LeafLists&) const = default;
};

// What was removed from the lists and added to them. An id that was removed and added again is in both lists: it may be
// another element, or have other content. A leaf edge with triangles on both sides is added and removed together with
// its hinge. hinges_changed: edges that stayed but whose triangles changed. refined_changed: triangles of any level
// that became refined, or ceased to be, or both; they may have been freed since.
struct LeafChanges {
    std::vector<VertexId> vertices_removed, vertices_added;
    std::vector<EdgeId> edges_removed, edges_added;
    std::vector<TriangleId> triangles_removed, triangles_added, refined_changed;
    std::vector<EdgeId> hinges_changed;

    void clear();
};

// m^2
inline float material_area(const std::array<Vec2f, 3>& u) {
    const Vec2f a = u[1] - u[0], b = u[2] - u[0];
    return 0.5F * (a.x() * b.y() - a.y() * b.x());
}

class AdaptiveMesh;
struct AdaptiveTriangle;

class LeafTracker {
 public:
    // Memory per id, in addition to the lists themselves.
    static constexpr std::size_t kBytesPerId = sizeof(std::uint32_t);
    static constexpr std::size_t kBytesPerArea = sizeof(double) + sizeof(float);

    // Must be noted: every triangle or edge that became a leaf or ceased to be one, or whose inner elements changed;
    // and every element that is released or overwritten. New elements are found through the element that owns them.
    void note(VertexId v) { note(vertices_, v); }
    void note(EdgeId e) { note(edges_, e); }
    void note(TriangleId t) { note(triangles_, t); }

    // The same for a released id. Does nothing if the id is neither listed nor noted.
    void note_released(VertexId v) { note_released(vertices_, v); }
    void note_released(EdgeId e) { note_released(edges_, e); }
    void note_released(TriangleId t) { note_released(triangles_, t); }

    // The same for an overwritten element. Does nothing if it is not listed.
    void note_rewritten(EdgeId e) { note_rewritten(edges_, e); }
    void note_rewritten(TriangleId t) { note_rewritten(triangles_, t); }

    // A triangle that becomes refined, or becomes a leaf again.
    void note_refined(TriangleId t) {
        Place& place = triangles_.by_id[t.value];
        if ((place & kIsRefinedNoted) != 0) return;
        place |= kIsRefinedNoted;
        refined_noted_.push_back(t);
    }

    // Must be called before an id of that number or above is noted.
    void grow(std::size_t vertices, std::size_t edges, std::size_t triangles);

    void refresh(const AdaptiveMesh& mesh);

    const LeafLists& lists() const { return lists_; }
    const Hinge* hinge(EdgeId e) const {
        const Place place = edges_.by_id[e.value];
        return is_listed(place) && (place & kIsBoundary) == 0 ? &lists_.hinges[place & kPosition] : nullptr;
    }
    const LeafChanges& changes() const { return changes_; }  // of the last refresh()

 private:
    // The index of an id in its list (bits 0..27), with flags in bits 28..31.
    using Place = std::uint32_t;
    static constexpr Place kNoted = 1U << 31U;
    static constexpr Place kIsBoundary = 1U << 30U;     // edges: the index is into the boundary list
    static constexpr Place kIsFresh = 1U << 29U;        // edges: its hinge is already recorded as changed
    static constexpr Place kIsRefinedNoted = kIsFresh;  // triangles
    static constexpr Place kIsReleased = 1U << 28U;     // since it was noted; the id may be in use again since
    static constexpr Place kUnlisted = kIsReleased - 1;
    static constexpr Place kPosition = kUnlisted;

    template <class ElementId>
    struct Places {
        std::vector<Place> by_id;
        std::vector<ElementId> noted;
    };

    static bool is_listed(Place place) { return (place & kPosition) != kUnlisted; }

    template <class ElementId>
    static void note(Places<ElementId>& places, ElementId id) {
        Place& place = places.by_id[id.value];
        if ((place & kNoted) == 0) places.noted.push_back(id);
        place = (place | kNoted) & ~kIsReleased;
    }

    template <class ElementId>
    static void note_released(Places<ElementId>& places, ElementId id) {
        Place& place = places.by_id[id.value];
        if (!is_listed(place) && (place & kNoted) == 0) return;
        note(places, id);
        place |= kIsReleased;
    }

    template <class ElementId>
    static void note_rewritten(Places<ElementId>& places, ElementId id) {
        if (is_listed(places.by_id[id.value])) note(places, id);
    }

    // Returns and clears the flag; call it once per noted id. An id that is in use again belongs to a new element,
    // which is found through its owner.
    template <class ElementId>
    static bool was_released(Places<ElementId>& places, ElementId id) {
        Place& place = places.by_id[id.value];
        const bool is_released = (place & kIsReleased) != 0;
        place &= ~kIsReleased;
        return is_released;
    }

    void erase_triangles();
    void erase_edges();
    void erase_vertices();
    void insert_edges(const AdaptiveMesh& mesh);
    void insert_triangles(const AdaptiveMesh& mesh);
    void insert(const AdaptiveMesh& mesh, EdgeId e);
    void insert(const AdaptiveMesh& mesh, TriangleId id);
    void insert(VertexId v);
    void write_hinges(const AdaptiveMesh& mesh, TriangleId id);
    void mark_fresh(EdgeId e, Place& place);
    void add_areas(const LeafTriangle& triangle, double sign);
    void close_gaps();
    void close_hinges();

    LeafLists lists_;
    LeafChanges changes_;
    std::vector<LeafEdge> boundary_;  // refresh() copies it to the end of the list of edges
    std::vector<double> area_sums_;   // m^2, by vertex id; floats summed in doubles, so that subtraction is exact
    Places<VertexId> vertices_;
    Places<EdgeId> edges_;
    Places<TriangleId> triangles_;
    std::vector<EdgeId> fresh_;  // edges with the flag kIsFresh
    std::vector<TriangleId> refined_noted_;
    std::size_t old_hinges_ = 0;
    struct Gaps {
        std::vector<Place> vertices, hinges, boundary, triangles;
    } gaps_;
};

// The unsplit edges, split edges and refined triangles of each level. The index of each element in its list is stored,
// so that removal takes constant time: the last entry moves into the gap. At the deepest level no edge may be split, so
// nothing is listed.

class LevelLists {
 public:
    static constexpr std::size_t kBytesPerId = sizeof(std::uint32_t);

    void set_deepest(int level) { levels_.resize(static_cast<std::size_t>(level)); }
    void grow(std::size_t edges, std::size_t triangles) {
        if (edge_places_.size() < edges) edge_places_.resize(edges);
        if (triangle_places_.size() < triangles) triangle_places_.resize(triangles);
    }

    std::span<const EdgeId> unsplit(int level) const { return lists(level, &Level::unsplit); }
    std::span<const EdgeId> split(int level) const { return lists(level, &Level::split); }
    std::span<const TriangleId> refined(int level) const { return lists(level, &Level::refined); }

    void add_unsplit(int level, EdgeId e) {
        if (is_listed(level)) add(at(level).unsplit, edge_places_, e);
    }
    void add_split(int level, EdgeId e) { add(at(level).split, edge_places_, e); }
    void add_refined(int level, TriangleId t) { add(at(level).refined, triangle_places_, t); }

    // Pre: the element is in that list.
    void remove_unsplit(int level, EdgeId e) {
        if (is_listed(level)) remove(at(level).unsplit, edge_places_, e);
    }
    void remove_split(int level, EdgeId e) { remove(at(level).split, edge_places_, e); }
    void remove_refined(int level, TriangleId t) { remove(at(level).refined, triangle_places_, t); }

 private:
    struct Level {
        std::vector<EdgeId> unsplit, split;
        std::vector<TriangleId> refined;
    };

    bool is_listed(int level) const { return static_cast<std::size_t>(level) < levels_.size(); }

    template <class List>
    std::span<const typename List::value_type> lists(int level, List Level::*list) const {
        if (!is_listed(level)) return {};
        return levels_[static_cast<std::size_t>(level)].*list;
    }
    Level& at(int level) { return levels_[static_cast<std::size_t>(level)]; }

    template <class ElementId>
    static void add(std::vector<ElementId>& list, std::vector<std::uint32_t>& places, ElementId id) {
        places[id.value] = static_cast<std::uint32_t>(list.size());
        list.push_back(id);
    }

    template <class ElementId>
    static void remove(std::vector<ElementId>& list, std::vector<std::uint32_t>& places, ElementId id) {
        const std::uint32_t place = places[id.value];
        const ElementId last = list.back();
        list[place] = last;
        places[last.value] = place;
        list.pop_back();
    }

    std::vector<Level> levels_;
    std::vector<std::uint32_t> edge_places_, triangle_places_;  // by id
};

}  // namespace selvedge::sim
