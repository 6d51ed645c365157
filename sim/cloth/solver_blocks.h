#pragma once
// What the solver's inner loops read: constraints in blocks of sixteen that share no vertex, one array per figure, with
// everything that does not change between two adaptations worked out beforehand.
//
// Stretch and shear after Baraff and Witkin (1998), conditions on the deformed warp and weft directions of a triangle;
// bending by the curvature of triangles (curvature_map.h); both as compliant constraints, visited once per sub-step
// (Macklin et al. 2019, "Small Steps"), so that stiffness has units.
//
// Of stretch, one visit per sub-step is not enough to reach the strain that belongs to a load: cloth would hang too
// long. So each condition has a bias, which is moved slowly until strain and stress agree with the fabric
// (update_bias).
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

#include "sim/core/math.h"
#include "sim/core/pool.h"

namespace selvedge::sim {

inline constexpr std::size_t kBlock = 16;
using BlockFloats = std::array<float, kBlock>;
using BlockPoints = std::array<std::uint32_t, kBlock>;  // four times a vertex's index: where its floats begin

// Warp, weft and shear of leaf triangles. With e1 = x1 - x0, e2 = x2 - x0 the deformed warp direction is a0 e1 + a1 e2,
// the deformed weft direction b0 e1 + b1 e2; both have length 1 at rest.
struct alignas(64) StretchBlock {
    std::array<BlockPoints, 3> vertices{};
    std::array<BlockFloats, 2> a{}, b{};
    BlockFloats warp{}, weft{}, shear{};  // 1 / (sum of w |grad|^2 + compliance); of shear: what is left of it when
                                          // warp and weft have been eliminated
    BlockFloats cross{};                  // sum of w grad grad between shear and warp, and between shear and weft
    BlockFloats longest{};                // length of warp and weft at the fabric's strain limit
    BlockFloats push{};                   // 1, or 0 where a seam gathers the cloth: compression is not resisted
    std::array<BlockFloats, 3> bias{};    // of warp, weft and shear: added to the strain that is seen
    BlockFloats stick{}, slip{};          // friction in shear: what it adds per strain beyond the anchor, and how far
    BlockFloats anchor{};                 // the strain may be from it before it follows
};

// Shares of what meets the conditions at once that a visit takes. With all of a leaf's, neighbours that share vertices
// drive each other to and fro, and every sub-step turns that into speed; of a refined triangle's excess half, for what
// is left the levels below see.
inline constexpr float kLeafShare = 0.75F;
inline constexpr float kLimitShare = 0.5F;

// kappa, the share of the corrections of stretch and shear that a vertex makes again in the next sub-step, before the
// constraints are visited: what one visit cannot reach adds up over the sub-steps, 1 / (1 - kappa) times as far. A
// visit that takes a small share of a mode's error is stable with it below 1/2 (the roots of (z - kappa)(z^2 - 2 z + 1)
// + beta kappa z^2 for beta to 0). So the constraints themselves have (1 - kappa) of the fabric's stiffness. It needs
// no state of constraints, so nothing is handed over when the mesh changes.
inline constexpr float kMomentum = 0.3F;

inline constexpr std::uint32_t kNoPlace = 0;
inline std::uint32_t place_of(TriangleId t) {
    return 4 * (t.value + 1);
}

// What is needed now and then besides: the last multipliers of warp, weft and shear, and the compliances over a
// sub-step.
struct alignas(64) StretchRecord {
    std::array<BlockFloats, 3> multiplier{};
    std::array<BlockFloats, 3> compliance{};
    BlockPoints parent{};   // the place of what carries the leaf's tension with it, in RestrictedStress
    BlockFloats of_area{};  // the leaf's, of its parent's
};

// However cloth folds, the flat triangle through three of its points stretches a thread hardly more than the cloth is
// stretched: a refined triangle is a one-sided limit. Its corners weigh what hangs on them, so that it carries
// with ease what the leaves in it can not: it has a bias too, and what it carries counts as stress of the leaves.
struct alignas(64) LimitBlock {
    std::array<BlockPoints, 3> vertices{};
    std::array<BlockFloats, 2> a{}, b{};
    BlockFloats longest_warp{}, longest_weft{};  // lengths of the directions above which they are taken back
    BlockFloats shear{};                         // multiplier of shear, as far as the tensions allow it
    std::array<BlockFloats, 2> gain{};           // multipliers of warp and weft per unit of excess
    std::array<BlockFloats, 3> warp{}, weft{};   // what each vertex moves along the direction per unit of multiplier, m
};

// What update_parents needs besides. Stress is by the stiffness: the strain that the fabric should have.
struct alignas(64) LimitRecord {
    BlockPoints place{}, parent{};             // places in RestrictedStress
    BlockFloats of_area{};                     // the triangle's, of its parent's
    std::array<BlockFloats, 2> free_length{};  // of warp and weft: the length that they may have without any bias
    std::array<BlockFloats, 3> bias{};         // how much shorter than that they are held; and of shear
    std::array<BlockFloats, 3> multiplier{};   // the last ones, of warp, weft and shear
    std::array<BlockFloats, 3> compliance{};   // over a sub-step
    std::array<BlockFloats, 3> per_stress{};   // bias that makes a unit of stress
    BlockFloats per_shear{};                   // multiplier that a unit of the bias of shear makes
    BlockFloats easy_shear{};                  // stress that what is inside carries well by itself
};

// Copies of the lanes of stretch blocks of one colour that were beyond the fabric's strain limit, side by side.
struct alignas(64) OverBlock {
    std::array<BlockPoints, 3> vertices{};
    std::array<BlockFloats, 2> a{}, b{};
    BlockFloats warp{}, weft{};
    BlockFloats longest{};
};

// Sums over warp, weft and shear, and a spare: of each triangle behind its id, and first a place for no triangle.
struct RestrictedStress {
    std::vector<Vec4f> above;  // stress that a refined triangle and all that it is inside of carry
    std::vector<Vec4f> below;  // scratch: mean stress of what is inside of it
    std::vector<Vec4f> off;    // scratch: mean strain of warp and weft that the leaves in it are off by
};

// Of a triangle of which no bending is asked: more than any interval of visits.
inline constexpr float kNeverVisited = 8;

// Bending of a triangle: its curvature is a fixed linear map of the angles of its three hinges (curvature_map.h), its
// energy 1/2 area k' D k with the rigidities D along warp, weft and of twist; the three hinges are solved together, as
// compliant constraints. Hinge i is the edge from corner i + 1 to corner i + 2. Multipliers are of moments times a
// sub-step's square, N m s^2.
//
// Internal friction acts on the curvatures along warp, weft and of twist: a spring from each to an anchor, which
// follows where the spring would pull harder than the fabric's friction (Prandtl's element, Jenkins' cell).
struct alignas(64) BendBlock {
    std::array<BlockPoints, 6> vertices{};  // the corners, then the apex beyond each edge; where there is none the
                                            // corner opposite to the edge
    std::array<BlockFloats, 3> own{},
        beyond{};  // 1 / height of corner and apex over the edge at rest, 1/m; 0: no hinge
    std::array<BlockFloats, 3> own_foot{},
        beyond_foot{};                     // of those heights along the edge: 0 at its beginning, 1 at its end
    std::array<BlockFloats, 6> gain{};     // multiplier per angle, symmetric: 00 11 22 01 02 12
    BlockFloats realised{};                // share of the fabric's rigidity that its visits make
    BlockFloats interval{};                // sub-steps from one visit to the next: 1, 2 or kNeverVisited
    BlockFloats has_friction{};            // 1 or 0: what follows is of those
    std::array<BlockFloats, 9> map{};      // curvature per angle, by rows: warp, weft, 2 twist; 1/m
    std::array<BlockFloats, 9> settled{};  // the same per angle that is seen, when all have had their turn
    std::array<BlockFloats, 3> stick{};    // multiplier per curvature beyond the anchor
    std::array<BlockFloats, 3> slip{};     // 1/m, how far a curvature may be from its anchor before that follows
    std::array<BlockFloats, 3> anchor{};   // 1/m
};

// The same of a refined triangle. Its vertices weigh what follows them: one visit of a triangle makes at most a
// stiffness that its masses can follow within a sub-step, and there coarse triangles can do 16 times as much as those
// of the next level. So every triangle takes of the rigidity and friction what it can, and hands the rest up.
struct alignas(64) CoarseBendBlock : BendBlock {
    std::array<BlockFloats, 6> inverse_mass{};  // 1/kg, of the vertices
};

// What weighing needs besides: figures of the fabric over a sub-step, for the whole of the rigidity.
struct alignas(64) BendRecord {
    std::array<BlockFloats, 6> stiffness{};  // multiplier per angle, symmetric as BendBlock::gain
    std::array<BlockFloats, 3> rigidity{};   // multiplier per curvature, of warp, weft and twist by themselves
    std::array<BlockFloats, 3> friction{};   // multiplier at most
    BlockPoints parent{};                    // place of the refined triangle that it is inside of, or kNoPlace
    BlockFloats of_area{};                   // the triangle's, of its parent's
    BlockFloats asked{};                     // share of the rigidity: 1 of leaves, else what was handed up
    BlockFloats handed_up{};                 // what is left of that
};

// Friction's springs are that much stiffer than the fabric: it slips at a small part of the curvatures or shears over
// which its loop is measured, and the solver need not follow anything harder.
inline constexpr float kStick = 4;

// The centre of a split edge: it follows what the ends are moved. Offsets as in BlockPoints.
struct EdgeCentre {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t centre = 0;
};

inline constexpr std::uint32_t kSpare = UINT32_MAX;

// Single lanes of blocks: rows of sixteen values of four bytes, `vertices` the first of them.

// Spare lanes stand on a point of its own behind those of the mesh, which cannot move.
template <class Block>
Block spare_block(std::size_t spare_point) {
    Block block{};
    for (BlockPoints& points : block.vertices) points.fill(static_cast<std::uint32_t>(4 * spare_point));
    if constexpr (std::is_same_v<Block, StretchBlock> || std::is_same_v<Block, OverBlock>)
        block.longest.fill(std::numeric_limits<float>::max());
    if constexpr (std::is_same_v<Block, StretchBlock>) block.push.fill(1);  // not gathered
    if constexpr (std::is_same_v<Block, LimitBlock>) {
        block.longest_warp.fill(1);
        block.longest_weft.fill(1);
    }
    return block;
}

// Compliances that only keep the gains of spare lanes finite.
template <class Record>
Record spare_record() {
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
void copy_lane(const Block& from, Block& to, std::size_t at) {
    constexpr std::size_t kValue = sizeof(float), kRow = kBlock * kValue;
    static_assert(sizeof(Block) % kRow == 0 && std::is_trivially_copyable_v<Block>);
    const auto* source = static_cast<const std::byte*>(static_cast<const void*>(&from));
    auto* target = static_cast<std::byte*>(static_cast<void*>(&to));
    for (std::size_t place = at * kValue; place < sizeof(Block); place += kRow) {
        std::memcpy(target + place, source + place, kValue);
    }
}

// Three figures of one lane.
inline Vec3f lane_of(const std::array<BlockFloats, 3>& rows, std::size_t at) {
    return {rows[0][at], rows[1][at], rows[2][at]};
}
inline void set_lane(std::array<BlockFloats, 3>& rows, std::size_t at, const Vec3f& values) {
    for (std::size_t k = 0; k < 3; ++k) rows[k][at] = values[static_cast<Eigen::Index>(k)];
}

// Vertex indices.
template <class Block>
auto corners_at(const Block& block, std::size_t at) {
    std::array<std::uint32_t, std::tuple_size_v<decltype(Block::vertices)>> corners{};
    for (std::size_t k = 0; k < corners.size(); ++k) corners[k] = block.vertices[k][at] / 4;
    return corners;
}

}  // namespace selvedge::sim
