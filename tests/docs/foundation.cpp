#include "tests/docs/foundation.h"

namespace selvedge::sim {

// [code]
void Foundation::make(const Cloth& cloth) {
    springs_.clear();
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
        const float compliance = compliance_of_spring(cloth, stiffness_ * material_area(leaf.u));
        springs_.push_back({{leaf.v[0].value, leaf.v[1].value, leaf.v[2].value}, compliance});
    }
}

void Foundation::solve(float* points, const float*) {
    for (const Spring& spring : springs_) {
        float height = 0, sum = spring.compliance;
        for (const std::uint32_t v : spring.corners) {
            height += points[4 * v + 1] / 3;
            sum += points[4 * v + 3] / 9;
        }
        const float multiplier = (plane_ - height) / sum;
        for (const std::uint32_t v : spring.corners) points[4 * v + 1] += points[4 * v + 3] * multiplier / 3;
    }
}
// [/code]

}  // namespace selvedge::sim
