#include "bench/contact_sheet.h"

#include <algorithm>

#include "sim/core/assert.h"

namespace selvedge {

Image contact_sheet(const std::vector<Image>& pictures, int columns) {
    constexpr int kGap = 4;  // px
    SELVEDGE_ASSERT(!pictures.empty() && columns >= 1);
    const int width = pictures.front().width_px, height = pictures.front().height_px;
    const int count = static_cast<int>(pictures.size()), rows = (count + columns - 1) / columns;
    Image sheet(columns * (width + kGap) - kGap, rows * (height + kGap) - kGap, {255, 255, 255, 255});
    for (int i = 0; i < count; ++i) {
        const Image& picture = pictures[static_cast<std::size_t>(i)];
        SELVEDGE_ASSERT(picture.width_px == width && picture.height_px == height);
        const int left = i % columns * (width + kGap), top = i / columns * (height + kGap);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) sheet.at(left + x, top + y) = picture.at(x, y);
        }
    }
    return sheet;
}

}  // namespace selvedge
