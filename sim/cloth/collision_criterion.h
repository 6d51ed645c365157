#pragma once
// Which edges cut into the body.  (SPEC 1.3)
#include <span>
#include <vector>

#include "sim/adaptive/adapt.h"
#include "sim/collide/collider.h"
#include "sim/core/math.h"

namespace selvedge::sim {

class Collider;

// Memory of a batch, kept between adaptations.
struct CollisionBatch {
    std::vector<EdgeId> edges;
    std::vector<EdgeId> asked;         // they, and the finer edges that they speak for
    std::vector<std::size_t> first;    // of each asked edge: its first point; and behind the last one
    std::vector<float> depths;         // by EdgeId, m: of those that were asked last, else the lowest float
    std::vector<ContactBlock> blocks;  // scratch
    bool is_looked_at = false;
};

// Splits an edge that cuts deep into the offset surface of the body, or whose triangles do; lets it rejoin when they no
// longer would. Asked of the parent chord: once the centre lies on the surface the children no longer cut.
// It speaks for the finer edges beside it, which may not split before it does (look_ahead.h). The offset keeps such
// chords outside of the body itself: they may use up two thirds of it, for the last third is for the collider's error.
struct CollisionCriterion {
    static constexpr bool is_batch = true;

    const std::vector<Vec4f>& x;
    const Collider& body;
    CollisionBatch& batch;
    SplitLimits limits{};        // of the edges that it speaks for
    float offset = 0.003F;       // m, contact offset
    float split_depth = 0.002F;  // m, of the chord below the offset surface
    float rejoin_depth = 0.0008F;
    float spacing = 0.025F;  // m, edges are asked at least this often, and in their middle

    void note(EdgeId e) const;
    std::span<const EdgeId> noted() const;  // since the last look
    std::span<const EdgeId> look(const AdaptiveMesh& mesh) const;

    // Pre: the last look saw the edge.
    bool wants_split(const AdaptiveMesh& mesh, EdgeId e) const { return cuts(e) || finer_edges_cut(mesh, e); }
    bool allows_rejoin(const AdaptiveMesh& mesh, EdgeId e) const {
        return batch.depths[e.value] < rejoin_depth && !finer_edges_cut(mesh, e);
    }

 private:
    bool cuts(EdgeId e) const { return e.value < batch.depths.size() && batch.depths[e.value] > split_depth; }
    bool finer_edges_cut(const AdaptiveMesh& mesh, EdgeId e) const;
    void gather(const AdaptiveMesh& mesh) const;
    void put_points(const AdaptiveMesh& mesh) const;
    float depth(std::size_t i) const;
};

}  // namespace selvedge::sim
