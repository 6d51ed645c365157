// Boxes that are typed into, dragged and stepped, in a window of no screen.
#include "editor/inspectors/number_box.h"

#include <gtest/gtest.h>

#include "tests/editor/inspectors/inspector_desk.h"

namespace selvedge {
namespace {

constexpr double kNear = 1e-9;

// The T-shirt with its front selected.
class NumberBoxes : public testing::Test {
 protected:
    NumberBoxes() : desk(shipped_pattern("tshirt.json"), draw_properties) {
        Selection selected;
        selected.panels.insert("front");
        desk.document().select(selected);
        desk.frame();
        desk.frame();
    }

    InspectorDesk desk;
};

TEST_F(NumberBoxes, enter_applies_an_expression_as_one_entry_of_the_history) {
    desk.click("panel.translation.y");
    desk.type("92/4+1");
    EXPECT_EQ(desk.document().history().size(), 0U) << "not before Enter";
    desk.key(ImGuiKey_Enter);
    EXPECT_NEAR(desk.panel(0).translation.y(), 0.24, kNear);
    EXPECT_EQ(desk.document().history().size(), 1U);
}

TEST_F(NumberBoxes, esc_takes_back_what_was_typed) {
    desk.click("panel.translation.y");
    desk.type("12");
    desk.key(ImGuiKey_Escape);
    EXPECT_NEAR(desk.panel(0).translation.y(), 0.785, kNear);
    EXPECT_TRUE(desk.document().history().empty());
    EXPECT_EQ(desk.state.boxes.typed.box, 0U);
}

TEST_F(NumberBoxes, a_click_elsewhere_applies) {
    desk.click("panel.translation.y");
    desk.type("50");
    desk.click("panel.translation.x");
    EXPECT_NEAR(desk.panel(0).translation.y(), 0.5, kNear);
}

TEST_F(NumberBoxes, what_is_no_number_is_marked_and_not_applied) {
    desk.click("panel.translation.y");
    desk.type("12 apples");
    EXPECT_FALSE(desk.state.boxes.typed.wrong.empty());
    desk.key(ImGuiKey_Enter);
    EXPECT_NEAR(desk.panel(0).translation.y(), 0.785, kNear);
    EXPECT_TRUE(desk.document().history().empty());
}

TEST_F(NumberBoxes, arrow_keys_step_and_are_one_entry_together) {
    desk.click("panel.translation.y");
    desk.key(ImGuiKey_UpArrow);
    desk.key(ImGuiKey_UpArrow);
    desk.key(ImGuiKey_UpArrow);
    EXPECT_NEAR(desk.panel(0).translation.y(), 0.788, kNear) << "seen at once";
    EXPECT_TRUE(desk.document().is_attempting());
    desk.key(ImGuiKey_Enter);
    EXPECT_FALSE(desk.document().is_attempting());
    EXPECT_EQ(desk.document().history().size(), 1U);
    EXPECT_NEAR(desk.panel(0).translation.y(), 0.788, kNear);
}

TEST_F(NumberBoxes, steps_are_taken_back_by_esc) {
    desk.click("panel.translation.y");
    desk.key(ImGuiKey_DownArrow);
    desk.key(ImGuiKey_Escape);
    EXPECT_NEAR(desk.panel(0).translation.y(), 0.785, kNear);
    EXPECT_FALSE(desk.document().is_attempting());
    EXPECT_TRUE(desk.document().history().empty());
}

TEST_F(NumberBoxes, what_is_no_number_is_not_taken_and_why_is_said) {
    desk.click("panel.translation.y");
    desk.type("12 apples");
    desk.key(ImGuiKey_Enter);
    EXPECT_TRUE(desk.document().history().empty());
    const Message* message = desk.workspace.messages.shown();
    ASSERT_NE(message, nullptr);
    EXPECT_NE(message->words.find("12 apples"), std::string::npos);
}

TEST_F(NumberBoxes, a_label_is_dragged_and_its_change_kept_when_it_is_let_go) {
    desk.drag("drag panel.translation.y", 40);
    EXPECT_TRUE(desk.document().is_attempting());
    EXPECT_NEAR(desk.panel(0).translation.y(), 0.805, kNear) << "2 px to the millimetre";
    desk.let_go();
    EXPECT_FALSE(desk.document().is_attempting());
    EXPECT_EQ(desk.document().history().size(), 1U);
    EXPECT_NEAR(desk.panel(0).translation.y(), 0.805, kNear);
}

TEST_F(NumberBoxes, esc_gives_a_drag_up) {
    desk.drag("drag panel.translation.y", 40);
    desk.key(ImGuiKey_Escape);
    desk.let_go();
    EXPECT_NEAR(desk.panel(0).translation.y(), 0.785, kNear);
    EXPECT_TRUE(desk.document().history().empty());
}

TEST_F(NumberBoxes, a_box_that_goes_away_while_it_is_stepped_keeps_what_is_seen) {
    desk.click("panel.translation.y");
    desk.key(ImGuiKey_UpArrow);
    desk.document().select({});
    for (int i = 0; i < 4; ++i) desk.frame();
    EXPECT_FALSE(desk.document().is_attempting());
    EXPECT_EQ(desk.document().history().size(), 1U);
}

TEST_F(NumberBoxes, a_typed_angle_turns_the_panel_and_stays_as_it_was_typed) {
    desk.click("panel.rotation.y");
    desk.type("120");
    desk.key(ImGuiKey_Enter);
    EXPECT_NEAR(desk.panel(0).rotation(0, 0), -0.5, kNear);
    EXPECT_EQ(desk.state.angles.at("front").angles.x(), 0) << "not 180, 60, 180";
}

TEST_F(NumberBoxes, a_factor_scales_the_panel_about_its_middle) {
    const double width = desk.panel(0).vertices[1].x() - desk.panel(0).vertices[0].x();
    desk.click("panel.scale.x");
    desk.type("150%");
    desk.key(ImGuiKey_Enter);
    EXPECT_NEAR(desk.panel(0).vertices[1].x() - desk.panel(0).vertices[0].x(), 1.5 * width, kNear);
}

TEST_F(NumberBoxes, a_panel_gets_another_name_and_stays_selected) {
    desk.click("panel.name");
    desk.type("bodice");
    desk.key(ImGuiKey_Enter);
    EXPECT_EQ(desk.panel(0).name, "bodice");
    EXPECT_TRUE(desk.document().selection().panels.contains("bodice"));
}

TEST_F(NumberBoxes, a_length_that_is_typed_moves_the_end_of_an_edge) {
    Selection selected;
    selected.edges.insert({"front", 1});
    desk.document().select(selected);
    desk.frame();
    desk.frame();
    desk.click("edge.length");
    desk.type("30");
    desk.key(ImGuiKey_Enter);
    EXPECT_NEAR((desk.panel(0).vertices[2] - desk.panel(0).vertices[1]).norm(), 0.3, kNear);
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
}  // namespace selvedge
