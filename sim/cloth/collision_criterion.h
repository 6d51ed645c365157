#pragma once
// Which edges cut into the body.  (SPEC 1.3)
#include <span>
#include <vector>

#include "sim/adaptive/adaptive_mesh.h"
#include "sim/body/contact_block.h"
#include "sim/core/vec.h"

namespace selvedge {

class Collider;

// Memory of a batch, kept between adaptions.
struct CollisionBatch {
    std::vector<EdgeId> edges;
    std::vector<float> depths;         // by EdgeId, m: of the edges that were looked at last
    std::vector<ContactBlock> blocks;  // scratch
    bool is_looked_at = false;
};

// Splits an edge that cuts into the offset surface of the body, or whose triangles do; lets it rejoin when they no
// longer would. Asked of the parent chord: once the centre lies on the surface the children no longer cut.
// Contacts between vertices hold such chords off, so that they touch the surface from outside and their ends stand away
// from it by what they would have cut: with `touch` above 0 that counts too.
struct CollisionCriterion {
    static constexpr bool is_batch = true;

    const std::vector<Vec4f>& x;
    const Collider& body;
    CollisionBatch& batch;
    float offset = 0.003F;       // m, contact offset
    float split_depth = 0.001F;  // m, of the chord below the offset surface
    float rejoin_depth = 0.0004F;
    float touch = 0;  // m above the offset surface at which a middle is taken to be held off

    void note(EdgeId e) const;
    std::span<const EdgeId> noted() const;  // since the last look
    std::span<const EdgeId> look(const AdaptiveMesh& mesh) const;

    // Pre: the last look saw the edge.
    bool wants_split(const AdaptiveMesh&, EdgeId e) const { return batch.depths[e.value] > split_depth; }
    bool allows_rejoin(const AdaptiveMesh&, EdgeId e) const { return batch.depths[e.value] < rejoin_depth; }

 private:
    float depth(const AdaptiveMesh& mesh, std::size_t i) const;
    float height(std::span<const VertexId> corners) const;
};

}  // namespace selvedge
