#include <gtest/gtest.h>
#include <filesystem>

#include "render/image/image.h"
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

}  // namespace selvedge::render
