// Lines that meet end to end become closed chains.
#include "sim/paper/closed_chains.h"

#include <gtest/gtest.h>

namespace selvedge::sim {
namespace {

using Line = std::vector<Vec2d>;

// The sides of a square of 1, each a line, from a corner.
std::vector<Line> square_at(const Vec2d& corner) {
    const Vec2d b = corner + Vec2d(1, 0), c = corner + Vec2d(1, 1), d = corner + Vec2d(0, 1);
    return {{corner, b}, {b, c}, {c, d}, {d, corner}};
}

TEST(ClosedChains, join_lines_in_either_direction_within_the_gap) {
    std::vector<Line> lines = square_at({0, 0});
    std::swap(lines[1].front(), lines[1].back());
    lines[2].front() += Vec2d(0.004, 0);
    const ClosedChains found = find_closed_chains(lines, {.gap = 0.005});
    ASSERT_EQ(found.chains.size(), 1U);
    EXPECT_EQ(found.chains[0].size(), 4U);
    EXPECT_NEAR(found.widest_gap, 0.004, 1e-12);
    int reversed = 0;
    for (const ChainLink& link : found.chains[0]) reversed += link.is_reversed ? 1 : 0;
    EXPECT_EQ(reversed, 1);
    EXPECT_TRUE(find_closed_chains(lines, {.gap = 0.003}).chains.empty());
}

TEST(ClosedChains, take_a_line_that_is_drawn_twice_once) {
    std::vector<Line> lines = square_at({0, 0});
    lines.push_back({lines[0].back(), Vec2d(0.5, 0), lines[0].front()});
    const ClosedChains found = find_closed_chains(lines, {.gap = 1e-3});
    ASSERT_EQ(found.chains.size(), 1U);
    EXPECT_EQ(found.chains[0].size(), 4U);
    EXPECT_EQ(found.repeated, std::vector<std::size_t>{4});
}

TEST(ClosedChains, leave_out_lines_that_end_at_nothing) {
    std::vector<Line> lines = square_at({0, 0});
    lines.push_back({Vec2d(1, 1), Vec2d(2, 2)});
    lines.push_back({Vec2d(2, 2), Vec2d(3, 2)});
    const ClosedChains found = find_closed_chains(lines, {.gap = 1e-3});
    ASSERT_EQ(found.chains.size(), 1U);
    EXPECT_EQ(found.chains[0].size(), 4U);
}

TEST(ClosedChains, are_one_outline_or_two_pieces_that_share_a_line) {
    std::vector<Line> lines = square_at({0, 0});
    for (const Line& line : square_at({1, 0})) lines.push_back(line);
    const ClosedChains pieces = find_closed_chains(lines, {.gap = 1e-3, .branches = Branches::Faces});
    EXPECT_EQ(pieces.chains.size(), 2U);
    EXPECT_EQ(pieces.shared, 1);
    const ClosedChains outer = find_closed_chains(lines, {.gap = 1e-3, .branches = Branches::Outer});
    ASSERT_EQ(outer.chains.size(), 1U);
    EXPECT_EQ(outer.chains[0].size(), 6U);
}

TEST(ClosedChains, give_a_dart_whose_mouth_is_drawn_to_its_piece) {
    // A square whose lower side has a dart: three lines of it, and two legs that meet within.
    std::vector<Line> lines = square_at({0, 0});
    lines.erase(lines.begin());
    const Vec2d a(0.45, 0), b(0.55, 0), tip(0.5, 0.3);
    for (const Line& line : {Line{{0, 0}, a}, Line{a, b}, Line{b, {1, 0}}, Line{a, tip}, Line{tip, b}})
        lines.push_back(line);
    const ClosedChains found = find_closed_chains(lines, {.gap = 1e-3, .branches = Branches::Faces});
    ASSERT_EQ(found.chains.size(), 1U);
    EXPECT_EQ(found.chains[0].size(), 6U);
}

TEST(ClosedChains, are_none_of_a_hatching) {
    std::vector<Line> lines;
    for (int i = 0; i < 20; ++i) {
        for (int k = 0; k < 19; ++k) {
            lines.push_back({Vec2d(i, k), Vec2d(i, k + 1)});
            lines.push_back({Vec2d(k, i), Vec2d(k + 1, i)});
        }
    }
    EXPECT_TRUE(find_closed_chains(lines, {.gap = 1e-3, .branches = Branches::Faces}).chains.empty());
}

TEST(ClosedChains, join_relatives_before_strangers) {
    // Two squares upon each other, whose corners are the same: a key tells their lines apart.
    std::vector<KeyedLine> lines;
    for (const Line& line : square_at({0, 0})) lines.push_back({line, {"black"}});
    lines.push_back({{Vec2d(0, 0), Vec2d(0.5, -1), Vec2d(1, 0)}, {"red"}});
    lines.push_back({{Vec2d(0, 0), Vec2d(0.5, -2), Vec2d(1, 0)}, {"red"}});
    const ClosedChains found = join_in_passes(lines, 1e-3, {Branches::Outer, Branches::Outer});
    ASSERT_EQ(found.chains.size(), 2U);
    EXPECT_EQ(found.chains[0].size() + found.chains[1].size(), 6U);
}

TEST(CutLines, end_where_the_end_of_another_lies_on_them) {
    const CutLines cut = cut_where_they_meet({{Vec2d(0, 0), Vec2d(3, 0)}, {Vec2d(1, 0), Vec2d(1, 1)}}, 1e-3);
    ASSERT_EQ(cut.lines.size(), 3U);
    EXPECT_EQ(cut.origin, (std::vector<std::size_t>{0, 0, 1}));
    EXPECT_EQ(cut.lines[0].back(), Vec2d(1, 0));
    EXPECT_EQ(cut.lines[1].front(), Vec2d(1, 0));
}

TEST(CutLines, end_where_another_crosses_them) {
    const CutLines cut = cut_where_they_meet({{Vec2d(0, 0), Vec2d(3, 0)}, {Vec2d(1, -1), Vec2d(1, 1)}}, 1e-3);
    ASSERT_EQ(cut.lines.size(), 4U);
    EXPECT_EQ(cut.origin, (std::vector<std::size_t>{0, 0, 1, 1}));
    for (const std::size_t second : {1U, 3U}) EXPECT_EQ(cut.lines[second].front(), Vec2d(1, 0));
}

}  // namespace
}  // namespace selvedge::sim
