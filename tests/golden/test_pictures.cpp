// The golden pictures, and a deliberate fault for each kind of fault that they detect: a golden test that cannot fail
// is useless.
#include <gtest/gtest.h>

#include <functional>
#include <ostream>
#include <string_view>

#include "render/draw/renderer.h"
#include "sim/tartan/tartan_file.h"
#include "tests/golden/frozen_scene.h"
#include "tests/golden/golden.h"

namespace selvedge::test {
namespace {

constexpr render::RenderOptions kSmall{.width_px = 256, .height_px = 256};

render::Image draw(const render::Scene& scene) {
    return render::Renderer().draw(scene, kSmall);
}

// So near that single threads are visible.
render::Scene near_scene() {
    render::Scene scene = make_frozen_scene({.view = render::View::Front});
    scene.camera.target = Vec3f(0.02F, 0.6F, 0.25F);
    scene.camera.eye = scene.camera.target + Vec3f(0.05F, 0.15F, 0.5F);
    scene.camera.fov_y = 0.09F;
    scene.camera.near_plane = 0.1F;
    return scene;
}

render::Scene transparent_scene() {
    render::Scene scene = make_frozen_scene();
    scene.background.is_transparent = true;
    return scene;
}

// From below, where the wrong side of the cloth is visible.
render::Scene below_scene() {
    render::Scene scene = make_frozen_scene({.has_ball = false});
    scene.camera.eye = Vec3f(0.9F, 0.1F, 2.0F);
    scene.camera.target = Vec3f(0, 0.5F, 0);
    scene.camera.near_plane = 0.1F;
    return scene;
}

// Warp and weft have different setts and colours.
sim::Sett denim() {
    sim::Sett sett = sim::parse_threadcount("I=#2E4468; I24 R2");
    sett.weft_stripes = sim::parse_threadcount("W9 G3").stripes;
    sett.weave = sim::Weave::Twill31;
    sett.thread_spacing = 0.0005;
    return sett;
}

sim::Sett linen() {
    sim::Sett sett = sim::parse_threadcount("N=#C9BDA4; N12 W4 B2");
    sett.weave = sim::Weave::Plain;
    return sett;
}

render::Scene woven(render::Scene scene, const sim::Sett& sett) {
    scene.cloths[0].sett = sett;
    return scene;
}

render::Scene silk_scene() {
    render::Scene scene = make_frozen_scene({.show = render::ShowMode::Plain});
    scene.cloths[0].colour = {0x7A, 0x1F, 0x3D};
    scene.cloths[0].material = {.gloss = 0.05F, .roughness = 0.25F, .sheen = 0.02F};
    return scene;
}

struct GoldenCase {
    const char* name;
    std::function<render::Scene()> make;
};

// The case's name in GoogleTest and ctest.
void PrintTo(const GoldenCase& golden, std::ostream* out) {
    *out << golden.name;
}

const std::vector<GoldenCase>& golden_cases() {
    static const std::vector<GoldenCase> cases{
        {"tartan_front", [] { return make_frozen_scene({.view = render::View::Front}); }},
        {"tartan_three_quarter", [] { return make_frozen_scene(); }},
        {"tartan_near", near_scene},
        {"tartan_below", below_scene},
        {"tartan_transparent", transparent_scene},
        {"denim_near", [] { return woven(near_scene(), denim()); }},
        {"denim_below", [] { return woven(below_scene(), denim()); }},
        {"linen_near", [] { return woven(near_scene(), linen()); }},
        {"silk", silk_scene},
        {"level", [] { return make_frozen_scene({.show = render::ShowMode::Level}); }},
        {"edges_left", [] { return make_frozen_scene({.view = render::View::Left, .show = render::ShowMode::Edges}); }},
        {"plain_back",
         [] { return make_frozen_scene({.view = render::View::Back, .show = render::ShowMode::Plain}); }}};
    return cases;
}

class Golden : public testing::TestWithParam<GoldenCase> {};

TEST_P(Golden, picture_is_as_it_was) {
    EXPECT_TRUE(matches_golden(draw(GetParam().make()), GetParam().name));
}

INSTANTIATE_TEST_SUITE_P(Picture, Golden, testing::ValuesIn(golden_cases()),
                         [](const auto& tested) { return std::string(tested.param.name); });

// Expects that a fault makes the picture differ from the stored reference.
void expect_seen(const render::Scene& faulty, const std::string& name) {
    const render::Comparison comparison = compare(read_reference(name), draw(faulty));
    EXPECT_FALSE(is_alike(comparison)) << "the golden " << name << " does not see it: " << describe(comparison);
}

std::vector<GoldenCase> cases_that(bool (*is_wanted)(const GoldenCase&)) {
    std::vector<GoldenCase> wanted;
    for (const GoldenCase& golden : golden_cases()) {
        if (is_wanted(golden)) wanted.push_back(golden);
    }
    return wanted;
}

bool is_woven(const GoldenCase& golden) {
    return golden.make().cloths[0].show == render::ShowMode::Tartan;
}

bool is_near(const GoldenCase& golden) {
    return std::string_view(golden.name).ends_with("_near");
}

// Every golden with every fault that its kind of picture can show.
class GoldenFault : public testing::TestWithParam<GoldenCase> {};

TEST_P(GoldenFault, flipped_normals_are_seen) {
    render::Scene scene = GetParam().make();
    for (Vec3f& normal : scene.cloths[0].mesh.normals) normal = -normal;
    expect_seen(scene, GetParam().name);
}

TEST_P(GoldenFault, swapped_colours_are_seen) {
    render::Scene scene = GetParam().make();
    render::ClothItem& cloth = scene.cloths[0];
    std::swap(cloth.colour[0], cloth.colour[2]);
    for (std::uint8_t& level : cloth.mesh.level) level ^= 1;
    for (auto* stripes : {&cloth.sett.stripes, &cloth.sett.weft_stripes}) {
        for (sim::SettStripe& stripe : *stripes) std::swap(stripe.colour[0], stripe.colour[2]);
    }
    expect_seen(scene, GetParam().name);
}

class WovenGoldenFault : public GoldenFault {};
class NearGoldenFault : public GoldenFault {};

TEST_P(WovenGoldenFault, a_sett_shifted_by_one_millimetre_is_seen) {
    render::Scene scene = GetParam().make();
    scene.cloths[0].sett_position += Vec2f(0.001F, 0.001F);
    expect_seen(scene, GetParam().name);
}

TEST_P(NearGoldenFault, another_weave_is_seen_from_near) {
    render::Scene scene = GetParam().make();
    sim::Weave& weave = scene.cloths[0].sett.weave;
    weave = weave == sim::Weave::Plain ? sim::Weave::Twill22 : sim::Weave::Plain;
    expect_seen(scene, GetParam().name);
}

INSTANTIATE_TEST_SUITE_P(Picture, GoldenFault, testing::ValuesIn(golden_cases()),
                         [](const auto& tested) { return std::string(tested.param.name); });
INSTANTIATE_TEST_SUITE_P(Picture, WovenGoldenFault, testing::ValuesIn(cases_that(is_woven)),
                         [](const auto& tested) { return std::string(tested.param.name); });
INSTANTIATE_TEST_SUITE_P(Picture, NearGoldenFault, testing::ValuesIn(cases_that(is_near)),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(SeededFault, a_swapped_colour_of_the_finest_stripe_is_seen) {
    render::Scene scene = make_frozen_scene();
    for (sim::SettStripe& stripe : scene.cloths[0].sett.stripes) {
        if (stripe.code == "Y") stripe.colour = {0xFC, 0xFC, 0xFC};
    }
    expect_seen(scene, "tartan_three_quarter");
}

TEST(SeededFault, a_sett_shifted_by_one_millimetre_is_seen) {
    render::Scene scene = make_frozen_scene({.view = render::View::Front});
    scene.cloths[0].sett_position.x() += 0.001F;
    expect_seen(scene, "tartan_front");
}

TEST(SeededFault, a_grain_turned_by_one_degree_is_seen) {
    render::Scene scene = make_frozen_scene({.view = render::View::Front});
    scene.cloths[0].mesh.panel_grain_angles[1] += 0.01745F;
    expect_seen(scene, "tartan_front");
}

TEST(SeededFault, warp_and_weft_swapped_by_one_thread_are_seen_from_near) {
    render::Scene scene = near_scene();
    scene.cloths[0].sett_position.y() += static_cast<float>(scene.cloths[0].sett.thread_spacing);
    expect_seen(scene, "tartan_near");
}

TEST(SeededFault, a_triangle_of_another_level_is_seen) {
    render::Scene scene = make_frozen_scene({.show = render::ShowMode::Level});
    scene.cloths[0].mesh.level[2940] = 4;
    expect_seen(scene, "level");
}

TEST(SeededFault, a_light_moved_by_two_degrees_is_seen) {
    render::Scene scene = make_frozen_scene({.view = render::View::Back, .show = render::ShowMode::Plain});
    scene.light.to_key += Vec3f(0.035F, 0, 0);
    expect_seen(scene, "plain_back");
}

TEST(SeededFault, a_missing_triangle_is_seen) {
    render::Scene scene = make_frozen_scene({.view = render::View::Left, .show = render::ShowMode::Edges});
    sim::DrawMesh& mesh = scene.cloths[0].mesh;
    mesh.triangles[2372] = {0, 0, 0};
    expect_seen(scene, "edges_left");
}

TEST(SeededFault, a_missing_reference_fails) {
    EXPECT_FALSE(matches_golden(render::Image(4, 4), "there_is_no_such_picture"));
}

}  // namespace
}  // namespace selvedge::test
