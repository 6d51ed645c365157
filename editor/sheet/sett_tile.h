#pragma once
// One repeat of a sett as a picture that can be laid side by side: what a tartan panel is filled with.
#include "render/image/image.h"
#include "sim/tartan/sett.h"

namespace selvedge {

// `side_px` wide, as high in proportion; column 0 is the first thread of the warp, row 0 the first of the weft. Where
// threads are a px or wider each one is seen as the weave crosses them, else their mean, in linear light.
// Pre: the sett has threads; side_px > 0.
Image sett_tile(const Sett& sett, int side_px);

// The size for a picture whose repeat is seen so many px wide: a power of two from 32 to 1,024.
int sett_tile_side(double repeat_px);

}  // namespace selvedge
