#include "render/level_legend.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "render/renderer.h"

namespace selvedge {
namespace {

PlainMesh mesh_with_levels(std::vector<std::uint8_t> levels) {
    PlainMesh mesh;
    mesh.level = std::move(levels);
    return mesh;
}

bool shows(const Image& image, const Rgb8& colour) {
    const Rgba8 opaque{colour[0], colour[1], colour[2], 255};
    return std::find(image.pixels.begin(), image.pixels.end(), opaque) != image.pixels.end();
}

TEST(LevelLegend, shows_every_level_up_to_the_highest) {
    Image image(512, 512);
    draw_level_legend(image, mesh_with_levels({0, 2, 0}));
    EXPECT_TRUE(shows(image, level_colour(0)));
    EXPECT_TRUE(shows(image, level_colour(1)));
    EXPECT_TRUE(shows(image, level_colour(2)));
    EXPECT_FALSE(shows(image, level_colour(3)));
}

TEST(LevelLegend, leaves_a_picture_that_is_too_small_alone) {
    for (const auto& [width, height] : {std::pair{16, 512}, {512, 16}, {1, 1}}) {
        const Image before(width, height);
        Image image = before;
        draw_level_legend(image, mesh_with_levels({7}));
        EXPECT_EQ(image, before) << width << "x" << height;
    }
}

}  // namespace
}  // namespace selvedge
