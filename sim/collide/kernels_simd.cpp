// The loops of kernels.h for any number of SIMD lanes. CMake compiles this source once for each SimdLevel, so
// everything but the last function has internal linkage (sim/core/simd_level.h).
#include <cstddef>
#include <cstdint>

#include "sim/collide/kernels.h"
#include "sim/core/simd_lanes.h"

namespace selvedge::sim {
namespace {

// Distance field sampling. The order of operations is that of DistanceField::sample(), so that both give the same bits.

// Rows of a ContactBlock.
constexpr std::size_t kRowX = 0, kRowY = 1, kRowZ = 2, kRowDistance = 3;
constexpr std::size_t kRowNormalX = 4, kRowNormalY = 5, kRowNormalZ = 6, kRows = 7;
constexpr std::size_t kRowLength = 16;
constexpr std::int32_t kFieldCells = 8;  // per block and axis
constexpr std::int32_t kFieldNodes = kFieldCells + 1;

struct LaneCell {
    lanes::Ints cell;
    lanes::Floats within;  // 0..1
};

// A point outside the grid, or NaN, is clamped to the grid's rim, which is outside the band.
[[gnu::always_inline]] inline LaneCell cell_of(const FieldView& field, int axis, const float* row) {
    lanes::Floats at = (lanes::load(row) - field.origin[axis]) * field.per_cell;
    at = lanes::min(lanes::max(at, lanes::broadcast(0)), lanes::broadcast(field.last[axis]));
    const lanes::Ints cell = lanes::truncated(at);
    return {cell, at - lanes::to_float(cell)};
}

// Index of the cell's lowest node.
[[gnu::always_inline]] inline lanes::Ints node_of(const FieldView& field, lanes::Ints i, lanes::Ints j, lanes::Ints k) {
    const lanes::Ints place = (i >> 3) + field.size[0] * ((j >> 3) + field.size[1] * (k >> 3));
    constexpr std::int32_t kWithin = kFieldCells - 1;
    return lanes::gather(field.blocks, place) + (i & kWithin) +
           kFieldNodes * ((j & kWithin) + kFieldNodes * (k & kWithin));
}

struct LaneSample {
    lanes::Floats distance, x, y, z;  // in units of a node's value
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

// Samples one register of lanes; returns a bit for each doubtful one.
[[gnu::always_inline]] inline unsigned sample_lanes(const FieldView& field, float* row, float reach) {
    const LaneCell x = cell_of(field, 0, row + kRowX * kRowLength);
    const LaneCell y = cell_of(field, 1, row + kRowY * kRowLength);
    const LaneCell z = cell_of(field, 2, row + kRowZ * kRowLength);
    const LaneSample sample =
        trilinear(field.nodes, node_of(field, x.cell, y.cell, z.cell), x.within, y.within, z.within);

    const lanes::Floats band = lanes::broadcast(field.band);
    const lanes::Floats distance = lanes::min(lanes::max(sample.distance * field.to_metres, -band), band);
    const lanes::Floats gx = sample.x * field.to_gradient;
    const lanes::Floats gy = sample.y * field.to_gradient;
    const lanes::Floats gz = sample.z * field.to_gradient;
    const lanes::Floats length = lanes::sqrt(gx * gx + gy * gy + gz * gz);
    const lanes::Ints is_known = (distance < band) & (distance > -band);
    const lanes::Ints has_normal = is_known & (length > 0);
    const lanes::Floats inverse = 1 / length;
    lanes::store(row + kRowDistance * kRowLength, distance);
    lanes::store(row + kRowNormalX * kRowLength, lanes::where(has_normal, gx * inverse));
    lanes::store(row + kRowNormalY * kRowLength, lanes::where(has_normal, gy * inverse));
    lanes::store(row + kRowNormalZ * kRowLength, lanes::where(has_normal, gz * inverse));
    const lanes::Ints is_near = distance < lanes::min(lanes::broadcast(reach), band);
    const lanes::Ints is_trusted = is_known & (length >= field.trusted);
    return lanes::bits(is_near & ~is_trusted);
}

void sample_blocks(const FieldView& view, float* rows, std::size_t blocks, float reach, std::uint16_t* doubtful) {
    const FieldView field = view;  // a copy, which cannot alias the rows that are written
    for (std::size_t block = 0; block < blocks; ++block) {
        float* row = rows + block * kRows * kRowLength;
        unsigned found = 0;
        for (std::size_t i = 0; i < kRowLength; i += lanes::kCount) found |= sample_lanes(field, row + i, reach) << i;
        doubtful[block] = std::uint16_t(found);
    }
}

// Sixteen points against eight triangles.

constexpr std::size_t kGroupPoints = 16;
constexpr std::size_t kGroupTriangles = 8;

// Values that are equal for all points: products of a triangle's edges, and reciprocals.
struct TriangleProducts {
    float bb[kGroupTriangles], cc[kGroupTriangles], bc[kGroupTriangles];
    float per_bb[kGroupTriangles], per_cc[kGroupTriangles], per_third[kGroupTriangles], per_area[kGroupTriangles];
};

[[gnu::always_inline]] inline void multiply_edges(const float* packet, TriangleProducts& to) {
    constexpr float kTiny = 1e-30F;  // keeps quotients finite for slivers
    const float* b = packet + 3 * kGroupTriangles;
    const float* c = packet + 6 * kGroupTriangles;
    constexpr std::size_t kY = kGroupTriangles;
    constexpr std::size_t kZ = 2 * kGroupTriangles;
    for (std::size_t i = 0; i < kGroupTriangles; ++i) {
        const float bb = b[i] * b[i] + b[kY + i] * b[kY + i] + b[kZ + i] * b[kZ + i];
        const float cc = c[i] * c[i] + c[kY + i] * c[kY + i] + c[kZ + i] * c[kZ + i];
        const float bc = b[i] * c[i] + b[kY + i] * c[kY + i] + b[kZ + i] * c[kZ + i];
        to.bb[i] = bb;
        to.cc[i] = cc;
        to.bc[i] = bc;
        to.per_bb[i] = 1 / (bb + kTiny);
        to.per_cc[i] = 1 / (cc + kTiny);
        to.per_third[i] = 1 / (bb + cc - 2 * bc + kTiny);
        to.per_area[i] = 1 / (bb * cc - bc * bc + kTiny);
    }
}

struct LanePoints {
    lanes::Floats x, y, z;
};

// Branch-free: the projection onto the plane when it is inside the triangle, else the nearest of the three edges.
[[gnu::always_inline]] inline lanes::Floats squared_distance_to(const float* packet, const TriangleProducts& products,
                                                                std::size_t i, const LanePoints& p) {
    using lanes::Floats;
    const float* row = packet + i;
    const float bx = row[3 * kGroupTriangles], by = row[4 * kGroupTriangles], bz = row[5 * kGroupTriangles],
                cx = row[6 * kGroupTriangles], cy = row[7 * kGroupTriangles], cz = row[8 * kGroupTriangles];
    const float bb = products.bb[i], cc = products.cc[i], bc = products.bc[i];

    const Floats x = p.x - row[0 * kGroupTriangles], y = p.y - row[1 * kGroupTriangles],
                 z = p.z - row[2 * kGroupTriangles];
    const Floats d1 = bx * x + by * y + bz * z;
    const Floats d2 = cx * x + cy * y + cz * z;
    const Floats v = (cc * d1 - bc * d2) * products.per_area[i];
    const Floats w = (bb * d2 - bc * d1) * products.per_area[i];
    const Floats t1 = lanes::clamp_to_unit(d1 * products.per_bb[i]);
    const Floats t2 = lanes::clamp_to_unit(d2 * products.per_cc[i]);
    const Floats t3 = lanes::clamp_to_unit((d2 - d1 - bc + bb) * products.per_third[i]);
    const Floats r3 = 1 - t3;
    const Floats g1 = t1 * (t1 * bb - 2 * d1);
    const Floats g2 = t2 * (t2 * cc - 2 * d2);
    const Floats g3 = r3 * (r3 * bb - 2 * d1) + t3 * (t3 * cc - 2 * d2) + 2 * r3 * t3 * bc;
    const auto on_third = g3 < lanes::min(g1, g2);
    const auto on_first = g1 <= g2;
    const Floats edge_v = on_third ? r3 : lanes::where(on_first, t1);
    const Floats edge_w = on_third ? t3 : lanes::where(~on_first, t2);
    const auto is_inside = lanes::min(lanes::min(v, w), 1 - v - w) >= lanes::broadcast(0);
    const Floats s = is_inside ? v : edge_v;
    const Floats t = is_inside ? w : edge_w;
    const Floats rx = x - s * bx - t * cx, ry = y - s * by - t * cy, rz = z - s * bz - t * cz;
    return rx * rx + ry * ry + rz * rz;
}

[[gnu::always_inline]] inline lanes::Floats squared_distance_to_box(const float* box, const LanePoints& p) {
    using lanes::Floats;
    const Floats zero = lanes::broadcast(0);
    const Floats x = lanes::max(zero, lanes::max(box[0] - p.x, p.x - box[3]));
    const Floats y = lanes::max(zero, lanes::max(box[1] - p.y, p.y - box[4]));
    const Floats z = lanes::max(zero, lanes::max(box[2] - p.z, p.z - box[5]));
    return x * x + y * y + z * z;
}

[[gnu::always_inline]] inline LanePoints points_in(const float* rows, std::size_t lane) {
    return {lanes::load(rows + lane), lanes::load(rows + kGroupPoints + lane),
            lanes::load(rows + 2 * kGroupPoints + lane)};
}

// Whether the box is nearer to any of the points than that point's nearest triangle so far.
[[gnu::always_inline]] inline bool may_be_nearer(const float* box, const float* rows) {
    unsigned nearer = 0;
    for (std::size_t lane = 0; lane < kGroupPoints; lane += lanes::kCount)
        nearer |= lanes::bits(squared_distance_to_box(box, points_in(rows, lane)) <
                              lanes::load(rows + 3 * kGroupPoints + lane));
    return nearer != 0;
}

[[gnu::always_inline]] inline float largest_of(const float* row) {
    float largest = row[0];
    for (std::size_t i = 1; i < kGroupPoints; ++i) largest = row[i] > largest ? row[i] : largest;
    return largest;
}

float nearest_in_packet(const float* packet, const std::uint32_t* ids, const float* box, float* rows,
                        std::uint32_t* nearest) {
    float* squares = rows + 3 * kGroupPoints;
    if (!may_be_nearer(box, rows)) return largest_of(squares);
    TriangleProducts products;
    multiply_edges(packet, products);
    for (std::size_t lane = 0; lane < kGroupPoints; lane += lanes::kCount) {
        const LanePoints p = points_in(rows, lane);
        lanes::Floats best = lanes::load(squares + lane);
        lanes::Ints which = lanes::load_ints(nearest + lane);
        for (std::size_t i = 0; i < kGroupTriangles; ++i) {
            const lanes::Floats squared = squared_distance_to(packet, products, i, p);
            const lanes::Ints is_nearer = squared < best;
            best = is_nearer ? squared : best;
            which = is_nearer ? lanes::broadcast_ints(std::int32_t(ids[i])) : which;
        }
        lanes::store(squares + lane, best);
        lanes::store_ints(nearest + lane, which);
    }
    return largest_of(squares);
}

// One point against eight triangles.

// Branch-free, as squared_distance_to().
[[gnu::always_inline]] inline lanes::Floats squared_distances(const float* row, const float* p) {
    using lanes::Floats;
    constexpr std::size_t kRow = 8;
    const Floats tiny = lanes::broadcast(1e-30F);  // keeps quotients finite for slivers

    const Floats x = p[0] - lanes::load(row), y = p[1] - lanes::load(row + kRow),
                 z = p[2] - lanes::load(row + 2 * kRow);
    const Floats bx = lanes::load(row + 3 * kRow), by = lanes::load(row + 4 * kRow), bz = lanes::load(row + 5 * kRow);
    const Floats cx = lanes::load(row + 6 * kRow), cy = lanes::load(row + 7 * kRow), cz = lanes::load(row + 8 * kRow);
    const Floats d1 = bx * x + by * y + bz * z;
    const Floats d2 = cx * x + cy * y + cz * z;
    const Floats bb = bx * bx + by * by + bz * bz;
    const Floats cc = cx * cx + cy * cy + cz * cz;
    const Floats bc = bx * cx + by * cy + bz * cz;
    const Floats area = bb * cc - bc * bc;
    const Floats v = cc * d1 - bc * d2;
    const Floats w = bb * d2 - bc * d1;
    const Floats t1 = lanes::clamp_to_unit(d1 / (bb + tiny));
    const Floats t2 = lanes::clamp_to_unit(d2 / (cc + tiny));
    const Floats t3 = lanes::clamp_to_unit((d2 - d1 - bc + bb) / (bb + cc - 2 * bc + tiny));
    const Floats r3 = 1 - t3;
    const Floats g1 = t1 * (t1 * bb - 2 * d1);
    const Floats g2 = t2 * (t2 * cc - 2 * d2);
    const Floats g3 = r3 * (r3 * bb - 2 * d1) + t3 * (t3 * cc - 2 * d2) + 2 * r3 * t3 * bc;
    const auto on_third = g3 < lanes::min(g1, g2);
    const auto on_first = g1 <= g2;
    const Floats edge_v = on_third ? r3 : lanes::where(on_first, t1);
    const Floats edge_w = on_third ? t3 : lanes::where(~on_first, t2);
    const Floats inverse = 1 / (area + tiny);
    const auto is_inside = lanes::min(lanes::min(v, w), area - v - w) >= lanes::broadcast(0);
    const Floats s = is_inside ? v * inverse : edge_v;
    const Floats t = is_inside ? w * inverse : edge_w;
    const Floats rx = x - s * bx - t * cx, ry = y - s * by - t * cy, rz = z - s * bz - t * cz;
    return rx * rx + ry * ry + rz * rz;
}

unsigned nearer_triangles(const float* packet, const float* p, float limit, float* squared) {
    constexpr std::size_t kTriangles = 8;
    unsigned nearer = 0;
    for (std::size_t i = 0; i < kTriangles; i += lanes::kCount) {
        const lanes::Floats squares = squared_distances(packet + i, p);
        lanes::store(squared + i, squares);
        nearer |= lanes::bits(squares < limit) << i;
    }
    return nearer;
}

void sweep_packet(const float* packet, const std::uint32_t* ids, const std::uint32_t* corners, const float* end,
                  const float* drift, float* moved, float* box) {
    constexpr std::size_t kLanes = kGroupTriangles;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        float a[kLanes], b[kLanes], c[kLanes];  // corners at the end
        for (std::size_t i = 0; i < kLanes; ++i) {
            const std::uint32_t* triangle = corners + 3 * ids[i];
            a[i] = end[3 * triangle[0] + axis];
            b[i] = end[3 * triangle[1] + axis];
            c[i] = end[3 * triangle[2] + axis];
        }
        const float *start = packet + axis * kLanes, *edge1 = packet + (3 + axis) * kLanes,
                    *edge2 = packet + (6 + axis) * kLanes;
        float low[kLanes], high[kLanes];
        for (std::size_t i = 0; i < kLanes; ++i) {
            moved[axis * kLanes + i] = a[i];
            moved[(3 + axis) * kLanes + i] = b[i] - a[i];
            moved[(6 + axis) * kLanes + i] = c[i] - a[i];
            const float p = start[i], q = start[i] + edge1[i], r = start[i] + edge2[i];
            const float x = a[i] - drift[axis], y = b[i] - drift[axis], z = c[i] - drift[axis];
            const auto least = [](float u, float v) { return u < v ? u : v; };
            const auto most = [](float u, float v) { return u > v ? u : v; };
            low[i] = least(least(least(p, q), r), least(least(x, y), z));
            high[i] = most(most(most(p, q), r), most(most(x, y), z));
        }
        box[axis] = low[0];
        box[axis + 3] = high[0];
        for (std::size_t i = 1; i < kLanes; ++i) {
            box[axis] = low[i] < box[axis] ? low[i] : box[axis];
            box[axis + 3] = high[i] > box[axis + 3] ? high[i] : box[axis + 3];
        }
    }
}

constexpr CollideKernels kKernels{.sample_blocks = sample_blocks,
                                  .squared_distances = lanes::kCount <= kGroupTriangles ? nearer_triangles : nullptr,
                                  .nearest_in_packet = nearest_in_packet,
                                  .sweep_packet = sweep_packet};

}  // namespace

template <>
const CollideKernels& collide_kernels_of<lanes::kLevel>() {
    return kKernels;
}

}  // namespace selvedge::sim
