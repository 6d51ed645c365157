#pragma once
// Small pictures for the gallery.
#include "render/image/image.h"

namespace selvedge::batch {

// The picture within that many pixels on each side, each the mean of those that it covers; unchanged if it is no
// larger.
render::Image shrunk(const render::Image& image, int most_px);

}  // namespace selvedge::batch
