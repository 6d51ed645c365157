#include "render/image/text.h"

#include <gtest/gtest.h>

#include <map>

namespace selvedge::render {
namespace {

TEST(Glyphs, every_letter_of_ascii_differs_from_every_other) {
    std::map<Glyph, char> seen;
    for (char letter = 32; letter < 127; ++letter) {
        const auto [found, is_new] = seen.emplace(find_glyph(letter), letter);
        EXPECT_TRUE(is_new) << letter << " looks like " << found->second;
    }
}

TEST(Glyphs, only_a_space_is_empty_and_only_what_descends_goes_below_the_line) {
    for (char letter = 33; letter < 127; ++letter) {
        const Glyph glyph = find_glyph(letter);
        EXPECT_NE(glyph, Glyph{}) << letter;
        const bool descends = std::string_view("gjpqy,;_").find(letter) != std::string_view::npos;
        EXPECT_EQ((glyph[7] | glyph[8]) != 0, descends) << letter;
    }
    EXPECT_EQ(find_glyph(' '), Glyph{});
}

TEST(Glyphs, what_is_not_ascii_is_a_question_mark) {
    EXPECT_EQ(find_glyph('\t'), find_glyph('?'));
    EXPECT_EQ(find_glyph(static_cast<char>(0xE9)), find_glyph('?'));
}

TEST(Text, figures_are_all_as_wide_and_an_umlaut_counts_once) {
    for (char figure = '0'; figure <= '9'; ++figure) EXPECT_EQ(text_width(std::string(1, figure)), 5) << figure;
    EXPECT_EQ(text_width("\xC3\xA4"), text_width("?"));
    EXPECT_EQ(text_width(""), 0);
}

TEST(Text, fills_exactly_the_width_that_it_was_said_to_have) {
    for (const int scale : {1, 2, 3}) {
        Image image(400, 40, {255, 255, 255, 255});
        draw_text(image, 10, 5, "Model 42", {.scale = scale});
        int first = image.width_px, last = -1;
        for (int x = 0; x < image.width_px; ++x) {
            for (int y = 0; y < image.height_px; ++y) {
                if (image.at(x, y) == Rgba8{255, 255, 255, 255}) continue;
                first = std::min(first, x);
                last = std::max(last, x);
            }
        }
        EXPECT_EQ(first, 10);
        EXPECT_EQ(last - first + 1, text_width("Model 42") * scale);
    }
}

TEST(Text, outside_the_picture_nothing_is_drawn_and_nothing_breaks) {
    Image image(20, 20, {9, 9, 9, 255});
    draw_text(image, -3, -4, "Wide words", {.scale = 3});
    fill_box(image, {-5, -5, 100, 8}, {255, 0, 0, 255});
    fill_rounded(image, {15, 15, 50, 50}, 4, {0, 255, 0, 255});
    EXPECT_EQ(image.at(0, 0), (Rgba8{255, 0, 0, 255}));
    EXPECT_EQ(image.at(19, 19), (Rgba8{0, 255, 0, 255}));
}

TEST(Text, half_a_colour_over_nothing_is_that_colour_half_seen) {
    Image image(2, 1, {0, 0, 0, 0});
    fill_box(image, {0, 0, 1, 1}, {200, 100, 50, 128});
    EXPECT_EQ(image.at(0, 0), (Rgba8{200, 100, 50, 128}));
    EXPECT_EQ(image.at(1, 0), (Rgba8{0, 0, 0, 0}));
}

}  // namespace
}  // namespace selvedge::render
