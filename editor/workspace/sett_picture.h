#pragma once
// Renders images of a tartan as woven cloth on the CPU, without GL: for lists and thumbnails.
#include "render/image/image.h"
#include "sim/tartan/sett.h"

namespace selvedge::editor {

struct SettPictureOptions {
    int width_px = 96;
    int height_px = 96;
    double px_per_thread = 0;  // 0: one warp repeat fits the smaller side
    int first_thread = 0;      // >= 0, of warp and weft at the upper left; only if threads are drawn
};

// Warp threads run vertically, weft threads horizontally; the first threads of both are at the upper left. From two
// pixels per thread on, single threads are drawn with the over and under of the weave; below that, their mean colours.
// Pre: sizes are positive, the sett has threads.
render::Image sett_picture(const sim::Sett& sett, const SettPictureOptions& options = {});

// Whether the warp thread is on top where these two threads cross, seen from the right side of the fabric.
bool is_warp_on_top(sim::Weave weave, int warp_thread, int weft_thread);

}  // namespace selvedge::editor
