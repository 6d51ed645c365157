// selvedge check: exit codes, and the path of every fault.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/app/selvedge_program.h"

namespace selvedge::app {
namespace {

// A square of 40 cm; its outline is closed if last_endpoint is 0.
std::string square_pattern(int last_endpoint) {
    return R"({"pattern": {"panels": {"square": {
        "vertices": [[0, 0], [40, 0], [40, 40], [0, 40]], "translation": [0, 0, 0], "rotation": [0, 0, 0],
        "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, )" +
           std::to_string(last_endpoint) + R"(]}]}}, "stitches": []},
        "properties": {"curvature_coords": "relative", "normalize_panel_translation": false,
                       "normalized_edge_loops": true, "units_in_meter": 100}})";
}

ProgramResult check_text(const std::string& text, const std::string& options = "") {
    const ScratchFolder folder;
    std::ofstream(folder / "pattern.json") << text;
    return run_selvedge("check '" + folder / "pattern.json" + "' " + options);
}

TEST(CheckCommand, every_pattern_that_ships_is_clean_even_strictly) {
    int tried = 0;
    for (const auto& entry : std::filesystem::directory_iterator(SELVEDGE_SOURCE_DIR "/patterns")) {
        if (entry.path().extension() != ".json") continue;
        const ProgramResult result = run_selvedge("check --strict '" + entry.path().string() + "'");
        EXPECT_EQ(result.exit_code, 0) << entry.path() << result.out << result.err;
        ++tried;
    }
    EXPECT_GE(tried, 5);
}

TEST(CheckCommand, a_closed_square_passes) {
    const ProgramResult result = check_text(square_pattern(0));
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
}

TEST(CheckCommand, an_open_outline_is_named_with_file_and_place) {
    const ProgramResult result = check_text(square_pattern(1));
    EXPECT_EQ(result.exit_code, 2);
    const std::string said = result.out + result.err;
    EXPECT_NE(said.find("pattern.json"), std::string::npos) << said;
    EXPECT_NE(said.find("pattern.panels.square"), std::string::npos) << said;
}

TEST(CheckCommand, a_tartan_that_dressing_would_refuse_is_a_fault) {
    const auto with_tartan = [](const std::string& tartan) {
        std::string text = square_pattern(0);
        return text.insert(1, R"("selvedge": {"tartan": ")" + tartan + R"("}, )");
    };
    EXPECT_EQ(check_text(with_tartan("gordon")).exit_code, 0);
    for (const char* tartan : {"nosuch", "B24 W4 weft: Q3"}) {
        const ProgramResult result = check_text(with_tartan(tartan));
        EXPECT_EQ(result.exit_code, 2) << tartan;
        EXPECT_EQ(count_lines(result.out), 1) << result.out;
        EXPECT_NE(result.out.find("pattern.json: selvedge.tartan: "), std::string::npos) << result.out;
    }
}

TEST(CheckCommand, text_that_is_no_json_is_a_fault) {
    EXPECT_EQ(check_text("{\"pattern\": ").exit_code, 2);
    EXPECT_EQ(check_text("").exit_code, 2);
    EXPECT_EQ(check_text(std::string(100, '[') + std::string(100, ']')).exit_code, 2);
}

}  // namespace
}  // namespace selvedge::app
