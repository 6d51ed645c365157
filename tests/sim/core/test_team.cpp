// Members of a team wait for each other, and divide what there is without gap or overlap.
#include "sim/core/team.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "sim/core/parallel.h"

namespace selvedge::test {
namespace {

TEST(Team, parts_of_its_members_cover_all_once_and_begin_at_whole_grains) {
    for (const int threads : {1, 2, 3}) {
        Team team(threads);
        for (const std::size_t size : {0U, 1U, 15U, 16U, 100U, 1000U}) {
            std::vector<int> seen(size, 0);
            team.run([&](TeamMember& member) {
                const auto [begin, end] = member.part_of(size, 16);
                EXPECT_TRUE(begin % 16 == 0 || begin == size);
                for (std::size_t i = begin; i < end; ++i) ++seen[i];
            });
            EXPECT_EQ(seen, std::vector<int>(size, 1));
        }
    }
}

// Each round reads what the other has written in the one before.
TEST(Team, what_is_written_before_waiting_is_seen_after_it) {
    constexpr std::size_t kRounds = 20000;
    Team team(2);
    std::vector<std::size_t> counts(2, 0);
    std::vector<std::size_t> late(2, 0);
    team.run([&](TeamMember& member) {
        for (std::size_t round = 1; round <= kRounds; ++round) {
            counts[member.index()] = round;
            member.wait();
            late[member.index()] += counts[1 - member.index()] == round ? 0 : 1;
            member.wait();
        }
    });
    EXPECT_EQ(counts, std::vector<std::size_t>(2, kRounds));
    EXPECT_EQ(late, std::vector<std::size_t>(2, 0));
}

TEST(Team, works_again_and_again_also_after_a_rest) {
    Team team(2);
    std::vector<int> runs(2, 0);
    for (int i = 0; i < 500; ++i) team.run([&](TeamMember& member) { ++runs[member.index()]; });
    EXPECT_EQ(runs, std::vector<int>(2, 500));
}

TEST(RunOnTeam, has_no_more_members_than_parallel_loops_have_threads) {
    const ThreadLimit limit(1);
    std::size_t members = 0;
    run_on_team(8, [&](TeamMember& member) { members = member.count(); });
    EXPECT_EQ(members, 1U);
}

TEST(RunOnTeam, lets_one_who_comes_while_it_works_work_alone) {
    std::size_t inner = 0;
    run_on_team(8, [&](TeamMember& outer) {
        if (outer.is_first()) run_on_team(8, [&](TeamMember& member) { inner = member.count(); });
    });
    EXPECT_EQ(inner, 1U);
}

}  // namespace
}  // namespace selvedge::test
