#pragma once
// Keeps the flat lists of the leaves up to date at a cost in proportion to what changed: the mesh notes which elements
// it touched, and refresh() looks at those and at what they hold, and at nothing else.  (SPEC 1.4)
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/math.h"
#include "sim/core/pool.h"

namespace selvedge::sim {

// Flat lists of the leaf elements: all that the inner loops of simulation and drawing read.  (SPEC 1.4, table 3.6)
// They are kept, not gathered: what changes is put in place of what went, and the last fill what stays empty. Their
// order depends on the history of the mesh, and is the same for the same history.

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
    // What an id costs here, beside the lists themselves.
    static constexpr std::size_t kBytesPerId = sizeof(std::uint32_t);
    static constexpr std::size_t kBytesPerArea = sizeof(double) + sizeof(float);

    // To be noted: a triangle or an edge that became a leaf or a parent or holds other elements, and whatever
    // is released or written over. What is new is found through the element that holds it.
    void note(VertexId v) { note(vertices_, v); }
    void note(EdgeId e) { note(edges_, e); }
    void note(TriangleId t) { note(triangles_, t); }

    // The same for what is released, which only matters to what knows of it ...
    void note_released(VertexId v) { note_released(vertices_, v); }
    void note_released(EdgeId e) { note_released(edges_, e); }
    void note_released(TriangleId t) { note_released(triangles_, t); }

    // ... and for what is written over, which only matters if a list holds it.
    void note_rewritten(EdgeId e) { note_rewritten(edges_, e); }
    void note_rewritten(TriangleId t) { note_rewritten(triangles_, t); }

    // A triangle that becomes refined, or a leaf again.
    void note_refined(TriangleId t) {
        Place& place = triangles_.by_id[t.value];
        if ((place & kIsRefinedNoted) != 0) return;
        place |= kIsRefinedNoted;
        refined_noted_.push_back(t);
    }

    // Pre: before an id of that number or above is noted.
    void grow(std::size_t vertices, std::size_t edges, std::size_t triangles);

    void refresh(const AdaptiveMesh& mesh);

    const LeafLists& lists() const { return lists_; }
    const Hinge* hinge(EdgeId e) const {
        const Place place = edges_.by_id[e.value];
        return is_listed(place) && (place & kIsBoundary) == 0 ? &lists_.hinges[place & kPosition] : nullptr;
    }
    const LeafChanges& changes() const { return changes_; }  // what the last refresh() did

 private:
    // Where an id stands in its list, with marks above.
    using Place = std::uint32_t;
    static constexpr Place kNoted = 1U << 31U;
    static constexpr Place kIsBoundary = 1U << 30U;     // of edges: in the list of those
    static constexpr Place kIsFresh = 1U << 29U;        // of edges: its hinge is known to have changed
    static constexpr Place kIsRefinedNoted = kIsFresh;  // of triangles
    static constexpr Place kIsReleased = 1U << 28U;     // since it was noted; it may have been taken again for another
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

    // Asked once per noted id, last of all: forgets it. One that lives again was created, and is found as such.
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
    void insert(const AdaptiveMesh& mesh, TriangleId t);
    void insert(VertexId v);
    void write_hinges(const AdaptiveTriangle& t);
    void mark_fresh(EdgeId e, Place& place);
    void add_areas(const LeafTriangle& triangle, double sign);
    void close_gaps();
    void close_hinges();

    LeafLists lists_;
    LeafChanges changes_;
    std::vector<LeafEdge> boundary_;  // by their places; they stand again at the end of the list of edges
    std::vector<double> area_sums_;   // by vertex id; sums of floats, so that what is added can be taken away exactly
    Places<VertexId> vertices_;
    Places<EdgeId> edges_;
    Places<TriangleId> triangles_;
    std::vector<EdgeId> fresh_;  // those that are marked so
    std::vector<TriangleId> refined_noted_;
    std::size_t old_hinges_ = 0;
    struct Gaps {
        std::vector<Place> vertices, hinges, boundary, triangles;
    } gaps_;
};

// The elements of each level by what they are now: edges that are unsplit or split, triangles that are refined. Each
// knows its place, so that it can leave when it changes: the last one takes its place. At the deepest level nothing
// changes, so nothing is listed.  (SPEC 1.4)

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

    // Pre: it stands in that list.
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
