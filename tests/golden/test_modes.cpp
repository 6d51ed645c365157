// A golden picture for each mode with paint or marks, including its legend, and for each one deliberate faults.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <ostream>

#include "render/draw/renderer.h"
#include "render/marks/show.h"
#include "sim/core/error.h"
#include "tests/golden/frozen_scene.h"
#include "tests/golden/golden.h"

namespace selvedge::test {
namespace {

constexpr int kModeSide = 320;  // px

struct ModeCase {
    const char* name;
    render::ShowMode mode;
};

void PrintTo(const ModeCase& tested, std::ostream* out) {
    *out << tested.name;
}

class GoldenMode : public testing::TestWithParam<ModeCase> {};

TEST_P(GoldenMode, picture_is_as_it_was) {
    EXPECT_TRUE(matches_golden(draw_frozen(make_frozen_mode(GetParam().mode), kModeSide),
                               std::string("mode_") + GetParam().name));
}

INSTANTIATE_TEST_SUITE_P(Picture, GoldenMode,
                         testing::Values(ModeCase{"vertices", render::ShowMode::Vertices},
                                         ModeCase{"hierarchy", render::ShowMode::Hierarchy},
                                         ModeCase{"strain_warp", render::ShowMode::StrainWarp},
                                         ModeCase{"strain_weft", render::ShowMode::StrainWeft},
                                         ModeCase{"strain", render::ShowMode::Strain},
                                         ModeCase{"clearance", render::ShowMode::Clearance},
                                         ModeCase{"panels", render::ShowMode::Panels},
                                         ModeCase{"seams", render::ShowMode::Seams}),
                         [](const auto& tested) { return std::string(tested.param.name); });

void shift_values(FrozenMode& frozen) {
    for (auto& corners : frozen.scene.cloths[0].paint->places)
        for (float& place : corners) place += 0.03F;
}

void turn_map(FrozenMode& frozen) {
    auto& map = frozen.scene.cloths[0].paint->map;
    std::reverse(map.begin(), map.end());
}

void flip_cloth_normals(FrozenMode& frozen) {
    for (Vec3f& normal : frozen.scene.cloths[0].mesh.normals) normal = -normal;
}

void flip_solid_normals(FrozenMode& frozen) {
    for (Vec3f& normal : frozen.scene.solids[0].normals) normal = -normal;
}

// Replaces one colour of the marks.
void swap_solid_colour(FrozenMode& frozen) {
    const sim::Rgb8 first = frozen.scene.solids[0].colours.front();
    for (sim::Rgb8& colour : frozen.scene.solids[0].colours) {
        if (colour == first) colour = {first[2], first[0], first[1]};
    }
}

void shift_solids(FrozenMode& frozen) {
    for (Vec3f& x : frozen.scene.solids[0].x) x.x() += 0.003F;
}

void lose_solids(FrozenMode& frozen) {
    frozen.scene.solids.clear();
}

void lose_ink(FrozenMode& frozen) {
    frozen.scene.cloths[0].ink = 0;
}

// Changes all digits of one value: a change of a single digit is within the tolerance for rounding.
void change_figure(FrozenMode& frozen) {
    std::string& figure = frozen.legend->notes.empty() ? frozen.legend->rows[0].figure : frozen.legend->notes[0][1];
    for (char& digit : figure) {
        if (digit >= '0' && digit <= '9') digit = static_cast<char>('0' + (digit - '0' + 5) % 10);
    }
}

void change_legend_colour(FrozenMode& frozen) {
    frozen.legend->rows[0].colour = {120, 120, 120};
}

struct FaultCase {
    const char* name;
    ModeCase mode;
    std::function<void(FrozenMode&)> seed;
};

void PrintTo(const FaultCase& fault, std::ostream* out) {
    *out << fault.name;
}

const std::vector<FaultCase>& faults() {
    constexpr ModeCase vertices{"vertices", render::ShowMode::Vertices},
        hierarchy{"hierarchy", render::ShowMode::Hierarchy}, warp{"strain_warp", render::ShowMode::StrainWarp},
        weft{"strain_weft", render::ShowMode::StrainWeft}, strain{"strain", render::ShowMode::Strain},
        clearance{"clearance", render::ShowMode::Clearance}, panels{"panels", render::ShowMode::Panels},
        seams{"seams", render::ShowMode::Seams};
    static const std::vector<FaultCase> all{{"vertices_with_flipped_normals", vertices, flip_solid_normals},
                                            {"vertices_of_another_colour", vertices, swap_solid_colour},
                                            {"vertices_shifted", vertices, shift_solids},
                                            {"vertices_without_edges", vertices, lose_ink},
                                            {"hierarchy_without_outlines", hierarchy, lose_solids},
                                            {"hierarchy_of_shifted_levels", hierarchy, shift_values},
                                            {"hierarchy_with_another_figure", hierarchy, change_figure},
                                            {"strain_warp_shifted", warp, shift_values},
                                            {"strain_warp_with_flipped_normals", warp, flip_cloth_normals},
                                            {"strain_weft_turned", weft, turn_map},
                                            {"strain_shifted", strain, shift_values},
                                            {"strain_with_another_figure", strain, change_figure},
                                            {"clearance_shifted", clearance, shift_values},
                                            {"clearance_turned", clearance, turn_map},
                                            {"panels_with_swapped_colours", panels, turn_map},
                                            {"panels_with_another_legend", panels, change_legend_colour},
                                            {"seams_of_another_colour", seams, swap_solid_colour},
                                            {"seams_shifted", seams, shift_solids},
                                            {"seams_with_another_figure", seams, change_figure}};
    return all;
}

class SeededModeFault : public testing::TestWithParam<FaultCase> {};

TEST_P(SeededModeFault, is_seen) {
    FrozenMode frozen = make_frozen_mode(GetParam().mode.mode);
    GetParam().seed(frozen);
    const std::string golden = std::string("mode_") + GetParam().mode.name;
    const render::Comparison comparison = compare(read_reference(golden), draw_frozen(frozen, kModeSide));
    EXPECT_FALSE(is_alike(comparison)) << "the golden " << golden << " does not see it: " << describe(comparison);
}

INSTANTIATE_TEST_SUITE_P(Fault, SeededModeFault, testing::ValuesIn(faults()),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(Modes, a_picture_in_tiles_is_the_picture_in_one_piece) {
    render::Renderer renderer;
    for (const render::ShowMode mode :
         {render::ShowMode::Vertices, render::ShowMode::Seams, render::ShowMode::Strain}) {
        const FrozenMode frozen = make_frozen_mode(mode);
        const render::Image whole = renderer.draw(frozen.scene, {.width_px = 150, .height_px = 110});
        const render::Image tiled = renderer.draw(frozen.scene, {.width_px = 150, .height_px = 110, .tile_px = 64});
        const render::Comparison comparison = compare(whole, tiled);
        EXPECT_TRUE(is_alike(comparison, {.tolerance = 3, .share_beyond = 0.002})) << describe(comparison);
    }
}

TEST(Modes, more_samples_than_the_context_takes_are_an_input_error) {
    try {
        render::Renderer().draw(make_frozen_scene(), {.width_px = 32, .height_px = 32, .samples = 1000});
        FAIL() << "no error";
    } catch (const sim::InputError& error) {
        EXPECT_EQ(error.place(), "samples");
    }
}

TEST(Modes, a_mode_without_paint_is_plain) {
    render::Renderer renderer;
    render::Scene scene = make_frozen_scene({.show = render::ShowMode::Plain});
    const render::Image plain = renderer.draw(scene, {.width_px = 96, .height_px = 96});
    scene.cloths[0].show = render::ShowMode::Panels;
    EXPECT_TRUE(plain == renderer.draw(scene, {.width_px = 96, .height_px = 96}));
}

}  // namespace
}  // namespace selvedge::test
