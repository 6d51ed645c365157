#include <gtest/gtest.h>
#include <ostream>
#include <string>

#include "editor/geometry/expression.h"

namespace selvedge::editor {
namespace {

struct Typed {
    friend void PrintTo(const Typed& typed, std::ostream* out) { *out << typed.text; }

    std::string text;
    double value;
};

class Expression : public ::testing::TestWithParam<Typed> {};

TEST_P(Expression, is_worth_what_a_person_means) {
    const auto value = evaluate(GetParam().text);
    ASSERT_TRUE(value);
    EXPECT_DOUBLE_EQ(*value, GetParam().value);
}

INSTANTIATE_TEST_SUITE_P(, Expression,
                         ::testing::Values(Typed{"92/4+1", 24}, Typed{"(3 - 0.5) * 2", 5}, Typed{"12 1/2", 12.5},
                                           Typed{"2,5", 2.5}, Typed{" 7 ", 7}, Typed{"\t7", 7}, Typed{".5", 0.5},
                                           Typed{"5.", 5}, Typed{"-3", -3}, Typed{"+3", 3}, Typed{"1 - -3", 4},
                                           Typed{"2*-3", -6}, Typed{"-(2+3)", -5}, Typed{"-12 1/2", -12.5},
                                           Typed{"12 1/2*2", 25}, Typed{"2*12 1/2", 25}, Typed{"1/2 1/2", 0.4},
                                           Typed{"12 -1/2", 11.5}, Typed{"12 1 / 2", 12.5}, Typed{"8/2/2", 2},
                                           Typed{"8-2-2", 4}, Typed{"2+3*4", 14}, Typed{"((((4))))", 4},
                                           Typed{"0.1", 0.1}, Typed{"0.0000001", 1e-7}, Typed{"123456.789", 123456.789},
                                           Typed{"0/5", 0}),
                         [](const auto& typed) { return "n" + std::to_string(typed.index); });

class NoExpression : public ::testing::TestWithParam<std::string> {};

TEST_P(NoExpression, is_worth_nothing) {
    EXPECT_FALSE(evaluate(GetParam())) << *evaluate(GetParam());
}

INSTANTIATE_TEST_SUITE_P(, NoExpression,
                         ::testing::Values("", " ", "+", "-", "*", "()", "(", ")", "1+", "*1", "1 2", "1 2 3", "12 1/0",
                                           "12.5 1/2", "12 1/2.5", "1/0", "1/(2-2)", "1..2", "1.2.3", "1,2,3",
                                           "1.000,5", ".", ",", "1e5", "0x10", "inf", "nan", "12cm", "1 + a", "(1",
                                           "1)", "3(2)", "(2)(3)", "--1", "1--", "1//2", "12 1/", "\n1", "1;", "\xff",
                                           std::string("1\0", 2), std::string(400, '9'), std::string(2000, '1'),
                                           std::string(900, '('), std::string(900, '-'),
                                           std::string(65, '(') + "1" + std::string(65, ')')),
                         [](const auto& text) { return "n" + std::to_string(text.index); });

}  // namespace

}  // namespace selvedge::editor
