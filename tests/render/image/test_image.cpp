#include <gtest/gtest.h>
#include <filesystem>
#include <map>

#include "render/image/image.h"
#include "render/image/text.h"
#include "sim/core/error.h"
#include "sim/core/file.h"

namespace selvedge::render {
namespace {

Image gradient(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            image.at(x, y) = {static_cast<std::uint8_t>(x * 7), static_cast<std::uint8_t>(y * 5),
                              static_cast<std::uint8_t>(x * y), static_cast<std::uint8_t>(255 - x)};
        }
    }
    return image;
}

std::string fault_of(const std::string& bytes) {
    try {
        decode_png(bytes, "mine.png");
    } catch (const sim::InputError& error) {
        EXPECT_EQ(error.file(), "mine.png");
        return error.problem();
    }
    return "";
}

// Width and height start at byte 16. A changed header needs a new checksum; otherwise libpng reports that first.
std::uint32_t crc32_of(std::string_view bytes) {
    std::uint32_t crc = 0xFFFFFFFFU;
    for (const char byte : bytes) {
        crc ^= static_cast<std::uint8_t>(byte);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1U ? 0xEDB88320U : 0U);
    }
    return ~crc;
}

void put_big_endian(std::string& bytes, std::size_t at, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(value >> (24 - 8 * i) & 0xFFU);
}

TEST(Png, gives_back_every_pixel_and_its_alpha) {
    const Image image = gradient(37, 21);
    EXPECT_EQ(decode_png(encode_png(image), "x"), image);
}

TEST(Png, same_image_same_bytes) {
    EXPECT_EQ(encode_png(gradient(64, 64)), encode_png(gradient(64, 64)));
}

TEST(Png, survives_the_way_through_a_file) {
    const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "way_through.png";
    write_png(path, gradient(9, 5));
    EXPECT_EQ(read_png(path), gradient(9, 5));
    std::filesystem::remove(path);
}

TEST(Png, a_file_cut_short_anywhere_is_an_input_error) {
    const std::string whole = encode_png(gradient(40, 40));
    constexpr std::size_t end_chunk = 12;  // IEND only marks the end: without it all pixels are present
    for (std::size_t length = 0; length + end_chunk < whole.size(); ++length) {
        EXPECT_THROW(decode_png(whole.substr(0, length), "x"), sim::InputError) << "at byte " << length;
    }
}

TEST(Png, changed_bytes_are_an_input_error_or_harmless_but_never_a_crash) {
    const std::string whole = encode_png(gradient(16, 16));
    int refused = 0;
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string broken = whole;
        broken[at] = static_cast<char>(broken[at] ^ 0x55);
        try {
            decode_png(broken, "x");
        } catch (const sim::InputError&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, static_cast<int>(whole.size()) / 2);
}

TEST(Png, what_is_no_picture_is_said_to_be_none) {
    EXPECT_NE(fault_of("").find("not a PNG"), std::string::npos);
    EXPECT_NE(fault_of("{\"pattern\": 1}").find("not a PNG"), std::string::npos);
}

TEST(Png, a_header_that_promises_too_many_pixels_is_refused_before_memory_is_taken) {
    std::string bytes = encode_png(gradient(4, 4));
    put_big_endian(bytes, 16, 1000000);
    put_big_endian(bytes, 20, 1000000);
    put_big_endian(bytes, 29, crc32_of(std::string_view(bytes).substr(12, 17)));
    EXPECT_NE(fault_of(bytes).find("1000000x1000000 pixels is over the limit"), std::string::npos) << fault_of(bytes);
}

TEST(Png, a_missing_folder_is_an_input_error) {
    EXPECT_THROW(read_png("/no/such/folder/a.png"), sim::InputError);
    EXPECT_THROW(write_png("/no/such/folder/a.png", gradient(2, 2)), sim::InputError);
}

}  // namespace

namespace {

constexpr Rgba8 kGrey{120, 120, 120, 255};

Image changed(Image image, int pixels, int step) {
    for (int i = 0; i < pixels; ++i) {
        std::uint8_t& red = image.pixels[static_cast<std::size_t>(i)][0];
        red = static_cast<std::uint8_t>(red + step);
    }
    return image;
}

TEST(Compare, a_picture_is_exactly_itself) {
    const Image image(100, 100, kGrey);
    const Comparison comparison = compare(image, image);
    EXPECT_TRUE(comparison.is_exact());
    EXPECT_TRUE(is_alike(comparison));
    EXPECT_EQ(describe(comparison), "the pictures are the same");
}

TEST(Compare, steps_of_three_are_alike_however_many) {
    const Image image(100, 100, kGrey);
    const Comparison comparison = compare(image, changed(image, 10000, 3));
    EXPECT_FALSE(comparison.is_exact());
    EXPECT_EQ(comparison.differing, 10000U);
    EXPECT_EQ(comparison.beyond, 0U);
    EXPECT_TRUE(is_alike(comparison));
}

TEST(Compare, one_pixel_in_ten_thousand_may_be_further_off_and_a_second_may_not) {
    const Image image(100, 100, kGrey);
    EXPECT_TRUE(is_alike(compare(image, changed(image, 1, 100))));
    EXPECT_FALSE(is_alike(compare(image, changed(image, 2, 4))));
}

TEST(Compare, a_step_down_or_in_alpha_counts_like_a_step_up) {
    const Image image(10, 10, kGrey);
    Image other = image;
    other.at(3, 4)[1] = 100;
    other.at(5, 6)[3] = 0;
    const Comparison comparison = compare(image, other);
    EXPECT_EQ(comparison.differing, 2U);
    EXPECT_EQ(comparison.largest_step, 255);
}

TEST(Compare, pictures_of_different_sizes_are_never_alike) {
    const Comparison comparison = compare(Image(10, 20, kGrey), Image(20, 10, kGrey));
    EXPECT_FALSE(comparison.has_same_size);
    EXPECT_EQ(comparison.pixels, 400U);
    EXPECT_EQ(comparison.differing, 300U);
    EXPECT_FALSE(is_alike(comparison, {.share_beyond = 1}));
    EXPECT_NE(describe(comparison).find("sizes differ"), std::string::npos);
}

TEST(Compare, the_share_that_differs_is_named) {
    const Image image(100, 100, kGrey);
    EXPECT_EQ(describe(compare(image, changed(image, 150, 7))),
              "1.5 % of the pixels differ (1.5 % by more than 3/255, at most 7/255)");
}

TEST(DifferencePicture, is_red_where_pixels_differ_and_grey_elsewhere) {
    const Image image(4, 2, kGrey);
    const Image difference = difference_picture(image, changed(image, 1, 1));
    EXPECT_GT(difference.at(0, 0)[0], difference.at(0, 0)[1] + 60);
    EXPECT_EQ(difference.at(1, 0)[0], difference.at(1, 0)[1]);
}

TEST(DifferencePicture, covers_both_pictures_when_their_sizes_differ) {
    const Image difference = difference_picture(Image(4, 2, kGrey), Image(2, 4, kGrey));
    EXPECT_EQ(difference.width_px, 4);
    EXPECT_EQ(difference.height_px, 4);
    EXPECT_EQ(difference.at(3, 0), (Rgba8{255, 0, 255, 255}));
    EXPECT_EQ(difference.at(3, 3), (Rgba8{255, 0, 255, 255}));
}

}  // namespace

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
