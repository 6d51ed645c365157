#include "render/image/image.h"

#include <gtest/gtest.h>

namespace selvedge::render {
namespace {

// Two colours of yarn in a plain weave, as a baked texture has them.
Image woven(int side) {
    Image image(side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            image.at(x, y) = (x / 3 + y / 3) % 2 == 0 ? Rgba8{200, 16, 32, 255} : Rgba8{16, 32, 200, 255};
    return image;
}

TEST(TexturePng, gives_back_every_colour_and_the_same_bytes_for_the_same_picture) {
    const Image image = woven(61);
    const std::string bytes = encode_texture_png(image);
    EXPECT_EQ(decode_png(bytes, "x"), image);
    EXPECT_EQ(encode_texture_png(image), bytes);
}

TEST(TexturePng, leaves_out_alpha) {
    Image image = woven(8);
    image.at(3, 2)[3] = 100;
    Image opaque = image;
    opaque.at(3, 2)[3] = 255;
    EXPECT_EQ(decode_png(encode_texture_png(image), "x"), opaque);
}

}  // namespace
}  // namespace selvedge::render
