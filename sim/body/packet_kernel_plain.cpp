#include "sim/body/packet_kernel_lanes.h"

namespace selvedge {
namespace {

struct Mine;

}  // namespace

void squared_distances_plain(const float* packet, const float* p, float* squared) {
    squared_distances_of<Mine>(packet, p, squared);
}

}  // namespace selvedge
