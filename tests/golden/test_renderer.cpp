// Properties of every picture, whatever it shows.
#include "render/draw/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "render/draw/ambient_occlusion.h"
#include "render/gl/target.h"
#include "render/image/image.h"
#include "sim/core/error.h"
#include "tests/golden/frozen_scene.h"

namespace selvedge::test {
namespace {

render::Scene frozen() {
    return make_frozen_scene();
}

TEST(Renderer, the_same_scene_gives_the_same_bits) {
    const render::RenderOptions options{.width_px = 96, .height_px = 64};
    render::Renderer renderer;
    const render::Image first = renderer.draw(frozen(), options);
    EXPECT_TRUE(first == renderer.draw(frozen(), options)) << "drawn again by the same renderer";
}

TEST(Renderer, a_picture_in_tiles_is_the_picture_in_one_piece) {
    render::Renderer renderer;
    const render::Image whole = renderer.draw(frozen(), {.width_px = 150, .height_px = 110});
    const render::Image tiled = renderer.draw(frozen(), {.width_px = 150, .height_px = 110, .tile_px = 64});
    const render::Comparison comparison = compare(whole, tiled);
    EXPECT_TRUE(is_alike(comparison, {.tolerance = 3, .share_beyond = 0.002})) << describe(comparison);
}

TEST(Renderer, supersampling_changes_the_sampling_and_not_the_picture) {
    render::Renderer renderer;
    const render::Image once = renderer.draw(frozen(), {.width_px = 96, .height_px = 96});
    const render::Image twice = renderer.draw(frozen(), {.width_px = 96, .height_px = 96, .supersample = 2});
    EXPECT_FALSE(once == twice);
    EXPECT_TRUE(is_alike(compare(once, twice, {.tolerance = 60}), {.tolerance = 60, .share_beyond = 0.05}));
}

TEST(Renderer, sizes_that_no_picture_has_are_input_errors) {
    render::Renderer renderer;
    for (const auto& [width, height] : {std::pair{0, 100}, {100, -1}, {20000, 10}, {16384, 16384}}) {
        EXPECT_THROW(renderer.draw(frozen(), {.width_px = width, .height_px = height}), sim::InputError)
            << width << "x" << height;
    }
}

TEST(Renderer, a_picture_of_one_pixel_and_one_of_one_row_can_be_drawn) {
    render::Renderer renderer;
    EXPECT_EQ(renderer.draw(frozen(), {.width_px = 1, .height_px = 1}).pixels.size(), 1U);
    EXPECT_EQ(renderer.draw(frozen(), {.width_px = 300, .height_px = 1}).width_px, 300);
}

TEST(Renderer, without_material_coordinates_a_tartan_is_drawn_plain) {
    render::Scene scene = frozen();
    scene.cloths[0].mesh.u.clear();
    render::Scene plain = scene;
    plain.cloths[0].show = render::ShowMode::Plain;
    render::Renderer renderer;
    const render::RenderOptions options{.width_px = 64, .height_px = 64};
    EXPECT_TRUE(renderer.draw(scene, options) == renderer.draw(plain, options));
}

TEST(Renderer, a_transparent_backdrop_leaves_corners_empty_and_cloth_whole) {
    render::Scene scene = frozen();
    scene.background.is_transparent = true;
    const render::Image image = render::Renderer().draw(scene, {.width_px = 128, .height_px = 128});
    EXPECT_EQ(image.at(0, 0)[3], 0);
    EXPECT_EQ(image.at(64, 50)[3], 255);
}

// The surface of the cloth, moved outwards, as a body.
render::BodyItem skin_over(const sim::DrawMesh& cloth, float by) {
    render::BodyItem skin{.x = cloth.x, .normals = cloth.normals, .triangles = cloth.triangles};
    for (std::size_t v = 0; v < skin.x.size(); ++v) skin.x[v] += by * skin.normals[v];
    return skin;
}

TEST(Renderer, skin_does_not_show_through_cloth_that_lies_half_a_millimetre_in_it) {
    const auto draw = [](float by) {
        render::Scene scene = make_frozen_scene({.view = render::View::Front, .has_ball = false});
        scene.cloths[0].show = render::ShowMode::Plain;
        scene.cloths[0].colour = {0xC0, 0x10, 0x10};
        scene.bodies = {skin_over(scene.cloths[0].mesh, by)};
        return render::Renderer().draw(scene, {.width_px = 128, .height_px = 128}).at(64, 50);
    };
    EXPECT_GT(draw(0.0005F)[0], 2 * draw(0.0005F)[1]) << "red cloth";
    EXPECT_LT(draw(0.003F)[0], 2 * draw(0.003F)[1]) << "skin";
}

// A flat surface between corners, in counterclockwise order.
render::BodyItem plate(const std::array<Vec3f, 4>& corners) {
    const Vec3f normal = (corners[1] - corners[0]).cross(corners[3] - corners[0]).normalized();
    return {.x = {corners.begin(), corners.end()},
            .normals = std::vector<Vec3f>(4, normal),
            .triangles = {{0, 1, 2}, {0, 2, 3}}};
}

// As of a hem over a thigh: a slanted strip 2 cm wide and 12 mm before a wall, which the light grazes.
TEST(Renderer, the_shadow_of_a_hem_is_whole_where_the_light_grazes) {
    constexpr int kSide = 160;
    render::Scene scene;
    scene.bodies = {
        plate({Vec3f(-0.5F, -0.5F, 0), {0.5F, -0.5F, 0}, {0.5F, 0.5F, 0}, {-0.5F, 0.5F, 0}}),
        plate({Vec3f(-0.06F, -0.3F, 0.012F), {-0.04F, -0.3F, 0.012F}, {0.06F, 0.3F, 0.012F}, {0.04F, 0.3F, 0.012F}})};
    scene.light = {.to_key = {0.95F, 0.05F, 0.3F}, .fill = 0};
    scene.camera = {.eye = {-0.04F, 0, 0.6F}, .target = {-0.04F, 0, 0}};
    scene.has_ground = false;
    const render::Image image = render::Renderer().draw(scene, {.width_px = kSide, .height_px = kSide});
    double least = 1e9, most = 0;
    for (int y = kSide / 4; y < 3 * kSide / 4; ++y) {
        double dark = 0;  // pixels that are in shadow, by their share
        for (int x = 0; x < kSide; ++x) dark += 1 - image.at(x, y)[1] / double(image.at(2, y)[1]);
        least = std::min(least, dark);
        most = std::max(most, dark);
    }
    EXPECT_GT(least, 2);
    EXPECT_LT(most, 2 * least) << "ragged";
}

// From afar every stripe is finer than a pixel: the cloth must have the sett's mean colour without a pattern.
TEST(Renderer, from_afar_the_tartan_neither_shimmers_nor_shifts_its_colour) {
    render::Scene scene = make_frozen_scene({.view = render::View::Front});
    scene.cloths[0].sett_scale = 0.002F;
    render::Renderer renderer;
    const render::RenderOptions options{.width_px = 96, .height_px = 96};
    const render::Image here = renderer.draw(scene, options);
    scene.cloths[0].sett_position = Vec2f(0.00011F, 0.00007F);
    const render::Comparison comparison = compare(here, renderer.draw(scene, options));
    EXPECT_LE(comparison.largest_step, 8) << describe(comparison);
}

// Grey value at a position in the picture, px from its upper left corner, interpolated between pixels.
double grey_at(const render::Image& image, const Vec2f& at) {
    const int x = static_cast<int>(std::floor(at.x() - 0.5F)), y = static_cast<int>(std::floor(at.y() - 0.5F));
    const double s = at.x() - 0.5 - x, t = at.y() - 0.5 - y;
    const auto grey = [&](int i, int j) { return (image.at(i, j)[0] + image.at(i, j)[1] + image.at(i, j)[2]) / 3.0; };
    return (1 - t) * ((1 - s) * grey(x, y) + s * grey(x + 1, y)) +
           t * ((1 - s) * grey(x, y + 1) + s * grey(x + 1, y + 1));
}

Vec2f place_in_picture(const render::Camera& camera, const Vec3f& x, int side_px) {
    const Eigen::Vector4f clip = projection_matrix(camera, 1) * view_matrix(camera) * x.homogeneous();
    const auto side = static_cast<float>(side_px);
    return {(clip.x() / clip.w() + 1) / 2 * side, (1 - clip.y() / clip.w()) / 2 * side};
}

render::Scene turned(render::Scene scene, float angle) {
    const Eigen::Matrix3f turn = Eigen::AngleAxisf(angle, Vec3f::UnitY()).toRotationMatrix();
    scene.camera.eye = scene.camera.target + turn * (scene.camera.eye - scene.camera.target);
    scene.camera.up = turn * scene.camera.up;
    return scene;
}

// Largest change, in bytes, of spots on a matt dome under a fixed light, from one small turn of the camera to the next.
double greatest_flicker(const render::Scene& scene) {
    constexpr int side = 256, turns = 8;
    render::Renderer renderer;
    std::vector<double> before;
    double greatest = 0;
    for (int i = 0; i < turns; ++i) {
        const render::Scene now = turned(scene, 0.004F * float(i));
        const render::Image image = renderer.draw(now, {.width_px = side, .height_px = side});
        std::vector<double> greys;
        const sim::DrawMesh& mesh = now.cloths[0].mesh;
        for (std::size_t v = 0; v < mesh.x.size(); ++v) {
            const Vec3f& x = mesh.x[v];
            const bool is_seen = x.y() > 0.62F && mesh.normals[v].dot((scene.camera.eye - x).normalized()) > 0.4F;
            if (is_seen) greys.push_back(grey_at(image, place_in_picture(now.camera, x, side)));
        }
        for (std::size_t v = 0; v < before.size(); ++v) greatest = std::max(greatest, std::abs(greys[v] - before[v]));
        before = greys;
    }
    return greatest;
}

render::Scene matt_dome() {
    render::Scene scene = make_frozen_scene({.view = render::View::Front, .show = render::ShowMode::Plain});
    scene.cloths[0].material = {.gloss = 0, .roughness = 0.5F, .sheen = 0};
    scene.cloths[0].mesh.panel.assign(scene.cloths[0].mesh.panel.size(), 0);  // no seam
    scene.cloths[0].mesh.u.clear();
    scene.camera.eye += Vec3f(0, 1.2F, 0);
    scene.cloths[0].colour = {0x90, 0x90, 0x90};
    return scene;
}

TEST(Flicker, a_still_spot_keeps_its_light_when_the_camera_turns) {
    EXPECT_LT(greatest_flicker(matt_dome()), 2);
}

TEST(Flicker, is_seen_where_there_is_some) {
    render::Scene scene = matt_dome();
    scene.cloths[0].show = render::ShowMode::Edges;  // lines about as wide as a pixel, so their coverage of it changes
    EXPECT_GT(greatest_flicker(scene), 8);
}

TEST(Flicker, light_on_the_ball_hardly_changes_when_cloth_moves_by_a_tenth_of_a_millimetre) {
    render::Scene scene = make_frozen_scene();
    const render::Casters before = cloth_casters_of(scene), bodies = body_casters_of(scene);
    for (Vec3f& x : scene.cloths[0].mesh.x) x.y() += 0.0001F;
    const render::Casters after = cloth_casters_of(scene);
    const render::LitPoints ball{.x = scene.bodies[0].x, .normals = scene.bodies[0].normals};
    const std::vector<render::AmbientVisibility> a = render::AmbientOcclusion().bake(before, bodies, ball),
                                                 b = render::AmbientOcclusion().bake(after, bodies, ball);
    float greatest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) greatest = std::max(greatest, std::abs(a[i].front - b[i].front));
    EXPECT_LT(greatest, 0.04F);
    EXPECT_GT(greatest, 0);
}

TEST(Renderer, a_picture_does_not_depend_on_those_before_it) {
    const render::RenderOptions options{.width_px = 96, .height_px = 64};
    const render::Scene scene = frozen();
    const render::Image alone = render::Renderer().draw(scene, options);
    render::Scene moved = scene, lit = scene, plain = scene;
    for (Vec3f& x : moved.cloths[0].mesh.x) x *= 1.01F;
    lit.light.to_key.x() += 0.5F;
    plain.cloths[0].show = render::ShowMode::Plain;
    for (const render::Scene& other : {moved, lit, plain, turned(scene, 0.3F)}) {
        render::Renderer renderer;
        EXPECT_FALSE(renderer.draw(other, options) == alone);
        EXPECT_TRUE(renderer.draw(scene, options) == alone);
    }
}

TEST(AmbientOcclusion, a_plate_under_another_is_dark_above_and_open_below) {
    render::Casters casters;
    for (const float y : {0.0F, 0.1F}) {
        const auto base = static_cast<std::uint32_t>(casters.x.size());
        for (const auto& [x, z] : {std::pair{-1.0F, -1.0F}, {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}}) {
            casters.x.emplace_back(x, y, z);
        }
        casters.triangles.push_back({base, base + 2, base + 1});
        casters.triangles.push_back({base, base + 3, base + 2});
    }
    const std::vector<render::AmbientVisibility> open = render::AmbientOcclusion().bake(
        casters, {},
        {.x = {Vec3f(0, 0, 0), Vec3f(0, 0.1F, 0)}, .normals = {Vec3f(0, 1, 0), Vec3f(0, 1, 0)}, .two_sided = 2});
    EXPECT_LT(open[0].front, 0.1F);
    EXPECT_GT(open[0].back, 0.99F);
    EXPECT_GT(open[1].front, 0.99F);
    EXPECT_LT(open[1].back, 0.1F);
}

TEST(Program, a_shader_that_does_not_compile_says_where) {
    const auto context = render::make_context();
    try {
        const render::Program program(context->gl(), {{"good.vert", "void main() { gl_Position = vec4(0.0); }"}},
                                      {{"bad.frag", "out vec4 colour;\nvoid main() { colour = vec3(1.0) * tartn; }"}});
        FAIL() << "no error";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("bad.frag"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("tartn"), std::string::npos) << error.what();
    }
}

// The kinds of GL context: all of them give the same picture.

std::optional<std::string> why_absent(render::ContextKind maker) {
    try {
        make_context(maker);
        return std::nullopt;
    } catch (const sim::InputError& error) {
        return error.problem();
    }
}

class WithEnvironment {
 public:
    explicit WithEnvironment(const char* value) {
        if (const char* before = std::getenv(kName)) before_ = before;
        setenv(kName, value, 1);
    }
    ~WithEnvironment() { before_ ? setenv(kName, before_->c_str(), 1) : unsetenv(kName); }

 private:
    static constexpr const char* kName = "SELVEDGE_GL";
    std::optional<std::string> before_;
};

TEST(Contexts, both_makers_draw_the_same_picture) {
    for (const render::ContextKind maker : {render::ContextKind::OSMesa, render::ContextKind::Egl}) {
        if (const auto reason = why_absent(maker)) GTEST_SKIP() << name(maker) << " is absent: " << *reason;
    }
    const render::Scene scene = make_frozen_scene();
    const render::RenderOptions options{.width_px = 200, .height_px = 160};
    const render::Image osmesa = render::Renderer(render::ContextKind::OSMesa).draw(scene, options);
    const render::Image egl = render::Renderer(render::ContextKind::Egl).draw(scene, options);
    const render::Comparison comparison = compare(osmesa, egl);
    EXPECT_TRUE(is_alike(comparison)) << describe(comparison);
}

TEST(Contexts, the_environment_chooses_the_maker) {
    for (const render::ContextKind maker : {render::ContextKind::OSMesa, render::ContextKind::Egl}) {
        if (const auto reason = why_absent(maker)) GTEST_SKIP() << name(maker) << " is absent: " << *reason;
        const WithEnvironment environment(name(maker));
        EXPECT_EQ(render::make_context()->maker(), maker);
    }
}

TEST(Contexts, a_maker_that_is_not_known_is_an_input_error) {
    const WithEnvironment environment("voodoo");
    try {
        render::make_context();
        FAIL() << "no error";
    } catch (const sim::InputError& error) {
        EXPECT_STREQ(error.what(), "SELVEDGE_GL: 'voodoo' is neither osmesa nor egl");
    }
}

TEST(Contexts, say_what_they_are) {
    EXPECT_NE(render::make_context()->description().find("OpenGL"), std::string::npos);
}

}  // namespace
}  // namespace selvedge::test
