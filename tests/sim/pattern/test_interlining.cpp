// Fabrics that are fused together.
#include <gtest/gtest.h>

#include <algorithm>

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

// 32 mm of denim is no cloth: it would be in contact with itself everywhere.
TEST(Bonded, refuses_what_no_fabric_file_may_say) {
    const Fabric denim = find_fabric("denim");
    EXPECT_NO_THROW(bonded(denim, std::vector<Fabric>(8, denim)));
    try {
        bonded(denim, std::vector<Fabric>(39, denim), "panel 'front'");
        FAIL();
    } catch (const InputError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("panel 'front'"), std::string::npos) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos);
    }
}

TEST(Interlinings, are_sixteen_at_most) {
    for (const int count : {16, 17}) {
        std::string list = "\"silk\"";
        for (int i = 1; i < count; ++i) list += ", \"silk\"";
        const std::vector<Fault> faults = check_pattern_text(
            replaced(sample_text(), R"("back": {)", R"("back": {"selvedge": {"interlinings": [)" + list + "]}, "),
            "f.json");
        const bool is_refused = std::ranges::any_of(
            faults, [](const Fault& fault) { return fault.problem == "17 interlinings: at most 16"; });
        EXPECT_EQ(is_refused, count == 17);
    }
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
