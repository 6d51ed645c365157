#include "bench/thesis/labels.h"

#include <algorithm>

#include "render/image/text.h"
#include "sim/core/assert.h"

namespace selvedge::bench {
namespace {

// Of the labels, so that they stay readable when the sheet is scaled to the width of a page, and fit their tiles.
int text_scale(const std::vector<Tile>& tiles, int tile_width, int across) {
    constexpr int kWidth = 700;  // px, of a sheet whose text is not enlarged
    int scale = std::max(1, across * tile_width / kWidth);
    for (const Tile& tile : tiles) scale = std::min(scale, tile_width / std::max(1, render::text_width(tile.label)));
    return std::max(1, scale);
}

}  // namespace

render::Image labelled_sheet(const std::vector<Tile>& tiles, int columns) {
    SELVEDGE_ASSERT(!tiles.empty() && columns >= 1);
    int width = 1, height = 1;
    for (const Tile& tile : tiles) {
        width = std::max(width, tile.picture.width_px);
        height = std::max(height, tile.picture.height_px);
    }
    const int count = static_cast<int>(tiles.size()), across = std::min(columns, count);
    const int scale = text_scale(tiles, width, across);
    const int gap = 4 * scale, band = (render::kGlyphHeight + 4) * scale;
    const int rows = (count + columns - 1) / columns;
    render::Image sheet(across * (width + gap) - gap, rows * (height + band + gap) - gap, {255, 255, 255, 255});
    for (int i = 0; i < count; ++i) {
        const Tile& tile = tiles[static_cast<std::size_t>(i)];
        const int left = i % columns * (width + gap), top = i / columns * (height + band + gap);
        draw_text(sheet, left + scale, top + 2 * scale, tile.label, {.scale = scale});
        for (int y = 0; y < tile.picture.height_px; ++y) {
            for (int x = 0; x < tile.picture.width_px; ++x) sheet.at(left + x, top + band + y) = tile.picture.at(x, y);
        }
    }
    return sheet;
}

}  // namespace selvedge::bench
