#pragma once
// The data of the solver's inner loops: constraints in blocks of sixteen that share no vertex, as structures of arrays.
// Everything that does not change between two adaptations is precomputed. See docs/solver.md for the method.
//
// Stretch and shear: conditions on the deformed warp and weft directions of a triangle (Baraff and Witkin 1998).
// Bending: the curvature of triangles (curvature_map.h). Both are compliant constraints, solved with one iteration per
// sub-step (Macklin et al. 2019, "Small Steps"), so that stiffness has physical units.
//
// For stretch, one iteration per sub-step does not reach the strain that a load requires: cloth would hang too long. So
// each condition has a bias: an accumulated strain (an integral term), added to the strain that the condition sees, and
// updated slowly until strain and stress agree with the fabric (Kernels::update_bias).
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

#include "sim/core/blocks.h"
#include "sim/core/math.h"
#include "sim/core/pool.h"

namespace selvedge::sim {

// Warp, weft and shear of leaf triangles. With e1 = x1 - x0, e2 = x2 - x0 the deformed warp direction is a0 e1 + a1 e2
// and the deformed weft direction is b0 e1 + b1 e2; both have length 1 at rest.
struct alignas(64) StretchBlock {
    std::array<BlockPoints, 3> vertices{};
    std::array<BlockFloats, 2> a{}, b{};
    BlockFloats warp{}, weft{}, shear{};  // gains 1 / (sum of w |grad|^2 + compliance); of shear after elimination of
                                          // warp and weft
    BlockFloats cross{};                  // sum of w grad grad between shear and warp, and between shear and weft
    BlockFloats longest{};                // length of warp and weft at the fabric's strain limit
    BlockFloats push{};                   // 1, or 0 where a seam gathers the cloth: compression is not resisted
    std::array<BlockFloats, 3> bias{};    // of warp, weft and shear: added to the measured strain
    BlockFloats stick{}, slip{};          // friction in shear: spring stiffness, relative to the fabric's; and the
    BlockFloats anchor{};                 // maximum distance of the strain from the anchor, which then follows
};

// Relaxation: the share of the full correction that one iteration applies. With all of a leaf's correction, neighbours
// that share vertices make each other oscillate, and each sub-step turns this into velocity. Coarse strain limits apply
// half of their correction, because the finer levels correct the rest.
inline constexpr float kLeafShare = 0.75F;
inline constexpr float kLimitShare = 0.5F;

// kappa, momentum of corrections: the share of the last sub-step's corrections of stretch and shear that each vertex
// repeats before the constraints are solved. Corrections accumulate over the sub-steps to 1 / (1 - kappa) times their
// size. For modes of which an iteration removes a small share beta of the error, it is stable below kappa = 1/2 (roots
// of (z - kappa)(z^2 - 2 z + 1) + beta kappa z^2 for beta -> 0; docs/solver.md). So that the total stiffness is right,
// constraints have (1 - kappa) of the fabric's. No state per constraint is needed, so none is transferred when the mesh
// changes.
inline constexpr float kMomentum = 0.3F;

// Offset of a triangle's four floats in the arrays of LevelStress; kNoOffset: no triangle.
inline constexpr std::uint32_t kNoOffset = 0;
inline std::uint32_t stress_offset(TriangleId t) {
    return 4 * (t.value + 1);
}

// Data of stretch constraints that only some operations need: the last multipliers of warp, weft and shear, and the
// compliances over a sub-step.
struct alignas(64) StretchRecord {
    std::array<BlockFloats, 3> multiplier{};
    std::array<BlockFloats, 3> compliance{};
    BlockPoints parent{};   // offset of the leaf's parent triangle in LevelStress
    BlockFloats of_area{};  // area of the leaf over that of its parent
};

// Coarse strain limits of refined triangles. However cloth folds, the flat triangle through three of its points
// stretches a yarn hardly more than the cloth itself is stretched. So a limit is one-sided: it only shortens. It moves
// its corners with the masses of all vertices that follow them, so that one iteration transmits tension over a longer
// distance than that of leaves does. It has a bias too, and the stress that it bears counts as stress of its leaves.
struct alignas(64) LimitBlock {
    std::array<BlockPoints, 3> vertices{};
    std::array<BlockFloats, 2> a{}, b{};
    BlockFloats longest_warp{}, longest_weft{};  // maximum lengths of the warp and weft directions
    BlockFloats shear{};                         // multiplier of shear; its bound depends on the tensions
    std::array<BlockFloats, 2> gain{};           // multipliers of warp and weft per unit of relative excess length
    std::array<BlockFloats, 3> warp{}, weft{};   // displacement of each vertex along the direction per multiplier, m
};

// Data for Kernels::update_limit_biases. Stress is divided by stiffness: it is the strain that the fabric has under it.
struct alignas(64) LimitRecord {
    BlockPoints offset{}, parent{};            // offsets of the triangle and of its parent in LevelStress
    BlockFloats of_area{};                     // area of the triangle over that of its parent
    std::array<BlockFloats, 2> free_length{};  // maximum length of warp and weft at a bias of 0
    std::array<BlockFloats, 3> bias{};         // of warp and weft: reduction of that length; and of shear
    std::array<BlockFloats, 3> multiplier{};   // the last ones, of warp, weft and shear
    std::array<BlockFloats, 3> compliance{};   // over a sub-step
    std::array<BlockFloats, 3> per_stress{};   // bias per unit of stress
    BlockFloats per_shear{};                   // multiplier of shear per unit of its bias
    BlockFloats bearable_shear{};              // shear stress that the inner triangles can bear without this limit
};

// Copies of the stretch constraints of one colour that were beyond the fabric's strain limit, packed without gaps.
struct alignas(64) OverBlock {
    std::array<BlockPoints, 3> vertices{};
    std::array<BlockFloats, 2> a{}, b{};
    BlockFloats warp{}, weft{};
    BlockFloats longest{};
};

// Sums of warp, weft and shear (and padding), passed between levels. Entry 0 stands for no triangle, entry id + 1 for
// triangle id. Stresses are divided by stiffness, as in LimitRecord.
struct LevelStress {
    std::vector<Vec4f> above;  // stress that a refined triangle and all its ancestors bear
    std::vector<Vec4f> below;  // scratch: mean stress that its inner triangles bear
    std::vector<Vec4f> off;    // scratch: mean strain error of warp and weft of the leaves in it
};

// The angle t of a fold is approximated from its sine s and cosine c by (4 s / (1 + c) + s) / 3. Towards 180 degrees
// it grows to kMaxFold. Within about 3 degrees of 180 it falls to 0, because there the sign of the fold cannot be
// determined: 1 + c counts as kMinFold at least.
inline constexpr float kMaxFold = 3.2F;  // rad, just more than pi
inline constexpr float kMinFold = 0.02F;

// The interval of a triangle that bends with no rigidity: larger than any interval that is solved.
inline constexpr float kNeverSolved = 8;

// Bending of a triangle: its curvature k is a fixed linear map of the angles of its three hinges (curvature_map.h), its
// energy is 1/2 area k' D k with the rigidities D along warp, weft and of twist. The three hinges are solved together
// as compliant constraints. Hinge i is the edge from corner i + 1 to corner i + 2. Multipliers are moments times the
// square of a sub-step, N m s^2.
//
// Internal friction acts on the curvatures along warp, weft and of twist: a spring connects each to an anchor, which
// follows where the spring would exceed the fabric's friction (Prandtl element, Jenkins cell).
struct alignas(64) BendBlock {
    std::array<BlockPoints, 6> vertices{};  // the corners, then the apex beyond each edge; if there is none, the corner
                                            // opposite to the edge
    std::array<BlockFloats, 3> own{},
        beyond{};  // 1 / height of corner and apex above the edge at rest, 1/m; 0: no hinge
    std::array<BlockFloats, 3> own_foot{},
        beyond_foot{};                     // feet of those heights along the edge: 0 at its start, 1 at its end
    std::array<BlockFloats, 6> gain{};     // multiplier per angle, symmetric: 00 11 22 01 02 12
    BlockFloats realised{};                // share of the fabric's rigidity that this triangle applies
    BlockFloats interval{};                // sub-steps between two solves: 1, 2 or kNeverSolved
    BlockFloats has_friction{};            // 1 or 0: whether the following values are used
    std::array<BlockFloats, 9> map{};      // curvature per angle, by rows: warp, weft, 2 twist; 1/m
    std::array<BlockFloats, 9> settled{};  // curvature expected after the whole iteration, per angle before it; 1/m
    std::array<BlockFloats, 3> stick{};    // multiplier per difference of curvature from the anchor
    std::array<BlockFloats, 3> slip{};     // 1/m, maximum difference of a curvature from its anchor, which then follows
    std::array<BlockFloats, 3> anchor{};   // 1/m
};

// The same for a refined triangle. Its vertices have the masses of all vertices that follow them. One iteration of a
// triangle can apply at most the stiffness that its masses can follow within a sub-step; for a coarse triangle that is
// 16 times as much as one level deeper. So each triangle applies as much of the rigidity and friction as it can, and
// passes the rest up to its parent.
struct alignas(64) CoarseBendBlock : BendBlock {
    std::array<BlockFloats, 6> inverse_mass{};  // 1/kg, of the vertices
};

// Data for the update of the gains: values of the fabric over a sub-step, for the full rigidity.
struct alignas(64) BendRecord {
    std::array<BlockFloats, 6> stiffness{};  // multiplier per angle, symmetric as BendBlock::gain
    std::array<BlockFloats, 3> rigidity{};   // multiplier per curvature, of warp, weft and twist separately
    std::array<BlockFloats, 3> friction{};   // maximum multiplier
    BlockPoints parent{};                    // offset of the parent triangle (see stress_offset), or kNoOffset
    BlockFloats of_area{};                   // area of the triangle over that of its parent
    BlockFloats requested{};                 // requested share of the rigidity: 1 for leaves, else what was passed up
    BlockFloats passed_up{};                 // remaining share, passed up to the parent
};

// Ratio of the spring of friction in shear to the fabric's shear stiffness: friction slips at a small part of the shear
// over which its hysteresis loop is measured. A stiffer spring would be harder to solve. (For bending see kBendStick.)
inline constexpr float kStick = 4;

// The centre of a split edge, which follows the displacements of the ends. Offsets as in BlockPoints.
struct EdgeCentre {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t centre = 0;
};

inline constexpr std::uint32_t kNoBlockSlot = UINT32_MAX;

// Access to single slots. A block consists of rows of sixteen values of four bytes; `vertices` are the first rows.

// A block of dummy constraints. All their vertices are the dummy vertex, whose index is one past those of the mesh and
// which cannot move.
template <class Block>
Block dummy_block(std::size_t dummy_vertex) {
    Block block{};
    for (BlockPoints& points : block.vertices) points.fill(static_cast<std::uint32_t>(4 * dummy_vertex));
    if constexpr (std::is_same_v<Block, StretchBlock> || std::is_same_v<Block, OverBlock>)
        block.longest.fill(std::numeric_limits<float>::max());
    if constexpr (std::is_same_v<Block, StretchBlock>) block.push.fill(1);  // not gathered
    if constexpr (std::is_same_v<Block, LimitBlock>) {
        block.longest_warp.fill(1);
        block.longest_weft.fill(1);
    }
    return block;
}

// The record of such a block. Its compliances only keep the gains finite.
template <class Record>
Record dummy_record() {
    Record record{};
    if constexpr (!std::is_same_v<Record, BendRecord>) {
        for (BlockFloats& compliance : record.compliance) compliance.fill(1);
    }
    if constexpr (std::is_same_v<Record, LimitRecord>) {
        for (BlockFloats& length : record.free_length) length.fill(1);
    }
    return record;
}

template <class Block>
void copy_slot(const Block& from, Block& to, std::size_t at) {
    constexpr std::size_t kValue = sizeof(float), kRow = kBlock * kValue;
    static_assert(sizeof(Block) % kRow == 0 && std::is_trivially_copyable_v<Block>);
    const auto* source = static_cast<const std::byte*>(static_cast<const void*>(&from));
    auto* target = static_cast<std::byte*>(static_cast<void*>(&to));
    for (std::size_t offset = at * kValue; offset < sizeof(Block); offset += kRow) {
        std::memcpy(target + offset, source + offset, kValue);
    }
}

// Three values of one constraint.
inline Vec3f values_at(const std::array<BlockFloats, 3>& rows, std::size_t at) {
    return {rows[0][at], rows[1][at], rows[2][at]};
}
inline void set_values(std::array<BlockFloats, 3>& rows, std::size_t at, const Vec3f& values) {
    for (std::size_t k = 0; k < 3; ++k) rows[k][at] = values[static_cast<Eigen::Index>(k)];
}

// The vertex indices of one constraint.
template <class Block>
auto corners_at(const Block& block, std::size_t at) {
    std::array<std::uint32_t, std::tuple_size_v<decltype(Block::vertices)>> corners{};
    for (std::size_t k = 0; k < corners.size(); ++k) corners[k] = block.vertices[k][at] / 4;
    return corners;
}

}  // namespace selvedge::sim
