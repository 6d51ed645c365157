#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sim/core/error.h"
#include "sim/pattern/edge_keys.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/pattern_file.h"
#include "tests/sim/pattern/sample.h"

namespace selvedge::sim {
namespace {

Panel square() {
    Panel panel;
    panel.name = "square";
    panel.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int i = 0; i < 4; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 4});
    return panel;
}

Panel keyed_square() {
    Panel panel = square();
    give_keys(panel);
    return panel;
}

std::vector<int> numbers_of(const Panel& panel) {
    std::vector<int> numbers;
    for (int e = 0; e < static_cast<int>(panel.edges.size()); ++e) numbers.push_back(edge_key(panel, e).number);
    return numbers;
}

TEST(EdgeKeys, count_the_edges_where_none_was_given) {
    EXPECT_EQ(numbers_of(square()), (std::vector{1, 2, 3, 4}));
    EXPECT_EQ(numbers_of(keyed_square()), (std::vector{1, 2, 3, 4}));
    Panel panel = square();
    split_edge(panel, 1, 0.5);
    EXPECT_FALSE(has_keys(panel));
}

TEST(EdgeKeys, the_first_part_of_an_edge_keeps_its_key_and_no_number_is_given_twice) {
    Panel panel = keyed_square();
    split_edge(panel, 1, 0.5);
    EXPECT_EQ(numbers_of(panel), (std::vector{1, 2, 5, 3, 4}));
    panel.edges.erase(panel.edges.begin() + 2);
    panel.edges[1].end = 2;
    split_edge(panel, 0, 0.5);
    EXPECT_EQ(numbers_of(panel), (std::vector{1, 6, 2, 3, 4}));
}

TEST(EdgeKeys, of_two_edges_with_one_key_the_second_gets_another) {
    Panel panel = keyed_square();
    panel.edges[3].key = panel.edges[0].key;
    panel.edges[2].key = {};
    give_keys(panel);
    EXPECT_EQ(numbers_of(panel), (std::vector{1, 2, 5, 6}));
}

TEST(EdgeKeys, a_mirrored_panel_has_those_of_its_source) {
    const Panel panel = keyed_square();
    const Panel mirrored = mapped_panel(panel, Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0)));
    EXPECT_EQ(numbers_of(mirrored), (std::vector{1, 4, 3, 2}));
    EXPECT_TRUE(is_turned_over(panel, mirrored));
    EXPECT_FALSE(is_turned_over(panel, panel));
    EXPECT_TRUE(shared_stretches(panel, mirrored).empty());
}

TEST(EdgeKeys, an_unfolded_panel_has_those_of_the_half_twice) {
    const Panel whole = unfolded(keyed_square(), 3);
    ASSERT_EQ(whole.edges.size(), 6U);
    for (int e = 0; e < 3; ++e) {
        EXPECT_EQ(edge_key(whole, e), (EdgeKey{e + 1}));
        EXPECT_EQ(edge_key(whole, 5 - e), (EdgeKey{e + 1, EdgeRole::Image}));
    }
    Panel twice = unfolded(whole, 1);
    const std::size_t count = twice.edges.size();
    const int last = twice.last_key;
    give_keys(twice);
    EXPECT_EQ(twice.edges.size(), count);
    EXPECT_EQ(twice.last_key, last) << "no key stood twice";
}

TEST(EdgeKeys, outlines_correspond_between_the_points_that_both_have) {
    const Panel panel = keyed_square();
    Panel split = panel;
    split_edge(split, 1, 0.5);
    std::rotate(split.edges.begin(), split.edges.begin() + 2, split.edges.end());  // keys 5 3 4 1 2
    const std::vector<OutlineStretch> stretches = shared_stretches(panel, split);
    ASSERT_EQ(stretches.size(), 4U);
    EXPECT_EQ(stretches[0].other_first, 3);
    EXPECT_EQ(stretches[0].other_count, 1);
    EXPECT_EQ(stretches[1].count, 1);
    EXPECT_EQ(stretches[1].other_first, 4);
    EXPECT_EQ(stretches[1].other_count, 2) << "edge 2 and its second part, which is first in the list";
    EXPECT_EQ(stretches[2].other_first, 1);
}

std::string with_keys(const std::string& keys) {
    return replaced(sample_text(), R"("front": {)", R"("front": {"selvedge": {"edge_keys": )" + keys + "}, ");
}

TEST(EdgeKeys, are_in_the_file_where_they_do_not_count_the_edges) {
    PatternDocument document = parse_pattern(sample_text(), "f.json");
    for (Panel& panel : document.pattern.panels) give_keys(panel);
    EXPECT_EQ(write_pattern(document), write_pattern(parse_pattern(sample_text(), "f.json")));
    split_edge(document.pattern.panels[0], 1, 0.5);
    const std::string text = write_pattern(document);
    EXPECT_NE(text.find("\"format\""), std::string::npos);
    const PatternDocument again = parse_pattern(text, "f.json");
    EXPECT_EQ(numbers_of(again.pattern.panels[0]), (std::vector{1, 2, 5, 3, 4}));
    EXPECT_EQ(again.pattern.panels[0].last_key, 5);
    EXPECT_EQ(write_pattern(again), text);
}

TEST(EdgeKeys, of_a_file_may_name_images) {
    const Pattern pattern = parse_pattern(with_keys(R"({"keys": [1, 2, {"image": 2}, 7], "last": 9})"), "").pattern;
    EXPECT_EQ(edge_key(pattern.panels[0], 2), (EdgeKey{2, EdgeRole::Image}));
    EXPECT_EQ(pattern.panels[0].last_key, 9);
}

TEST(EdgeKeys, of_a_file_are_checked) {
    const std::string at = "f.json: pattern.panels.front.selvedge.edge_keys";
    EXPECT_EQ(faults_of(with_keys(R"({"keys": [1, 2, 3], "last": 4})")),
              (std::vector{at + ".keys: warning: 3 different keys for 4 edges: the edges are numbered anew"}));
    EXPECT_EQ(faults_of(with_keys(R"({"keys": [1, 2, 3, 3], "last": 4})")),
              (std::vector{at + ".keys: warning: 3 different keys for 4 edges: the edges are numbered anew"}));
    EXPECT_EQ(faults_of(with_keys(R"({"keys": [1, 1, 1, 1], "last": 4})")),
              (std::vector{at + ".keys: warning: 1 different key for 4 edges: the edges are numbered anew"}));
    EXPECT_EQ(faults_of(with_keys(R"({"keys": [1, 2, 3, 4]})")), (std::vector{at + ": no key 'last'"}));
    EXPECT_EQ(faults_of(with_keys(R"({"keys": [1, 2, 3, {"twin": 4}], "last": 4})")),
              (std::vector{at + ".keys[3]: no key 'image'"}));
    EXPECT_EQ(faults_of(with_keys(R"({"keys": [1, 2, 3, 5], "last": 4})")).size(), 1U);
    EXPECT_EQ(faults_of(with_keys("7")).size(), 1U);
    EXPECT_EQ(faults_of(with_keys(R"({"keys": [1, 2, 3, 4], "last": 1000000000})")),
              (std::vector{at + ".last: warning: no number is left for a new key: the edges are numbered anew"}));
}

TEST(EdgeKeys, a_file_of_a_newer_format_is_read_and_not_written) {
    const std::string text =
        replaced(sample_text(), R"("parameters")", R"("selvedge": {"format": 3, "fabric": "silk"}, "parameters")");
    const std::vector<std::string> faults = faults_of(text);
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults[0],
              "f.json: selvedge.format: warning: written by a newer program, in format 3; this one knows formats up to "
              "2 and would lose what is new in it");
    const PatternDocument document = parse_pattern(text, "f.json");
    EXPECT_EQ(document.pattern.fabric, "silk");
    EXPECT_THROW(save_pattern(document, "nowhere/f.json"), InputError);
    EXPECT_TRUE(newer_format(document.json));
    EXPECT_FALSE(newer_format(parse_pattern(sample_text(), "f.json").json));
}

TEST(EdgeKeysInFiles, an_image_of_no_edge_is_told) {
    EXPECT_EQ(faults_of(with_keys(R"({"keys": [1, 2, {"image": 2}, {"image": 7}], "last": 7})")),
              (std::vector<std::string>{"f.json: pattern.panels.front.selvedge.edge_keys.keys[3]: warning: no edge has "
                                        "the key 7, of which this is the image"}));
}

}  // namespace
}  // namespace selvedge::sim
