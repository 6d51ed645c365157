// Patterns with several garments: put over each other, taken off, written and read.
#include "sim/pattern/garments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "sim/core/error.h"
#include "sim/pattern/pattern_file.h"
#include "tests/sim/pattern/sample.h"

namespace selvedge::sim {
namespace {

using Names = std::vector<std::string>;

Pattern sample(const std::string& name) {
    return parse_pattern(sample_text(), name + ".json").pattern;
}

Names panel_names(const Pattern& pattern) {
    Names names;
    for (const Panel& panel : pattern.panels) names.push_back(panel.name);
    return names;
}

const Panel& panel_named(const Pattern& pattern, const std::string& name) {
    return *std::ranges::find(pattern.panels, name, &Panel::name);
}

TEST(Garments, a_pattern_without_named_garments_is_one_of_its_own_name) {
    const std::vector<Garment> garments = garments_of(sample("shirt"));
    ASSERT_EQ(garments.size(), 1U);
    EXPECT_EQ(garments[0].name, "shirt");
    EXPECT_EQ(garments[0].panels, (std::vector<int>{0, 1}));
}

TEST(Garments, are_listed_from_the_lowest_layer_to_the_highest) {
    Pattern pattern = sample("shirt");
    pattern.panels[0].garment = "coat";
    pattern.panels[0].layer = 2;
    EXPECT_EQ(garment_names(pattern), (Names{"shirt", "coat"}));
    pattern.panels[0].layer = -1;
    EXPECT_EQ(garment_names(pattern), (Names{"coat", "shirt"}));
    pattern.panels[0].layer = 0;
    EXPECT_EQ(garment_names(pattern), (Names{"coat", "shirt"})) << "equal layers: in the order of the file";
}

TEST(PutOver, keeps_all_panels_and_seams_and_raises_the_layers_of_the_outer_garment) {
    Pattern pattern = sample("shirt"), vest = sample("vest");
    pattern.panels[1].layer = 3;
    vest.panels[0].layer = -2;
    EXPECT_TRUE(put_over(pattern, vest).empty());
    EXPECT_EQ(garment_names(pattern), (Names{"shirt", "vest"}));
    EXPECT_EQ(panel_names(pattern), (Names{"front", "back", "vest_front", "vest_back"}));
    EXPECT_EQ(pattern.panels[2].layer, 4);
    EXPECT_EQ(pattern.panels[3].layer, 6);
    ASSERT_EQ(pattern.seams.size(), 4U);
    EXPECT_EQ(pattern.seams[2].first, (SeamSide{2, 1}));
    EXPECT_EQ(pattern.seams[3].second, (SeamSide{3, 0}));
    EXPECT_EQ(pattern.panels[2].vertices, vest.panels[0].vertices);
}

TEST(PutOver, gives_each_of_many_garments_its_own_names) {
    Pattern pattern = sample("vest");
    pattern.panels[1].name = "vest_front";
    pattern.seams[0].name = "side";
    Pattern outer = sample("vest");
    outer.seams[0].name = "side";
    outer.panels[1].mirror_of = "front";
    for (int i = 0; i < 2; ++i) put_over(pattern, outer);
    EXPECT_EQ(garment_names(pattern), (Names{"vest", "vest_2", "vest_3"}));
    const Names panels = panel_names(pattern);
    EXPECT_EQ(std::set<std::string>(panels.begin(), panels.end()).size(), 6U);
    EXPECT_EQ(panel_named(pattern, "back").mirror_of, "vest_2_front");
    EXPECT_EQ(pattern.seams[2].name, "vest_2_side");
    EXPECT_EQ(pattern.seams[4].name, "vest_3_side");
}

TEST(PutOver, keeps_the_fabrics_of_both) {
    Pattern pattern = sample("shirt");
    pattern.fabric = "silk";
    Pattern denim = sample("vest"), plain = sample("coat");
    denim.fabric = "denim";
    denim.panels[1].fabric = "linen";
    put_over(pattern, denim);
    put_over(pattern, plain);
    EXPECT_EQ(pattern.fabric, "silk");
    const Names expected{"", "", "denim", "linen", "cotton_shirting", "cotton_shirting"};
    for (std::size_t p = 0; p < 6; ++p) EXPECT_EQ(pattern.panels[p].fabric, expected[p]);
}

TEST(PutOver, says_where_the_outer_garment_names_another_body_or_edge_length) {
    Pattern pattern = sample("shirt"), vest = sample("vest");
    vest.body = "mannequin:sex=male";
    vest.tartan = "black_watch";
    vest.edge_length = 0.02;
    const Names notes = put_over(pattern, vest);
    ASSERT_EQ(notes.size(), 2U);
    EXPECT_EQ(notes[0], "'vest' names another body than 'shirt', over which it is worn: that of 'shirt' counts");
    EXPECT_TRUE(pattern.body.empty());
    EXPECT_TRUE(pattern.tartan.empty());
    EXPECT_FALSE(pattern.edge_length);
}

TEST(PutOver, the_outer_garment_keeps_what_it_shows) {
    Pattern pattern = sample("shirt"), vest = sample("vest"), coat = sample("coat");
    pattern.tartan = "gingham";
    vest.tartan = "black_watch";
    vest.sett_size = 0.1;
    vest.panels[1].surface = SurfaceDesign{.kind = DesignKind::Test};
    coat.surface = SurfaceDesign{.kind = DesignKind::Colour, .source = "#203040"};
    put_over(pattern, vest);
    put_over(pattern, coat);
    ASSERT_EQ(pattern.panels.size(), 6U);
    EXPECT_FALSE(pattern.panels[0].surface);
    EXPECT_EQ(pattern.panels[2].surface, (SurfaceDesign{.source = "black_watch", .size = 0.1}));
    EXPECT_EQ(pattern.panels[3].surface, vest.panels[1].surface);
    EXPECT_EQ(pattern.panels[4].surface, coat.surface);
}

TEST(PutOver, refuses_a_layer_beyond_the_highest) {
    Pattern pattern = sample("shirt");
    pattern.panels[0].layer = kHighestLayer;
    EXPECT_THROW(put_over(pattern, sample("vest")), InputError);
}

TEST(PutOver, survives_a_round_trip_through_a_file) {
    PatternDocument document = parse_pattern(sample_text(), "shirt.json");
    put_over(document.pattern, sample("vest"));
    const PatternDocument read = parse_pattern(write_pattern(document), "shirt.json");
    EXPECT_EQ(read.pattern, document.pattern);
    EXPECT_EQ(garment_names(read.pattern), (Names{"shirt", "vest"}));
    EXPECT_TRUE(check_pattern_text(write_pattern(read), "shirt.json").empty());
}

TEST(TakeOff, leaves_the_other_garments_as_they_were) {
    const Pattern alone = sample("shirt");
    Pattern pattern = alone;
    put_over(pattern, sample("vest"));
    EXPECT_TRUE(take_off(pattern, "vest"));
    EXPECT_EQ(panel_names(pattern), panel_names(alone));
    EXPECT_EQ(pattern.seams, alone.seams);
    EXPECT_FALSE(take_off(pattern, "vest"));
}

TEST(TakeOff, of_the_inner_garment_renumbers_the_seams_of_the_outer_one) {
    Pattern pattern = sample("shirt");
    put_over(pattern, sample("vest"));
    EXPECT_TRUE(take_off(pattern, "shirt"));
    EXPECT_EQ(panel_names(pattern), (Names{"vest_front", "vest_back"}));
    EXPECT_EQ(pattern.seams, sample("vest").seams);
}

TEST(GarmentFile, refuses_a_garment_that_is_no_text) {
    const std::string text = replaced(sample_text(), R"("back": {)", R"("back": {"selvedge": {"garment": 3}, )");
    try {
        parse_pattern(text, "f.json");
        ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), "pattern.panels.back.selvedge.garment");
    }
}

}  // namespace
}  // namespace selvedge::sim
