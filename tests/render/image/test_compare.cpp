#include "render/image/compare.h"

#include <gtest/gtest.h>

namespace selvedge::render {
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
}  // namespace selvedge::render
