// Woven cloth in pictures that cover 2 cm to 5 m: the same colour at every distance and angle, and no wave that is not
// in the cloth. Colours are compared in linear light.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "sim/tartan/tartan_file.h"
#include "tests/golden/fourier.h"
#include "tests/golden/weave_sheet.h"

namespace selvedge::test {
namespace {

constexpr int kWeaveSide = 128;  // px
constexpr double kOneStep = 1.0 / 255;
constexpr double kMinWave = 1.5 / 255;  // amplitude in linear light; smaller waves are invisible
constexpr int kSlowest = 6;             // waves per picture: patterns below have more where threads are near a pixel

sim::Sett few_threads(sim::Weave weave) {
    sim::Sett sett = sim::parse_threadcount("K1 W2 R3");
    sett.weave = weave;
    return sett;
}

sim::Sett two_dye_denim() {
    sim::Sett sett = sim::parse_threadcount("B8");
    sett.weft_stripes = sim::parse_threadcount("W8").stripes;
    sett.weave = sim::Weave::Twill31;
    return sett;
}

sim::Sett unlike_setts() {
    sim::Sett sett = sim::find_tartan("buchanan");
    sett.weft_stripes = sim::parse_threadcount("N6 W5 K2").stripes;
    sett.weave = sim::Weave::Plain;
    return sett;
}

LinearPicture draw(render::Renderer& renderer, const SheetView& view) {
    return to_linear(renderer.draw(sheet_scene(view), {.width_px = kWeaveSide, .height_px = kWeaveSide}));
}

// The light on the sheet, measured with a cloth of one colour.
Vec3d light_on(render::Renderer& renderer, SheetView view) {
    view.sett = sim::parse_threadcount("W4");
    view.field = 1;
    const Vec3d dye = dyes_seen(view, 1, 1).pixels[0];
    const Vec3d seen = draw(renderer, view).mean();
    return seen.cwiseQuotient(lit_dye(dye, view, Vec3d::Ones()));
}

// Largest difference of a channel's mean from the value computed from the threads.
double shift_of(const LinearPicture& picture, const SheetView& view, const Vec3d& light) {
    const Vec3d expected = lit_dye(dyes_seen(view, kWeaveSide, 6).mean(), view, light);
    return (picture.mean() - expected).cwiseAbs().maxCoeff();
}

double moire_of(const LinearPicture& picture, const SheetView& view, const Vec3d& light) {
    const LinearPicture dyes = dyes_seen(view, kWeaveSide, 10);
    double greatest = 0;
    for (int channel = 0; channel < 3; ++channel) {
        std::vector<double> difference = picture.channel(channel);
        for (std::size_t i = 0; i < difference.size(); ++i) {
            difference[i] -= lit_dye(dyes.pixels[i], view, light)[channel];
        }
        greatest = std::max(greatest, greatest_slow_wave(difference, kWeaveSide, kSlowest));
    }
    return greatest;
}

struct WeaveCase {
    const char* name;
    sim::Sett sett;
    double turn = 0;
    double tilt = 0;
    bool is_behind = false;
    float key = 0;
};

void PrintTo(const WeaveCase& tested, std::ostream* out) {
    *out << tested.name;
}

std::vector<WeaveCase> weave_cases() {
    return {{"plain", few_threads(sim::Weave::Plain)},
            {"twill", few_threads(sim::Weave::Twill22)},
            {"twill31", few_threads(sim::Weave::Twill31)},
            {"twill31_behind", few_threads(sim::Weave::Twill31), 0.4, 0, true},
            {"denim", two_dye_denim(), 0.1},
            {"denim_behind", two_dye_denim(), 0.1, 0, true},
            {"plain_turned", few_threads(sim::Weave::Plain), 0.37},
            {"twill_turned", few_threads(sim::Weave::Twill22), 0.7853981},
            {"twill_in_key_light", few_threads(sim::Weave::Twill22), 0.5, 0.9, false, 0.5F},
            {"twill_grazing", few_threads(sim::Weave::Twill22), 0.2, 1.31},
            {"many_threads", sim::find_tartan("royal_stewart")},
            {"many_threads_turned_and_grazing", sim::find_tartan("royal_stewart"), 0.61, 1.31},
            {"unlike_setts", unlike_setts(), 1.1, 0.5},
            {"pepita", sim::parse_threadcount("K4 W4"), 0.3}};
}

SheetView view_of(const WeaveCase& tested, double field) {
    return {.sett = tested.sett,
            .field = field,
            .turn = tested.turn,
            .tilt = tested.tilt,
            .is_behind = tested.is_behind,
            .key = tested.key};
}

class Weaves : public testing::TestWithParam<WeaveCase> {};

TEST_P(Weaves, have_one_colour_from_two_centimetres_to_five_metres) {
    render::Renderer renderer;
    const Vec3d light = light_on(renderer, view_of(GetParam(), 1));
    for (const double field : {0.02, 0.033, 0.055, 0.09, 0.15, 0.3, 0.7, 1.6, 5.0}) {
        const SheetView view = view_of(GetParam(), field);
        EXPECT_LT(shift_of(draw(renderer, view), view, light), kOneStep) << field << " m";
    }
}

TEST_P(Weaves, show_no_wave_that_is_not_in_the_cloth) {
    render::Renderer renderer;
    const Vec3d light = light_on(renderer, view_of(GetParam(), 1));
    for (const double threads_per_px : {1.05, 1.4, 1.9, 2.9, 4.0, 6.1, 11.0, 40.0}) {
        const SheetView view = view_of(GetParam(), threads_per_px * kWeaveSide * GetParam().sett.thread_spacing);
        EXPECT_LT(moire_of(draw(renderer, view), view, light), kMinWave) << threads_per_px << " threads to a pixel";
    }
}

INSTANTIATE_TEST_SUITE_P(Woven, Weaves, testing::ValuesIn(weave_cases()),
                         [](const auto& tested) { return std::string(tested.param.name); });

// Without filtering over the pixel: each pixel takes one point of a picture with eight times the resolution.
LinearPicture unfiltered(render::Renderer& renderer, const SheetView& view) {
    constexpr int times = 8;
    const render::Image fine =
        renderer.draw(sheet_scene(view), {.width_px = times * kWeaveSide, .height_px = times * kWeaveSide});
    render::Image coarse(kWeaveSide, kWeaveSide);
    for (int y = 0; y < kWeaveSide; ++y) {
        for (int x = 0; x < kWeaveSide; ++x) coarse.at(x, y) = fine.at(times * x + times / 2, times * y + times / 2);
    }
    return to_linear(coarse);
}

TEST(SeededWeaveFault, waves_are_found_where_nothing_is_filtered) {
    render::Renderer renderer;
    for (const double turn : {0.0, 0.37}) {
        SheetView view{.sett = few_threads(sim::Weave::Twill22), .turn = turn};
        const Vec3d light = light_on(renderer, view);
        double greatest = 0;
        for (const double threads_per_px : {1.05, 4.0, 11.0}) {
            view.field = threads_per_px * kWeaveSide * view.sett.thread_spacing;
            greatest = std::max(greatest, moire_of(unfiltered(renderer, view), view, light));
        }
        EXPECT_GT(greatest, 4 * kMinWave) << turn;
    }
}

TEST(SeededWeaveFault, a_cloth_of_another_weave_has_another_colour) {
    render::Renderer renderer;
    const SheetView view{.sett = two_dye_denim(), .field = 0.4};
    SheetView twill = view, behind = view;
    twill.sett.weave = sim::Weave::Twill22;
    behind.is_behind = true;
    const Vec3d light = light_on(renderer, view);
    const LinearPicture picture = draw(renderer, view);
    EXPECT_LT(shift_of(picture, view, light), kOneStep);
    EXPECT_GT(shift_of(picture, twill, light), 10 * kOneStep);
    EXPECT_GT(shift_of(picture, behind, light), 10 * kOneStep);
}

TEST(SeededWeaveFault, one_thread_more_is_seen_in_the_mean) {
    render::Renderer renderer;
    const SheetView view{.sett = few_threads(sim::Weave::Twill22), .field = 1.2};
    SheetView other = view;
    other.sett = sim::parse_threadcount("K1 W3 R3");
    EXPECT_GT(shift_of(draw(renderer, view), other, light_on(renderer, view)), kOneStep);
}

TEST(SeededWeaveFault, a_relief_that_darkens_by_two_in_a_hundred_is_seen_in_the_mean) {
    render::Renderer renderer;
    const SheetView view{.sett = few_threads(sim::Weave::Twill22), .field = 0.02};
    LinearPicture picture = draw(renderer, view);
    for (Vec3d& pixel : picture.pixels) pixel *= 0.98;
    EXPECT_GT(shift_of(picture, view, light_on(renderer, view)), kOneStep);
}

TEST(Fourier, finds_a_wave_and_its_amplitude) {
    std::vector<double> values;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x)
            values.push_back(0.3 + 0.05 * std::cos(2 * 3.14159265358979 * (3 * x - 5 * y) / 64));
    }
    EXPECT_NEAR(greatest_slow_wave(values, 64, 8), 0.05, 1e-3);
    EXPECT_LT(greatest_slow_wave(values, 64, 4), 0.03) << "of which the fading leaves a part to its neighbours";
}

// sRGB encoding: a cloth of a known colour, in light that shows white as white, keeps its bytes.
TEST(Encoding, a_plain_colour_in_full_even_light_keeps_its_bytes) {
    SheetView view{.sett = sim::parse_threadcount("W4")};
    render::Scene scene = sheet_scene(view);
    scene.cloths[0].show = render::ShowMode::Plain;
    scene.light.sky = scene.light.bounce = 1;
    for (const int grey : {20, 90, 128, 200}) {
        const auto byte = static_cast<std::uint8_t>(grey);
        scene.cloths[0].colour = {byte, byte, byte};
        const render::Image image = render::Renderer().draw(scene, {.width_px = 16, .height_px = 16});
        EXPECT_NEAR(image.at(8, 8)[1], grey, 2);
    }
}

}  // namespace
}  // namespace selvedge::test
