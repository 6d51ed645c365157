#pragma once
// What of a garment a detail shows: patches of one size, so that fabrics are judged side by side.
#include <vector>

#include "render/scene/camera.h"

namespace selvedge {

inline constexpr float kDetailSize = 0.30F;  // m, of the patch that Close and Hem show

bool is_detail(View view);

// The corners of the patch: at the front, by the garment's upper edge for Close, by its lower one for Hem.
// Pre: is_detail(view), points not empty.
std::vector<Vec3f> detail_patch(const std::vector<Vec3f>& garment, View view);

}  // namespace selvedge
