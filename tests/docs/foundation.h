#pragma once
// The example of docs/adding-a-constraint.md: an elastic foundation (Winkler). Each leaf triangle is tied to a
// horizontal plane by springs all over its area: E = 1/2 k A d^2, where d is the height of its centroid above the
// plane.
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "sim/simulation/cloth_constraint.h"

namespace selvedge::sim {

// [class]
class Foundation : public ClothConstraint {
 public:
    Foundation(float stiffness, float plane) : stiffness_(stiffness), plane_(plane) {}

    std::unique_ptr<ClothConstraint> copy() const override { return std::make_unique<Foundation>(*this); }
    void make(const Cloth& cloth) override;
    void solve(float* points, const float* before) override;

 private:
    struct Spring {
        std::array<std::uint32_t, 3> corners{};
        float compliance = 0;  // 1/kg, over a sub-step
    };

    float stiffness_;  // k, N/m^3
    float plane_;      // m, its height
    std::vector<Spring> springs_;
};
// [/class]

}  // namespace selvedge::sim
