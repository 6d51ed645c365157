// Gains that follow the masses: what an adaptation leaves as it was keeps its gains to the bit.
#include "sim/cloth/effective_masses.h"

#include <gtest/gtest.h>

#include <cstring>

#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/step.h"
#include "tests/sim/cloth/fixtures.h"

namespace selvedge::test {
namespace {

template <class Block>
bool are_same_bytes(const std::vector<Block>& a, const std::vector<Block>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Block)) == 0);
}

template <class Set>
void expect_same_set(const Set& a, const Set& b) {
    EXPECT_TRUE(are_same_bytes(a.blocks, b.blocks));
    EXPECT_TRUE(are_same_bytes(a.records, b.records));
}

void expect_same_blocks(const Constraints& a, const Constraints& b) {
    expect_same_set(a.stretch, b.stretch);
    expect_same_set(a.bend, b.bend);
    ASSERT_EQ(a.parents.size(), b.parents.size());
    for (std::size_t level = 0; level < a.parents.size(); ++level) {
        SCOPED_TRACE(level);
        expect_same_set(a.parents[level].limits, b.parents[level].limits);
        expect_same_set(a.parents[level].bend, b.parents[level].bend);
    }
}

void mark_all_dirty(Constraints& constraints) {
    const auto mark_all = [](auto& set) { set.dirty.mark_all(set.blocks.size()); };
    mark_all(constraints.stretch);
    mark_all(constraints.bend);
    for (ParentLevel& level : constraints.parents) {
        mark_all(level.limits);
        mark_all(level.bend);
    }
}

// Adapts where the cloth is shaken; returns how many adaptations changed the blocks in place.
int adapt_and_compare(Cloth& cloth, float strength, std::mt19937& random) {
    int in_place = 0;
    for (int i = 0; i < 40; ++i) {
        shake(cloth, strength, random);
        const std::size_t inserted = cloth.solver.lists.inserted;
        if (!adapt_cloth(cloth, nothing_near(), {.shortest_edge = 0}).changed()) continue;
        in_place += cloth.solver.lists.inserted > inserted ? 1 : 0;
        Cloth anew = cloth;
        mark_all_dirty(anew.solver.constraints);
        update_effective_masses(anew);
        expect_same_blocks(cloth.solver.constraints, anew.solver.constraints);
        if (::testing::Test::HasFailure()) return in_place;
        for (int k = 0; k < 2; ++k) step(cloth, nothing_near(), {.contact = {.floor = kNoFloor}});
    }
    return in_place;
}

TEST(EffectiveMasses, of_what_changed_alone_are_those_of_all_worked_out_anew) {
    for (const char* fabric : {"denim", "silk", "wool_twill"}) {
        SCOPED_TRACE(fabric);
        std::mt19937 random(11);
        Cloth cloth = make_patch(find_fabric(fabric), {.side = 0.4});
        cloth.is_pinned[3] = true;
        refresh_solver(cloth);
        refresh_contacts(cloth);
        const int of_many = adapt_and_compare(cloth, 0.004F, random);
        const int of_few = adapt_and_compare(cloth, 0.001F, random);
        EXPECT_GT(of_many + of_few, 5);
    }
}

TEST(EffectiveMasses, of_few_changes_leave_most_blocks_alone) {
    std::mt19937 random(11);
    Cloth cloth = make_patch(find_fabric("denim"), {.side = 0.4});
    refresh_solver(cloth);
    refresh_contacts(cloth);
    for (int i = 0; i < 6; ++i) {
        shake(cloth, 0.004F, random);
        adapt_cloth(cloth, nothing_near(), {.shortest_edge = 0});
    }
    // A block that nothing marks keeps what stands in it.
    for (StretchBlock& block : cloth.solver.constraints.stretch.blocks) block.warp.fill(-1);
    update_effective_masses(cloth);
    for (const StretchBlock& block : cloth.solver.constraints.stretch.blocks) EXPECT_EQ(block.warp[0], -1);
}

}  // namespace
}  // namespace selvedge::test
