// Tables as Markdown, JSON and CSV, and timings.
#include <gtest/gtest.h>

#include "bench/support/table.h"
#include "bench/support/timing.h"

namespace selvedge::bench {
namespace {

Table two_rows() {
    Table table{.name = "3.2", .title = "Clearing", .note = "One thread.", .columns = {"from", "us", "count"}};
    table.add_row({"C1", Cell(0.14553, 3), 4});
    table.add_row({"C2", Cell(), 120});
    return table;
}

TEST(Table, markdown_has_a_heading_a_note_and_numbers_flush_right) {
    EXPECT_EQ(to_markdown(two_rows()),
              "## 3.2: Clearing\n\nOne thread.\n\n"
              "| from |    us | count |\n"
              "|------|------:|------:|\n"
              "| C1   | 0.146 |     4 |\n"
              "| C2   |     - |   120 |\n");
}

TEST(Table, json_keeps_the_digits_that_are_not_printed_and_says_null_where_nothing_is_known) {
    const sim::Json json = to_json(two_rows());
    EXPECT_EQ(json.find("name")->string(), "3.2");
    EXPECT_EQ(json.find("columns")->elements().size(), 3U);
    const std::vector<sim::Json>& rows = json.find("rows")->elements();
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].elements()[0].string(), "C1");
    EXPECT_EQ(rows[0].elements()[1].number(), 0.14553);
    EXPECT_EQ(rows[0].elements()[2].number_text(), "4");
    EXPECT_TRUE(rows[1].elements()[1].is_null());
}

TEST(Thinned, keeps_a_few_rows_the_last_among_them_and_says_so) {
    Table table{.name = "1", .title = "long", .columns = {"i"}};
    for (int i = 0; i < 100; ++i) table.add_row({i});
    const Table part = thinned(table, 24);
    EXPECT_LE(part.rows.size(), 24U);
    EXPECT_GE(part.rows.size(), 20U);
    EXPECT_EQ(part.rows.back()[0].to_text(), "99");
    EXPECT_NE(part.note.find("One row in 5"), std::string::npos) << part.note;
    EXPECT_EQ(thinned(table, 100).rows.size(), 100U);
}

TEST(Timing, is_the_middle_and_the_least_of_the_runs) {
    const Timing timing = timing_of({3, 1, 2, 9, 8});
    EXPECT_EQ(timing.median, 3);
    EXPECT_EQ(timing.least, 1);
    EXPECT_EQ(timing.runs, 5);
}

TEST(Timing, prepares_before_each_run) {
    int prepared = 0;
    int worked = 0;
    const Timing timing = time_runs(
        4, [&] { ++prepared; }, [&] { EXPECT_EQ(++worked, prepared); });
    EXPECT_EQ(worked, 4);
    EXPECT_EQ(timing.runs, 4);
}

TEST(ToCsv, has_a_line_of_names_and_a_line_for_each_row_with_quotes_only_where_needed) {
    Table table{.name = "3.25", .title = "x", .columns = {"time, s", "ms", "what"}};
    table.add_row({Cell(0.25, 2), Cell(1.0 / 3, 3), "say \"so\""});
    table.add_row({Cell(0.5, 2), Cell(), 7});
    EXPECT_EQ(to_csv(table), "\"time, s\",ms,what\n0.25,0.333,\"say \"\"so\"\"\"\n0.50,,7\n");
}

}  // namespace

}  // namespace selvedge::bench
