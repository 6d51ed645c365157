#pragma once
// A tartan as one picture that repeats, with every smaller size of it, for drafts: a lookup by place costs one sample.
// Single threads are not drawn; each size holds the exact mean colours of the threads that a texel covers.
#include "render/gl/handle.h"
#include "render/image/image.h"
#include "render/sett_sums.h"

namespace selvedge {

// From the largest, a power of two each way, down to one pixel. x is along the weft (the warp's threads), y along the
// warp.
std::vector<Image> draft_weave(const Sett& sett);

Texture upload_draft_weave(const GladGLContext& gl, const std::vector<Image>& sizes);

}  // namespace selvedge
