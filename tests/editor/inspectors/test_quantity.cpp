// Values in boxes.
#include "editor/inspectors/quantity.h"

#include <gtest/gtest.h>

#include <numbers>

namespace selvedge {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

TEST(Quantity, lengths_are_shown_in_cm_with_as_few_figures_as_say_it) {
    EXPECT_EQ(quantity_text(0.925, Unit::Centimetres), "92.5 cm");
    EXPECT_EQ(quantity_text(1, Unit::Centimetres), "100 cm");
    EXPECT_EQ(quantity_text(0.123456, Unit::Centimetres), "12.35 cm");
    EXPECT_EQ(quantity_text(-0.00001, Unit::Centimetres), "0 cm");
    EXPECT_EQ(quantity_text(0.0032, Unit::Millimetres), "3.2 mm");
}

TEST(Quantity, what_is_shown_is_read_back) {
    for (const Unit unit : {Unit::Centimetres, Unit::Millimetres, Unit::Degrees, Unit::Factor, Unit::Plain}) {
        const double value = 0.25;
        const std::optional<double> read = parse_quantity(quantity_text(value, unit), unit);
        ASSERT_TRUE(read) << quantity_text(value, unit);
        EXPECT_NEAR(*read, value, 1e-4) << quantity_text(value, unit);
    }
}

TEST(Quantity, expressions_and_other_units_are_understood) {
    EXPECT_NEAR(parse_quantity("92/4+1", Unit::Centimetres).value_or(0), 0.24, 1e-12);
    EXPECT_NEAR(parse_quantity(" 120 mm ", Unit::Centimetres).value_or(0), 0.12, 1e-12);
    EXPECT_NEAR(parse_quantity("4 in", Unit::Centimetres).value_or(0), 0.1016, 1e-12);
    EXPECT_NEAR(parse_quantity("1.2m", Unit::Centimetres).value_or(0), 1.2, 1e-12);
    EXPECT_NEAR(parse_quantity("105%", Unit::Factor).value_or(0), 1.05, 1e-12);
    EXPECT_NEAR(parse_quantity("90 deg", Unit::Degrees).value_or(0), 90 * kDegree, 1e-12);
}

TEST(Quantity, what_is_no_such_value_is_refused) {
    EXPECT_FALSE(parse_quantity("", Unit::Centimetres));
    EXPECT_FALSE(parse_quantity("cm", Unit::Centimetres));
    EXPECT_FALSE(parse_quantity("12 kg", Unit::Centimetres));
    EXPECT_FALSE(parse_quantity("1/0", Unit::Centimetres));
    EXPECT_FALSE(parse_quantity("5%", Unit::Centimetres));
    EXPECT_FALSE(parse_quantity("2.5", Unit::Whole));
    EXPECT_FALSE(parse_quantity("1e300*1e300", Unit::Plain));
}

TEST(Quantity, steps_go_along_a_raster) {
    EXPECT_NEAR(stepped(0.92530, Unit::Centimetres, 1), 0.926, 1e-12);
    EXPECT_NEAR(stepped(0.92, Unit::Centimetres, -10), 0.91, 1e-12);
    EXPECT_NEAR(stepped(44.6 * kDegree, Unit::Degrees, 1), 46 * kDegree, 1e-12);
    EXPECT_EQ(stepped(3, Unit::Whole, 1), 4);
}

}  // namespace
}  // namespace selvedge
