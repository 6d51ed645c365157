#include "sim/body/packet_kernel_lanes.h"

namespace selvedge {
namespace {

struct Mine;

}  // namespace

unsigned squared_distances_plain(const float* packet, const float* p, float limit, float* squared) {
    return squared_distances_of<Mine>(packet, p, limit, squared);
}

}  // namespace selvedge
