#include "render/image/photo.h"

#include <gtest/gtest.h>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "sim/core/error.h"

namespace selvedge::render {
namespace {

// Four quarters: red, green; blue, white, so that its turned and mirrored forms all differ.
Image quarters(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const bool is_right = 2 * x >= width, is_low = 2 * y >= height;
            image.at(x, y) = is_low ? (is_right ? Rgba8{255, 255, 255, 255} : Rgba8{0, 0, 255, 255})
                                    : (is_right ? Rgba8{0, 255, 0, 255} : Rgba8{255, 0, 0, 255});
        }
    }
    return image;
}

std::string big_endian(std::uint32_t value, std::size_t count) {
    std::string bytes;
    for (std::size_t i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * (count - 1 - i)) & 0xFFU);
    return bytes;
}

// A JPEG with an Exif segment that holds only the orientation.
std::string with_orientation(std::string jpeg, int orientation) {
    const std::string body =
        std::string("Exif\0\0MM\0\x2A\0\0\0\x08", 14) + big_endian(1, 2) + big_endian(0x0112, 2) + big_endian(3, 2) +
        big_endian(1, 4) + big_endian(static_cast<std::uint32_t>(orientation), 2) + big_endian(0, 2) + big_endian(0, 4);
    return jpeg.insert(2, "\xFF\xE1" + big_endian(static_cast<std::uint32_t>(body.size() + 2), 2) + body);
}

char letter(const Rgba8& pixel) {
    if (pixel[0] > 200 && pixel[1] > 200) return 'W';
    return pixel[0] > 200 ? 'R' : pixel[1] > 200 ? 'G' : 'B';
}

// The colours of the quarters, row by row.
std::string letters(const Image& image) {
    std::string text;
    for (const int y : {1, 3}) {
        for (const int x : {1, 3}) text += letter(image.at(x * image.width_px / 4, y * image.height_px / 4));
    }
    return text;
}

std::string photo_fault_of(const std::string& bytes) {
    try {
        decode_photo(bytes, "mine.jpg");
    } catch (const sim::InputError& error) {
        EXPECT_EQ(error.file(), "mine.jpg");
        return error.problem();
    }
    return "";
}

TEST(Photo, reads_a_jpeg) {
    const Photo photo = decode_photo(encode_jpeg(quarters(64, 32), 95), "x");
    EXPECT_EQ(photo.image.width_px, 64);
    EXPECT_EQ(photo.image.height_px, 32);
    EXPECT_EQ(letters(photo.image), "RGBW");
}

TEST(Photo, reads_a_png_by_its_content) {
    EXPECT_EQ(decode_photo(encode_png(quarters(8, 8)), "x").image, quarters(8, 8));
}

// The eight orientations of Exif: what is stored as row 0 and column 0 is there at the top, right, bottom or left.
TEST(Photo, turns_a_photo_as_the_camera_was_held) {
    const std::array<std::string, 8> seen{"RGBW", "GRWB", "WBGR", "BWRG", "RBGW", "BRWG", "WGBR", "GWRB"};
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const Photo photo = decode_photo(with_orientation(encode_jpeg(quarters(64, 32), 95), orientation), "x");
        EXPECT_EQ(letters(photo.image), seen[static_cast<std::size_t>(orientation) - 1]) << orientation;
        EXPECT_EQ(photo.image.width_px, orientation >= 5 ? 32 : 64) << orientation;
    }
}

TEST(Photo, an_unknown_orientation_is_upright) {
    EXPECT_EQ(letters(decode_photo(with_orientation(encode_jpeg(quarters(64, 32), 95), 77), "x").image), "RGBW");
}

// JFIF's density stands at byte 13: unit 1 counts per inch, 2 per centimetre.
TEST(Photo, takes_the_size_of_a_pixel_from_a_scan) {
    std::string jpeg = encode_jpeg(quarters(16, 16), 90);
    ASSERT_EQ(jpeg.substr(6, 4), "JFIF");
    jpeg.replace(13, 5, big_endian(1, 1) + big_endian(300, 2) + big_endian(300, 2));
    EXPECT_NEAR(decode_photo(jpeg, "x").pixel_size.value(), 0.0254 / 300, 1e-9);
    jpeg.replace(13, 5, big_endian(2, 1) + big_endian(120, 2) + big_endian(120, 2));
    EXPECT_NEAR(decode_photo(jpeg, "x").pixel_size.value(), 0.01 / 120, 1e-9);
    jpeg.replace(13, 5, big_endian(1, 1) + big_endian(72, 2) + big_endian(72, 2));
    EXPECT_FALSE(decode_photo(jpeg, "x").pixel_size) << "72 is what cameras write";
}

// The chunk follows the header, whose chunk ends at byte 33. Its checksum is not looked at: libpng skips the chunk.
TEST(Photo, takes_the_size_of_a_pixel_from_a_png) {
    const std::string chunk =
        big_endian(9, 4) + "pHYs" + big_endian(11811, 4) + big_endian(11811, 4) + '\1' + big_endian(0x78A53F76, 4);
    EXPECT_NEAR(decode_photo(encode_png(quarters(8, 8)).insert(33, chunk), "x").pixel_size.value(), 1.0 / 11811, 1e-9);
}

TEST(Photo, says_what_is_wrong) {
    EXPECT_EQ(photo_fault_of("GIF89a"), "neither a PNG nor a JPEG picture");
    EXPECT_EQ(photo_fault_of(""), "neither a PNG nor a JPEG picture");
    EXPECT_TRUE(
        photo_fault_of(encode_jpeg(quarters(64, 64), 90).substr(0, 20)).starts_with("not a whole JPEG picture"));
    std::string vast = encode_jpeg(quarters(16, 16), 90);
    const std::size_t frame = vast.find("\xFF\xC0");  // start of frame: height and width are 5 and 7 bytes on
    ASSERT_NE(frame, std::string::npos);
    vast.replace(frame + 5, 4, big_endian(65000, 2) + big_endian(65000, 2));
    EXPECT_EQ(photo_fault_of(vast), "picture of 65000x65000 pixels is over the limit");
}

TEST(Photo, no_damage_harms) {
    const std::string whole = with_orientation(encode_jpeg(quarters(48, 32), 80), 6);
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ 0x5A);
        photo_fault_of(damaged);
        photo_fault_of(whole.substr(0, i));
    }
    EXPECT_EQ(photo_fault_of(whole), "");
}

TEST(Photo, is_reduced_to_half_until_it_fits) {
    const Image half = reduced(quarters(64, 32), 40);
    EXPECT_EQ(half.width_px, 32);
    EXPECT_EQ(half.height_px, 16);
    EXPECT_EQ(letters(half), "RGBW");
    EXPECT_EQ(reduced(quarters(64, 32), 64), quarters(64, 32));
    EXPECT_EQ(reduced(Image(5, 1), 2).height_px, 1);
}

}  // namespace
}  // namespace selvedge::render
