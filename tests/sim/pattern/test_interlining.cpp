// Fabrics that are fused together.
#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/pattern_file.h"
#include "tests/sim/pattern/sample.h"

namespace selvedge::sim {
namespace {

TEST(Bonded, adds_mass_thickness_and_stiffness_exactly) {
    const Fabric shell = find_fabric("denim"), canvas = find_fabric("linen"), silk = find_fabric("silk");
    const Fabric all = bonded(shell, std::vector{canvas, silk});
    for (double Fabric::*value :
         {&Fabric::area_density, &Fabric::thickness, &Fabric::stretch_warp, &Fabric::stretch_weft, &Fabric::shear,
          &Fabric::bending_warp, &Fabric::bending_weft, &Fabric::bending_hysteresis, &Fabric::shear_hysteresis}) {
        EXPECT_EQ(all.*value, shell.*value + canvas.*value + silk.*value);
    }
    EXPECT_EQ(all.strain_limit, std::min({shell.strain_limit, canvas.strain_limit, silk.strain_limit}));
    EXPECT_EQ(all.friction, shell.friction);
    EXPECT_EQ(all.gloss, shell.gloss);
    EXPECT_EQ(bonded(shell, {}), shell);
}

TEST(Interlinings, of_a_panel_survive_a_round_trip_through_a_file) {
    const std::string text =
        replaced(sample_text(), R"("back": {)", R"("back": {"selvedge": {"interlinings": ["linen", "silk"]}, )");
    const PatternDocument document = parse_pattern(text, "f.json");
    EXPECT_TRUE(document.pattern.panels[0].interlinings.empty());
    EXPECT_EQ(document.pattern.panels[1].interlinings, (std::vector<std::string>{"linen", "silk"}));
    EXPECT_EQ(parse_pattern(write_pattern(document), "f.json").pattern, document.pattern);
}

TEST(Interlinings, must_be_a_list_of_fabrics) {
    for (const char* bad : {R"("linen")", R"([3])", R"([""])"}) {
        const std::string text = replaced(sample_text(), R"("back": {)",
                                          std::string(R"("back": {"selvedge": {"interlinings": )") + bad + "}, ");
        EXPECT_THROW(parse_pattern(text, "f.json"), InputError) << bad;
    }
}

}  // namespace
}  // namespace selvedge::sim
