#pragma once
// In which pose a body is dressed in what.
#include <memory>

#include "sim/dress/prepared_body.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// The body as it is given, if no arm belongs in the garment and its arms are lower while it is dressed: they would only
// be in the way of a skirt. Else the body itself, also if an arm was not found. placed: the pattern's panels round it
// as it stands while it is dressed. body: not null.
std::shared_ptr<const PreparedBody> wearer_of(const GarmentMesh& placed, const Pattern& pattern,
                                              const std::shared_ptr<const PreparedBody>& body);

}  // namespace selvedge::sim
