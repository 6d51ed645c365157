// What panels are for, by their names.
#include "sim/proposals/panel_role.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace selvedge::sim
