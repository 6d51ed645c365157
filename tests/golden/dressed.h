#pragma once
// Shipped garments on the coarse mannequin, for the golden cases that run from end to end.
#include <string>

#include "sim/dress/dress.h"

namespace selvedge {

// The female mannequin at its lowest resolution.
Body coarse_mannequin();

// `garment` is a name of patterns/, without extension.
DressedGarment dress_shipped(const std::string& garment, const DressOptions& options = {});

}  // namespace selvedge
