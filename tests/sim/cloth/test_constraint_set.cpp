#include "sim/cloth/constraint_set.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "sim/cloth/saved_states.h"

namespace selvedge::test {
namespace {

using Set = ConstraintSet<StretchBlock, StretchRecord>;
using Corners = std::array<std::uint32_t, 3>;
constexpr std::size_t kSparePoint = 60;

// What a lane is filled with: its corners, and a figure of the triangle's own.
void fill(Set& set, TriangleId t, const Corners& corners, std::uint32_t lane) {
    const std::size_t at = lane % kBlock;
    for (std::size_t k = 0; k < 3; ++k) set.blocks[lane / kBlock].vertices[k][at] = 4 * corners[k];
    set.blocks[lane / kBlock].anchor[at] = set.records[lane / kBlock].of_area[at] = static_cast<float>(t.value);
}

void insert(Set& set, TriangleId t, const Corners& corners) {
    set.insert(t, corners, kSparePoint, [&](std::uint32_t lane) { fill(set, t, corners, lane); });
}

Set empty_set() {
    Set set;
    set.make(
        std::vector<TriangleId>{}, kSparePoint, [](TriangleId t) { return t; }, [](TriangleId) { return Corners{}; },
        [](TriangleId, std::uint32_t) {});
    return set;
}

void expect_holds(const Set& set, TriangleId t, const Corners& corners) {
    const std::uint32_t lane = set.lane_of(t, corners);
    ASSERT_NE(lane, kSpare);
    EXPECT_EQ(lane, set.lane_of(t));
    EXPECT_EQ(set.blocks[lane / kBlock].anchor[lane % kBlock], static_cast<float>(t.value));
    EXPECT_EQ(set.records[lane / kBlock].of_area[lane % kBlock], static_cast<float>(t.value));
}

TEST(ConstraintSet, finds_by_its_triangle_what_was_made_and_inserted_and_not_what_was_removed) {
    std::mt19937 random(8);
    std::map<std::uint32_t, Corners> held;
    const auto among = [&](std::uint32_t least) { return least + static_cast<std::uint32_t>(random() % 20); };
    std::vector<TriangleId> first;
    for (std::uint32_t t = 0; t < 100; ++t) {
        first.emplace_back(3 * t);
        held[3 * t] = {among(0), among(20), among(40)};
    }
    Set set;
    set.make(
        first, kSparePoint, [](TriangleId t) { return t; }, [&](TriangleId t) { return held[t.value]; },
        [&](TriangleId t, std::uint32_t lane) { fill(set, t, held[t.value], lane); });
    std::uint32_t next = 1000;
    for (int i = 0; i < 3000; ++i) {
        if (random() % 2 == 0 && !held.empty()) {
            const auto one = std::next(held.begin(), static_cast<std::ptrdiff_t>(random() % held.size()));
            set.remove(TriangleId(one->first), kSparePoint);
            EXPECT_EQ(set.lane_of(TriangleId(one->first)), kSpare);
            held.erase(one);
        } else {
            held[++next] = {among(0), among(20), among(40)};
            insert(set, TriangleId(next), held[next]);
        }
    }
    for (const auto& [t, corners] : held) expect_holds(set, TriangleId(t), corners);
    std::size_t used = 0;
    for (const StretchBlock& block : set.blocks) {
        for (const std::uint32_t corner : block.vertices[0]) used += corner != 4 * kSparePoint ? 1U : 0U;
    }
    EXPECT_EQ(used, held.size()) << "all others are spare";
    set.forget();
    EXPECT_EQ(set.lane_of(TriangleId(held.begin()->first)), kSpare);
}

TEST(ConstraintSet, does_not_take_another_triangle_of_the_same_id_for_its_own) {
    Set set = empty_set();
    insert(set, TriangleId(5), {1, 21, 41});
    EXPECT_NE(set.lane_of(TriangleId(5), {1, 21, 41}), kSpare);
    EXPECT_EQ(set.lane_of(TriangleId(5), {1, 21, 42}), kSpare);
    EXPECT_EQ(set.lane_of(TriangleId(6), {1, 21, 41}), kSpare);
}

TEST(ConstraintSet, has_each_block_weighed_once_that_was_changed) {
    Set set = empty_set();
    for (std::uint32_t t = 0; t < 40; ++t) insert(set, TriangleId(t), {t, 50, 55});  // each of a colour of its own
    std::size_t weighed = 0;
    const auto count = [&](auto blocks, auto records) {
        EXPECT_EQ(blocks.size(), records.size());
        weighed += blocks.size();
    };
    set.weigh_dirty(count);
    EXPECT_EQ(weighed, 40U);
    set.remove(TriangleId(7), kSparePoint);
    set.weigh_dirty(count);
    EXPECT_EQ(weighed, 41U);
    set.weigh_dirty(count);
    EXPECT_EQ(weighed, 41U);
}

TEST(SavedStates, are_those_of_one_adaption) {
    SavedStates<int> states;
    EXPECT_EQ(states.find(TriangleId(3), 1), nullptr);
    states.save(TriangleId(3), 1, 7);
    states.save(TriangleId(900), 1, 8);
    ASSERT_NE(states.find(TriangleId(3), 1), nullptr);
    EXPECT_EQ(*states.find(TriangleId(3), 1), 7);
    EXPECT_EQ(states.find(TriangleId(3), 2), nullptr);
    EXPECT_EQ(states.find(TriangleId(4), 1), nullptr);
    states.save(TriangleId(3), 1, 9);
    EXPECT_EQ(*states.find(TriangleId(3), 1), 9);
}

}  // namespace
}  // namespace selvedge::test
