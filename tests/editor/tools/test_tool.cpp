#include <gtest/gtest.h>

#include "editor/tools/tool.h"

namespace selvedge::editor {
namespace {

TEST(TypedInput, a_letter_does_not_begin_a_number) {
    TypedInput input;
    EXPECT_FALSE(input.add("x"));
    EXPECT_FALSE(input.add("h"));
    EXPECT_TRUE(input.is_empty());
    EXPECT_FALSE(input.numbers());
}

TEST(TypedInput, reads_expressions) {
    TypedInput input;
    EXPECT_TRUE(input.add("92/4+1"));
    EXPECT_EQ(input.numbers(), std::vector<double>{24});
}

TEST(TypedInput, reads_several_numbers_with_a_cross_between) {
    TypedInput input;
    for (const char* c : {"3", "0", " ", "x", " ", "4", "0", "/", "2"}) EXPECT_TRUE(input.add(c));
    EXPECT_EQ(input.numbers(), (std::vector<double>{30, 20}));
}

TEST(TypedInput, has_no_number_while_one_is_unfinished) {
    TypedInput input;
    input.add("30x");
    EXPECT_FALSE(input.numbers());
    input.remove_last();
    EXPECT_EQ(input.numbers(), std::vector<double>{30});
    input.clear();
    EXPECT_TRUE(input.is_empty());
}

TEST(TypedInput, does_not_grow_without_end) {
    TypedInput input;
    for (int i = 0; i < 1000; ++i) input.add("1");
    EXPECT_LE(input.text().size(), 64U);
}

}  // namespace

}  // namespace selvedge::editor
