#include "sim/collide/stored_field.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/core/flat_bytes.h"
#include "sim/core/simd_level.h"

namespace selvedge::sim {
namespace {

constexpr std::string_view kKind = "field";

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
    if (store == nullptr) return DistanceField(bvh, options, interrupt);
    const std::string surface = made_from(bvh, options);
    if (const std::optional<std::string> bytes = store->find(kKind, surface)) {
        if (std::optional<DistanceField> field = DistanceField::from_bytes(*bytes)) return std::move(*field);
    }
    DistanceField field(bvh, options, interrupt);
    store->keep(kKind, surface, field.to_bytes());
    return field;
}

}  // namespace selvedge::sim
