#pragma once
// PNG files of textures of woven cloth, which repeat from yarn to yarn: the filters of PNG, which suit smooth pictures,
// make such files larger, and most of the time to write them goes into the search for repeats.
#include <string>

#include "render/image/image.h"

namespace selvedge::render {

// The colours of the picture without its alpha, unfiltered and lightly compressed. For a T-shirt's textures of 2048
// pixels: in a quarter of the time of encode_png(), and a quarter smaller. Equal images give equal bytes. Pre: the
// image is not empty.
std::string encode_texture_png(const Image& image);

}  // namespace selvedge::render
