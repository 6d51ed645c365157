// selvedge bench, as a black box.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "sim/core/json.h"
#include "tests/app/selvedge_program.h"

namespace selvedge::app {
namespace {

TEST(BenchCommand, prints_the_table_that_is_asked_for_and_keeps_it_as_json) {
    const ScratchFolder folder;
    const ProgramResult result = run_selvedge("bench thesis --quick --table 3.11 --json '" + folder / "t.json" + "'");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out.rfind("## 3.11: ", 0), 0U) << result.out;
    EXPECT_EQ(result.out.find("## 3.6"), std::string::npos);
    const sim::Json json = sim::read_json(folder / "t.json");
    ASSERT_EQ(json.find("tables")->elements().size(), 1U);
    const sim::Json& table = json.find("tables")->elements()[0];
    EXPECT_EQ(table.find("name")->string(), "3.11");
    for (const sim::Json& row : table.find("rows")->elements())
        EXPECT_EQ(row.elements().size(), table.find("columns")->elements().size());
}

TEST(BenchCommand, writes_a_series_as_csv_and_says_on_one_line_that_it_cannot_draw_it) {
    const ScratchFolder folder;
    const ProgramResult result =
        run_command("PATH=/nowhere '" SELVEDGE_PROGRAM "' bench thesis --quick --figure 3.21 3.22 --out '" +
                    folder / "figures" + "'");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(content_of(folder / "figures/figure-3.21.csv").rfind("base triangles,", 0), 0U);
    const std::string line = "no plots: ";
    EXPECT_NE(result.out.find(line), std::string::npos) << result.out;
    EXPECT_EQ(result.out.find(line), result.out.rfind(line)) << "once is enough";
    EXPECT_FALSE(std::filesystem::exists(folder / "figures/figure-3.21.png"));
}

TEST(BenchCommand, a_picture_is_measured_for_every_kind_of_change) {
    const ScratchFolder folder;
    const std::string sheet = folder / "sheet.obj";
    std::ofstream(sheet) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
    const ProgramResult result = run_selvedge("bench picture '" + sheet + "' --side 64 --pictures 1 --triangles 30 " +
                                              "--json '" + folder / "picture.json" + "'");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const sim::Json json = sim::read_json(folder / "picture.json");
    const sim::Json& table = json.find("tables")->elements()[0];
    EXPECT_NE(table.find("note")->string().find("cloth of 32 triangles"), std::string::npos);
    ASSERT_EQ(table.find("rows")->elements().size(), 7U);
    for (const sim::Json& row : table.find("rows")->elements()) EXPECT_GT(row.elements()[1].number(), 0);
}

TEST(BenchCommand, a_table_that_is_not_there_gets_one_line_with_those_that_are) {
    for (const char* arguments : {"bench thesis --table 9.9", "bench thesis --figure 3.1"}) {
        const ProgramResult result = run_selvedge(arguments);
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_EQ(count_lines(result.err), 1) << result.err;
        EXPECT_NE(result.err.find("3.2"), std::string::npos) << result.err;
        EXPECT_EQ(result.out, "");
    }
}

}  // namespace
}  // namespace selvedge::app
