#pragma once
// Shipped garments on the coarse mannequin, for golden tests that run the whole pipeline.
#include <string>

#include "sim/dress/dress.h"

namespace selvedge::test {

// The female mannequin at its lowest resolution.
sim::Body coarse_mannequin();

// `garment`: a file name in patterns/, without extension.
sim::DressedGarment dress_shipped(const std::string& garment, const sim::DressOptions& options = {});

}  // namespace selvedge::test
