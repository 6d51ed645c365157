#include "sim/body/group_kernel_lanes.h"

namespace selvedge {
namespace {

struct Mine;

}  // namespace

float nearest_in_packet_avx2(const float* packet, const std::uint32_t* ids, const float* box, float* rows,
                             std::uint32_t* nearest) {
    return nearest_in_packet<Mine>(packet, ids, box, rows, nearest);
}

}  // namespace selvedge
