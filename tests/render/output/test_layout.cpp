// Legend placement: the legend never covers the subject, for any shape, any picture size, and a full turn.
#include "render/output/picture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/draw/renderer.h"

namespace selvedge::render {
namespace {

struct Size {
    float width;  // m
    float height;
};

// A closed tube of two panels on the floor, with this width and height.
sim::DrawMesh tube(const Size& size) {
    constexpr std::uint32_t around = 24, rows = 12;
    sim::DrawMesh mesh;
    for (std::uint32_t j = 0; j <= rows; ++j) {
        for (std::uint32_t i = 0; i < around; ++i) {
            const float turn = 6.2831853F * float(i) / float(around);
            mesh.x.emplace_back(0.5F * size.width * std::sin(turn), size.height * float(j) / float(rows),
                                0.1F * std::cos(turn));
        }
    }
    for (std::uint32_t j = 0; j < rows; ++j) {
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t a = j * around + i, b = j * around + (i + 1) % around;
            mesh.triangles.push_back({a, b, b + around});
            mesh.triangles.push_back({a, b + around, a + around});
            const std::uint16_t panel = i < around / 2 ? 0 : 1;
            mesh.panel.insert(mesh.panel.end(), {panel, panel});
        }
    }
    mesh.panel_names = {"one_panel_with_a_name", "and_another"};
    return mesh;
}

// Opaque pixels of the subject in the legend's box, in the scene drawn without the legend.
int hidden_pixels(const Scene& shown, const Layout& layout, const PictureOptions& options) {
    Scene scene = shown;
    scene.background.is_transparent = true;
    scene.has_ground = false;
    const Image image = Renderer().draw(scene, render_options(options));
    const auto place = place_legend(*layout.legend, options.width_px, options.height_px, layout.corner);
    if (!place) return 0;
    int hidden = 0;
    for (int y = place->box.top; y < place->box.top + place->box.height; ++y)
        for (int x = place->box.left; x < place->box.left + place->box.width; ++x)
            hidden += image.at(x, y)[3] > 0 ? 1 : 0;
    return hidden;
}

TEST(Layout, the_legend_hides_nothing_of_the_figure) {
    int would_hide = 0;
    for (const Size size : {Size{1.0F, 1.0F}, {0.4F, 1.6F}, {2.0F, 0.5F}}) {
        const sim::DrawMesh mesh = tube(size);
        for (const auto& [width, height] : {std::pair{256, 256}, {400, 200}, {220, 400}}) {
            for (const ShowMode mode : {ShowMode::Panels, ShowMode::Seams}) {
                PictureOptions options;
                options.width_px = width;
                options.height_px = height;
                options.show = mode;
                const Layout layout = compose({.garment = mesh}, options);
                EXPECT_EQ(hidden_pixels(layout.scene, layout, options), 0)
                    << size.width << " " << width << "x" << height;
                Layout as_without = layout;
                options.show = ShowMode::Plain;
                as_without.scene.camera = compose({.garment = mesh}, options).scene.camera;
                as_without.corner = Corner::LowerLeft;
                would_hide += hidden_pixels(as_without.scene, as_without, options);
            }
        }
    }
    EXPECT_GT(would_hide, 1000) << "if nobody cared";
}

TEST(Layout, the_legend_hides_nothing_through_a_whole_turn) {
    const sim::DrawMesh mesh = tube({1.2F, 0.8F});
    PictureOptions options;
    options.width_px = options.height_px = 256;
    options.show = ShowMode::Panels;
    std::vector<float> turns;
    for (int i = 0; i < 8; ++i) turns.push_back(0.78539816F * float(i));
    const Layout layout = compose({.garment = mesh}, options, turns);
    for (const float angle : turns)
        EXPECT_EQ(hidden_pixels(turned(layout, options, angle), layout, options), 0) << angle;
}

TEST(Layout, a_figure_that_leaves_a_corner_free_is_as_large_as_without_a_legend) {
    const sim::DrawMesh mesh = tube({0.4F, 1.6F});
    PictureOptions options;
    options.width_px = options.height_px = 512;
    const Camera plain = compose({.garment = mesh}, options).scene.camera;
    options.show = ShowMode::Panels;
    const Camera with_legend = compose({.garment = mesh}, options).scene.camera;
    EXPECT_EQ(plain.eye, with_legend.eye);
}

TEST(Layout, a_camera_given_by_its_eye_is_left_as_it_is) {
    const sim::DrawMesh mesh = tube({1, 1});
    PictureOptions options;
    options.show = ShowMode::Panels;
    options.camera = parse_camera("0.5,1,2,0,0.5,0");
    const Camera camera = compose({.garment = mesh}, options).scene.camera;
    EXPECT_EQ(camera.eye, Vec3f(0.5F, 1, 2));
    EXPECT_EQ(camera.target, Vec3f(0, 0.5F, 0));
}

}  // namespace
}  // namespace selvedge::render
