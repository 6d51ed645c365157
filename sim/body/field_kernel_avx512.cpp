#include "sim/body/field_kernel_lanes.h"

namespace selvedge {
namespace {

struct Mine;

}  // namespace

void sample_blocks_avx512(const FieldView& field, float* rows, std::size_t blocks, float reach,
                          std::uint16_t* doubtful) {
    sample_blocks<Mine>(field, rows, blocks, reach, doubtful);
}

}  // namespace selvedge
