#pragma once
// The biases of the stretch conditions while triangles come and go: they live in the solver's blocks, and are kept by
// TriangleId in Cloth::bias while an adaption is under way.  (solver_blocks.h)
#include <array>
#include <cstddef>

#include "sim/core/ids.h"
#include "sim/core/vec.h"

namespace selvedge {

struct Cloth;

// What was kept of that triangle since Cloth::adaptions was last counted up, else what its lane has; 0 if it has none.
Vec3f kept_bias(const Cloth& cloth, TriangleId t);

// The same of a refined triangle's.
Vec3f kept_limit(const Cloth& cloth, TriangleId t);

// From the lane of a leaf, or of a refined triangle, to Cloth::bias, if nothing was kept of it yet; and of all.
void keep_bias(Cloth& cloth, TriangleId t);
void keep_limit(Cloth& cloth, TriangleId t);
void keep_biases(Cloth& cloth);

// While what is inside a triangle goes and comes: what stays keeps its bias, what is new gets the mean of what was
// there, weighed by area; a leaf that is refined goes on with its bias as a limit, and back.
class BiasHandover {
 public:
    explicit BiasHandover(Cloth& cloth) : cloth_(cloth) {}
    void before(TriangleId t);
    void after(TriangleId t);

 private:
    Cloth& cloth_;
    Vec3f mean_ = Vec3f::Zero();   // of what was inside
    Vec3f limit_ = Vec3f::Zero();  // the triangle's own when it is refined
    std::array<TriangleId, 4> inside_{};
    std::array<std::array<VertexId, 3>, 4> corners_{};
    std::size_t count_ = 0;
};

}  // namespace selvedge
