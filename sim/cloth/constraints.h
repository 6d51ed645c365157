#pragma once
// One pass over each kind of constraint, in list order (Gauss-Seidel): the inner loops of a sub-step.
#include <cstdint>
#include <span>
#include <vector>

#include "sim/cloth/elements.h"
#include "sim/core/vec.h"

namespace selvedge {

// Warp, weft and shear strain of every leaf triangle, by compliance.
void solve_stretch(std::span<const StretchElement> elements, std::span<const float> inverse_mass, std::span<Vec4f> x);

// Takes back what warp and weft are stretched beyond their slack; and what is beyond the fabric's strain limit again
// and again. Shear is left out: one pass weighs it as high as the threads, and it must not hold them apart. `over` is
// scratch.
void limit_stretch(std::span<const StretchElement> elements, std::span<Vec4f> x, std::vector<std::uint32_t>& over);

// Every hinge towards flat, by compliance.
void solve_bend(std::span<const BendElement> elements, std::span<Vec4f> x);

// Shortens what is longer than its limit. After Provot (1995), for unequal masses.
void limit_lengths(std::span<const LengthLimit> limits, std::span<Vec4f> x);

// Refined triangles from coarse to fine: what stretches one beyond its threads is taken back, and the centres of its
// edges follow, so that one pass spreads tension over the whole garment. `before` is scratch of the size of x.
void limit_parents(std::span<const ParentLevel> levels, std::span<Vec4f> x, std::vector<Vec4f>& before);

}  // namespace selvedge
