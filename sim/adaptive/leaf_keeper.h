#pragma once
// Keeps the flat lists of the leaves up to date at a cost in proportion to what changed: the mesh notes which elements
// it touched, and refresh() looks at those and at what they hold, and at nothing else.  (SPEC 1.4)
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/adaptive/leaf_lists.h"
#include "sim/core/ids.h"

namespace selvedge {

class AdaptiveMesh;
struct AdaptiveTriangle;

class LeafKeeper {
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

    void take_out_triangles();
    void take_out_edges();
    void take_out_vertices();
    void put_in_edges(const AdaptiveMesh& mesh);
    void put_in_triangles(const AdaptiveMesh& mesh);
    void put_in(const AdaptiveMesh& mesh, EdgeId e);
    void put_in(const AdaptiveMesh& mesh, TriangleId t);
    void put_in(VertexId v);
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

}  // namespace selvedge
