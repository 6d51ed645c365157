#include "sim/exchange/uv_atlas.h"

#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "sim/core/error.h"

namespace selvedge::sim {
namespace {

MaterialBox box(double width, double height, const Vec2d& low = Vec2d::Zero()) {
    return {low, low + Vec2d(width, height)};
}

// In texels, without its margin.
MaterialBox box_in_texels(const UvChart& chart, const MaterialBox& material, const AtlasOptions& options) {
    MaterialBox texels;
    for (const auto corner : {MaterialBox::BottomLeft, MaterialBox::TopRight})
        texels.extend(options.size_px * chart.uv(material.corner(corner)));
    return texels;
}

// Every chart is inside the square by a margin and two margins away from every other one.
void expect_sound(const std::vector<UvChart>& charts, const std::vector<MaterialBox>& boxes,
                  const AtlasOptions& options) {
    constexpr double kRounding = 1e-6;  // texels
    ASSERT_EQ(charts.size(), boxes.size());
    std::vector<MaterialBox> texels;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_EQ(charts[i].scale, charts[0].scale);
        texels.push_back(box_in_texels(charts[i], boxes[i], options));
        EXPECT_GE(texels[i].min().minCoeff(), options.margin_px - kRounding);
        EXPECT_LE(texels[i].max().maxCoeff(), options.size_px - options.margin_px + kRounding);
        const Vec2d low = texels[i].min();
        EXPECT_NEAR(low.x(), std::round(low.x()), kRounding);
        EXPECT_NEAR(low.y(), std::round(low.y()), kRounding);
        for (std::size_t j = 0; j < i; ++j) {
            const Vec2d gap = (texels[i].min() - texels[j].max()).cwiseMax(texels[j].min() - texels[i].max());
            EXPECT_GE(gap.maxCoeff(), 2 * options.margin_px - kRounding) << i << " and " << j;
        }
    }
}

double area_of(const std::vector<MaterialBox>& boxes) {
    double area = 0;
    for (const MaterialBox& material : boxes) area += material.volume();
    return area;
}

TEST(UvAtlas, charts_of_random_panels_lie_inside_apart_and_at_one_scale) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> side(0.005, 1.2), place(-2, 2);
    for (int garment = 0; garment < 200; ++garment) {
        const AtlasOptions options{.size_px = 256 << random() % 5, .margin_px = static_cast<int>(random() % 9)};
        std::vector<MaterialBox> boxes(1 + random() % 40);
        for (MaterialBox& material : boxes) material = box(side(random), side(random), {place(random), place(random)});
        expect_sound(pack_charts(boxes, options), boxes, options);
        if (HasFailure()) FAIL() << "garment " << garment;
    }
}

TEST(UvAtlas, most_of_the_square_is_used) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> side(0.2, 0.9);
    for (int garment = 0; garment < 20; ++garment) {
        std::vector<MaterialBox> boxes(24);
        for (MaterialBox& material : boxes) material = box(side(random), side(random));
        const double scale = pack_charts(boxes, {.size_px = 4096, .margin_px = 4})[0].scale;
        EXPECT_GT(area_of(boxes) * scale * scale, 0.7);
    }
}

TEST(UvAtlas, a_single_panel_fills_the_square_between_the_margins) {
    const std::vector<MaterialBox> boxes{box(0.5, 0.5, {-0.25, 0.1})};
    const AtlasOptions options{.size_px = 1024, .margin_px = 12};
    const MaterialBox texels = box_in_texels(pack_charts(boxes, options)[0], boxes[0], options);
    EXPECT_LT((texels.min() - Vec2d(12, 12)).norm(), 1e-6);
    EXPECT_LT((texels.max() - Vec2d(1012, 1012)).norm(), 1e-6);
}

TEST(UvAtlas, a_panel_is_turned_where_that_makes_all_larger) {
    const std::vector<MaterialBox> boxes{box(1, 0.5), box(0.5, 1)};
    const std::vector<UvChart> charts = pack_charts(boxes, {.size_px = 1024, .margin_px = 0});
    expect_sound(charts, boxes, {.size_px = 1024, .margin_px = 0});
    EXPECT_NE(charts[0].is_turned, charts[1].is_turned);
    EXPECT_NEAR(charts[0].scale, 1, 1e-3);
}

TEST(UvAtlas, material_coordinates_come_back) {
    for (const bool is_turned : {false, true}) {
        const UvChart chart{.scale = 0.7, .is_turned = is_turned, .offset = {0.2, 0.9}};
        const Vec2d material(0.31, -0.12);
        EXPECT_LT((chart.material(chart.uv(material)) - material).norm(), 1e-12);
        // No mirror image: the weft's direction is to the right of the warp's in the texture too.
        const Vec2d weft = chart.uv({1, 0}) - chart.uv({0, 0}), warp = chart.uv({0, 1}) - chart.uv({0, 0});
        EXPECT_NEAR(cross2(weft, warp), 0.49, 1e-12);
    }
}

TEST(UvAtlas, a_texture_without_room_for_the_margins_is_refused) {
    const std::vector<MaterialBox> boxes(100, box(0.1, 0.1));
    EXPECT_THROW(pack_charts(boxes, {.size_px = 128, .margin_px = 8}), InputError);
    EXPECT_EQ(pack_charts(boxes, {.size_px = 256, .margin_px = 8}).size(), 100U);
}

TEST(UvAtlas, panels_without_area_get_a_texel) {
    const std::vector<MaterialBox> boxes{box(0, 0), box(0.2, 0)};
    expect_sound(pack_charts(boxes), boxes, {});
}

}  // namespace
}  // namespace selvedge::sim
