// The search for the least number of sub-steps that passes.
#include <gtest/gtest.h>

#include <algorithm>

#include "bench/drop/search.h"

namespace selvedge {
namespace {

struct Search {
    std::optional<int> found;
    std::vector<int> asked;
};

Search search_for(int least, int most) {
    Search search;
    search.found = find_least(most, [&](int n) {
        search.asked.push_back(n);
        return n >= least;
    });
    return search;
}

TEST(FindLeast, finds_every_least_number_and_asks_none_twice) {
    for (int least = 1; least <= 64; ++least) {
        Search search = search_for(least, 64);
        EXPECT_EQ(search.found, least);
        std::ranges::sort(search.asked);
        EXPECT_EQ(std::ranges::unique(search.asked).size(), 0U) << least;
        EXPECT_LE(search.asked.size(), 12U);
    }
}

TEST(FindLeast, gives_up_where_it_should) {
    const Search search = search_for(101, 100);
    EXPECT_FALSE(search.found);
    EXPECT_EQ(*std::ranges::max_element(search.asked), 100);
}

TEST(FindLeast, reaches_its_most_also_when_that_is_no_power_of_two) {
    EXPECT_EQ(search_for(100, 100).found, 100);
    EXPECT_EQ(search_for(1, 1).found, 1);
}

}  // namespace
}  // namespace selvedge
