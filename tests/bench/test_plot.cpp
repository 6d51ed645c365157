#include "bench/plot.h"

#include <gtest/gtest.h>

namespace selvedge {
namespace {

TEST(ToCsv, has_a_line_of_names_and_a_line_for_each_row_with_quotes_only_where_needed) {
    Table table{.name = "3.25", .title = "x", .columns = {"time, s", "ms", "what"}};
    table.add_row({Cell(0.25, 2), Cell(1.0 / 3, 3), "say \"so\""});
    table.add_row({Cell(0.5, 2), Cell(), 7});
    EXPECT_EQ(to_csv(table), "\"time, s\",ms,what\n0.25,0.333,\"say \"\"so\"\"\"\n0.50,,7\n");
}

}  // namespace
}  // namespace selvedge
