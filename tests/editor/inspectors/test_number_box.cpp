// Typing into, dragging and stepping of number fields, in an offscreen window.
#include <gtest/gtest.h>
#include <array>
#include <numbers>
#include <tuple>

#include "editor/inspectors/number_box.h"
#include "tests/editor/inspectors/inspector_support.h"

namespace selvedge::editor {
namespace {

constexpr double kNear = 1e-9;

// The T-shirt pattern with its front selected.
class NumberBoxes : public testing::Test {
 protected:
    NumberBoxes() : inspector(shipped_pattern("tshirt.json"), draw_properties) {
        Selection selected;
        selected.panels.insert("front");
        inspector.document().select(selected);
        inspector.frame();
        inspector.frame();
    }

    InspectorFixture inspector;
};

TEST_F(NumberBoxes, enter_applies_an_expression_as_one_entry_of_the_history) {
    inspector.click("panel.translation.y");
    inspector.type("92/4+1");
    EXPECT_EQ(inspector.document().history().size(), 0U) << "not before Enter";
    inspector.key(Key::Enter);
    EXPECT_NEAR(inspector.panel(0).translation.y(), 0.24, kNear);
    EXPECT_EQ(inspector.document().history().size(), 1U);
}

TEST_F(NumberBoxes, esc_takes_back_what_was_typed) {
    inspector.click("panel.translation.y");
    inspector.type("12");
    inspector.key(Key::Escape);
    EXPECT_NEAR(inspector.panel(0).translation.y(), 0.785, kNear);
    EXPECT_TRUE(inspector.document().history().empty());
    EXPECT_EQ(inspector.state.boxes.typed.box, 0U);
}

TEST_F(NumberBoxes, a_click_elsewhere_applies) {
    inspector.click("panel.translation.y");
    inspector.type("50");
    inspector.click("panel.translation.x");
    EXPECT_NEAR(inspector.panel(0).translation.y(), 0.5, kNear);
}

TEST_F(NumberBoxes, what_is_no_number_is_marked_and_not_applied) {
    inspector.click("panel.translation.y");
    inspector.type("12 apples");
    EXPECT_FALSE(inspector.state.boxes.typed.wrong.empty());
    inspector.key(Key::Enter);
    EXPECT_NEAR(inspector.panel(0).translation.y(), 0.785, kNear);
    EXPECT_TRUE(inspector.document().history().empty());
}

TEST_F(NumberBoxes, arrow_keys_step_and_are_one_entry_together) {
    inspector.click("panel.translation.y");
    inspector.key(Key::Up);
    inspector.key(Key::Up);
    inspector.key(Key::Up);
    EXPECT_NEAR(inspector.panel(0).translation.y(), 0.788, kNear) << "seen at once";
    EXPECT_TRUE(inspector.document().is_previewing());
    inspector.key(Key::Enter);
    EXPECT_FALSE(inspector.document().is_previewing());
    EXPECT_EQ(inspector.document().history().size(), 1U);
    EXPECT_NEAR(inspector.panel(0).translation.y(), 0.788, kNear);
}

TEST_F(NumberBoxes, steps_are_taken_back_by_esc) {
    inspector.click("panel.translation.y");
    inspector.key(Key::Down);
    inspector.key(Key::Escape);
    EXPECT_NEAR(inspector.panel(0).translation.y(), 0.785, kNear);
    EXPECT_FALSE(inspector.document().is_previewing());
    EXPECT_TRUE(inspector.document().history().empty());
}

TEST_F(NumberBoxes, what_is_no_number_is_not_taken_and_why_is_said) {
    inspector.click("panel.translation.y");
    inspector.type("12 apples");
    inspector.key(Key::Enter);
    EXPECT_TRUE(inspector.document().history().empty());
    const Message* message = inspector.workspace.messages.shown();
    ASSERT_NE(message, nullptr);
    EXPECT_NE(message->text.find("12 apples"), std::string::npos);
}

TEST_F(NumberBoxes, a_label_is_dragged_and_its_change_kept_when_it_is_let_go) {
    inspector.drag("drag panel.translation.y", 40);
    EXPECT_TRUE(inspector.document().is_previewing());
    EXPECT_NEAR(inspector.panel(0).translation.y(), 0.805, kNear) << "2 px to the millimetre";
    inspector.let_go();
    EXPECT_FALSE(inspector.document().is_previewing());
    EXPECT_EQ(inspector.document().history().size(), 1U);
    EXPECT_NEAR(inspector.panel(0).translation.y(), 0.805, kNear);
}

TEST_F(NumberBoxes, esc_gives_a_drag_up) {
    inspector.drag("drag panel.translation.y", 40);
    inspector.key(Key::Escape);
    inspector.let_go();
    EXPECT_NEAR(inspector.panel(0).translation.y(), 0.785, kNear);
    EXPECT_TRUE(inspector.document().history().empty());
}

TEST_F(NumberBoxes, a_box_that_goes_away_while_it_is_stepped_keeps_what_is_seen) {
    inspector.click("panel.translation.y");
    inspector.key(Key::Up);
    inspector.document().select({});
    for (int i = 0; i < 4; ++i) inspector.frame();
    EXPECT_FALSE(inspector.document().is_previewing());
    EXPECT_EQ(inspector.document().history().size(), 1U);
}

TEST_F(NumberBoxes, a_typed_angle_turns_the_panel_and_stays_as_it_was_typed) {
    inspector.click("panel.rotation.y");
    inspector.type("120");
    inspector.key(Key::Enter);
    EXPECT_NEAR(inspector.panel(0).rotation(0, 0), -0.5, kNear);
    EXPECT_EQ(inspector.state.angles.at("front").angles.x(), 0) << "not 180, 60, 180";
}

TEST_F(NumberBoxes, a_factor_scales_the_panel_about_its_middle) {
    const double width = inspector.panel(0).vertices[1].x() - inspector.panel(0).vertices[0].x();
    inspector.click("panel.scale.x");
    inspector.type("150%");
    inspector.key(Key::Enter);
    EXPECT_NEAR(inspector.panel(0).vertices[1].x() - inspector.panel(0).vertices[0].x(), 1.5 * width, kNear);
}

TEST_F(NumberBoxes, a_typed_scale_changes_the_area_that_is_shown) {
    inspector.frame();
    const double area = inspector.state.panels.at("front").area;
    inspector.click("panel.scale.x");
    inspector.type("60%");
    inspector.key(Key::Enter);
    inspector.frame();
    EXPECT_NEAR(inspector.state.panels.at("front").area, 0.6 * area, kNear);
}

TEST_F(NumberBoxes, a_panel_gets_another_name_and_stays_selected) {
    inspector.click("panel.name");
    inspector.type("bodice");
    inspector.key(Key::Enter);
    EXPECT_EQ(inspector.panel(0).name, "bodice");
    EXPECT_TRUE(inspector.document().selection().panels.contains("bodice"));
}

TEST_F(NumberBoxes, a_length_that_is_typed_moves_the_end_of_an_edge) {
    Selection selected;
    selected.edges.insert({"front", 1});
    inspector.document().select(selected);
    inspector.frame();
    inspector.frame();
    inspector.click("edge.length");
    inspector.type("30");
    inspector.key(Key::Enter);
    EXPECT_NEAR((inspector.panel(0).vertices[2] - inspector.panel(0).vertices[1]).norm(), 0.3, kNear);
}

TEST(ReadNumber, ranges_are_told_in_the_box_own_unit) {
    const NumberBox box{.unit = Unit::Centimetres, .least = 0.01, .most = 0.5};
    EXPECT_EQ(read_number(box, "0.5").wrong, "It is 1 cm at least");
    EXPECT_EQ(read_number(box, "51").wrong, "It is 50 cm at most");
    EXPECT_NEAR(read_number(box, "50").value.value_or(0), 0.5, kNear);
    EXPECT_FALSE(read_number(box, " ").wrong.empty());
}

TEST(ReadNumber, a_box_that_stands_for_something_may_be_emptied) {
    const NumberBox box{.may_be_empty = true, .standing_for = 0.05};
    EXPECT_TRUE(read_number(box, " ").wrong.empty());
    EXPECT_FALSE(read_number(box, " ").value);
}

}  // namespace

// Conversion between values and text.

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

TEST(Quantity, values_of_fabrics_are_shown_in_units_of_the_trade_and_read_back) {
    constexpr std::array<std::tuple<Unit, double, const char*>, 7> kShown{{
        {Unit::GramsPerArea, 0.12, "120 g/m\u00B2"},
        {Unit::NewtonsPerMetre, 8000, "8000 N/m"},
        {Unit::MicronewtonMetres, 4.5e-5, "45 \u00B5N\u00B7m"},
        {Unit::Millinewtons, 0.000686, "0.686 mN"},
        {Unit::Thickness, 0.00028, "0.28 mm"},
        {Unit::PerSecond, 0.6, "0.6 /s"},
        {Unit::Percent, 0.03, "3 %"},
    }};
    for (const auto& [unit, value, text] : kShown) {
        EXPECT_EQ(quantity_text(value, unit), text);
        const std::optional<double> read = parse_quantity(text, unit);
        ASSERT_TRUE(read) << text;
        EXPECT_NEAR(*read, value, 1e-12 * value) << text;
    }
    EXPECT_NEAR(parse_quantity("0.33 kg/m\u00B2", Unit::GramsPerArea).value_or(0), 0.33, 1e-12);
    EXPECT_NEAR(parse_quantity("9uNm", Unit::MicronewtonMetres).value_or(0), 9e-6, 1e-15);
    EXPECT_FALSE(parse_quantity("9 cm", Unit::MicronewtonMetres));
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

}  // namespace selvedge::editor
