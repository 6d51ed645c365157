// selvedge print: pages of true size, files that import reads back, and wrong options refused on one line.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "sim/core/file.h"
#include "sim/core/file_path.h"
#include "sim/core/json.h"
#include "sim/pattern/pattern_file.h"
#include "tests/app/selvedge_program.h"

namespace selvedge::app {
namespace {

TEST(PrintCommand, test_square_has_sides_of_ten_centimetres_in_the_pdfs_own_coordinates) {
    const ScratchFolder folder;
    const std::string file = folder / "tshirt.pdf";
    const ProgramResult printed = run_selvedge("print " + shipped("tshirt.json") + " -o '" + file + "' --allowance 10");
    ASSERT_EQ(printed.exit_code, 0) << printed.err;
    EXPECT_NE(printed.out.find("pages, "), std::string::npos) << printed.out;
    EXPECT_EQ(printed.err, "");
    const ProgramResult measured =
        run_command("python3 -B '" + source_folder() + "/tests/app/pdf_rectangles.py' '" + file + "'");
    ASSERT_EQ(measured.exit_code, 0) << measured.err;
    double width = 0, height = 0;
    std::istringstream(measured.out) >> width >> height;
    EXPECT_NEAR(width, 100, 0.01) << measured.out;
    EXPECT_NEAR(height, 100, 0.01) << measured.out;
}

TEST(PrintCommand, svg_and_dxf_come_back_by_import_with_all_seams) {
    const sim::Pattern original = sim::load_pattern(source_folder() + "/patterns/tshirt.json").pattern;
    const ScratchFolder folder;
    for (const char* name : {"t.svg", "t.dxf"}) {
        const std::string file = folder / name, garment = folder / "garment.json";
        ASSERT_EQ(run_selvedge("print " + shipped("tshirt.json") + " -o '" + file + "' --allowance 10").exit_code, 0);
        const ProgramResult imported = run_selvedge("import '" + file + "' -o '" + garment + "'");
        ASSERT_EQ(imported.exit_code, 0) << imported.err;
        const sim::Pattern pattern = sim::load_pattern(garment).pattern;
        EXPECT_EQ(pattern.panels.size(), original.panels.size()) << name;
        EXPECT_EQ(pattern.seams.size(), original.seams.size()) << name;
    }
}

TEST(PrintCommand, cutting_layout_says_how_much_fabric_it_takes) {
    const ScratchFolder folder;
    for (const char* name : {"layout.pdf", "layout.svg"}) {
        const std::string file = folder / name;
        const ProgramResult result =
            run_selvedge("print " + shipped("skirt.json") + " -o '" + file + "' --layout --fabric-width 140");
        ASSERT_EQ(result.exit_code, 0) << result.err;
        EXPECT_NE(result.out.find(" m of "), std::string::npos) << result.out;
        EXPECT_NE(result.out.find("140 cm wide"), std::string::npos) << result.out;
    }
}

TEST(PrintCommand, tells_warnings_as_match_does_when_the_file_has_unknown_keys) {
    const ScratchFolder folder;
    sim::Json garment = sim::read_json(source_folder() + "/patterns/two_squares.json");
    garment["pattern"]["panels"]["back"]["selvedge"]["grainlin"] = sim::Json(0.0);
    const std::string file = folder / "odd.json";
    sim::write_file_atomically(file, write_json(garment));
    const std::string note =
        "selvedge: note: " + file + ": pattern.panels.back.selvedge.grainlin: warning: unknown key";
    const ProgramResult printed = run_selvedge("print '" + file + "' -o '" + folder / "odd.svg" + "'");
    EXPECT_EQ(printed.exit_code, 0);
    EXPECT_NE(printed.err.find(note), std::string::npos) << printed.err;
    const ProgramResult matched = run_selvedge("match --dry-run '" + file + "'");
    EXPECT_EQ(matched.exit_code, 0);
    EXPECT_NE(matched.err.find(note), std::string::npos) << matched.err;
}

TEST(PrintCommand, a_name_of_a_million_letters_is_printed_in_part) {
    const ScratchFolder folder;
    const std::string garment = folder / "long.json", file = folder / "long.pdf";
    sim::write_file_atomically(garment, R"({"pattern": {"panels": {")" + std::string(1000000, 'n') +
                                            R"(": {"vertices": [[0, 0], [40, 0], [40, 40], [0, 40]], "edges": [
            {"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, 0]}]}},
            "stitches": []}})");
    const ProgramResult result =
        run_command("ulimit -t 20; " + program() + " print '" + garment + "' -o '" + file + "'");
    EXPECT_EQ(result.exit_code, 0) << result.err.substr(0, 1000);
    EXPECT_LT(std::filesystem::file_size(file), 1000000U);
}

TEST(PrintCommand, refuses_a_date_that_is_no_number) {
    const ScratchFolder folder;
    const std::string file = folder / "t.dxf";
    const std::string print = " " + program() + " print " + shipped("two_squares.json") + " -o '" + file + "'";
    for (const char* wrong : {"''", "today", "12x", "-1", "99999999999999999999"}) {
        const ProgramResult result = run_command("SOURCE_DATE_EPOCH=" + std::string(wrong) + print);
        EXPECT_EQ(result.exit_code, 2) << wrong;
        EXPECT_EQ(result.err.rfind("selvedge: SOURCE_DATE_EPOCH: '", 0), 0U) << result.err;
        EXPECT_FALSE(sim::file_exists(file)) << wrong;
    }
    EXPECT_EQ(run_command("SOURCE_DATE_EPOCH=0" + print).exit_code, 0);
    EXPECT_NE(sim::read_file(file, 1U << 20).find("01-01-1970"), std::string::npos);
}

TEST(PrintCommand, more_pages_than_can_be_glued_are_refused_in_a_moment) {
    const ScratchFolder folder;
    const std::string garment = folder / "many.json", file = folder / "many.pdf";
    std::string panels;
    for (int i = 0; i < 2000; ++i) {
        panels += (panels.empty() ? "" : ",") + ("\"p" + std::to_string(i)) +
                  R"(": {"vertices": [[0, 0], [40, 0], [40, 40], [0, 40]], "edges": [
            {"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, 0]}]})";
    }
    sim::write_file_atomically(garment, R"({"pattern": {"panels": {)" + panels + R"(}, "stitches": []}})");
    const ProgramResult result =
        run_command("ulimit -t 20; " + program() + " print '" + garment + "' -o '" + file + "'");
    EXPECT_EQ(result.exit_code, 2) << result.err.substr(0, 1000);
    EXPECT_NE(result.err.find("pages: at most 400"), std::string::npos) << result.err;
}

TEST(PrintCommand, refuses_wrong_input_on_one_line_and_writes_nothing) {
    const ScratchFolder folder;
    const std::string file = folder / "t.pdf", drawn = folder / "t.png", garment = shipped("tshirt.json");
    const std::string dxf = folder / "t.dxf", svg = folder / "t.svg";
    for (const std::string& arguments :
         {garment + " -o '" + file + "' --paper a9", garment + " -o '" + file + "' --layers cut,sews",
          garment + " -o '" + drawn + "'", garment + " -o '" + file + "' --layout --fabric-width 30",
          garment + " -o '" + dxf + "' --layout", garment + " -o '" + dxf + "' --layers cut",
          garment + " -o '" + dxf + "' --on-fold", garment + " -o '" + svg + "' --on-fold",
          garment + " -o '" + svg + "' --one-page", garment + " -o '" + svg + "' --astm",
          garment + " -o '" + file + "' --folded", garment + " -o '" + file + "' --layout --on-fold",
          "missing.json -o '" + file + "'"}) {
        const ProgramResult result = run_selvedge("print " + arguments);
        EXPECT_EQ(result.exit_code, 2) << arguments;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n') - (result.err.find("note:") < 200 ? 1 : 0), 1)
            << result.err;
        EXPECT_FALSE(std::filesystem::exists(file));
        EXPECT_FALSE(std::filesystem::exists(dxf) || std::filesystem::exists(svg));
    }
}

}  // namespace
}  // namespace selvedge::app
