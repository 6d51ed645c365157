// Patterns that are too large to be meant: refused on one line, in bounded time and memory.
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "sim/core/error.h"
#include "sim/pattern/pattern_file.h"
#include "tests/support/processor_time.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

std::string quoted(const std::string& text) {
    return '"' + text + '"';
}

// Squares of 10 cm, called p0, p1 ...
std::string squares(int count) {
    std::string text;
    for (int p = 0; p < count; ++p) {
        text += (p > 0 ? "," : "") + quoted("p" + std::to_string(p)) +
                R"(:{"vertices":[[0,0],[10,0],[10,10],[0,10]],"edges":[{"endpoints":[0,1]},{"endpoints":[1,2]},)"
                R"({"endpoints":[2,3]},{"endpoints":[3,0]}]})";
    }
    return text;
}

std::string side(int index) {
    return R"({"panel":"p)" + std::to_string(index / 4) + R"(","edge":)" + std::to_string(index % 4) + '}';
}

TEST(PatternLimits, a_file_of_more_than_16_megabytes_is_refused_on_one_line) {
    const TemporaryFolder folder;
    std::ofstream(folder / "large.json") << R"({"pattern":{"panels":{}},"x":")" << std::string(17 << 20, 'a') << "\"}";
    try {
        load_pattern(folder / "large.json");
        ADD_FAILURE() << "read";
    } catch (const InputError& error) {
        EXPECT_NE(error.problem().find("16777216"), std::string::npos) << error.what();
    }
    EXPECT_EQ(check_pattern_file(folder / "large.json").size(), 1U);
}

TEST(PatternLimits, more_than_10000_panels_are_one_fault) {
    std::string panels;
    for (int p = 0; p < 10'001; ++p) panels += (p > 0 ? "," : "") + quoted("p" + std::to_string(p)) + ":{}";
    const std::vector<Fault> faults = check_pattern_text(R"({"pattern":{"panels":{)" + panels + "}}}", "many.json");
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(describe(faults[0]), "many.json: pattern.panels: 10001 panels: at most 10000");
}

TEST(PatternLimits, of_many_faults_the_first_thousand_are_listed) {
    std::string points;
    for (int i = 0; i < 100'000; ++i) points += i > 0 ? ",1" : "1";
    const std::vector<Fault> faults =
        check_pattern_text(R"({"pattern":{"panels":{"p":{"vertices":[)" + points + R"(],"edges":[]}}}})", "wrong.json");
    EXPECT_EQ(faults.size(), kMostFaults + 1);
    EXPECT_EQ(faults.back().problem, "more than 1000: no others are listed");
}

// Looking for each of the listed edges among all seams would take 8e9 comparisons.
TEST(PatternLimits, seams_that_are_listed_are_found_in_time_that_grows_with_the_list) {
    constexpr int kSeams = 20'000, kListed = 400'000;
    std::string stitches, listed;
    for (int s = 0; s < kSeams; ++s) stitches += (s > 0 ? ",[" : "[") + side(2 * s) + ',' + side(2 * s + 1) + ']';
    for (int i = 0; i < kListed; ++i) listed += (i > 0 ? "," : "") + side(2 * kSeams - 1 - i % 8);
    const auto seconds = [&](const std::string& object) {
        const std::string text = R"({"pattern":{"panels":{)" + squares(kSeams / 2) + R"(},"stitches":[)" + stitches +
                                 R"(]},")" + object + R"(":{"eased":[)" + listed + "]}}";
        const double before = processor_seconds();
        const std::vector<Fault> faults = check_pattern_text(text, "many.json");
        EXPECT_EQ(faults.empty(), object != "selvedge") << "a seam is listed once";
        return processor_seconds() - before;
    };
    const double only_parsed = seconds("not_ours");
    EXPECT_LT(seconds("selvedge"), 4 * only_parsed);
}

}  // namespace
}  // namespace selvedge::sim
