// Panels with linked halves: taking a half out and unfolding it again, and what files have of them.
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "sim/pattern/edge_keys.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/halves.h"
#include "sim/pattern/pattern_file.h"
#include "sim/pattern/sources.h"
#include "tests/sim/pattern/sample.h"

namespace selvedge::sim {
namespace {

// The sample's front, unfolded over its slanted last edge, with a mark of each kind and a seam within each half.
Pattern halved_sample() {
    Pattern pattern = evaluate(sources_of(parse_pattern(sample_text(), "f.json").pattern));
    Panel& front = pattern.panels[0];
    front.notches = {{.edge = 0, .t = 0.25}, {.edge = 2, .t = 0.6, .kind = NotchKind::V}};
    front.pins = {1, 3};
    front.internal_lines = {{.name = "pocket", .points = {{0.2, 0.2}, {0.3, 0.25}}}};
    front.drill_points = {{0.25, 0.1}};
    front.fold_key = front.edges[3].key.number;
    front = unfolded(front, 3);
    pattern.seams.clear();
    pattern.seams.push_back({.first = {0, 0}, .second = {0, 2}, .is_eased = true});
    pattern.seams.push_back({.first = {0, 3}, .second = {0, 5}, .name = "image", .is_eased = true});
    pattern.seams.push_back({.first = {0, 4}, .second = {1, 0}});
    return pattern;
}

TEST(LinkedHalves, are_unfolded_from_the_half_that_the_sources_hold) {
    const Pattern pattern = halved_sample();
    const Sources sources = sources_of(pattern);
    EXPECT_EQ(sources.panels[0].edges.size(), 4U);
    EXPECT_EQ(sources.panels[0].vertices.size(), 4U);
    EXPECT_EQ(sources.panels[0].notches.size(), 2U);
    EXPECT_EQ(sources.panels[0].internal_lines.size(), 1U);
    EXPECT_EQ(sources.panels[0].drill_points.size(), 1U);
    EXPECT_EQ(sources.seams[1].properties, (Seam{.first = {}, .second = {}, .name = "image"}));
    EXPECT_EQ(sources.seams[2].first, (SourceSide{"front", {2, EdgeRole::Image}}));
    EXPECT_EQ(evaluate(sources), pattern);
    EXPECT_EQ(sources_of(evaluate(sources)), sources);
}

TEST(LinkedHalves, change_both_when_the_source_is_edited) {
    Sources sources = sources_of(halved_sample());
    sources.panels[0].vertices[1] += Vec2d(0.05, 0.01);
    sources.seams[0].properties.is_eased = false;
    const Pattern pattern = evaluate(sources);
    const Panel half = *half_of(pattern.panels[0], EdgeRole::Drawn),
                other = *half_of(pattern.panels[0], EdgeRole::Image);
    for (const int number : {1, 2, 3}) {
        const OutlineEdge& own = half.edges[as_size(*find_edge(half, {number}))];
        const OutlineEdge& image = other.edges[as_size(*find_edge(other, {number}))];
        const Vec2d reflected = fold_reflection(half) * half.vertices[as_size(own.start)];
        EXPECT_LT((other.vertices[as_size(image.end)] - reflected).norm(), 1e-12) << number;
    }
    EXPECT_FALSE(pattern.seams[1].is_eased);
    EXPECT_EQ(pattern.seams[1].name, "image");
}

TEST(LinkedHalves, give_the_image_half_the_seams_that_the_drawn_half_has) {
    Sources sources = sources_of(halved_sample());
    sources.seams.erase(sources.seams.begin() + 1);
    const Pattern pattern = evaluate(sources);
    ASSERT_EQ(pattern.seams.size(), 3U);
    EXPECT_EQ(edge_key(pattern.panels[0], pattern.seams[2].first.edge), (EdgeKey{1, EdgeRole::Image}));
    EXPECT_EQ(edge_key(pattern.panels[0], pattern.seams[2].second.edge), (EdgeKey{3, EdgeRole::Image}));
}

TEST(LinkedHalves, give_a_copy_and_a_mirror_image_of_the_panel_both_halves) {
    Pattern pattern = halved_sample();
    for (const Derivation kind : {Derivation::Mirror, Derivation::Copy}) {
        Panel own;
        own.name = kind == Derivation::Mirror ? "image" : "copy";
        (kind == Derivation::Mirror ? own.mirror_of : own.copy_of) = "front";
        pattern.panels.push_back(derived_panel(pattern.panels[0], kind, own));
    }
    pattern = evaluate(sources_of(pattern));
    EXPECT_EQ(pattern.seams.size(), 7U) << "two seams within each derived panel";
    EXPECT_EQ(evaluate(sources_of(pattern)), pattern);
    EXPECT_EQ(pattern.panels[3].edges, pattern.panels[0].edges);
    Pattern again = parse_pattern(write_pattern({pattern, {}}), "f.json").pattern;
    EXPECT_TRUE(end_broken_links(again).empty());
    EXPECT_EQ(write_pattern({evaluate(sources_of(again)), {}}), write_pattern({pattern, {}}));
}

TEST(LinkedHalves, come_back_from_a_file_as_they_were) {
    const Pattern pattern = halved_sample();
    const std::string text = write_pattern({pattern, {}});
    EXPECT_NE(text.find("\"format\": 2"), std::string::npos);
    Pattern again = parse_pattern(text, pattern.name + ".json").pattern;
    EXPECT_EQ(again.panels[0].fold_key, 4);
    EXPECT_TRUE(end_broken_links(again).empty());
    EXPECT_EQ(write_pattern({evaluate(sources_of(again)), {}}), text);
}

TEST(LinkedHalves, end_where_no_edge_can_have_had_the_key_of_the_fold) {
    const std::string text = write_pattern({halved_sample(), {}});
    const auto with_fold = [&](const std::string& key) {
        return replaced(text, R"("fold_key": 4)", R"("fold_key": )" + key);
    };
    EXPECT_EQ(faults_of(with_fold("999999999")),
              std::vector<std::string>{"f.json: pattern.panels.front.selvedge.fold_key: warning: no edge had this key: "
                                       "the last that was given is 4"});
    EXPECT_FALSE(has_linked_halves(parse_pattern(with_fold("5"), "f.json").pattern.panels[0]));
    EXPECT_EQ(faults_of(with_fold("1000000000")),
              std::vector<std::string>{"f.json: pattern.panels.front.selvedge.fold_key: 1000000000 is not a whole "
                                       "number from 0 to 999999999"});
}

TEST(LinkedHalves, that_end_leave_no_key_of_a_fold_in_the_file) {
    PatternDocument document = parse_pattern(write_pattern({halved_sample(), {}}), "f.json");
    document.pattern.panels[0].fold_key = 0;
    EXPECT_EQ(write_pattern(document).find("fold_key"), std::string::npos);
}

TEST(LinkedHalves, that_another_program_changed_are_told_and_kept) {
    const Pattern linked = halved_sample();
    const auto move_image = [](Pattern& pattern) { pattern.panels[0].vertices[5].y() += 0.002; };
    const auto remove_notch = [](Pattern& pattern) { pattern.panels[0].notches.pop_back(); };
    const auto remove_seam = [](Pattern& pattern) { pattern.seams.erase(pattern.seams.begin()); };
    const auto ease_image = [](Pattern& pattern) { pattern.seams[1].is_eased = !pattern.seams[1].is_eased; };
    const auto lose_keys = [](Pattern& pattern) {
        for (OutlineEdge& edge : pattern.panels[0].edges) edge.key = {};
    };
    Pattern pattern = linked;
    EXPECT_TRUE(end_broken_links(pattern).empty());
    EXPECT_EQ(pattern, linked);
    for (const auto& change :
         std::vector<void (*)(Pattern&)>{move_image, remove_notch, remove_seam, ease_image, lose_keys}) {
        pattern = linked;
        change(pattern);
        const Pattern changed = pattern;
        EXPECT_EQ(end_broken_links(pattern),
                  (std::vector<EndedLink>{{"front",
                                           "the halves of 'front' are not mirror images of each other: the "
                                           "link is not followed"}}));
        EXPECT_FALSE(has_linked_halves(pattern.panels[0]));
        EXPECT_EQ(pattern.panels[0].vertices, changed.panels[0].vertices);
        EXPECT_EQ(evaluate(sources_of(pattern)), pattern);
    }
}

}  // namespace
}  // namespace selvedge::sim
