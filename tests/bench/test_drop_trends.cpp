// Whether drops show what the thesis reports of them, judged from tables of known numbers.
#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "bench/thesis/drop_trends.h"
#include "bench/thesis/thesis.h"

namespace selvedge::bench {
namespace {

// A table of uniform drops in which each cloth takes these times, ms, at levels 0 to 3.
Table uniform_table(const std::array<double, 4>& selvedge, const std::array<double, 4>& others) {
    Table table{.name = "3.12",
                .title = "",
                .columns = {"cloth", "level", "collision, ms", "total update, ms", "total update CPU, ms"}};
    for (const char* cloth : {"selvedge", "vertices only", "mass-spring"}) {
        for (int level = 0; level < 4; ++level) {
            const double ms = (cloth[0] == 's' ? selvedge : others)[static_cast<std::size_t>(level)];
            table.add_row({cloth, level, Cell(ms / 2, 2), Cell(ms, 2), Cell(ms, 2)});
        }
    }
    return table;
}

TEST(DropTrends, of_uniform_levels_agree_only_if_each_level_of_each_cloth_costs_more_and_else_say_why) {
    ThesisResult result{.tables = {uniform_table({1, 2, 3, 4}, {1, 2, 3, 4})}};
    ASSERT_EQ(drop_trends(result).size(), 1U);
    EXPECT_TRUE(drop_trends(result).front().agrees);
    EXPECT_EQ(drop_trends(result).front().measured.find("contact points"), std::string::npos);
    result.tables = {uniform_table({20, 16, 8, 4}, {1, 2, 3, 4})};
    EXPECT_FALSE(drop_trends(result).front().agrees);
    EXPECT_NE(drop_trends(result).front().measured.find("20.00, 16.00, 8.00, 4.00"), std::string::npos);
    EXPECT_NE(drop_trends(result).front().measured.find("contact points"), std::string::npos);
    result.tables = {uniform_table({1, 2, 3, 4}, {1, 3, 2, 4})};
    EXPECT_FALSE(drop_trends(result).front().agrees);
}

// A table of adaptive drops on both objects with these bends, 1/m.
Table adaptive_table(double a_with_c, double b_with_c) {
    Table table{.name = "3.14",
                .title = "",
                .columns = {"object", "cloth", "criteria", "triangles, mean", "share of uniform", "bend, 1/m"}};
    for (const char* object : {"sphere", "cylinder"}) {
        const auto add = [&](const char* criteria, int triangles, double bend) {
            table.add_row({object, "selvedge", criteria, triangles, Cell(0.5, 2), Cell(bend, 2)});
        };
        add("uniform", 2048, 20);
        add("A", 400, 10);
        add("B", 900, 16);
        add("C", 200, 10);
        add("A+B", 1000, 16);
        add("A+C", 600, a_with_c);
        add("B+C", 950, b_with_c);
        add("A+B+C", 1100, b_with_c);
    }
    return table;
}

TEST(DropTrends, of_wrinkles_agree_only_if_length_adds_them_beside_each_criterion) {
    const auto wrinkles = [](double a_with_c, double b_with_c) {
        const std::vector<Trend> trends = drop_trends({.tables = {adaptive_table(a_with_c, b_with_c)}});
        return *std::ranges::find(trends, "F3.24", &Trend::item);
    };
    EXPECT_TRUE(wrinkles(13, 17).agrees);
    EXPECT_FALSE(wrinkles(13, 16.1).agrees) << "chance";
    EXPECT_NE(wrinkles(13, 16.1).measured.find("13.00 per m with A+C (A 10.00), 16.10 per m with B+C (B 16.00)"),
              std::string::npos);
    EXPECT_NE(wrinkles(13, 16.1).measured.find("B has split them already"), std::string::npos);
    EXPECT_EQ(wrinkles(13, 17).measured.find("B has split them already"), std::string::npos);
}

TEST(DropTrends, of_steps_ask_that_cloth_refined_by_collision_alone_is_coarse_again_at_the_end) {
    const auto agrees = [](const char* criteria, std::vector<int> triangles) {
        Figure figure;
        figure.series = {.name = "3.25", .title = std::string("Cylinder ") + criteria, .columns = {"triangles"}};
        for (const int count : triangles) figure.series.add_row({count});
        return drop_trends({.figures = {figure}}).at(0).agrees;
    };
    EXPECT_TRUE(agrees("[A]", {32, 300, 32}));
    EXPECT_FALSE(agrees("[A]", {32, 300, 200}));
    EXPECT_TRUE(agrees("[B]", {32, 300, 300}));
    EXPECT_FALSE(agrees("[B]", {32, 32, 32}));
}

}  // namespace
}  // namespace selvedge::bench
