#pragma once
// The kernel of field_kernel.h, written once for any number of lanes. Operations stand in the order of
// DistanceField::sample(), so that both give the same bits.
#include "sim/body/field_kernel.h"
#include "sim/core/simd_lanes.h"

namespace selvedge {

// Rows of a ContactBlock.
enum FieldRow { kRowX, kRowY, kRowZ, kRowDistance, kRowNormalX, kRowNormalY, kRowNormalZ, kRows };
inline constexpr std::size_t kRowLength = 16;
inline constexpr std::int32_t kFieldCells = 8;  // per block and axis
inline constexpr std::int32_t kFieldNodes = kFieldCells + 1;

struct LaneCell {
    lanes::Ints cell;
    lanes::Floats within;  // 0..1
};

// A point beyond the grid, or none at all, comes to lie in the grid's rim, which is outside.
[[gnu::always_inline]] inline LaneCell cell_of(const FieldView& field, int axis, const float* row) {
    lanes::Floats at = (lanes::load(row) - field.origin[axis]) * field.per_cell;
    at = lanes::lesser(lanes::greater(at, lanes::all(0)), lanes::all(field.last[axis]));
    const lanes::Ints cell = lanes::truncated(at);
    return {cell, at - lanes::to_float(cell)};
}

// Place of the cell's lowest node.
[[gnu::always_inline]] inline lanes::Ints node_of(const FieldView& field, lanes::Ints i, lanes::Ints j, lanes::Ints k) {
    const lanes::Ints place = (i >> 3) + field.size[0] * ((j >> 3) + field.size[1] * (k >> 3));
    constexpr std::int32_t kWithin = kFieldCells - 1;
    return lanes::gather(field.blocks, place) + (i & kWithin) +
           kFieldNodes * ((j & kWithin) + kFieldNodes * (k & kWithin));
}

struct LaneSample {
    lanes::Floats distance, x, y, z;  // in steps of a node's value
};

[[gnu::always_inline]] inline LaneSample trilinear(const std::int16_t* nodes, lanes::Ints node, lanes::Floats fx,
                                                   lanes::Floats fy, lanes::Floats fz) {
    constexpr std::int32_t kY = kFieldNodes;
    constexpr std::int32_t kZ = kFieldNodes * kFieldNodes;
    const lanes::Ints p00 = lanes::gather_pairs(nodes, node);
    const lanes::Ints p10 = lanes::gather_pairs(nodes + kY, node);
    const lanes::Ints p01 = lanes::gather_pairs(nodes + kZ, node);
    const lanes::Ints p11 = lanes::gather_pairs(nodes + kZ + kY, node);
    const lanes::Floats dx00 = lanes::second_of(p00) - lanes::first_of(p00);
    const lanes::Floats dx10 = lanes::second_of(p10) - lanes::first_of(p10);
    const lanes::Floats dx01 = lanes::second_of(p01) - lanes::first_of(p01);
    const lanes::Floats dx11 = lanes::second_of(p11) - lanes::first_of(p11);
    const lanes::Floats v00 = lanes::first_of(p00) + fx * dx00;
    const lanes::Floats v10 = lanes::first_of(p10) + fx * dx10;
    const lanes::Floats v01 = lanes::first_of(p01) + fx * dx01;
    const lanes::Floats v11 = lanes::first_of(p11) + fx * dx11;
    const lanes::Floats v0 = v00 + fy * (v10 - v00);
    const lanes::Floats v1 = v01 + fy * (v11 - v01);
    const lanes::Floats dx0 = dx00 + fy * (dx10 - dx00);
    const lanes::Floats dx1 = dx01 + fy * (dx11 - dx01);
    return {v0 + fz * (v1 - v0), dx0 + fz * (dx1 - dx0), (v10 - v00) + fz * ((v11 - v01) - (v10 - v00)), v1 - v0};
}

// One register of lanes; returns which of them are doubtful.
[[gnu::always_inline]] inline unsigned sample_lanes(const FieldView& field, float* row, float reach) {
    const LaneCell x = cell_of(field, 0, row + kRowX * kRowLength);
    const LaneCell y = cell_of(field, 1, row + kRowY * kRowLength);
    const LaneCell z = cell_of(field, 2, row + kRowZ * kRowLength);
    const LaneSample sample =
        trilinear(field.nodes, node_of(field, x.cell, y.cell, z.cell), x.within, y.within, z.within);

    const lanes::Floats band = lanes::all(field.band);
    const lanes::Floats distance = lanes::lesser(lanes::greater(sample.distance * field.to_metres, -band), band);
    const lanes::Floats gx = sample.x * field.to_gradient;
    const lanes::Floats gy = sample.y * field.to_gradient;
    const lanes::Floats gz = sample.z * field.to_gradient;
    const lanes::Floats length = lanes::root(gx * gx + gy * gy + gz * gz);
    const lanes::Ints is_known = (distance < band) & (distance > -band);
    const lanes::Ints has_normal = is_known & (length > 0);
    const lanes::Floats inverse = 1 / length;
    lanes::store(row + kRowDistance * kRowLength, distance);
    lanes::store(row + kRowNormalX * kRowLength, lanes::where(has_normal, gx * inverse));
    lanes::store(row + kRowNormalY * kRowLength, lanes::where(has_normal, gy * inverse));
    lanes::store(row + kRowNormalZ * kRowLength, lanes::where(has_normal, gz * inverse));
    const lanes::Ints is_asked = distance < lanes::lesser(lanes::all(reach), band);
    const lanes::Ints is_trusted = is_known & (length >= field.trusted);
    return lanes::bits(is_asked & ~is_trusted);
}

// To be called with a type of the source's own, that no other source can name.
template <class OwnedByOneSource>
void sample_blocks(FieldView field, float* rows, std::size_t blocks, float reach, std::uint16_t* doubtful) {
    for (std::size_t block = 0; block < blocks; ++block) {
        float* row = rows + block * kRows * kRowLength;
        unsigned found = 0;
        for (std::size_t i = 0; i < kRowLength; i += lanes::kCount) found |= sample_lanes(field, row + i, reach) << i;
        doubtful[block] = std::uint16_t(found);
    }
}

}  // namespace selvedge
