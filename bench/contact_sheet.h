#pragma once
// Pictures side by side in one.
#include <vector>

#include "render/image/image.h"

namespace selvedge {

// Row by row, so many in each, with white between. Pre: there are some, all of one size, columns >= 1.
Image contact_sheet(const std::vector<Image>& pictures, int columns);

}  // namespace selvedge
