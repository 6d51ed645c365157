#pragma once
// Squared distances from a point to eight triangles: one kernel, compiled for each SimdLevel that has eight lanes or
// fewer.  (SPEC 3.3)

namespace selvedge {

// packet: a TrianglePacket's nine rows of floats; p: x, y, z; squared: eight, m^2.
using PacketKernel = void (*)(const float* packet, const float* p, float* squared);

PacketKernel packet_kernel();  // for the SimdLevel in force

void squared_distances_plain(const float* packet, const float* p, float* squared);
void squared_distances_avx2(const float* packet, const float* p, float* squared);

}  // namespace selvedge
