#pragma once
// The legend that explains a picture's colours, drawn in a corner of it: data in, pixels out.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "render/image/image.h"
#include "render/image/text.h"
#include "sim/tartan/sett.h"

namespace selvedge::render {

// One colour with its name, and a value to the right of it.
struct LegendRow {
    sim::Rgb8 colour{};
    std::string label;
    std::string figure{};
};

// A colour map, drawn with its low end at the left.
struct LegendScale {
    struct Tick {
        float place = 0;  // 0..1 along the map
        std::string label;
    };
    std::vector<sim::Rgb8> map;
    std::vector<Tick> ticks;  // in rising order
};

struct Legend {
    std::string title;
    std::vector<LegendRow> rows{};
    std::optional<LegendScale> scale{};
    std::vector<std::array<std::string, 2>> notes{};  // a name and its value each, below everything else
};

enum class Corner { LowerLeft, LowerRight, UpperLeft, UpperRight };

struct LegendLayout {
    PixelBox box;
    int scale = 1;         // picture pixels per font pixel
    std::size_t rows = 0;  // rows that fit; if not all do, the last of them reads "and N more"
};

// The legend's box in a corner of a picture. Scale: the picture's shorter side / 512 px, at least 1; a smaller one if
// the legend would be wider than half of the picture. Rows beyond three quarters of the picture's height are left out.
// nullopt if it does not fit even so.
std::optional<LegendLayout> place_legend(const Legend& legend, int width_px, int height_px, Corner corner);

// Draws nothing if place_legend() returns nullopt.
void draw_legend(Image& image, const Legend& legend, Corner corner);

}  // namespace selvedge::render
