// What panels are for, by their names.
#include "sim/proposals/panel_role.h"

#include <gtest/gtest.h>
#include <vector>

#include "tests/support/polygon.h"

namespace selvedge::sim {
namespace {

using enum GarmentPart;

struct Named {
    const char* name;
    PanelRole role;
};

TEST(PanelRole, is_read_from_names_of_several_programs_and_languages) {
    const std::vector<Named> all{{"left_sleeve_f", {Sleeve, Face::Front, Flank::Left}},
                                 {"FrontPanel", {Unknown, Face::Front, Flank::None}},
                                 {"pant_b_r", {Leg, Face::Back, Flank::Right}},
                                 {"right_ftorso", {Torso, Face::Front, Flank::Right}},
                                 {"CollarTopInterface", {Accessory, Face::None, Flank::None}},
                                 {"collar stand", {CollarStand, Face::None, Flank::None}},
                                 {"CollarBase", {CollarStand, Face::None, Flank::None}},
                                 {"wb_back", {Waistband, Face::Back, Flank::None}},
                                 {"neckBinding", {Binding, Face::None, Flank::None}},
                                 {"Vorderteil", {Unknown, Face::Front, Flank::None}},
                                 {"manche", {Sleeve, Face::None, Flank::None}},
                                 {"PocketFlap", {Accessory, Face::None, Flank::None}},
                                 {"teagan.sleeve", {Sleeve, Face::None, Flank::None}},
                                 {"R\u00FCckenteil links", {Unknown, Face::Back, Flank::Left}},
                                 {"\u00C4rmel", {Sleeve, Face::None, Flank::None}},
                                 {"Pu\u00F1o", {Cuff, Face::None, Flank::None}},
                                 {"Col", {Collar, Face::None, Flank::None}},
                                 {"Colour card", {Unknown, Face::None, Flank::None}},
                                 {"\u041F\u0415\u0420\u0415\u0414", {Unknown, Face::Front, Flank::None}},
                                 {"\u0412\u0435\u0440\u0445\u043D\u044F\u044F \u0447\u0430\u0441\u0442\u044C "
                                  "\u0440\u0443\u043A\u0430\u0432\u0430",
                                  {Sleeve, Face::Front, Flank::None}},
                                 {"Takakappale", {Unknown, Face::Back, Flank::None}},
                                 {"Ty\u0142", {Unknown, Face::Back, Flank::None}},
                                 {"\u5DE6\u524D\u7247", {Unknown, Face::Front, Flank::Left}},
                                 {"\u8896\u53E3", {Cuff, Face::None, Flank::None}},
                                 {"\xFFhiha\xFE", {Sleeve, Face::None, Flank::None}},
                                 {"SLEEVE WITH CUFF", {Sleeve, Face::None, Flank::None}},
                                 {"sleeve contrast cuff", {Cuff, Face::None, Flank::None}},
                                 {"Detail_2", {Unknown, Face::None, Flank::None}}};
    for (const Named& named : all) EXPECT_EQ(role_of_name(named.name), named.role) << named.name;
}

TEST(PanelRole, of_a_plain_front_follows_from_the_garment) {
    Pattern pattern;
    for (const char* name : {"front", "back"}) {
        Panel panel;
        panel.name = name;
        panel.vertices = {{0, 0}, {0.3, 0}, {0.3, 0.6}, {0, 0.6}};
        for (int i = 0; i < 4; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 4});
        pattern.panels.push_back(panel);
    }
    EXPECT_EQ(roles_of(pattern)[0].part, Torso);
    EXPECT_EQ(roles_of(pattern, "Penelope pencil skirt")[0].part, Skirt);
    pattern.name = "jeans";
    EXPECT_EQ(roles_of(pattern)[1].part, Leg);
    pattern.name = "";
    pattern.panels[1].name = "sleeve";
    EXPECT_EQ(roles_of(pattern)[0].part, Torso);
}

TEST(PanelRole, of_a_leg_is_seen_from_its_crotch) {
    Pattern pattern;
    Panel panel;
    panel.name = "front";
    panel.vertices = {{0, 0}, {0.2, 0}, {0.3, 0.7}, {0.22, 0.8}, {0.22, 1}, {0, 1}};
    for (int i = 0; i < 6; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 6});
    pattern.panels = {panel};
    EXPECT_EQ(roles_of(pattern)[0].part, Leg);
    pattern.panels[0].vertices[2] = {0.2, 0.7};
    EXPECT_EQ(roles_of(pattern)[0].part, Torso);
}

// A bodice half with its middle on the left: the shoulder stands out over the armhole.
Panel bodice_half(const char* name, double neck) {
    return polygon(name, {{0, 0}, {0.24, 0}, {0.25, 0.4}, {0.17, 0.45}, {0.19, 0.6}, {0.08, 0.64}, {0, 0.64 - neck}});
}

// A trouser half: the crotch on the right, a waist that slopes, a corner off for a slanted pocket.
Panel leg_half(const char* name, double width) {
    return polygon(name, {{0, 0}, {0.2, 0}, {width, 0.7}, {0.22, 0.8}, {0.21, 1.0}, {0.04, 0.96}, {0, 0.82}});
}

TEST(PanelRole, of_bodices_and_skirts_is_not_that_of_a_leg) {
    Pattern pattern;
    pattern.panels = {bodice_half("front", 0.08), bodice_half("back", 0.02)};
    EXPECT_EQ(roles_of(pattern)[0].part, Torso);
    // The hip of a skirt is round.
    Panel skirt = polygon("front", {{0, 0}, {0.25, 0}, {0.26, 0.45}, {0.25, 0.55}, {0.2, 0.65}, {0, 0.65}});
    pattern.panels = {skirt, skirt};
    pattern.panels[1].name = "back";
    EXPECT_EQ(roles_of(pattern)[0].part, Torso);
    pattern.panels.push_back(polygon("waistband", {{0, 0}, {0.7, 0}, {0.7, 0.04}, {0, 0.04}}));
    EXPECT_EQ(roles_of(pattern)[0].part, Skirt) << "it hangs from a waistband";
}

// The hem is narrower than the chest, and the shoulder lies further in than the underarm.
TEST(PanelRole, of_fronts_and_backs_with_shoulders_is_not_that_of_a_leg) {
    Pattern pattern;
    pattern.panels = {polygon("front", {{0, 0}, {0.28, 0}, {0.3, 0.36}, {0.248, 0.6}, {0.1, 0.64}, {0, 0.45}}),
                      polygon("back", {{0, 0}, {0.28, 0}, {0.3, 0.36}, {0.248, 0.6}, {0.1, 0.64}, {0, 0.61}})};
    for (const PanelRole& role : roles_of(pattern)) EXPECT_EQ(role.part, Torso);
}

TEST(PanelRole, of_a_leg_is_seen_though_its_waist_slopes_and_its_pocket_is_slanted) {
    Pattern pattern;
    pattern.panels = {leg_half("front", 0.3), leg_half("back", 0.34)};
    EXPECT_EQ(roles_of(pattern)[0].part, Leg);
    EXPECT_EQ(roles_of(pattern)[1].part, Leg);
    // A front that spans the middle of the body is of no trousers.
    pattern.panels[0] = polygon("front", {{-0.25, 0}, {0.25, 0}, {0.25, 0.6}, {-0.25, 0.6}});
    EXPECT_NE(roles_of(pattern)[1].part, Leg);
}

TEST(PanelRole, of_pieces_without_names_is_seen_from_their_outlines) {
    Pattern pattern;
    pattern.panels = {leg_half("DETAIL", 0.3), leg_half("DETAIL_2", 0.34)};
    std::vector<PanelRole> roles = roles_of(pattern);
    EXPECT_EQ(roles[0], (PanelRole{Leg, Face::Front, Flank::None}));
    EXPECT_EQ(roles[1], (PanelRole{Leg, Face::Back, Flank::None})) << "the wider one";
    pattern.panels = {bodice_half("?????", 0.08), bodice_half("??????", 0.02),
                      polygon("???", {{-0.1, 0}, {0.1, 0}, {0.18, 0.45}, {0.05, 0.55}, {-0.05, 0.55}, {-0.18, 0.45}}),
                      polygon("????", {{0, 0}, {0.1, 0}, {0.1, 0.12}, {0, 0.12}})};
    roles = roles_of(pattern);
    EXPECT_EQ(roles[0], (PanelRole{Torso, Face::Front, Flank::None})) << "the deeper neck";
    EXPECT_EQ(roles[1], (PanelRole{Torso, Face::Back, Flank::None}));
    EXPECT_EQ(roles[2].part, Sleeve);
    EXPECT_EQ(roles[3].part, Unknown);
}

TEST(PanelRole, of_bodices_is_seen_from_shoulders_that_stand_out_little_or_are_straps) {
    Pattern pattern;
    // The tip of the shoulder is 2 mm from the deepest place of the armhole.
    Panel half = polygon("?", {{0, 0}, {0.3, 0}, {0.3, 0.36}, {0.248, 0.6}, {0.1, 0.64}, {0, 0.57}});
    half.edges[2].kind = CurveKind::Cubic;
    half.edges[2].control = {Vec2d(0.25, 0.37), Vec2d(0.245, 0.45)};
    Panel other = half;
    other.vertices.back().y() = 0.62;
    other.edges[4].kind = CurveKind::Cubic;
    other.edges[4].control = {Vec2d(0.09, 0.62), Vec2d(0.05, 0.62)};
    pattern.panels = {half, other};
    EXPECT_EQ(roles_of(pattern)[0], (PanelRole{Torso, Face::Front, Flank::None}));
    EXPECT_EQ(roles_of(pattern)[1], (PanelRole{Torso, Face::Back, Flank::None}));
    Panel top = polygon(
        "DETAIL", {{0, 0}, {0.32, 0}, {0.32, 0.19}, {0.29, 0.35}, {0.25, 0.35}, {0.07, 0.35}, {0.03, 0.35}, {0, 0.19}});
    const auto bend = [&](std::size_t edge, const Vec2d& a, const Vec2d& b) {
        top.edges[edge].kind = CurveKind::Cubic;
        top.edges[edge].control = {a, b};
    };
    bend(2, {0.29, 0.2}, {0.29, 0.3});
    bend(4, {0.24, 0.2}, {0.08, 0.2});  // a deep neck between the straps
    bend(6, {0.03, 0.3}, {0.03, 0.2});
    pattern.panels = {top};
    EXPECT_EQ(roles_of(pattern)[0].part, Torso);
}

TEST(PanelRole, of_a_skirt_without_names_is_told_by_the_file) {
    Pattern pattern;
    pattern.panels = {polygon("DETAIL", {{0, 0}, {0.24, 0}, {0.24, 0.4}, {0.21, 0.54}, {0, 0.54}}),
                      polygon("DETAIL_2", {{0, 0}, {0.23, 0}, {0.23, 0.4}, {0.2, 0.54}, {0, 0.54}})};
    EXPECT_EQ(roles_of(pattern)[0].part, Unknown);
    EXPECT_EQ(roles_of(pattern, "Keiko_skirt_1")[0], (PanelRole{Skirt, Face::Front, Flank::None}));
    EXPECT_EQ(roles_of(pattern, "Keiko_skirt_1")[1], (PanelRole{Skirt, Face::Back, Flank::None}));
}

}  // namespace
}  // namespace selvedge::sim
