#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sim/core/error.h"
#include "sim/pattern/edge_keys.h"
#include "sim/pattern/pattern_file.h"
#include "sim/pattern/sources.h"
#include "tests/sim/pattern/sample.h"
#include "tests/support/checkout.h"

namespace selvedge::sim {
namespace {

Pattern evaluated_sample() {
    return evaluate(sources_of(parse_pattern(sample_text(), "f.json").pattern));
}

// With a mirror image and a copy of the front, the copy placed elsewhere, and a seam within each of them.
Pattern linked_sample() {
    Pattern pattern = evaluated_sample();
    const Panel front = pattern.panels[0];
    Panel image, copy;
    image.name = "image";
    image.mirror_of = "front";
    copy.name = "copy";
    copy.copy_of = "front";
    copy.translation = {1, 2, 3};
    copy.layer = 4;
    pattern.panels.push_back(derived_panel(front, Derivation::Mirror, image));
    pattern.panels.push_back(derived_panel(front, Derivation::Copy, copy));
    pattern.seams.clear();
    pattern.seams.push_back({.first = {2, 0}, .second = {2, 2}, .name = "of the image"});
    pattern.seams.push_back({.first = {0, 0}, .second = {0, 2}, .is_eased = true});
    pattern.seams[0].is_eased = true;
    pattern.seams.push_back({.first = {3, 0}, .second = {3, 2}, .is_eased = true});
    pattern.seams.push_back({.first = {2, 1}, .second = {1, 1}});
    return pattern;
}

TEST(Sources, give_the_pattern_again) {
    int patterns = 0;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() + "/patterns")) {
        if (entry.path().extension() != ".json") continue;
        const Pattern pattern = evaluate(sources_of(load_pattern(entry.path()).pattern));
        EXPECT_EQ(evaluate(sources_of(pattern)), pattern) << entry.path();
        EXPECT_EQ(sources_of(pattern), sources_of(evaluate(sources_of(pattern)))) << entry.path();
        ++patterns;
    }
    EXPECT_GT(patterns, 3);
    EXPECT_EQ(evaluate(sources_of(linked_sample())), linked_sample());
}

TEST(Sources, hold_only_own_fields_of_a_panel_that_is_derived) {
    const Sources sources = sources_of(linked_sample());
    const Panel& image = sources.panels[2];
    const Panel& copy = sources.panels[3];
    EXPECT_TRUE(image.edges.empty() && image.vertices.empty() && copy.edges.empty());
    EXPECT_EQ(image.translation, Vec3d::Zero().eval());
    EXPECT_EQ(copy.translation, Vec3d(1, 2, 3));
    EXPECT_EQ(copy.layer, 4);
    EXPECT_EQ(sources.seams[0].properties, (Seam{.first = {}, .second = {}, .name = "of the image"}))
        << "the front's seam says the rest";
    EXPECT_EQ(sources.seams[3].first, (SourceSide{"image", EdgeKey{4}}));
}

TEST(Sources, change_derived_panels_when_their_source_is_edited) {
    Sources sources = sources_of(linked_sample());
    sources.panels[0].fabric = "silk";
    sources.panels[0].vertices[0].x() += 0.01;
    const Pattern pattern = evaluate(sources);
    EXPECT_EQ(pattern.panels[2].fabric, "silk");
    EXPECT_EQ(pattern.panels[2].vertices[0].x(), -pattern.panels[0].vertices[0].x());
    EXPECT_EQ(pattern.panels[3].vertices, pattern.panels[0].vertices);
    EXPECT_EQ(pattern.panels[3].translation, Vec3d(1, 2, 3));
}

std::string problem_of(const Sources& sources) {
    try {
        evaluate(sources);
    } catch (const InputError& error) {
        return error.problem();
    }
    return "";
}

TEST(Sources, cycles_and_missing_sources_are_named) {
    Sources sources = sources_of(linked_sample());
    sources.panels[0] = {};
    sources.panels[0].name = "front";
    sources.panels[0].copy_of = "copy";
    EXPECT_EQ(problem_of(sources), "panel 'front' is derived from itself");
    sources.panels[0].copy_of = "nobody";
    EXPECT_EQ(problem_of(sources), "panel 'front' is derived from 'nobody', which is not there");
    sources = sources_of(linked_sample());
    sources.seams[3].second.edge.number = 77;
    EXPECT_EQ(problem_of(sources), "a seam has edge 77 of panel 'back', which is not there");
}

TEST(Sources, links_of_panels_that_another_program_changed_end) {
    const Pattern linked = linked_sample();
    Pattern pattern = linked;
    EXPECT_TRUE(end_broken_links(pattern).empty());
    EXPECT_EQ(pattern, linked);
    pattern.panels[2].vertices[1].y() += 0.002;
    pattern.panels[3].fabric = "silk";
    const Pattern changed = pattern;
    EXPECT_EQ(end_broken_links(pattern),
              (std::vector<EndedLink>{{"image", "'image' is not the mirror image of 'front': the link is not followed"},
                                      {"copy", "'copy' is not the copy of 'front': the link is not followed"}}));
    EXPECT_FALSE(link_of(pattern.panels[2]) || link_of(pattern.panels[3]));
    EXPECT_EQ(pattern.panels[2].vertices, changed.panels[2].vertices);
    EXPECT_EQ(pattern.panels[3].fabric, "silk");
    EXPECT_EQ(evaluate(sources_of(pattern)), pattern);
}

TEST(Sources, a_link_ends_where_one_panel_has_a_seam_within_it_and_the_other_has_not) {
    Pattern pattern = linked_sample();
    pattern.seams.erase(pattern.seams.begin());
    EXPECT_EQ(end_broken_links(pattern).size(), 1U);
    EXPECT_EQ(evaluate(sources_of(pattern)).seams.size(), 3U);
}

TEST(Sources, linked_panels_come_back_from_a_file_as_they_were) {
    const Pattern linked = linked_sample();
    const std::string text = write_pattern({linked, {}});
    EXPECT_NE(text.find("\"format\": 2"), std::string::npos);
    Pattern again = parse_pattern(text, linked.name + ".json").pattern;
    EXPECT_EQ(again.panels[3].copy_of, "front");
    EXPECT_TRUE(end_broken_links(again).empty());
    EXPECT_EQ(write_pattern({evaluate(sources_of(again)), {}}), text);
}

TEST(Sources, broken_links_are_warned_of_at_the_panel_when_a_file_is_read) {
    Pattern pattern = linked_sample();
    pattern.seams.pop_back();  // its sides differ
    EXPECT_TRUE(parse_pattern(write_pattern({pattern, {}}), "f.json").warnings.empty());
    pattern.panels[3].fabric = "silk";
    const std::string text = write_pattern({pattern, {}});
    const std::vector<std::string> faults = faults_of(text);
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults[0],
              "f.json: pattern.panels.copy: warning: 'copy' is not the copy of 'front': the link is not followed");
    const PatternDocument document = parse_pattern(text, "f.json");
    ASSERT_EQ(document.warnings.size(), 1U);
    EXPECT_EQ(describe(document.warnings[0]), faults[0]);
    EXPECT_EQ(document.pattern.panels[3].copy_of, "front") << "what only reads the file keeps the link";
}

TEST(Sources, links_in_a_file_are_checked) {
    const std::string text = write_pattern({linked_sample(), {}});
    const std::string at = "f.json: pattern.panels.copy.selvedge.copy_of: ";
    EXPECT_EQ(faults_of(replaced(text, R"("copy_of": "front")", R"("copy_of": "fornt")")).front(),
              at + "no panel 'fornt'");
    EXPECT_EQ(faults_of(replaced(text, R"("copy_of": "front")", R"("copy_of": "copy")")).front(),
              at + "a panel is no copy of itself");
    EXPECT_EQ(faults_of(replaced(text, R"("copy_of": "front")", R"("copy_of": "front", "mirror_of": "front")")).front(),
              at + "a panel has mirror_of or copy_of, not both");
    EXPECT_EQ(faults_of(replaced(text, R"("copy_of": "front")", R"("copy_of": "")")).front(), at + "no panel ''");
}

TEST(Sources, panels_that_are_copies_of_each_other_are_told_so) {
    std::string text = sample_text();
    text = replaced(text, R"("front": {)", R"("front": {"selvedge": {"copy_of": "back"}, )");
    text = replaced(text, R"("back": {)", R"("back": {"selvedge": {"copy_of": "front"}, )");
    const std::string place = "f.json: pattern.panels.";
    EXPECT_EQ(faults_of(text), (std::vector<std::string>{
                                   place + "front.selvedge.copy_of: panel 'back' is made from 'front' itself: one of "
                                           "them must be drawn",
                                   place + "back.selvedge.copy_of: panel 'front' is made from 'back' itself: one of "
                                           "them must be drawn"}));
}

// The image and the copy are derived from the front.
TEST(Sources, a_fault_of_a_link_is_said_of_the_panel_that_has_it) {
    Pattern pattern = linked_sample();
    pattern.seams.clear();
    const auto faults_of_front = [&](const std::string& source) {
        pattern.panels[0].copy_of = source;
        return faults_of(write_pattern({pattern, {}}));
    };
    const std::string at = "f.json: pattern.panels.front.selvedge.copy_of: ";
    EXPECT_EQ(faults_of_front("front"), std::vector{at + "a panel is no copy of itself"});
    EXPECT_EQ(faults_of_front("fornt"), std::vector{at + "no panel 'fornt'"});
}

}  // namespace
}  // namespace selvedge::sim
