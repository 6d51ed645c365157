// Spoils a garment file at many places: it loads or is refused in words, and what loads is sound enough to save.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "sim/core/error.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/pattern_file.h"
#include "tests/sim/pattern/sample.h"

namespace selvedge {
namespace {

constexpr std::array kScraps{"",     "-",     "0",     "9",    "1e9",   "1e300", "-1",         "null",
                             "true", "\"\"",  "[]",    "{}",   "[",     "]",     "}",          ",",
                             "0.5",  "\"x\"", "[[0]]", "1e-9", "front", "edge",  "\"circle\"", "\"absolute\""};

// Replaces up to eight characters at a random place by a scrap of JSON.
std::string spoil(std::string text, std::mt19937& random) {
    const auto below = [&](std::size_t count) { return random() % count; };
    const std::size_t at = below(text.size());
    text.replace(at, below(9), kScraps[below(kScraps.size())]);
    return text;
}

// Replaces one number, which leaves the file well-formed far more often.
std::string spoil_number(std::string text, std::mt19937& random) {
    const std::size_t from = text.find_first_of("0123456789", random() % text.size());
    if (from == std::string::npos) return text;
    const std::size_t to = text.find_first_not_of("0123456789.", from);
    text.replace(from, to - from, kScraps[random() % kScraps.size()]);
    return text;
}

// Did it load? Whatever else than InputError leaves this, or a value that is not finite, fails the test.
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
    for (int i = 0; i < 1500; ++i) loaded += survives(spoil(sample_text(), random)) ? 1 : 0;
    for (int i = 0; i < 1500; ++i) loaded += survives(spoil_number(sample_text(), random)) ? 1 : 0;
    EXPECT_GT(loaded, 300);  // else it tries the JSON parser only
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
    for (int i = 0; i < 1500; ++i) loaded += survives(spoil(text, random)) ? 1 : 0;
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
}  // namespace selvedge
