// A photo of a pattern piece is laid under the sheet, scaled by two of its points, and traced, as a user does it.
#include <gtest/gtest.h>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>

#include "render/image/photo.h"
#include "sim/core/file.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/pattern_file.h"
#include "tests/app/selvedge_program.h"

namespace selvedge::app {
namespace {

constexpr double kTruePixel = 0.0005;  // m: of the photo, in which a ruler of 10 cm is 200 px long

// A skirt's front with a rounded hem, beside a ruler, on a table.
render::Image photo_of_a_piece() {
    render::Image photo(1000, 800, {205, 180, 140, 255});
    for (int y = 100; y < 660; ++y) {
        const double widening = 100.0 * (y - 100) / 500;
        for (int x = 0; x < 1000; ++x) {
            const double hem = 600 + 50 * (1 - (x - 500.0) * (x - 500.0) / (300.0 * 300.0));
            if (x >= 300 - widening && x <= 700 + widening && y <= hem) photo.at(x, y) = {250, 248, 240, 255};
        }
    }
    for (int y = 700; y < 730; ++y) {
        for (int x = 100; x <= 300; ++x) {
            const bool is_mark = (x - 100) % 20 == 0 && y < 715;
            photo.at(x, y) = is_mark ? render::Rgba8{20, 20, 20, 255} : render::Rgba8{240, 220, 60, 255};
        }
    }
    return photo;
}

// Where a pixel of the photo is on the sheet, cm: as it is laid there (1 m wide, its middle at 0, 0), and after the
// ruler was given its length about its left end.
std::string at(double x, double y, bool is_scaled = true) {
    const double left = (100 - 500) * 0.1, low = (400 - 700) * 0.1;
    const double cm = is_scaled ? 100 * kTruePixel : 0.1;
    std::ostringstream text;
    text << "sheet " << left + (x - 100) * cm << " " << low + (700 - y) * cm << "\n";
    return text.str();
}

class Trace : public testing::Test {
 protected:
    Trace() {
        sim::write_file_atomically(photo_, encode_jpeg(photo_of_a_piece(), 90));
        std::filesystem::create_directory(folder_ / "state");
    }
    ProgramResult play(const std::string& script) {
        sim::write_file_atomically(folder_ / "trace.txt", script);
        return run_selvedge("edit --size 2400x1500 --script '" + (folder_ / "trace.txt") + "' --state '" +
                            (folder_ / "state") + "'");
    }

    const ScratchFolder folder_;
    const std::string photo_ = folder_ / "piece.jpg", garment_ = folder_ / "skirt.json",
                      picture_ = folder_ / "traced.png";
};

TEST_F(Trace, gives_a_panel_of_true_size) {
    const std::string scale = "click " + at(100, 700, false) + "click " + at(300, 700, false) + "type 10\nkey enter\n";
    const std::string outline = "key h\nclick " + at(300, 100) + "click " + at(200, 600) + "click " + at(800, 600) +
                                "click " + at(700, 100) + "key enter\nframes 2\n";
    const std::string hem =
        "key c\npress " + at(500, 600) + "move " + at(500, 630) + "move " + at(500, 650) + "release " + at(500, 650);
    const ProgramResult result =
        play("import \"" + photo_ + "\"\nframes 3\n" + scale + "key f\nframes 2\n" + outline + hem +
             "key v\nframes 2\nscreenshot \"" + picture_ + "\"\nsave \"" + garment_ + "\"\n");
    ASSERT_EQ(result.exit_code, 0) << result.err;

    const sim::Pattern pattern = sim::load_pattern(garment_).pattern;
    ASSERT_EQ(pattern.panels.size(), 1U);
    const sim::Panel& panel = pattern.panels[0];
    ASSERT_EQ(panel.edges.size(), 4U);
    const auto length = [&](std::size_t edge) { return sim::outline_length(panel, panel.edges[edge]); };
    constexpr double kScreenPixel = 0.001;  // m, about: clicks are at whole px of the screen
    EXPECT_NEAR(length(3), 400 * kTruePixel, kScreenPixel) << "the waist";
    EXPECT_NEAR(length(0), std::hypot(100, 500) * kTruePixel, kScreenPixel);
    EXPECT_NEAR(length(2), std::hypot(100, 500) * kTruePixel, kScreenPixel);
    const Vec2d left = sim::outline_point(panel, panel.edges[1], 0),
                right = sim::outline_point(panel, panel.edges[1], 1),
                middle = sim::outline_point(panel, panel.edges[1], 0.5);
    EXPECT_NEAR((right - left).norm(), 600 * kTruePixel, kScreenPixel) << "the hem";
    EXPECT_NEAR((left + right).y() / 2 - middle.y(), 50 * kTruePixel, kScreenPixel) << "the hem is round";

    ASSERT_EQ(pattern.underlays.size(), 1U) << "the photo is still there";
    EXPECT_EQ(pattern.underlays[0].file, std::filesystem::canonical(photo_).string());
    EXPECT_NEAR(pattern.underlays[0].pixel_size, kTruePixel, 0.005 * kTruePixel);
}

TEST_F(Trace, the_photo_may_be_missing_later) {
    ASSERT_EQ(play("import \"" + photo_ + "\"\nframes 3\nsave \"" + garment_ + "\"\n").exit_code, 0);
    std::filesystem::remove(photo_);
    const ProgramResult result = play("open \"" + garment_ + "\"\nframes 3\n");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const ProgramResult dressed = run_selvedge("dress '" + garment_ + "' --render '" + picture_ + "'");
    EXPECT_EQ(dressed.exit_code, 2);
    EXPECT_NE(dressed.err.find("no panel that is worn"), std::string::npos) << dressed.err;
}

TEST_F(Trace, a_damaged_photo_is_refused_on_one_line) {
    sim::write_file_atomically(photo_, "\xFF\xD8\xFF\xE0 no more");
    const ProgramResult result = play("import \"" + photo_ + "\"\n");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("not a whole JPEG picture"), std::string::npos) << result.err;
}

TEST_F(Trace, import_of_a_photo_says_where_it_can_be_traced) {
    const ProgramResult result = run_selvedge("import '" + photo_ + "' -o '" + garment_ + "'");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("a photo: trace it in the editor, selvedge edit"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace selvedge::app
