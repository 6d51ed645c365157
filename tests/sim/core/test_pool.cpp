#include "sim/core/pool.h"

#include <gtest/gtest.h>

#include <vector>

namespace selvedge::sim {
namespace {

using Numbers = Pool<int, VertexId>;

TEST(Pool, gives_rising_ids_from_none) {
    Numbers pool;
    EXPECT_EQ(pool.capacity(), 0U);
    for (std::uint32_t i = 0; i < 5; ++i) EXPECT_EQ(pool.create(7), VertexId(i));
    EXPECT_EQ(pool.size(), 5U);
    EXPECT_EQ(pool.capacity(), Numbers::kBlockSize);
}

TEST(Pool, gives_the_id_again_that_was_released_last) {
    Numbers pool;
    for (int i = 0; i < 5; ++i) pool.create(i);
    pool.release(VertexId(1));
    pool.release(VertexId(3));
    EXPECT_EQ(pool.create(30), VertexId(3));
    EXPECT_EQ(pool.create(10), VertexId(1));
    EXPECT_EQ(pool.create(50), VertexId(5));
    EXPECT_EQ(pool[VertexId(3)], 30);
}

TEST(Pool, counts_what_was_released_as_free) {
    Numbers pool;
    const VertexId id = pool.create(42);
    EXPECT_EQ(pool.size(), 1U);
    pool.release(id);
    EXPECT_EQ(pool.size(), 0U);
    EXPECT_EQ(pool.free_ids().back(), id);
}

TEST(Pool, never_moves_an_element_when_it_grows) {
    Numbers pool;
    const int* first = &pool[pool.create(1)];
    for (std::size_t i = 0; i < 10 * Numbers::kBlockSize; ++i) pool.create(static_cast<int>(i));
    EXPECT_EQ(first, &pool[VertexId(0)]);
    EXPECT_EQ(*first, 1);
    EXPECT_EQ(pool.capacity(), 11 * Numbers::kBlockSize);
}

TEST(Pool, is_copied_with_its_elements_and_its_free_ids) {
    Numbers pool;
    for (int i = 0; i < 3; ++i) pool.create(i);
    pool.release(VertexId(1));
    Numbers copy = pool;
    pool[VertexId(2)] = 99;
    EXPECT_EQ(copy[VertexId(2)], 2);
    EXPECT_EQ(copy.create(5), VertexId(1));
    EXPECT_EQ(pool.size(), 2U);
}

TEST(PoolDeathTest, stops_when_more_is_released_than_there_is) {
    Numbers pool;
    pool.release(pool.create(1));
    EXPECT_DEATH(pool.release(VertexId(0)), "pool.h");
}

}  // namespace
}  // namespace selvedge::sim
