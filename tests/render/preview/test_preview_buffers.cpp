#include <gtest/gtest.h>

#include "render/draw/cloth_vertices.h"
#include "render/preview/preview_renderer.h"
#include "render/scene/colour.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge::render {
namespace {

Vec3f mean_light(const Image& image) {
    Vec3d sum = Vec3d::Zero();
    for (const Rgba8& pixel : image.pixels) sum += to_linear(sim::Rgb8{pixel[0], pixel[1], pixel[2]}).cast<double>();
    return (sum / static_cast<double>(image.pixels.size())).cast<float>();
}

TEST(PreviewWeave, halves_down_to_one_pixel_and_keeps_its_mean_light) {
    const sim::Sett sett = sim::find_tartan("royal_stewart");
    const std::vector<Image> sizes = preview_weave(sett);
    EXPECT_EQ(sizes.back().width_px * sizes.back().height_px, 1);
    for (std::size_t i = 1; i < sizes.size(); ++i) EXPECT_EQ(sizes[i].width_px, (sizes[i - 1].width_px + 1) / 2);
    const Vec3f mean = 0.5F * (sum_warp(sett).mean + sum_weft(sett).mean);
    for (const Image& size : sizes) EXPECT_LT((mean_light(size) - mean).cwiseAbs().maxCoeff(), 0.01F);
}

TEST(PreviewWeave, a_denim_shows_mostly_its_warp) {
    const sim::Sett sett = sim::parse_threadcount("B8 weft: W8 weave: denim");
    const Vec3f denim = mean_light(preview_weave(sett).front());
    const Vec3f expected = 0.75F * sum_warp(sett).mean + 0.25F * sum_weft(sett).mean;
    EXPECT_LT((denim - expected).cwiseAbs().maxCoeff(), 0.01F);
}

}  // namespace

}  // namespace selvedge::render
