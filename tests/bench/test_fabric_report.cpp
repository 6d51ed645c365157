// What the fabric experiment asks of whom, and its table.
#include "bench/fabric/report.h"

#include <gtest/gtest.h>

#include "sim/core/error.h"

namespace selvedge {
namespace {

TEST(FabricReport, asks_more_of_finer_levels) {
    EXPECT_LT(allowed_error({.level = 0}), 0);
    EXPECT_EQ(allowed_error({.level = 1}), 0.1);
    EXPECT_EQ(allowed_error({.level = 2}), 0.05);
    EXPECT_EQ(allowed_error({.level = 3, .is_adaptive = true}), 0.05);
}

TEST(FabricReport, covers_all_levels_and_angles_unless_it_is_quick) {
    EXPECT_EQ(level_settings({}).size(), 5U);
    EXPECT_EQ(mesh_angles({}).size(), 3U);
    EXPECT_EQ(level_settings({.is_quick = true}).size(), 2U);
    EXPECT_EQ(mesh_angles({.is_quick = true}).size(), 1U);
}

TEST(FabricReport, knows_the_published_ranges_of_the_shipped_fabrics) {
    for (const std::string& name : fabric_names()) {
        EXPECT_GT(published_drape(name).low, 0) << name;
        EXPECT_GT(published_drape(name).high, published_drape(name).low) << name;
    }
    EXPECT_EQ(published_drape("sackcloth").high, 0);
}

TEST(FabricReport, gives_each_row_its_expected_value_error_gate_and_verdict) {
    const FabricTables made = measure_fabrics("cantilever", {.fabrics = {"silk"}, .is_quick = true});
    ASSERT_EQ(made.tables.size(), 1U);
    const std::vector<std::string> columns{"fabric", "direction",      "level",   "expected",
                                           "17 deg", "worst error, %", "gate, %", "verdict"};
    EXPECT_EQ(made.tables[0].columns, columns);
    EXPECT_EQ(made.tables[0].rows.size(), 4U);
    EXPECT_EQ(made.rows, 4);
    EXPECT_LE(made.missed, made.rows);
}

TEST(FabricReport, names_a_fabric_that_it_does_not_know) {
    EXPECT_THROW(measure_fabrics("energy", {.fabrics = {"sackcloth"}}), InputError);
}

}  // namespace
}  // namespace selvedge
