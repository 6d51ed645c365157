#pragma once
// Distance fields that are made once and kept in a store on disk, by the surface that they belong to.
#include <functional>

#include "sim/collide/distance_field.h"
#include "sim/collide/surface_bvh.h"
#include "sim/core/content_store.h"

namespace selvedge::sim {

// The field of the surface, with the same bits whether it is made or found in the store; a new one is kept there.
// store: null for none. Otherwise as the constructor of DistanceField.
DistanceField stored_field(const SurfaceBvh& bvh, const DistanceFieldOptions& options,
                           const std::function<void()>& interrupt, const ContentStore* store);

}  // namespace selvedge::sim
