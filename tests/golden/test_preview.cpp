// The preview renderer, and pictures that stay in GL memory (PictureTexture).
#include <gtest/gtest.h>

#include <cmath>

#include "render/draw/renderer.h"
#include "render/image/image.h"
#include "render/preview/preview_renderer.h"
#include "render/scene/colour.h"
#include "tests/golden/frozen_scene.h"

namespace selvedge::test {
namespace {

constexpr int kWidth = 120, kHeight = 96;

render::SceneView view_of(const render::Scene& scene) {
    return {.scene = std::make_shared<const render::Scene>(scene), .camera = scene.camera, .light = scene.light};
}

class Previews : public testing::Test {
 protected:
    Previews() { to_.resize(kWidth, kHeight); }

    render::Image preview(render::PreviewRenderer& renderer, const render::SceneView& view) {
        renderer.draw(view, to_);
        return to_.read();
    }
    render::Image fresh_preview(const render::Scene& scene) {
        render::PreviewRenderer renderer(*context_);
        return preview(renderer, view_of(scene));
    }

    std::unique_ptr<render::GlContext> context_ = render::make_context();
    render::PictureTexture to_{context_->gl()};
};

render::Scene rippled(render::Scene scene) {
    for (Vec3f& x : scene.cloths[0].mesh.x) x.y() += 0.01F * std::sin(40 * x.x());
    scene.cloths[0].mesh.normals.clear();
    return scene;
}

// Mean colours of the picture's blocks of 12 x 12 px.
std::vector<Vec3f> block_means(const render::Image& image) {
    std::vector<Vec3f> means;
    for (int top = 0; top < image.height_px; top += 12) {
        for (int left = 0; left < image.width_px; left += 12) {
            Vec3f sum = Vec3f::Zero();
            for (int i = 0; i < 144; ++i) {
                const render::Rgba8& pixel = image.at(left + i % 12, top + i / 12);
                sum += Vec3f(pixel[0], pixel[1], pixel[2]);
            }
            means.emplace_back(sum / 144);
        }
    }
    return means;
}

TEST_F(Previews, a_shared_view_in_a_texture_is_the_picture_of_its_scene) {
    render::Renderer renderer(*context_);
    const render::Image image =
        renderer.draw(make_frozen_scene(), {.width_px = kWidth, .height_px = kHeight, .tile_px = 50});
    renderer.draw(view_of(make_frozen_scene()), to_, {.tile_px = 50});
    EXPECT_TRUE(image == to_.read());
}

TEST_F(Previews, are_like_the_picture_from_afar) {
    for (const render::ShowMode show : {render::ShowMode::Tartan, render::ShowMode::Level, render::ShowMode::Plain}) {
        const render::Scene scene = make_frozen_scene({.show = show});
        const std::vector<Vec3f> drafted = block_means(fresh_preview(scene));
        render::Renderer renderer(*context_);
        const std::vector<Vec3f> fine = block_means(renderer.draw(scene, {.width_px = kWidth, .height_px = kHeight}));
        double difference = 0;
        for (std::size_t i = 0; i < fine.size(); ++i) difference += double((drafted[i] - fine[i]).cwiseAbs().mean());
        EXPECT_LT(difference / double(fine.size()), 14) << "of 255, in show mode " << int(show);
    }
}

TEST_F(Previews, have_the_same_bits_whatever_was_drawn_before) {
    render::PreviewRenderer renderer(*context_);
    const render::Scene still = make_frozen_scene(), moved = rippled(still);
    const render::Scene levels = make_frozen_scene({.show = render::ShowMode::Level, .has_ball = false});
    const render::Image first = preview(renderer, view_of(still));
    EXPECT_FALSE(first == preview(renderer, view_of(moved)));
    for (const render::Scene& scene : {moved, levels, still, moved}) {
        EXPECT_TRUE(fresh_preview(scene) == preview(renderer, view_of(scene)));
    }
}

TEST_F(Previews, follow_the_camera_and_the_size_of_the_same_scene) {
    render::PreviewRenderer renderer(*context_);
    render::SceneView view = view_of(make_frozen_scene());
    const render::Image first = preview(renderer, view);
    view.camera = turned(view.camera, 0.4F, Vec3f::Zero());
    const render::Image second = preview(renderer, view);
    EXPECT_FALSE(first == second);
    render::Scene same = make_frozen_scene();
    same.camera = view.camera;
    EXPECT_TRUE(second == fresh_preview(same));
    to_.resize(kHeight, kWidth);
    EXPECT_EQ(preview(renderer, view).width_px, kHeight);
}

TEST_F(Previews, fill_a_picture_that_has_grown) {
    render::PreviewRenderer renderer(*context_);
    const render::SceneView view = view_of(make_frozen_scene());
    to_.resize(kWidth, kHeight / 2);
    preview(renderer, view);
    to_.resize(kWidth, kHeight);
    EXPECT_TRUE(preview(renderer, view) == fresh_preview(*view.scene));
}

// Samples of one view, until its picture is smooth.
constexpr int kSamples = 16;

render::Image smooth_preview(render::PreviewRenderer& renderer, const render::SceneView& view,
                             render::PictureTexture& to) {
    for (int i = 0; i < kSamples; ++i) renderer.refine(view, i, to);
    return to.read();
}

// The mean, in linear light, of each block of `factor` x `factor` px.
std::vector<Vec3f> shrunk(const render::Image& image, int factor) {
    std::vector<Vec3f> means;
    for (int top = 0; top < image.height_px; top += factor) {
        for (int left = 0; left < image.width_px; left += factor) {
            Vec3f sum = Vec3f::Zero();
            for (int i = 0; i < factor * factor; ++i) {
                const render::Rgba8& pixel = image.at(left + i % factor, top + i / factor);
                sum += render::to_linear(sim::Rgb8{pixel[0], pixel[1], pixel[2]});
            }
            means.emplace_back(sum / float(factor * factor));
        }
    }
    return means;
}

double mean_difference(const std::vector<Vec3f>& a, const std::vector<Vec3f>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += double((a[i] - b[i]).cwiseAbs().mean());
    return sum / double(a.size());
}

// As a tartan does that is seen from the side: its stripes are not much wider than a pixel.
render::SceneView striped_view() {
    render::Scene scene = make_frozen_scene();
    scene.camera = turned(scene.camera, 0.9F, Vec3f::Zero());
    return view_of(scene);
}

TEST_F(Previews, at_rest_are_the_mean_of_much_finer_pictures) {
    render::PreviewRenderer renderer(*context_);
    const render::SceneView view = striped_view();
    const render::Image moving = preview(renderer, view);
    const render::Image resting = smooth_preview(renderer, view, to_);
    constexpr int kFiner = 8;
    to_.resize(kFiner * kWidth, kFiner * kHeight);
    const std::vector<Vec3f> fine = shrunk(preview(renderer, view), kFiner);
    const double of_moving = mean_difference(shrunk(moving, 1), fine);
    const double of_resting = mean_difference(shrunk(resting, 1), fine);
    RecordProperty("differences", std::to_string(of_moving) + " " + std::to_string(of_resting));
    EXPECT_LT(of_resting, 0.5 * of_moving) << of_moving << " " << of_resting;
}

TEST_F(Previews, at_rest_begin_as_they_were_and_show_a_change_at_once) {
    render::PreviewRenderer renderer(*context_);
    const render::SceneView view = striped_view(), other = view_of(make_frozen_scene());
    const render::Image first = preview(renderer, view);
    renderer.refine(view, 0, to_);
    EXPECT_TRUE(to_.read() == first) << "no pixel jumps when the view comes to rest";
    const render::Image smooth = smooth_preview(renderer, view, to_);
    EXPECT_FALSE(smooth == first);
    EXPECT_TRUE(preview(renderer, other) == fresh_preview(*other.scene));
    EXPECT_TRUE(smooth_preview(renderer, view, to_) == smooth) << "whatever was drawn before";
    to_.resize(kHeight, kWidth);
    EXPECT_EQ(smooth_preview(renderer, view, to_).width_px, kHeight);
}

TEST_F(Previews, show_painted_cloth_marks_and_an_empty_room) {
    render::Scene scene = make_frozen_scene({.show = render::ShowMode::Plain});
    const render::Image plain = fresh_preview(scene);
    render::ClothItem& cloth = scene.cloths[0];
    cloth.show = render::ShowMode::Strain;
    cloth.paint = render::ClothPaint{.map = {{255, 0, 0}, {0, 0, 255}}, .places = {}};
    cloth.paint->places.assign(cloth.mesh.triangles.size(), {0.F, 0.F, 0.F});
    const render::Image red = fresh_preview(scene);
    cloth.paint->places.assign(cloth.mesh.triangles.size(), {1.F, 1.F, 1.F});
    const render::Image blue = fresh_preview(scene);
    const render::Rgba8 red_pixel = red.at(kWidth / 2, kHeight / 3), blue_pixel = blue.at(kWidth / 2, kHeight / 3);
    EXPECT_GT(red_pixel[0], red_pixel[2] + 100);
    EXPECT_GT(blue_pixel[2], blue_pixel[0] + 100);
    scene.solids.push_back({.x = {{-2, -2, 0.6F}, {2, -2, 0.6F}, {0, 3, 0.6F}},
                            .normals = std::vector<Vec3f>(3, Vec3f::UnitZ()),
                            .colours = std::vector<sim::Rgb8>(3, sim::Rgb8{0, 255, 0}),
                            .triangles = {{0, 1, 2}}});
    const render::Rgba8 green_pixel = fresh_preview(scene).at(kWidth / 2, kHeight / 3);
    EXPECT_GT(green_pixel[1], green_pixel[0] + 100);
    const render::Image empty = fresh_preview({});
    EXPECT_EQ(empty.at(kWidth / 2, kHeight / 2)[3], 255);
    EXPECT_FALSE(empty == plain);
}

}  // namespace
}  // namespace selvedge::test
