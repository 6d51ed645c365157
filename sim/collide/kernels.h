#pragma once
// Inner loops of the distance field and the surface tree, compiled once per SimdLevel and selected at run time.
#include <cstddef>
#include <cstdint>

#include "sim/core/simd_level.h"

namespace selvedge::sim {

// A DistanceField as plain data. Kernels use no inline code of the rest of the program, because each is compiled for
// another instruction set.
struct FieldView {
    const std::int32_t* blocks;  // index of each block's first node; blocks beyond the band share one per sign
    const std::int16_t* nodes;
    float origin[3];       // m
    float last[3];         // cells along each axis, rounded down to the next float
    std::int32_t size[2];  // blocks along x and y
    float per_cell;        // cells per m
    float to_metres;       // scale of a node's value
    float to_gradient;     // scale of the difference of two adjacent nodes
    float band;            // m
    float trusted;         // minimum length of a reliable gradient
};

struct CollideKernels {
    // `rows` is an array of ContactBlock. Writes distance and normal of each slot; doubtful[block] gets a bit for each
    // slot that is nearer than `reach` and has no reliable gradient.
    void (*sample_blocks)(const FieldView& field, float* rows, std::size_t blocks, float reach,
                          std::uint16_t* doubtful);

    // Squared distances from a point to eight triangles. packet: the nine rows of floats of a TrianglePacket; p: x, y,
    // z; squared: output, eight values, m^2. Returns a bit for each triangle whose squared distance is below `limit`
    // (m^2).
    unsigned (*squared_distances)(const float* packet, const float* p, float limit, float* squared);

    // Updates the nearest triangles of sixteen nearby points with eight triangles. packet: as above; ids: its
    // triangles; box: low x, y, z and high x, y, z of the bounding box of the packet. rows: x, y, z of sixteen points
    // (m) and their smallest squared distances so far (m^2); nearest: the triangles of those distances. Updates the
    // distances and `nearest`. Returns the largest of the sixteen squared distances.
    float (*nearest_in_packet)(const float* packet, const std::uint32_t* ids, const float* box, float* rows,
                               std::uint32_t* nearest);

    // Writes the nine rows of a packet for moved triangles to `moved`. packet: its rows where they are; ids: its eight
    // triangles; corners: three vertices per triangle of the surface; end: x, y, z per vertex where they will be (m).
    // box: output, low x, y, z and high x, y, z of the triangles where they are, and where they will be less `drift`.
    void (*sweep_packet)(const float* packet, const std::uint32_t* ids, const std::uint32_t* corners, const float* end,
                         const float* drift, float* moved, float* box);
};

const CollideKernels& collide_kernels(SimdLevel level);

// The kernels of one level, defined by the compilation of kernels_simd.cpp for that level.
template <SimdLevel>
const CollideKernels& collide_kernels_of();

}  // namespace selvedge::sim
