#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

#include "sim/core/error.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/pattern.h"
#include "sim/pattern/pattern_file.h"
#include "tests/sim/pattern/sample.h"

namespace selvedge::sim {
namespace {

Panel wrapped(bool is_mirrored) {
    Panel panel;
    panel.is_mirrored = is_mirrored;
    panel.wrap_radius = 0.15;
    panel.translation = {0.1, 1.2, 0.3};
    return panel;
}

TEST(PanelPlace, a_wrap_keeps_lengths_along_x_and_y) {
    for (const bool is_mirrored : {false, true}) {
        const Panel panel = wrapped(is_mirrored);
        double length = 0;
        constexpr int kSteps = 10000;
        for (int i = 0; i < kSteps; ++i) {
            const auto at = [&](int step) { return panel.place({-0.2 + 0.5 * step / kSteps, 0.4}); };
            length += (at(i + 1) - at(i)).norm();
        }
        EXPECT_NEAR(length, 0.5, 1e-8);
        EXPECT_NEAR((panel.place({0.1, 0.7}) - panel.place({0.1, 0.2})).norm(), 0.5, 1e-12);
    }
}

// Panels are stored as seen from the right side, with x to the right and y up, so x cross y points out of it.
TEST(PanelPlace, the_right_side_of_a_wrap_looks_away_from_its_axis) {
    for (const bool is_mirrored : {false, true}) {
        const Panel panel = wrapped(is_mirrored);
        const double side = is_mirrored ? -1 : 1;
        const Vec3d axis = panel.translation - Vec3d(0, 0, side * panel.wrap_radius);
        for (const double x : {-0.2, -0.01, 0.0, 0.1, 0.3}) {
            const Vec2d u(x, 0.25);
            const double step = 1e-6;
            const Vec3d along_x = panel.place(u + Vec2d(step, 0)) - panel.place(u - Vec2d(step, 0));
            const Vec3d along_y = panel.place(u + Vec2d(0, step)) - panel.place(u - Vec2d(0, step));
            Vec3d outward = panel.place(u) - axis;
            outward.y() = 0;
            EXPECT_NEAR(outward.norm(), panel.wrap_radius, 1e-12);
            EXPECT_NEAR(along_x.cross(along_y).normalized().dot(outward.normalized()), 1, 1e-6);
        }
    }
}

TEST(PanelPlace, a_wrap_and_a_flat_panel_touch_at_x_0) {
    for (const bool is_mirrored : {false, true}) {
        const Panel bent = wrapped(is_mirrored);
        Panel flat = bent;
        flat.wrap_radius = 0;
        EXPECT_TRUE(bent.place({0, 0.3}).isApprox(flat.place({0, 0.3}), 1e-15));
        EXPECT_NEAR((bent.place({0.001, 0.3}) - flat.place({0.001, 0.3})).norm(), 0, 1e-5);
        EXPECT_GT((bent.place({0.1, 0.3}) - flat.place({0.1, 0.3})).norm(), 1e-2);
    }
}

Panel bent_to_cone(bool is_mirrored, double sine) {
    Panel panel;
    panel.is_mirrored = is_mirrored;
    panel.wrap_cone = WrapCone{.apex = {0.1, 0.5}, .sine = sine};
    panel.translation = {0.1, 1.2, 0.3};
    return panel;
}

TEST(PanelPlace, a_cone_keeps_lengths_and_has_its_right_side_outside) {
    for (const bool is_mirrored : {false, true}) {
        for (const double sine : {0.3, 0.7, 1.0}) {
            const Panel panel = bent_to_cone(is_mirrored, sine);
            const Vec3d apex = panel.place(panel.wrap_cone->apex);
            for (const Vec2d& u : {Vec2d(0.1, 0), Vec2d(-0.2, 0.2), Vec2d(0.4, 0.45)}) {
                const double step = 1e-6;
                const Vec3d x = (panel.place(u + Vec2d(step, 0)) - panel.place(u - Vec2d(step, 0))) / (2 * step);
                const Vec3d y = (panel.place(u + Vec2d(0, step)) - panel.place(u - Vec2d(0, step))) / (2 * step);
                EXPECT_NEAR(x.norm(), 1, 1e-7);
                EXPECT_NEAR(y.norm(), 1, 1e-7);
                EXPECT_NEAR(x.dot(y), 0, 1e-7);
                Vec3d outward = panel.place(u) - apex;
                const double reach = (u - panel.wrap_cone->apex).norm();
                EXPECT_NEAR(outward.norm(), reach, 1e-12);
                outward.y() = 0;
                EXPECT_NEAR(outward.norm(), reach * sine, 1e-12);
                if (sine < 1) {
                    EXPECT_GT(x.cross(y).dot(outward), 0);
                }
            }
        }
    }
}

TEST(PanelPlace, a_sector_goes_round_the_cone_by_its_angle_over_the_sine) {
    const Panel panel = bent_to_cone(false, 0.5);
    const auto from_axis = [&](double angle) -> Vec3d {  // rad, on the panel from straight down
        const Vec2d u = panel.wrap_cone->apex + 0.3 * Vec2d(std::sin(angle), -std::cos(angle));
        return panel.place(u) - panel.place(panel.wrap_cone->apex);
    };
    const double quarter = std::acos(0.0);
    EXPECT_NEAR((from_axis(quarter) - from_axis(-quarter)).norm(), 0, 1e-9) << "a half disc closes";
    EXPECT_NEAR(from_axis(0).z(), 0.15, 1e-12);
    EXPECT_NEAR(from_axis(quarter).z(), -0.15, 1e-12);
    EXPECT_NEAR(from_axis(quarter / 2).x(), 0.15, 1e-12);
}

TEST(SeamName, follows_from_the_edges_unless_the_seam_has_its_own) {
    Pattern pattern = parse_pattern(sample_text(), "").pattern;
    EXPECT_EQ(seam_name(pattern, pattern.seams[0]), "front.1+back.2");
    pattern.seams[0].name = "left side";
    EXPECT_EQ(seam_name(pattern, pattern.seams[0]), "left side");
}

TEST(SeamName, finds_seams_by_name_by_edges_in_either_order_and_by_label) {
    Pattern pattern = parse_pattern(sample_text(), "").pattern;
    pattern.seams[0].name = "left side";
    pattern.panels[0].edges[1].label = "side";
    pattern.panels[1].edges[0].label = "side";
    EXPECT_EQ(find_seams(pattern, "left side"), (std::vector<int>{0}));
    EXPECT_EQ(find_seams(pattern, "front.3+back.0"), (std::vector<int>{1}));
    EXPECT_EQ(find_seams(pattern, "back.0+front.3"), (std::vector<int>{1}));
    EXPECT_EQ(find_seams(pattern, "side"), (std::vector<int>{0, 1}));
    EXPECT_TRUE(find_seams(pattern, "front.3").empty());
    EXPECT_TRUE(find_seams(pattern, "").empty());
}

}  // namespace

namespace {

std::string fabric_text() {
    return R"({"name": "net", "area_density": 0.05, "stretch_warp": 900, "stretch_weft": 700, "shear": 12,
 "bending_warp": 1e-6, "bending_weft": 0, "thickness": 0.0002, "source": "made up for a test"})";
}

std::string complaint(const std::string& text) {
    try {
        parse_fabric(text, "f.json");
        return "";
    } catch (const InputError& error) {
        return error.what();
    }
}

TEST(Fabric, ships_the_usual_cloths) {
    const std::vector<std::string> names = fabric_names();
    for (const char* name : {"cotton_shirting", "wool_twill", "silk", "denim", "jersey"}) {
        EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
    }
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
}

TEST(Fabric, every_shipped_one_loads_under_its_own_name) {
    EXPECT_FALSE(fabric_names().empty());
    for (const std::string& name : fabric_names()) EXPECT_EQ(find_fabric(name).name, name);
}

TEST(Fabric, the_default_is_the_shipped_cotton_shirting) {
    const Fabric shipped = find_fabric("");
    EXPECT_EQ(shipped.name, Fabric().name);
    EXPECT_EQ(shipped.area_density, Fabric().area_density);
    EXPECT_EQ(shipped.stretch_warp, Fabric().stretch_warp);
    EXPECT_EQ(shipped.stretch_weft, Fabric().stretch_weft);
    EXPECT_EQ(shipped.shear, Fabric().shear);
    EXPECT_EQ(shipped.bending_warp, Fabric().bending_warp);
    EXPECT_EQ(shipped.bending_weft, Fabric().bending_weft);
    EXPECT_EQ(shipped.thickness, Fabric().thickness);
    EXPECT_EQ(shipped.friction, Fabric().friction);
    EXPECT_EQ(shipped.strain_limit, Fabric().strain_limit);
    EXPECT_EQ(shipped.gloss, Fabric().gloss);
    EXPECT_EQ(shipped.roughness, Fabric().roughness);
    EXPECT_EQ(shipped.sheen, Fabric().sheen);
}

TEST(Fabric, silk_is_limper_than_wool_and_wool_than_denim) {
    EXPECT_LT(find_fabric("silk").bending_warp, find_fabric("wool_twill").bending_warp);
    EXPECT_LT(find_fabric("wool_twill").bending_warp, find_fabric("denim").bending_warp);
}

TEST(Fabric, silk_shines_and_wool_does_not) {
    EXPECT_GT(find_fabric("silk").gloss, 5 * find_fabric("wool_twill").gloss);
    EXPECT_LT(find_fabric("silk").roughness, find_fabric("wool_twill").roughness);
    EXPECT_LT(find_fabric("silk").sheen, find_fabric("wool_twill").sheen);
}

TEST(Fabric, an_unknown_name_lists_the_known_ones) {
    try {
        find_fabric("velour");
        FAIL() << "found";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("no fabric 'velour': known are cotton_shirting, denim"),
                  std::string::npos)
            << error.what();
    }
    EXPECT_THROW(find_fabric("no/such/fabric.json"), InputError);
}

TEST(Fabric, takes_what_is_not_said_from_the_default) {
    const Fabric net = parse_fabric(fabric_text(), "f.json");
    EXPECT_EQ(net.name, "net");
    EXPECT_EQ(net.bending_weft, 0);
    EXPECT_EQ(net.friction, Fabric().friction);
}

TEST(Fabric, refuses_figures_that_no_cloth_has) {
    const auto spoilt = [](const char* from, const char* to) { return complaint(replaced(fabric_text(), from, to)); };
    EXPECT_EQ(spoilt("\"stretch_warp\": 900", "\"stretch_warp\": 0"),
              "f.json: stretch_warp: 0 is not between 10 and 1e+06");
    EXPECT_NE(spoilt("0.05", "-0.05").find("area_density"), std::string::npos);
    EXPECT_NE(spoilt("0.05", "NaN"), "");
    EXPECT_NE(spoilt("0.05", "1e999"), "");
    EXPECT_NE(spoilt("\"shear\": 12", "\"shear\": \"12\"").find("a string where a number should be"),
              std::string::npos);
    EXPECT_NE(spoilt("\"thickness\": 0.0002", "\"thick\": 0.0002").find("no key 'thickness'"), std::string::npos);
    EXPECT_EQ(spoilt("\"shear\": 12", "\"shear\": 12, \"frition\": 0.3"),
              "f.json: frition: unknown key 'frition': is 'friction' meant?");
    EXPECT_EQ(spoilt("\"shear\": 12", "\"shear\": 12, \"my own\": 1"), "");
    EXPECT_EQ(complaint(fabric_text()), "");
}

}  // namespace

}  // namespace selvedge::sim
