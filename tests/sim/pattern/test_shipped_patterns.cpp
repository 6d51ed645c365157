// Checks the shipped garments, which are also test cases for the rest of the program.
#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <filesystem>
#include <random>

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/pattern_file.h"
#include "tests/sim/pattern/sample.h"
#include "tests/support/checkout.h"

namespace selvedge::sim {
namespace {

std::filesystem::path shipped(const std::string& name) {
    return std::filesystem::path(source_folder()) / "patterns" / (name + ".json");
}

class ShippedPattern : public ::testing::TestWithParam<const char*> {
 protected:
    Pattern pattern = load_pattern(shipped(GetParam())).pattern;
};

TEST_P(ShippedPattern, has_neither_fault_nor_warning) {
    for (const Fault& fault : check_pattern_file(shipped(GetParam()))) ADD_FAILURE() << describe(fault);
}

TEST_P(ShippedPattern, names_a_fabric_a_tartan_and_its_body) {
    EXPECT_NO_THROW(find_fabric(pattern.fabric));
    EXPECT_FALSE(pattern.tartan.empty());
    EXPECT_EQ(pattern.body, "mannequin:sex=female");
    EXPECT_NEAR(pattern.body_height, 1.606, 1e-9);
}

// The sides of each seam are close in x and height, and less than 0.45 m apart, so that the seam closes without
// crossing the body.
TEST_P(ShippedPattern, the_ends_of_its_seams_stand_level_across_the_body) {
    for (const Seam& seam : pattern.seams) {
        const auto end = [&](const SeamSide& side, double t) {
            const Panel& panel = pattern.panels[static_cast<std::size_t>(side.panel)];
            return panel.place(outline_point(panel, panel.edges[static_cast<std::size_t>(side.edge)], t));
        };
        for (const double t : {0.0, 0.5, 1.0}) {
            const Vec3d gap = end(seam.first, t) - end(seam.second, seam.is_reversed ? 1 - t : t);
            EXPECT_LT(std::abs(gap.x()), 0.12);
            EXPECT_LT(std::abs(gap.y()), 0.12);
            EXPECT_LT(gap.norm(), 0.45);
        }
    }
}

// The placed outlines must have the same total length on both sides of x = 0, within 0.5 %.
TEST_P(ShippedPattern, is_as_long_on_the_left_as_on_the_right) {
    double left = 0;
    double right = 0;
    for (const Panel& panel : pattern.panels) {
        for (const OutlineEdge& edge : panel.edges) {
            for (int i = 0; i < 200; ++i) {
                const double middle = panel.place(outline_point(panel, edge, (i + 0.5) / 200)).x();
                (middle > 0 ? left : right) += outline_length(panel, edge) / 200;
            }
        }
    }
    EXPECT_NEAR(left, right, 0.005 * right);
}

INSTANTIATE_TEST_SUITE_P(, ShippedPattern,
                         ::testing::Values("tshirt", "tshirt_thesis", "skirt", "poncho", "two_squares", "vest",
                                           "dress"),
                         [](const auto& garment) { return std::string(garment.param); });

TEST(FormatGuide, shows_a_garment_that_is_sound) {
    const std::string guide =
        read_file(std::filesystem::path(source_folder()) / "patterns" / "FORMAT.md", std::size_t{1} << 20);
    const std::size_t from = guide.find("```json\n") + 8;
    const std::string example = guide.substr(from, guide.find("```", from) - from);
    for (const Fault& fault : check_pattern_text(example, "FORMAT.md")) ADD_FAILURE() << describe(fault);
    EXPECT_TRUE(parse_pattern(example, "FORMAT.md").pattern.panels[1].is_mirrored);
}

double girth(const Pattern& pattern, int front_edge, int back_edge) {
    return outline_length(pattern.panels[0], pattern.panels[0].edges[static_cast<std::size_t>(front_edge)]) +
           outline_length(pattern.panels[1], pattern.panels[1].edges[static_cast<std::size_t>(back_edge)]);
}

TEST(ShippedSkirt, sits_on_a_waist_of_66_and_a_half_centimetres) {
    const Pattern skirt = load_pattern(shipped("skirt")).pattern;
    EXPECT_NEAR(girth(skirt, 2, 1), 0.67, 0.005);
    EXPECT_GT(girth(skirt, 0, 3), 1.5);
}

TEST(ShippedShirt, has_ease_round_the_bust_and_sleeves_that_fit_their_armholes) {
    const Pattern shirt = load_pattern(shipped("tshirt")).pattern;
    ASSERT_EQ(shirt.panels.size(), 6U);
    const Panel& front = shirt.panels[0];
    const double bust = 4 * front.vertices[2].x();
    EXPECT_GT(bust, 0.838 + 0.06);
    EXPECT_LT(bust, 0.838 + 0.12);
    int armhole_seams = 0;
    for (const Seam& seam : shirt.seams) {
        if (seam.first.panel > 1 || seam.second.panel < 2) continue;
        ++armhole_seams;
        const Panel& body = shirt.panels[static_cast<std::size_t>(seam.first.panel)];
        const Panel& sleeve = shirt.panels[static_cast<std::size_t>(seam.second.panel)];
        const double ease = outline_length(sleeve, sleeve.edges[static_cast<std::size_t>(seam.second.edge)]) /
                            outline_length(body, body.edges[static_cast<std::size_t>(seam.first.edge)]);
        EXPECT_GT(ease, 0.98);
        EXPECT_LT(ease, 1.05);
    }
    EXPECT_EQ(armhole_seams, 4);
}

}  // namespace

// Fuzz test: changes a garment file at random. It must load or be rejected with InputError; what loads must be valid
// enough to save.

namespace {

constexpr std::array kScraps{"",     "-",     "0",     "9",    "1e9",   "1e300", "-1",         "null",
                             "true", "\"\"",  "[]",    "{}",   "[",     "]",     "}",          ",",
                             "0.5",  "\"x\"", "[[0]]", "1e-9", "front", "edge",  "\"circle\"", "\"absolute\""};

// Replaces up to eight characters at a random offset by a fragment of JSON.
std::string mutate(std::string text, std::mt19937& random) {
    const auto below = [&](std::size_t count) { return random() % count; };
    const std::size_t at = below(text.size());
    text.replace(at, below(9), kScraps[below(kScraps.size())]);
    return text;
}

// Replaces one number, so that the file stays well-formed much more often.
std::string spoil_number(std::string text, std::mt19937& random) {
    const std::size_t from = text.find_first_of("0123456789", random() % text.size());
    if (from == std::string::npos) return text;
    const std::size_t to = text.find_first_not_of("0123456789.", from);
    text.replace(from, to - from, kScraps[random() % kScraps.size()]);
    return text;
}

// Returns whether the text loads. Any exception other than InputError, or a value that is not finite, fails the test.
bool survives(const std::string& text) {
    PatternDocument document;
    try {
        document = parse_pattern(text, "f.json");
    } catch (const InputError& error) {
        EXPECT_TRUE(has_error(check_pattern_text(text, "f.json"))) << error.what();
        return false;
    }
    for (const Panel& panel : document.pattern.panels) {
        EXPECT_GT(outline_area(panel), 0) << text;
        for (const OutlineEdge& edge : panel.edges) {
            EXPECT_GT(outline_length(panel, edge), 0) << text;
            EXPECT_TRUE(panel.place(outline_point(panel, edge, 0.5)).allFinite()) << text;
        }
    }
    EXPECT_EQ(parse_pattern(write_pattern(document), "f.json").pattern.panels.size(), document.pattern.panels.size());
    return true;
}

TEST(PatternFuzz, loads_or_refuses_whatever_stands_in_the_file) {
    std::mt19937 random(20121);
    int loaded = 0;
    for (int i = 0; i < 1500; ++i) loaded += survives(mutate(sample_text(), random)) ? 1 : 0;
    for (int i = 0; i < 1500; ++i) loaded += survives(spoil_number(sample_text(), random)) ? 1 : 0;
    EXPECT_GT(loaded, 300);  // otherwise it tests only the JSON parser
    EXPECT_LT(loaded, 2700);
}

TEST(PatternFuzz, loads_or_refuses_whatever_stands_in_what_drafting_adds) {
    const std::string text =
        replaced(replaced(sample_text(), R"("back": {)",
                          R"("back": {"selvedge": {"notches": [{"edge": 1, "at": 0.25}, {"edge": 0, "at": 1}],
 "wrap_radius": 15, "mirror_of": "front", "sheet_position": [120, -7]}, )"),
                 R"("pattern": {)", R"("selvedge": {"eased": [{"panel": "back", "edge": 2}]}, "pattern": {)");
    std::mt19937 random(5);
    int loaded = 0;
    for (int i = 0; i < 1500; ++i) loaded += survives(mutate(text, random)) ? 1 : 0;
    for (int i = 0; i < 1500; ++i) loaded += survives(spoil_number(text, random)) ? 1 : 0;
    EXPECT_GT(loaded, 300);
    EXPECT_LT(loaded, 2700);
}

TEST(PatternFuzz, refuses_a_file_cut_short_anywhere) {
    const std::string text = sample_text();
    for (std::size_t length = 0; length + 2 < text.size(); length += 7) {
        EXPECT_THROW(parse_pattern(text.substr(0, length), "f.json"), InputError) << length;
    }
}

}  // namespace

}  // namespace selvedge::sim
