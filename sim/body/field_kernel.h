#pragma once
// Sixteen points in a distance field at once: one kernel, compiled for each SimdLevel.  (SPEC 3.3)
#include <cstddef>
#include <cstdint>

namespace selvedge {

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

// `rows` is an array of ContactBlock. Fills distance and normal of each lane; doubtful[block] gets a bit for each lane
// that lies nearer than `reach` and whose gradient cannot be trusted.
void sample_blocks_plain(const FieldView& field, float* rows, std::size_t blocks, float reach, std::uint16_t* doubtful);
void sample_blocks_avx2(const FieldView& field, float* rows, std::size_t blocks, float reach, std::uint16_t* doubtful);
void sample_blocks_avx512(const FieldView& field, float* rows, std::size_t blocks, float reach,
                          std::uint16_t* doubtful);

}  // namespace selvedge
