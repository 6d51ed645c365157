#pragma once
// What the colours of a picture mean, written in a corner of it: data in, pixels out.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "render/image/image.h"
#include "render/image/text.h"
#include "sim/tartan/sett.h"

namespace selvedge::render {

// One colour with its name, and a figure that stands to the right of it.
struct LegendRow {
    sim::Rgb8 colour{};
    std::string label;
    std::string figure{};
};

// A map from its low end, at the left, to its high one.
struct LegendScale {
    struct Tick {
        float place = 0;  // 0..1 along the map
        std::string label;
    };
    std::vector<sim::Rgb8> map;
    std::vector<Tick> ticks;  // rising
};

struct Legend {
    std::string title;
    std::vector<LegendRow> rows{};
    std::optional<LegendScale> scale{};
    std::vector<std::array<std::string, 2>> notes{};  // a name and its figure, below all else
};

enum class Corner { LowerLeft, LowerRight, UpperLeft, UpperRight };

struct LegendPlace {
    PixelBox box;
    int scale = 1;         // px of the picture for one of the letters'
    std::size_t rows = 0;  // that have room; one less names how many are left out
};

// Where it comes to lie in a corner of a picture: in letters that fit the picture's size, or the largest smaller ones
// with which it takes no more than half of the picture's width; rows beyond three quarters of its height are left out.
// None where there is no room for it even so.
std::optional<LegendPlace> place_legend(const Legend& legend, int width_px, int height_px, Corner corner);

// Nothing is drawn where there is no place for it.
void draw_legend(Image& image, const Legend& legend, Corner corner);

}  // namespace selvedge::render
