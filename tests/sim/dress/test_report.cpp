// The report's JSON, read back by the program's own reader.
#include "sim/dress/report.h"

#include <gtest/gtest.h>

#include <set>

#include "sim/core/json.h"

namespace selvedge::test {
namespace {

using Keys = std::set<std::string>;

Keys keys_of(const Json& object) {
    Keys keys;
    for (const Json::Member& member : object.members()) keys.insert(member.key);
    return keys;
}

DressReport full_report() {
    DressReport report;
    report.garment = "tshirt";
    report.body = "mannequin";
    report.settled = true;
    report.stopped_because = "settled";
    report.simulated_seconds = 3.5;
    report.faults = {{"open_seam", "seam 2, 'front' edge 1 to 'back' edge 3", 0.012}};
    report.notes = {"panel 'front' moved 20 mm outward, clear of the body"};
    report.mesh = {.base_triangles = 700,
                   .leaf_triangles = 6000,
                   .leaf_vertices = 3100,
                   .by_level = {10, 20, 30, 40},
                   .min_angle_deg = 27.5,
                   .splits = 5000000000,
                   .rejoins = 12,
                   .transitions = 34};
    report.seams = {.count = 12, .open = 1, .worst_length_mismatch = 0.04};
    report.contact = {.inside = 3, .deepest_m = 0.0004};
    report.stretch = {.warp_weft_p50 = 0.001, .warp_weft_p99 = 0.02, .warp_weft_max = 0.03, .shear_deg_p99 = 12};
    report.timing = {.wall_s = 9,
                     .ms_per_adaption = 1,
                     .ms_per_step = 2,
                     .ms_adapt_plus_4_steps = 9,
                     .phases_s = {{"draping", 7.0}, {"sewing", 2.0}},
                     .peak_memory_mb = 80};
    return report;
}

Json parsed(const DressReport& report) {
    return parse_json(to_json(report), "report.json");
}

TEST(Report, has_the_keys_that_were_promised_and_no_others) {
    const Json json = parsed(full_report());
    EXPECT_EQ(keys_of(json), (Keys{"garment", "body", "settled", "stopped_because", "simulated_seconds", "faults",
                                   "notes", "mesh", "seams", "contact", "stretch", "timing"}));
    EXPECT_EQ(keys_of(json.find("faults")->elements().at(0)), (Keys{"kind", "place", "value"}));
    EXPECT_EQ(keys_of(*json.find("mesh")), (Keys{"base_triangles", "leaf_triangles", "leaf_vertices", "by_level",
                                                 "min_angle_deg", "splits", "rejoins", "transitions"}));
    EXPECT_EQ(keys_of(*json.find("seams")), (Keys{"count", "open", "worst_length_mismatch"}));
    EXPECT_EQ(keys_of(*json.find("contact")), (Keys{"inside", "deepest_m"}));
    EXPECT_EQ(keys_of(*json.find("stretch")),
              (Keys{"warp_weft_p50", "warp_weft_p99", "warp_weft_max", "shear_deg_p99"}));
    EXPECT_EQ(keys_of(*json.find("timing")),
              (Keys{"wall_s", "ms_per_adaption", "ms_per_step", "ms_adapt_plus_4_steps", "phases", "peak_memory_mb"}));
}

TEST(Report, has_the_same_keys_when_there_is_nothing_to_say) {
    const Json full = parsed(full_report());
    const Json empty = parsed(DressReport{});
    EXPECT_EQ(keys_of(empty), keys_of(full));
    EXPECT_TRUE(empty.find("faults")->elements().empty());
    EXPECT_EQ(keys_of(*empty.find("mesh")), keys_of(*full.find("mesh")));
}

TEST(Report, gives_back_what_was_put_in) {
    const Json json = parsed(full_report());
    const JsonView view(json, "report.json");
    EXPECT_EQ(view.at("garment").string(), "tshirt");
    EXPECT_TRUE(view.at("settled").boolean());
    EXPECT_EQ(view.at("simulated_seconds").number(), 3.5);
    EXPECT_EQ(view.at("faults").at(0).at("kind").string(), "open_seam");
    EXPECT_EQ(view.at("faults").at(0).at("value").number(), 0.012);
    EXPECT_EQ(view.at("mesh").at("by_level").numbers(), (std::vector<double>{10, 20, 30, 40}));
    EXPECT_EQ(view.at("mesh").at("splits").number(), 5e9);
    EXPECT_EQ(view.at("contact").at("deepest_m").number(), 0.0004);
    EXPECT_EQ(view.at("stretch").at("warp_weft_max").number(), 0.03);
    EXPECT_EQ(view.at("timing").at("phases").at("sewing").number(), 2.0);
}

TEST(Report, survives_places_that_need_escaping) {
    DressReport report = full_report();
    report.faults[0].place = "panel \"a\\b\"\n'\u00e4rmel'";
    EXPECT_EQ(parsed(report).find("faults")->elements()[0].find("place")->string(), report.faults[0].place);
}

}  // namespace
}  // namespace selvedge::test
