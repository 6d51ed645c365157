#pragma once
// Squared distances from a point to eight triangles: one kernel, compiled for each SimdLevel that has eight lanes or
// fewer.  (SPEC 3.3)

namespace selvedge {

// packet: a TrianglePacket's nine rows of floats; p: x, y, z; squared: eight, m^2. Returns a bit for each triangle
// nearer than the root of `limit`.
using PacketKernel = unsigned (*)(const float* packet, const float* p, float limit, float* squared);

PacketKernel packet_kernel();  // for the SimdLevel in force

unsigned squared_distances_plain(const float* packet, const float* p, float limit, float* squared);
unsigned squared_distances_avx2(const float* packet, const float* p, float limit, float* squared);

}  // namespace selvedge
