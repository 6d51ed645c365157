#include "sim/cloth/constraint_set.h"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <random>

#include "sim/cloth/saved_states.h"

namespace selvedge::test {
namespace {

using Set = ConstraintSet<StretchBlock, StretchRecord>;
using Corners = std::array<std::uint32_t, 3>;
constexpr std::size_t kSparePoint = 60;

// What a slot is filled with: its corners, and a figure of the triangle's own.
void fill(Set& set, TriangleId t, const Corners& corners, std::uint32_t slot) {
    const std::size_t at = slot % kBlock;
    for (std::size_t k = 0; k < 3; ++k) set.blocks[slot / kBlock].vertices[k][at] = 4 * corners[k];
    set.blocks[slot / kBlock].anchor[at] = set.records[slot / kBlock].of_area[at] = static_cast<float>(t.value);
}

void insert(Set& set, TriangleId t, const Corners& corners) {
    set.insert(t, corners, kSparePoint, [&](std::uint32_t slot) { fill(set, t, corners, slot); });
}

Set empty_set() {
    Set set;
    set.make(
        std::vector<TriangleId>{}, kSparePoint, [](TriangleId t) { return t; }, [](TriangleId) { return Corners{}; },
        [](TriangleId, std::uint32_t) {});
    return set;
}

void expect_holds(const Set& set, TriangleId t, const Corners& corners) {
    const std::uint32_t slot = set.slot_of(t, corners);
    ASSERT_NE(slot, kSpare);
    EXPECT_EQ(slot, set.slot_of(t));
    EXPECT_EQ(set.blocks[slot / kBlock].anchor[slot % kBlock], static_cast<float>(t.value));
    EXPECT_EQ(set.records[slot / kBlock].of_area[slot % kBlock], static_cast<float>(t.value));
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
        [&](TriangleId t, std::uint32_t slot) { fill(set, t, held[t.value], slot); });
    std::uint32_t next = 1000;
    std::vector<std::uint32_t> gone;
    for (int i = 0; i < 3000; ++i) {
        if (random() % 2 == 0 && !held.empty()) {
            const auto one = std::next(held.begin(), static_cast<std::ptrdiff_t>(random() % held.size()));
            set.remove(TriangleId(one->first), kSparePoint);
            EXPECT_EQ(set.slot_of(TriangleId(one->first)), kSpare);
            gone.push_back(one->first);
            held.erase(one);
        } else {
            const bool comes_again = !gone.empty() && random() % 2 == 0;
            const std::uint32_t t = comes_again ? gone.back() : ++next;
            if (comes_again) gone.pop_back();
            held[t] = {among(0), among(20), among(40)};
            insert(set, TriangleId(t), held[t]);
        }
    }
    for (const auto& [t, corners] : held) expect_holds(set, TriangleId(t), corners);
    const StretchBlock spare = spare_block<StretchBlock>(kSparePoint);
    const StretchRecord spare_of_records = spare_record<StretchRecord>();
    std::size_t used = 0;
    for (std::size_t slot = 0; slot < set.blocks.size() * kBlock; ++slot) {
        const std::size_t at = slot % kBlock;
        StretchBlock block = set.blocks[slot / kBlock];
        StretchRecord record = set.records[slot / kBlock];
        if (block.vertices[0][at] != 4 * kSparePoint) {
            ++used;
            continue;
        }
        const StretchBlock found = block;
        const StretchRecord found_record = record;
        copy_lane(spare, block, at);
        copy_lane(spare_of_records, record, at);
        EXPECT_EQ(std::memcmp(&block, &found, sizeof block), 0);
        EXPECT_EQ(std::memcmp(&record, &found_record, sizeof record), 0);
    }
    EXPECT_EQ(used, held.size()) << "all others are spare";
    set.forget();
    EXPECT_EQ(set.slot_of(TriangleId(held.begin()->first)), kSpare);
}

TEST(ConstraintSet, does_not_take_another_triangle_of_the_same_id_for_its_own) {
    Set set = empty_set();
    insert(set, TriangleId(5), {1, 21, 41});
    EXPECT_NE(set.slot_of(TriangleId(5), {1, 21, 41}), kSpare);
    EXPECT_EQ(set.slot_of(TriangleId(5), {1, 21, 42}), kSpare);
    EXPECT_EQ(set.slot_of(TriangleId(6), {1, 21, 41}), kSpare);
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
    Set one = empty_set();
    insert(one, TriangleId(1), {1, 2, 3});
    insert(one, TriangleId(2), {4, 5, 6});  // in the same block
    one.remove(TriangleId(1), kSparePoint);
    weighed = 0;
    one.weigh_dirty(count);
    EXPECT_EQ(weighed, 1U);
}

TEST(ConstraintSet, forgets_what_it_had_when_it_is_made_again) {
    Set set = empty_set();
    for (std::uint32_t t = 0; t < 40; ++t) insert(set, TriangleId(t), {t, 50, 55});
    const Corners corners{1, 2, 3};
    set.make(
        std::vector<TriangleId>{TriangleId(3)}, kSparePoint, [](TriangleId t) { return t; },
        [&](TriangleId) { return corners; }, [&](TriangleId t, std::uint32_t slot) { fill(set, t, corners, slot); });
    EXPECT_EQ(set.slot_of(TriangleId(4)), kSpare);
    expect_holds(set, TriangleId(3), corners);
    std::size_t weighed = 0;
    set.weigh_dirty([&](auto blocks, auto) { weighed += blocks.size(); });
    EXPECT_EQ(weighed, 1U);
}

TEST(SavedStates, are_those_of_one_adaptation) {
    SavedStates<int> states;
    EXPECT_EQ(states.find(TriangleId(3), 1), nullptr);
    states.save(TriangleId(3), 1, 7);
    states.save(TriangleId(900), 1, 8);
    ASSERT_NE(states.find(TriangleId(3), 1), nullptr);
    EXPECT_EQ(*states.find(TriangleId(3), 1), 7);
    EXPECT_EQ(states.find(TriangleId(3), 2), nullptr);
    EXPECT_EQ(states.find(TriangleId(4), 1), nullptr);
    EXPECT_EQ(states.find(TriangleId(4), 0), nullptr);
    states.save(TriangleId(3), 1, 9);
    EXPECT_EQ(*states.find(TriangleId(3), 1), 9);
}

}  // namespace
}  // namespace selvedge::test
