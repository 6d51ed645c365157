#pragma once
// Sixteen points that lie together against eight triangles: one kernel, compiled for each SimdLevel.  (SPEC 3.3)
#include <cstdint>

namespace selvedge {

// packet: a TrianglePacket's nine rows of floats; ids: its triangles; box: low x, y, z and high x, y, z of what holds
// them. rows: x, y, z of sixteen points and the squared distances of what is nearest to each so far, m and m^2;
// nearest: which triangles those are. Both are brought up to date. Returns the largest of the squared distances.
using GroupKernel = float (*)(const float* packet, const std::uint32_t* ids, const float* box, float* rows,
                              std::uint32_t* nearest);

GroupKernel group_kernel();  // for the SimdLevel in force

float nearest_in_packet_plain(const float* packet, const std::uint32_t* ids, const float* box, float* rows,
                              std::uint32_t* nearest);
float nearest_in_packet_avx2(const float* packet, const std::uint32_t* ids, const float* box, float* rows,
                             std::uint32_t* nearest);
float nearest_in_packet_avx512(const float* packet, const std::uint32_t* ids, const float* box, float* rows,
                               std::uint32_t* nearest);

}  // namespace selvedge
