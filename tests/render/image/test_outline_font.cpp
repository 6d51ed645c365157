// Fonts of outlines, with whichever of the interface's fonts is installed.
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include "render/image/outline_font.h"
#include "render/image/text.h"
#include "sim/core/file.h"

namespace selvedge::render {
namespace {

constexpr Rgba8 kWhite{255, 255, 255, 255}, kBlack{0, 0, 0, 255};

class OutlineFonts : public testing::Test {
 protected:
    void SetUp() override {
        for (const char* file : {"opentype/inter/Inter-Regular.otf", "truetype/noto/NotoSans-Regular.ttf",
                                 "truetype/dejavu/DejaVuSans.ttf"}) {
            const std::filesystem::path path = std::filesystem::path("/usr/share/fonts") / file;
            if (!font_ && std::filesystem::exists(path)) {
                bytes_ = sim::read_file(path, 64U << 20U);
                font_ = OutlineFont::read(bytes_);
            }
        }
        if (!font_) GTEST_SKIP() << "no font is installed";
    }

    Image drawn(const std::string& text, TextLine line) const {
        Image image(300, 60, kWhite);
        line.colour = kBlack;
        font_->draw(image, text, line);
        return image;
    }

    std::string bytes_;  // of its file
    std::shared_ptr<const OutlineFont> font_;
};

// The rectangle of the pixels that are not white.
std::optional<PixelBox> inked(const Image& image) {
    int left = image.width_px, right = -1, top = image.height_px, bottom = -1;
    for (int y = 0; y < image.height_px; ++y) {
        for (int x = 0; x < image.width_px; ++x) {
            if (image.at(x, y) == kWhite) continue;
            left = std::min(left, x), right = std::max(right, x);
            top = std::min(top, y), bottom = std::max(bottom, y);
        }
    }
    if (right < 0) return std::nullopt;
    return PixelBox{.left = left, .top = top, .width = right - left + 1, .height = bottom - top + 1};
}

TEST_F(OutlineFonts, draw_smooth_edges) {
    const Image image = drawn("Strain", {.left_px = 10, .baseline_px = 40, .size_px = 24});
    int dark = 0, between = 0;
    for (const Rgba8& pixel : image.pixels) {
        dark += pixel[0] < 20 ? 1 : 0;
        between += pixel[0] > 60 && pixel[0] < 200 ? 1 : 0;
    }
    EXPECT_GT(dark, 50);
    EXPECT_GT(between, 50);
}

TEST_F(OutlineFonts, stand_on_the_baseline_and_are_as_high_and_wide_as_they_were_said_to_be) {
    for (const float size : {12.0F, 17.5F, 30.0F}) {
        const auto box = inked(drawn("HHHH", {.left_px = 10, .baseline_px = 40, .size_px = size}));
        ASSERT_TRUE(box);
        EXPECT_EQ(box->top + box->height, 40) << size;
        EXPECT_NEAR(float(box->height), size * font_->capital_height(), 1.01F);
        EXPECT_LE(float(box->width), size * font_->text_width("HHHH") + 1);
        EXPECT_GT(float(box->width), size * font_->text_width("HHH"));
        EXPECT_GE(box->left, 10);
    }
}

TEST_F(OutlineFonts, have_digits_of_one_width) {
    for (char digit = '0'; digit <= '9'; ++digit)
        EXPECT_FLOAT_EQ(font_->text_width(std::string(1, digit)), font_->text_width("8")) << digit;
    EXPECT_LT(font_->text_width("i"), font_->text_width("m"));
    EXPECT_EQ(font_->text_width(""), 0);
}

TEST_F(OutlineFonts, show_letters_with_accents_and_a_question_mark_for_what_they_lack) {
    const TextLine line{.left_px = 10, .baseline_px = 40, .size_px = 24};
    EXPECT_FALSE(drawn("\xC3\xA4", line) == drawn("?", line));
    EXPECT_TRUE(drawn("\xF0\x9F\xA7\xB5", line) == drawn("?", line)) << "a spool of thread";
    EXPECT_TRUE(drawn("\xC3", line) == drawn("?", line)) << "cut short";
    EXPECT_TRUE(drawn("\xFF\xFE", line) == drawn("??", line));
}

TEST_F(OutlineFonts, draw_nothing_outside_the_picture) {
    Image image(12, 9, kWhite);
    font_->draw(image, "Wide words", {.left_px = -30, .baseline_px = 5, .size_px = 20, .colour = kBlack});
    font_->draw(image, "Wide words", {.left_px = 3, .baseline_px = 900, .size_px = 20, .colour = kBlack});
    EXPECT_TRUE(inked(image));
}

TEST_F(OutlineFonts, that_are_cut_short_are_refused) {
    for (const double share : {0.001, 0.01, 0.1, 0.3, 0.5, 0.9, 0.999}) {
        const auto size = static_cast<std::size_t>(share * static_cast<double>(bytes_.size()));
        EXPECT_EQ(OutlineFont::read(bytes_.substr(0, size)), nullptr) << share;
    }
    EXPECT_NE(OutlineFont::read(bytes_), nullptr);
}

TEST(OutlineFontFiles, that_are_none_are_refused) {
    EXPECT_EQ(OutlineFont::read(""), nullptr);
    EXPECT_EQ(OutlineFont::read("font"), nullptr);
    EXPECT_EQ(OutlineFont::read(std::string(5000, 'x')), nullptr);
}

}  // namespace
}  // namespace selvedge::render
