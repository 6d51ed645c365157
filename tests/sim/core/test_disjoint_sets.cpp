#include "sim/core/disjoint_sets.h"

#include <gtest/gtest.h>

namespace selvedge::sim {
namespace {

TEST(DisjointSets, have_their_lowest_member_as_representative_whatever_the_order) {
    DisjointSets sets(6);
    sets.join(5, 3);
    sets.join(4, 5);
    sets.join(1, 4);
    for (const int member : {1, 3, 4, 5}) EXPECT_EQ(sets.find(member), 1);
    EXPECT_EQ(sets.find(0), 0);
    EXPECT_EQ(sets.find(2), 2);
}

}  // namespace
}  // namespace selvedge::sim
