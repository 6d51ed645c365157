#pragma once
// Transfer of the solver's accumulated state when the mesh changes: the biases of stretch and shear and
// the anchors of internal friction. They are stored in the constraint blocks (solver_blocks.h). During an adaptation
// the state of changed triangles is saved in SolverState::saved_bias and SolverState::saved_bend.
#include <array>
#include <cstddef>

#include "sim/cloth/cloth.h"
#include "sim/cloth/solver_state.h"
#include "sim/core/math.h"
#include "sim/core/pool.h"

namespace selvedge::sim {

// The state of a leaf as saved since Cloth::adaptations was last incremented, else the state in its slot; 0 if it has
// no slot.
SavedBias saved_bias_of(const Cloth& cloth, TriangleId t);

// The same for the bias of a refined triangle's coarse strain limit.
Vec3f saved_limit_of(const Cloth& cloth, TriangleId t);

// Saves the state in the slot of a leaf, or of a refined triangle of that level, in SolverState::saved_bias, unless it
// was saved in this adaptation already. save_biases() saves the state of all triangles.
void save_bias(Cloth& cloth, TriangleId t);
void save_limit(Cloth& cloth, TriangleId t, const ParentLevel& level);
void save_biases(Cloth& cloth);

// The same for a triangle's friction in bending, leaf or refined; is_known is false if it has no slot.
SavedBend saved_bend_of(const Cloth& cloth, TriangleId t);
void save_bend(Cloth& cloth, TriangleId t);
void save_bends(Cloth& cloth);

// Rescales all biases for a new length of sub-steps: with shorter sub-steps one iteration reaches more of the required
// strain, so a smaller bias is needed. Call it before Cloth::substep is multiplied by `ratio`.
void rescale_biases(Cloth& cloth, float ratio);

// Transfers the state at a transition of triangle t. Inner triangles that stay keep their bias; new ones get the
// area-weighted mean of the previous ones. A leaf that becomes refined passes its bias to its coarse strain limit, and
// back. Anchors of friction in bending are transferred in the same way; a leaf that is refined also keeps its own.
class StateTransfer {
 public:
    explicit StateTransfer(Cloth& cloth) : cloth_(cloth) {}
    void before(TriangleId t);
    void after(TriangleId t);

 private:
    Cloth& cloth_;
    Vec3f mean_ = Vec3f::Zero();   // mean bias of the previous inner triangles, or the bias of the leaf itself
    float mean_anchor_ = 0;        // the same for the anchor of friction in shear
    SavedBend mean_bend_, bend_;   // the same for friction in bending; and the triangle's own
    Vec3f limit_ = Vec3f::Zero();  // bias of the triangle's coarse strain limit
    std::array<TriangleId, 4> inside_{};
    std::array<std::array<VertexId, 3>, 4> corners_{};
    std::size_t count_ = 0;
};

}  // namespace selvedge::sim
