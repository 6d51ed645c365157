#include "sim/collide/stored_field.h"

#include <string>
#include <utility>
#include <vector>

#include "sim/core/flat_bytes.h"
#include "sim/core/simd_level.h"

namespace selvedge::sim {
namespace {

// The level of SIMD belongs to it, because plain kernels differ from the others by rounding. AVX2 and AVX-512 give
// identical bits, so machines of both kinds share their fields.
std::string made_from(const SurfaceBvh& bvh, const DistanceFieldOptions& options) {
    FlatWriter writer;
    writer.value(simd_level() == SimdLevel::Plain);
    writer.value(options.cell);
    writer.value(options.band);
    writer.list(std::vector(bvh.points().begin(), bvh.points().end()));
    writer.list(std::vector(bvh.triangles().begin(), bvh.triangles().end()));
    return writer.bytes();
}

}  // namespace

DistanceField stored_field(const SurfaceBvh& bvh, const DistanceFieldOptions& options,
                           const std::function<void()>& interrupt, const ContentStore* store) {
    const auto make = [&] { return DistanceField(bvh, options, interrupt); };
    if (store == nullptr) return make();
    return find_or_make(
        store, "field", made_from(bvh, options), make, [](const DistanceField& field) { return field.to_bytes(); },
        DistanceField::from_bytes);
}

}  // namespace selvedge::sim
