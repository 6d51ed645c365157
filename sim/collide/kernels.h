#pragma once
// The inner loops of distance field and tree: written once, compiled for each SimdLevel and chosen at run time.
#include <cstddef>
#include <cstdint>

#include "sim/core/simd_level.h"

namespace selvedge::sim {

// What a kernel needs of a DistanceField; plain memory, for kernels share no code with the rest of the program.
struct FieldView {
    const std::int32_t* blocks;  // first node of each block; blocks wholly outside or inside share one of their own
    const std::int16_t* nodes;
    float origin[3];       // m
    float last[3];         // cells along each axis, less a hair
    std::int32_t size[2];  // blocks along x and y
    float per_cell;        // cells per m
    float to_metres;       // of a node's value
    float to_gradient;     // of the difference of two neighbours
    float band;            // m
    float trusted;         // least length of a gradient that can be
};

struct CollideKernels {
    // `rows` is an array of ContactBlock. Fills distance and normal of each lane; doubtful[block] gets a bit for each
    // lane that lies nearer than `reach` and whose gradient cannot be trusted.
    void (*sample_blocks)(const FieldView& field, float* rows, std::size_t blocks, float reach,
                          std::uint16_t* doubtful);

    // Squared distances from a point to eight triangles. packet: a TrianglePacket's nine rows of floats; p: x, y, z;
    // squared: eight, m^2. Returns a bit for each triangle nearer than the root of `limit`.
    unsigned (*squared_distances)(const float* packet, const float* p, float limit, float* squared);

    // Sixteen points that lie together against eight triangles. packet: as above; ids: its triangles; box: low x, y, z
    // and high x, y, z of what holds them. rows: x, y, z of sixteen points and the squared distances of what is nearest
    // to each so far, m and m^2; nearest: which triangles those are. Both are brought up to date. Returns the largest
    // of the squared distances.
    float (*nearest_in_packet)(const float* packet, const std::uint32_t* ids, const float* box, float* rows,
                               std::uint32_t* nearest);
};

const CollideKernels& collide_kernels(SimdLevel level);

// Those of one level; each is defined by the compilation of kernels_simd.cpp for that level.
template <SimdLevel>
const CollideKernels& collide_kernels_of();

}  // namespace selvedge::sim
