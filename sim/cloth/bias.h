#pragma once
// What triangles have learnt, biases and friction, while they come and go: it lives in the solver's constraints, and is
// kept in SolverState::saved_bias and SolverState::saved_bend while an adaptation is under way. (solver_blocks.h)
#include <array>
#include <cstddef>

#include "sim/cloth/cloth.h"
#include "sim/core/math.h"
#include "sim/core/pool.h"

namespace selvedge::sim {

// What was kept of that triangle since Cloth::adaptations was last counted up, else what its slot has; 0 if it has
// none.
KeptBias kept_bias(const Cloth& cloth, TriangleId t);

// The same of a refined triangle's.
Vec3f kept_limit(const Cloth& cloth, TriangleId t);

// From the slot of a leaf, or of a refined triangle of that level, to SolverState::saved_bias, if nothing was kept of
// it yet; and of all.
void keep_bias(Cloth& cloth, TriangleId t);
void keep_limit(Cloth& cloth, TriangleId t, const ParentLevel& level);
void keep_biases(Cloth& cloth);

// The same of a triangle's friction in bending, leaf or refined; not known if it has no slot.
KeptBend kept_bend(const Cloth& cloth, TriangleId t);
void keep_bend(Cloth& cloth, TriangleId t);
void keep_bends(Cloth& cloth);

// Biases make up for what a visit cannot do, and a visit can do more when sub-steps are shorter: to be called before
// Cloth::substep becomes its `ratio`-fold, so that what they have learnt is of use with it.
void fit_biases(Cloth& cloth, float ratio);

// While what is inside a triangle goes and comes: what stays keeps its bias, what is new gets the mean of what was
// there, weighed by area; a leaf that is refined goes on with its bias as a limit, and back. So do the anchors of
// friction in bending, and a leaf that is refined keeps its own.
class BiasHandover {
 public:
    explicit BiasHandover(Cloth& cloth) : cloth_(cloth) {}
    void before(TriangleId t);
    void after(TriangleId t);

 private:
    Cloth& cloth_;
    Vec3f mean_ = Vec3f::Zero();   // of what was inside
    float mean_anchor_ = 0;        // the same
    KeptBend mean_bend_, bend_;    // the same of friction in bending, and the triangle's own
    Vec3f limit_ = Vec3f::Zero();  // the triangle's own when it is refined
    std::array<TriangleId, 4> inside_{};
    std::array<std::array<VertexId, 3>, 4> corners_{};
    std::size_t count_ = 0;
};

}  // namespace selvedge::sim
