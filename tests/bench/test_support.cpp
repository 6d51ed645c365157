// Tables as Markdown, JSON and CSV, and timings.
#include <gtest/gtest.h>
#include <cmath>
#include <limits>
#include <numbers>

#include "bench/support/cloth_run.h"
#include "bench/support/measured_mesh.h"
#include "bench/support/table.h"
#include "sim/mesh/square.h"

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

// The measurements of measured_mesh.h, on hand-made positions.

namespace {

constexpr int kQuads = 10;

sim::GarmentMesh grid() {
    return sim::make_square({.columns = kQuads, .rows = kQuads});
}

template <class Move>
std::vector<Vec3d> moved(const sim::GarmentMesh& mesh, Move&& move) {
    std::vector<Vec3d> x;
    for (const Vec3d& p : mesh.x) x.push_back(move(p));
    return x;
}

TEST(MeasuredMesh, takes_grid_edges_for_threads_and_leaves_diagonals_out) {
    const MeasuredMesh mesh = measured(grid());
    EXPECT_EQ(mesh.yarn_edges.size(), 2U * kQuads * (kQuads + 1));
    EXPECT_EQ(mesh.triangles.size(), 2U * kQuads * kQuads);
    EXPECT_EQ(mesh.vertices.size(), std::size_t((kQuads + 1) * (kQuads + 1)));
    EXPECT_NEAR(mesh.rest_area, 1, 1e-12);
    for (const YarnEdge& edge : mesh.yarn_edges) EXPECT_NEAR(edge.rest_length, 1.0 / kQuads, 1e-12);
}

TEST(MeasuredMesh, takes_diagonals_for_threads_where_the_grain_lies_at_45_degrees) {
    sim::GarmentMesh bias = grid();
    bias.panel_grain_angles = {std::numbers::pi / 4};
    EXPECT_EQ(measured(bias).yarn_edges.size(), std::size_t(kQuads * kQuads));
}

TEST(MeasuredMesh, cloth_stretched_by_3_percent_one_way_has_a_p99_of_3_percent) {
    const sim::GarmentMesh square = grid();
    const MeasuredMesh mesh = measured(square);
    const std::vector<Vec3d> x = moved(square, [](const Vec3d& p) { return Vec3d(1.03 * p.x(), p.y(), p.z()); });
    const YarnStretch stretch = yarn_stretch(mesh, x);
    EXPECT_NEAR(stretch.p99, 0.03, 1e-12);
    EXPECT_NEAR(stretch.max, 0.03, 1e-12);
    EXPECT_NEAR(stretch.p1, 0, 1e-12);
    EXPECT_NEAR(area_ratio(mesh, x), 1.03, 1e-12);
}

TEST(MeasuredMesh, compression_shows_in_the_first_percentile_and_the_area) {
    const sim::GarmentMesh square = grid();
    const MeasuredMesh mesh = measured(square);
    const std::vector<Vec3d> x = moved(square, [](const Vec3d& p) { return Vec3d(p.x(), p.y(), 0.9 * p.z()); });
    EXPECT_NEAR(yarn_stretch(mesh, x).p1, -0.1, 1e-12);
    EXPECT_NEAR(yarn_stretch(mesh, x).p99, 0, 1e-12);
    EXPECT_NEAR(area_ratio(mesh, x), 0.9, 1e-12);
}

TEST(MeasuredMesh, shear_stretches_no_thread) {
    const sim::GarmentMesh square = grid();
    const MeasuredMesh mesh = measured(square);
    const double angle = 0.3;
    const std::vector<Vec3d> x = moved(
        square, [&](const Vec3d& p) { return Vec3d(p.x() + std::sin(angle) * p.z(), 0, std::cos(angle) * p.z()); });
    EXPECT_NEAR(yarn_stretch(mesh, x).max, 0, 1e-12);
    EXPECT_NEAR(yarn_stretch(mesh, x).p1, 0, 1e-12);
    EXPECT_NEAR(area_ratio(mesh, x), std::cos(angle), 1e-12);
}

TEST(MeasuredMesh, tells_numbers_that_are_none) {
    const sim::GarmentMesh square = grid();
    const MeasuredMesh mesh = measured(square);
    std::vector<Vec3d> x = square.x;
    EXPECT_TRUE(all_finite(mesh, x));
    x[5].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(all_finite(mesh, x));
}

TEST(MeasuredMesh, a_shift_is_its_own_mean_and_rms_distance) {
    const sim::GarmentMesh square = grid();
    const std::vector<Vec3d> x = moved(square, [](const Vec3d& p) { return Vec3d(p + Vec3d(0.003, 0, 0.004)); });
    const ShapeDistance distance = shape_distance(measured(square), square.x, x);
    EXPECT_NEAR(distance.mean, 0.005, 1e-12);
    EXPECT_NEAR(distance.rms, 0.005, 1e-12);
}

}  // namespace

}  // namespace selvedge::bench
