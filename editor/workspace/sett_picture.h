#pragma once
// Pictures of a tartan as cloth, made without GL: for lists, and wherever a renderer is too much.
#include "render/image/image.h"
#include "sim/tartan/sett.h"

namespace selvedge::editor {

struct SettPictureOptions {
    int width_px = 96;
    int height_px = 96;
    double px_per_thread = 0;  // 0: the smaller side holds one repeat of the warp
    int first_thread = 0;      // of warp and weft, upper left, where threads are seen; 0 or more
};

// Warp threads run upwards, weft threads across; the picture begins at the first threads of both, upper left. From two
// pixels per thread on the threads are seen, over and under each other as they are woven, else their mean colour.
// Pre: sizes are positive, the sett has threads.
render::Image sett_picture(const sim::Sett& sett, const SettPictureOptions& options = {});

// Whether the warp lies on top where these threads cross, on the right side of the fabric.
bool is_warp_on_top(sim::Weave weave, int warp_thread, int weft_thread);

}  // namespace selvedge::editor
