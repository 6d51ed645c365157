#include "sim/exchange/obj_text.h"

#include <gtest/gtest.h>

#include <clocale>
#include <locale>
#include <sstream>

#include "tests/sim/exchange/two_panels.h"

namespace selvedge::sim {
namespace {

std::vector<std::string> lines_with(const std::string& text, const std::string& start) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
        if (line.starts_with(start)) lines.push_back(line);
    return lines;
}

TEST(ObjText, writes_positions_and_material_coordinates_in_metres_and_a_group_per_panel) {
    const std::string text = garment_obj(two_panels());
    EXPECT_EQ(lines_with(text, "v "), (std::vector<std::string>{"v 0 1 0", "v 0.1 1 0", "v 0.1 1.3 0", "v 0 1.3 0",
                                                                "v 0.2 1 -0.05", "v 0.2 1.3 -0.05"}));
    EXPECT_EQ(lines_with(text, "g "), (std::vector<std::string>{"g front", "g left_sleeve"}));
    EXPECT_EQ(lines_with(text, "vt ").size(), 8U);
    EXPECT_EQ(lines_with(text, "vt ")[4], "vt -0.7 0.013");
    EXPECT_EQ(lines_with(text, "f "), (std::vector<std::string>{"f 1/1/1 2/2/2 3/3/3", "f 1/1/1 3/3/3 4/4/4",
                                                                "f 2/5/2 5/6/5 6/7/6", "f 2/5/2 6/7/6 3/8/3"}));
}

TEST(ObjText, keeps_every_bit_of_a_float) {
    PlainMesh mesh = two_panels();
    mesh.x[0] = {0.1F + 0.2F, 1.0F / 3, 1e-7F};
    std::istringstream line(lines_with(garment_obj(mesh), "v ")[0].substr(2));
    for (const float expected : mesh.x[0]) {
        std::string word;
        line >> word;
        EXPECT_EQ(std::stof(word), expected);
    }
}

struct CommaLocale : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(ObjText, is_the_same_in_any_locale) {
    const std::string expected = garment_obj(two_panels());
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaLocale));
    const std::string text = garment_obj(two_panels());
    std::locale::global(before);
    EXPECT_EQ(text, expected);
}

TEST(ObjText, gives_back_the_grain_angles_that_it_wrote) {
    const auto angles = grain_angles_in_obj(garment_obj(two_panels()));
    ASSERT_EQ(angles.size(), 2U);
    EXPECT_EQ(angles[0], (std::pair<std::string, float>("front", 0.0F)));
    EXPECT_EQ(angles[1], (std::pair<std::string, float>("left_sleeve", 0.7853982F)));
    EXPECT_TRUE(grain_angles_in_obj("g a\nf 1 2 3\n# grain_angle many\n# grain_angle").empty());
}

TEST(ObjText, gives_back_the_sett_offsets_that_it_wrote_where_there_are_any) {
    const auto offsets = sett_offsets_in_obj(garment_obj(two_panels()));
    ASSERT_EQ(offsets.size(), 1U);
    EXPECT_EQ(offsets[0], (std::pair<std::string, Vec2f>("left_sleeve", Vec2f(0.0123F, -0.05F))));
    EXPECT_TRUE(
        sett_offsets_in_obj("g a\n# sett_offset 1\n# sett_offset 1 x\n# sett_offset nan 1\n# sett_offset").empty());
}

TEST(ObjText, writes_a_body_as_one_group) {
    Body body;
    body.name = "mannequin female";
    body.x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    body.triangles = {{0, 1, 2}};
    const std::string text = body_obj(body);
    EXPECT_EQ(lines_with(text, "g "), (std::vector<std::string>{"g mannequin_female"}));
    EXPECT_EQ(lines_with(text, "vn ")[0], "vn 0 0 1");
    EXPECT_EQ(lines_with(text, "f ")[0], "f 1//1 2//2 3//3");
}

}  // namespace
}  // namespace selvedge::sim
