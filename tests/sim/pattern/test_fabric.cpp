#include "sim/pattern/fabric.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/core/error.h"
#include "tests/sim/pattern/sample.h"

namespace selvedge::sim {
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
    EXPECT_EQ(complaint(fabric_text()), "");
}

}  // namespace
}  // namespace selvedge::sim
