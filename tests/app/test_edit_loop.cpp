// The editor's host without a window.
#include "app/edit_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "render/image/image.h"
#include "sim/core/error.h"
#include "tests/app/edit_stand_in.h"
#include "tests/golden/frozen_scene.h"

namespace selvedge::app {
namespace {

editor::InputEvent button(bool is_down) {
    return {.kind = editor::InputEvent::Kind::MouseButton,
            .x = FakeEditor::kButtonX,
            .y = FakeEditor::kButtonY,
            .is_down = is_down};
}

editor::InputEvent move_to(float x, float y) {
    return {.kind = editor::InputEvent::Kind::MouseMove, .x = x, .y = y};
}

// Shows the windows, moves to the button, presses, releases, then draws one more frame.
render::Image press_and_look(OffscreenEditLoop& loop, FakeEditor& surface) {
    for (int i = 0; i < 2; ++i) loop.step(surface);  // until the windows have their sizes
    loop.step(surface, {move_to(FakeEditor::kButtonX, FakeEditor::kButtonY)});
    loop.step(surface, {button(true)});
    loop.step(surface, {button(false)});
    loop.step(surface);
    return loop.screenshot();
}

int reddish_pixels(const render::Image& image) {
    return static_cast<int>(std::count_if(image.pixels.begin(), image.pixels.end(), [](const render::Rgba8& pixel) {
        return pixel[0] > pixel[1] + 60 && pixel[0] > pixel[2] + 60;
    }));
}

TEST(EditLoop, events_reach_the_surface_and_the_screenshot_shows_its_scene) {
    OffscreenEditLoop loop;
    FakeEditor surface(test::make_frozen_scene());
    const render::Image image = press_and_look(loop, surface);
    EXPECT_EQ(surface.presses(), 1);
    EXPECT_EQ(image.width_px, 1280);
    const render::Image scene = [] {
        OffscreenEditLoop other;
        FakeEditor bare(render::Scene{});
        return press_and_look(other, bare);
    }();
    EXPECT_FALSE(image == scene);
    EXPECT_TRUE(image.at(300, 400) == scene.at(300, 400)) << "beside the scene";
    EXPECT_GT(reddish_pixels(image), 20000) << "a red tartan in the middle of the view";
    EXPECT_EQ(reddish_pixels(scene), 0);
}

TEST(EditLoop, the_same_events_make_the_same_bits) {
    std::vector<render::Image> images;
    for (int i = 0; i < 2; ++i) {
        OffscreenEditLoop loop;
        FakeEditor surface(test::make_frozen_scene(), 0.1F);
        images.push_back(press_and_look(loop, surface));
    }
    EXPECT_TRUE(images[0] == images[1]);
}

TEST(EditLoop, a_fine_scene_is_the_renderers_picture) {
    OffscreenEditLoop loop;
    FakeEditor surface(test::make_frozen_scene(), 0, {}, false);
    loop.step(surface);
    loop.step(surface);  // a second frame, because ImGui shows a new window only when its size is known
    const render::Image image = loop.screenshot();
    const render::Image fine = render::Renderer().draw(test::make_frozen_scene(), {.width_px = 640, .height_px = 640});
    const int left = 628, top = 20 + 27;  // position of the scene in the screenshot, in ImGui's default style
    EXPECT_EQ(image.at(left + 320, top + 200), fine.at(320, 200));
    EXPECT_EQ(image.at(left + 400, top + 500), fine.at(400, 500));
}

TEST(FrameTimes, are_a_row_for_each_frame) {
    const std::string path = testing::TempDir() + "/frame_times.csv";
    {
        FrameTimesFile file(path);
        file.add({.events_and_ui = 1, .scenes = 2, .ui_draw = 3, .swap = 4});
        file.add({});
    }
    std::ifstream in(path);
    std::string heading, first, second;
    std::getline(in, heading);
    std::getline(in, first);
    std::getline(in, second);
    EXPECT_EQ(heading, "frame,total_ms,events_and_ui_ms,scenes_ms,ui_draw_ms,swap_ms");
    EXPECT_EQ(first, "0,10.000,1.000,2.000,3.000,4.000");
    EXPECT_EQ(second, "1,0.000,0.000,0.000,0.000,0.000");
    EXPECT_THROW(FrameTimesFile(testing::TempDir() + "/no/such/folder/times.csv"), sim::InputError);
}

TEST(FrameTimes, of_a_full_disk_are_refused) {
    EXPECT_THROW(FrameTimesFile("/dev/full").add({}), sim::InputError);
}

}  // namespace
}  // namespace selvedge::app
