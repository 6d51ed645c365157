#pragma once
// The collision criterion: splits edges that penetrate the offset surface of the body.  (thesis 3.4.2, fig. 3.13)
#include <span>
#include <vector>

#include "sim/adaptive/adapt.h"
#include "sim/collide/collider.h"
#include "sim/core/math.h"

namespace selvedge::sim {

class Collider;
struct MovingContacts;

// Working memory of a batch evaluation, reused by later adaptations.
struct CollisionBatch {
    std::vector<EdgeId> edges;         // the noted edges
    std::vector<EdgeId> evaluated;     // the evaluated edges: the noted ones and the finer edges beside them
    std::vector<std::size_t> first;    // index of the first point of each evaluated edge in a query, and the number
    std::vector<float> depths;         // by EdgeId, m: penetration at the last evaluation; lowest float: not evaluated
    std::vector<float> least;          // m, the least distance of the other points of each evaluated edge
    std::vector<ContactBlock> blocks;  // scratch
    bool is_evaluated = false;
};

// Splits an edge if it, or a triangle beside it, lies deeper than split_depth below the offset surface of the body;
// lets it rejoin if the depth is below rejoin_depth. A split edge is tested as the straight chord between its ends:
// once the centre lies on the surface, its children no longer penetrate, and testing them would make the edge flicker.
// With look-ahead (LookAheadCriterion in criteria.h): an edge also requests a split for the finer edges beside it. A
// chord above the split depth stays outside of the body itself: it may use two thirds of the contact offset, and the
// last third is reserved for the error of the collider.
struct CollisionCriterion {
    static constexpr bool is_batch = true;

    const std::vector<Vec4f>& x;
    const Collider& body;
    CollisionBatch& batch;
    SplitLimits limits{};                          // look-ahead considers only finer edges that these allow to be split
    float offset = 0.003F;                         // m, contact offset
    const std::vector<float>* standoff = nullptr;  // by vertex, m beyond the offset (standoff.h); nullptr: none
    const MovingContacts* moving = nullptr;        // what is known of a body that moves; nullptr: every point asks it
    float split_depth = 0.002F;                    // m, of the chord below the offset surface
    float rejoin_depth = 0.0008F;
    float spacing = 0.025F;  // m, maximum distance between sample points of an edge; one is always in the middle

    void note(EdgeId e) const;
    std::span<const EdgeId> noted() const;  // since the last look()
    std::span<const EdgeId> look(const AdaptiveMesh& mesh) const;

    // Pre: the last look() evaluated the edge.
    bool wants_split(const AdaptiveMesh& mesh, EdgeId e) const { return cuts(e) || finer_edges_cut(mesh, e); }
    bool allows_rejoin(const AdaptiveMesh& mesh, EdgeId e) const {
        return batch.depths[e.value] < rejoin_depth && !finer_edges_cut(mesh, e);
    }

 private:
    bool cuts(EdgeId e) const { return e.value < batch.depths.size() && batch.depths[e.value] > split_depth; }
    bool finer_edges_cut(const AdaptiveMesh& mesh, EdgeId e) const;
    void gather(const AdaptiveMesh& mesh) const;
    void put_points(const AdaptiveMesh& mesh) const;
    float depth(const AdaptiveMesh& mesh, std::size_t i) const;
    float height(const AdaptiveMesh& mesh, EdgeId e) const;
};

}  // namespace selvedge::sim
