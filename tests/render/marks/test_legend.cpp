#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>

#include "render/marks/legend.h"
#include "sim/core/file.h"

namespace selvedge::render {
namespace {

constexpr Corner kCorners[] = {Corner::LowerLeft, Corner::LowerRight, Corner::UpperLeft, Corner::UpperRight};

sim::Rgb8 row_colour(std::size_t i) {
    return {static_cast<std::uint8_t>(20 + 7 * i), static_cast<std::uint8_t>(200 - 6 * i), 90};
}

Legend with_rows(std::size_t count) {
    Legend legend{.title = "Panels"};
    for (std::size_t i = 0; i < count; ++i)
        legend.rows.push_back({row_colour(i), "panel number " + std::to_string(i), std::to_string(i) + " cm"});
    return legend;
}

bool shows(const Image& image, const sim::Rgb8& colour) {
    const Rgba8 opaque{colour[0], colour[1], colour[2], 255};
    return std::find(image.pixels.begin(), image.pixels.end(), opaque) != image.pixels.end();
}

TEST(Legend, shows_the_colour_of_every_row) {
    Image image(512, 512);
    draw_legend(image, with_rows(4), Corner::LowerLeft);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(shows(image, row_colour(i))) << i;
    EXPECT_FALSE(shows(image, row_colour(4)));
}

TEST(Legend, shows_both_ends_of_its_map) {
    Image image(512, 512);
    const LegendScale scale{.map = {{10, 20, 30}, {60, 70, 80}, {200, 100, 50}}, .ticks = {{0, "0"}, {1, "5 mm"}}};
    draw_legend(image, {.title = "Distance", .scale = scale}, Corner::UpperRight);
    for (const sim::Rgb8& colour : scale.map) EXPECT_TRUE(shows(image, colour));
}

TEST(Legend, lies_wholly_inside_the_picture_whatever_its_size) {
    const Legend legend = with_rows(9);
    int placed = 0;
    for (const int width : {40, 96, 200, 333, 512, 1024, 3000}) {
        for (const int height : {40, 96, 200, 333, 512, 1024, 3000}) {
            for (const Corner corner : kCorners) {
                const auto place = place_legend(legend, width, height, corner);
                if (!place) continue;
                ++placed;
                EXPECT_GT(place->box.left, 0);
                EXPECT_GT(place->box.top, 0);
                EXPECT_LT(place->box.left + place->box.width, width);
                EXPECT_LT(place->box.top + place->box.height, height);
            }
        }
    }
    EXPECT_GT(placed, 40);
}

TEST(Legend, touches_no_pixel_outside_its_place_and_rim) {
    for (const Corner corner : kCorners) {
        const Image before(400, 300, {250, 250, 250, 255});
        Image image = before;
        const auto place = place_legend(with_rows(3), 400, 300, corner);
        ASSERT_TRUE(place);
        draw_legend(image, with_rows(3), corner);
        const PixelBox& box = place->box;
        int changed = 0;
        for (int y = 0; y < image.height_px; ++y) {
            for (int x = 0; x < image.width_px; ++x) {
                if (image.at(x, y) == before.at(x, y)) continue;
                ++changed;
                ASSERT_TRUE(x >= box.left - 1 && x <= box.left + box.width && y >= box.top - 1 &&
                            y <= box.top + box.height)
                    << x << " " << y;
            }
        }
        EXPECT_GT(changed, box.width * box.height / 4);
    }
}

TEST(Legend, leaves_a_picture_that_is_too_small_alone) {
    for (const auto& [width, height] : {std::pair{16, 512}, {512, 16}, {1, 1}, {120, 120}}) {
        const Image before(width, height);
        Image image = before;
        draw_legend(image, with_rows(8), Corner::LowerLeft);
        EXPECT_EQ(image, before) << width << "x" << height;
    }
}

TEST(Legend, leaves_out_rows_that_have_no_room_and_keeps_the_letters_size) {
    const auto place = place_legend(with_rows(30), 512, 300, Corner::LowerLeft);
    ASSERT_TRUE(place);
    EXPECT_EQ(place->scale, 1);
    EXPECT_GT(place->rows, 8U);
    EXPECT_LT(place->rows, 20U);
    Image image(512, 300);
    draw_legend(image, with_rows(30), Corner::LowerLeft);
    EXPECT_TRUE(shows(image, row_colour(place->rows - 2)));
    EXPECT_FALSE(shows(image, row_colour(place->rows - 1))) << "this row says how many are left out";
}

TEST(Legend, cuts_names_only_where_smaller_letters_are_not_enough) {
    Legend wide{.title = "Seams", .rows = {{{1, 2, 3}, std::string(60, 'm')}}};
    const auto large = place_legend(wide, 2048, 2048, Corner::LowerLeft);
    ASSERT_TRUE(large);
    EXPECT_LT(large->scale, 4) << "smaller letters first";
    EXPECT_LE(large->box.width, 1024);
    const auto small = place_legend(wide, 512, 512, Corner::LowerLeft);
    ASSERT_TRUE(small);
    EXPECT_EQ(small->box.width, 256);
}

TEST(Legend, figures_stand_below_each_other_at_the_right_edge) {
    Image image(512, 512, {255, 255, 255, 255});
    Legend legend{.title = "T", .rows = {{{1, 2, 3}, "a", "7"}, {{1, 2, 3}, "a", "17"}}};
    const auto place = place_legend(legend, 512, 512, Corner::UpperLeft);
    draw_legend(image, legend, Corner::UpperLeft);
    // The last digit of both rows is a seven, so its columns are equal.
    const auto column_sum = [&](int x, int top) {
        int sum = 0;
        for (int y = top; y < top + 10; ++y) sum += image.at(x, y)[0];
        return sum;
    };
    const int right = place->box.left + place->box.width - 8, first = place->box.top + 8 + 16;
    for (int x = right - 5; x < right; ++x) EXPECT_EQ(column_sum(x, first), column_sum(x, first + 13)) << x;
}

// Legends in the font of the interface.
class LegendFont : public testing::Test {
 protected:
    void SetUp() override {
        const std::filesystem::path path = "/usr/share/fonts/opentype/inter/Inter-Regular.otf";
        if (!std::filesystem::exists(path)) GTEST_SKIP() << "fonts-inter is not installed";
        legend_.font = OutlineFont::read(sim::read_file(path, 64U << 20U));
        ASSERT_TRUE(legend_.font);
    }

    Image drawn(int width_px, int height_px) const {
        Image image(width_px, height_px, {255, 255, 255, 255});
        draw_legend(image, legend_, Corner::LowerLeft);
        return image;
    }

    Legend legend_ = with_rows(4);
};

// Colours of letters: between the paper and the ink.
int half_inked(const Image& image) {
    return static_cast<int>(std::ranges::count_if(
        image.pixels, [](const Rgba8& p) { return p[0] == p[1] && p[1] + 8 > p[2] && p[0] > 90 && p[0] < 200; }));
}

TEST_F(LegendFont, has_smooth_edges_that_the_bitmap_font_lacks) {
    const Image smooth = drawn(512, 512);
    legend_.font = nullptr;
    const Image rough = drawn(512, 512);
    EXPECT_GT(half_inked(smooth), 40 + half_inked(rough));
}

TEST_F(LegendFont, grows_with_the_picture_in_small_steps) {
    const auto small = place_legend(legend_, 512, 512, Corner::LowerLeft);
    const auto middle = place_legend(legend_, 768, 800, Corner::LowerLeft);
    ASSERT_TRUE(small && middle);
    EXPECT_EQ(small->scale, 1);
    EXPECT_EQ(middle->scale, 1.5F);
    EXPECT_NEAR(float(middle->box.width), 1.5F * float(small->box.width), 2);
    EXPECT_NEAR(float(middle->box.height), 1.5F * float(small->box.height), 2);
}

TEST_F(LegendFont, leaves_all_outside_the_legend_alone_whatever_the_pictures_size) {
    for (const int side : {400, 512, 777, 1100}) {
        const Image image = drawn(side, side);
        const auto place = place_legend(legend_, side, side, Corner::LowerLeft);
        ASSERT_TRUE(place) << side;
        const int rim = static_cast<int>(std::ceil(place->scale));
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const PixelBox& box = place->box;
                const bool is_inside = x >= box.left - rim && x < box.left + box.width + rim && y >= box.top - rim &&
                                       y < box.top + box.height + rim;
                ASSERT_TRUE(is_inside || image.at(x, y) == (Rgba8{255, 255, 255, 255})) << x << " " << y;
            }
        }
        for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(shows(image, row_colour(i))) << i;
    }
}

TEST_F(LegendFont, cuts_long_names_between_letters) {
    legend_ = {.title = "Panels", .rows = {{{1, 2, 3}, {}}, {{1, 2, 3}, "back"}}, .font = legend_.font};
    for (int i = 0; i < 60; ++i) legend_.rows[0].label += "\xC3\xA4";
    const Image cut = drawn(400, 400);
    legend_.rows[0].label += "\xC3\xB6";
    EXPECT_TRUE(cut == drawn(400, 400)) << "the end is not seen";
}

}  // namespace

// The legend goes where it covers nothing; if there is no such corner, the camera makes room.

namespace {

constexpr PictureSize kSize{.width_px = 400, .height_px = 300};
const Legend kLegend{.title = "Panels", .rows = {{.colour = {}, .label = "front"}, {.colour = {}, .label = "back"}}};

// Upright rectangles in the plane z = 0: low and high corner, m.
Scene scene_of(const std::vector<std::array<Vec2f, 2>>& rectangles) {
    Scene scene;
    ClothItem& cloth = scene.cloths.emplace_back();
    for (const auto& [low, high] : rectangles) {
        const auto first = static_cast<std::uint32_t>(cloth.mesh.x.size());
        for (const Vec2f& p : {low, Vec2f(high.x(), low.y()), high, Vec2f(low.x(), high.y())})
            cloth.mesh.x.emplace_back(p.x(), p.y(), 0.0F);
        cloth.mesh.triangles.push_back({first, first + 1, first + 2});
        cloth.mesh.triangles.push_back({first, first + 2, first + 3});
    }
    return scene;
}

SubjectFrame frame_of(const Scene& scene) {
    return {.points = scene.cloths.front().mesh.x, .direction = {}, .options = {.aspect = kSize.aspect()}};
}

LegendPlace place_in(Scene& scene, const SubjectFrame& frame) {
    scene.camera = frame.camera();
    const std::vector<float> turns{0};
    return find_legend_place(kLegend, {.scene = scene, .frame = frame, .turns = turns}, kSize);
}

// An L: the column at the left and the beam at the bottom leave the upper right corner free.
Scene letter_l() {
    return scene_of({{Vec2f(-2, 0), Vec2f(-1.6F, 3)}, {Vec2f(-2, 0), Vec2f(2, 0.4F)}});
}

TEST(LegendPlace, is_the_corner_that_the_subject_leaves_free) {
    Scene scene = letter_l();
    const LegendPlace place = place_in(scene, frame_of(scene));
    EXPECT_EQ(place.corner, Corner::UpperRight);
    EXPECT_EQ(place.camera.eye, scene.camera.eye) << "the camera stays";
}

TEST(LegendPlace, is_made_by_a_camera_farther_away_if_no_corner_is_free) {
    Scene scene = scene_of({{Vec2f(-2, 0), Vec2f(2, 3)}});
    SubjectFrame frame = frame_of(scene);
    const LegendPlace place = place_in(scene, frame);
    EXPECT_GT(pixel_size(place.camera, kSize.height_px), pixel_size(scene.camera, kSize.height_px));
    frame.may_move = false;
    EXPECT_EQ(place_in(scene, frame).camera.eye, scene.camera.eye);
}

}  // namespace

}  // namespace selvedge::render
