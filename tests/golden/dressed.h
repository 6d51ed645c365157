#pragma once
// Shipped garments on the coarse mannequin, for the golden cases that run from end to end.
#include <string>

#include "sim/dress/dress.h"

namespace selvedge::test {

// The female mannequin at its lowest resolution.
sim::Body coarse_mannequin();

// `garment` is a name of patterns/, without extension.
sim::DressedGarment dress_shipped(const std::string& garment, const sim::DressOptions& options = {});

}  // namespace selvedge::test
