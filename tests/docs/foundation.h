#pragma once
// The example of docs/adding-a-constraint.md: an elastic foundation (Winkler). Each leaf triangle is tied to a
// horizontal plane by springs all over its area: E = 1/2 k A d^2, where d is the height of its centroid above the
// plane.
#include <array>
#include <span>

#include "sim/cloth/cloth.h"
#include "sim/cloth/constraint_set.h"
#include "sim/cloth/solver_blocks.h"
#include "sim/core/simd_level.h"

namespace selvedge::sim {

// [block]
struct alignas(64) FoundationBlock {
    std::array<BlockPoints, 3> vertices{};  // the corners
    BlockFloats gain{};                     // kg: multiplier per height, times the gradient 1/3
};

struct alignas(64) FoundationRecord {
    std::array<BlockFloats, 1> compliance{};  // 1/kg, over a sub-step: compliance_of()
};
// [/block]

// [kernels]
struct FoundationKernels {
    // gain := 1/3 / (sum of w / 9 + compliance), after an adaptation. w: inverse masses, 1/kg.
    void (*update_masses)(std::span<FoundationBlock> blocks, std::span<FoundationRecord> records,
                          const float* inverse_masses);

    // One iteration over blocks of one colour. plane: m.
    void (*solve)(std::span<const FoundationBlock> blocks, float plane, float* points);
};

template <SimdLevel>
const FoundationKernels& foundation_kernels_of();
// [/kernels]

// [list]
struct Foundation {
    float stiffness = 1000;  // k, N/m^3
    float plane = 0;         // m, its height
    ConstraintSet<FoundationBlock, FoundationRecord> set{};
    std::size_t vertices = 0;  // the dummy vertex' index
};

void make_foundation(Foundation& foundation, const Cloth& cloth);

// After adapt_cloth(). Pre: make_foundation() was called.
void change_foundation(Foundation& foundation, const Cloth& cloth);

// For StepOptions::solve_more.
void solve_foundation(Foundation& foundation, float* points);
// [/list]

}  // namespace selvedge::sim
