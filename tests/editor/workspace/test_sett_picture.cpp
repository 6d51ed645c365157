// Images of tartans, rendered without GL.
#include "editor/workspace/sett_picture.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace selvedge::editor {
namespace {

TEST(SettPicture, twill_goes_over_two_and_under_two_one_thread_on_with_each_row) {
    for (int row = 0; row < 8; ++row) {
        int over = 0;
        for (int thread = 0; thread < 8; ++thread) over += is_warp_on_top(sim::Weave::Twill22, thread, row) ? 1 : 0;
        EXPECT_EQ(over, 4);
        EXPECT_EQ(is_warp_on_top(sim::Weave::Twill22, 3, row), is_warp_on_top(sim::Weave::Twill22, 2, row + 1));
    }
    EXPECT_NE(is_warp_on_top(sim::Weave::Plain, 0, 0), is_warp_on_top(sim::Weave::Plain, 1, 0));
    EXPECT_EQ(is_warp_on_top(sim::Weave::Twill31, -4, 0), is_warp_on_top(sim::Weave::Twill31, 0, 0))
        << "also left of the first";
}

TEST(SettPicture, from_afar_each_pixel_has_the_mean_light_of_warp_and_weft) {
    const render::Image image =
        sett_picture(sim::parse_threadcount("K=#000000; W=#FFFFFF; K8 W8"), {.width_px = 16, .height_px = 16});
    EXPECT_EQ(image.at(0, 0), (render::Rgba8{0, 0, 0, 255}));
    EXPECT_EQ(image.at(15, 15), (render::Rgba8{255, 255, 255, 255}));
    EXPECT_EQ(image.at(15, 0), (render::Rgba8{188, 188, 188, 255})) << "half the light is no half of the byte";
}

TEST(SettPicture, a_denim_shows_three_parts_of_its_warp) {
    const render::Image image = sett_picture(sim::parse_threadcount("K=#000000; W=#FFFFFF; W4 weft: K4 weave: denim"),
                                             {.width_px = 4, .height_px = 4});
    EXPECT_EQ(image.at(1, 1), (render::Rgba8{225, 225, 225, 255}));
}

TEST(SettPicture, from_near_the_threads_of_both_colours_are_seen) {
    const render::Image image = sett_picture(sim::parse_threadcount("R=#FF0000; B=#0000FF; R4 weft: B4"),
                                             {.width_px = 32, .height_px = 32, .px_per_thread = 8});
    const auto is_seen = [&](std::size_t channel) {
        return std::count_if(image.pixels.begin(), image.pixels.end(), [&](const render::Rgba8& pixel) {
            return pixel[channel] > 150 && pixel[2 - channel] < 50;
        });
    };
    EXPECT_GT(is_seen(0), 300);
    EXPECT_GT(is_seen(2), 300);
}

}  // namespace
}  // namespace selvedge::editor
