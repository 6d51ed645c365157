// The tree of objects: what it lists and finds, and what clicks in it do.
#include <gtest/gtest.h>
#include <set>
#include <string>

#include "editor/inspectors/object_tree.h"
#include "sim/pattern/garments.h"
#include "tests/editor/inspectors/inspector_support.h"

namespace selvedge::editor {
namespace {

// A T-shirt whose front has a dart and the internal line "pocket".
Document tshirt_with_parts() {
    Document document(shipped_pattern("tshirt.json"));
    document.run(AddInternalLine{.panel = "front", .line = {"pocket", {{0.01, 0.02}, {0.05, 0.02}}}});
    document.run(AddDart{.panel = "front", .edge = 0, .t = 0.5, .width = 0.02, .depth = 0.08});
    document.select({});
    return document;
}

std::set<std::string> panels_in(const sim::Pattern& pattern, const PanelGroup& group) {
    std::set<std::string> names;
    for (const ListedPanel& listed : group.panels)
        names.insert(pattern.panels[static_cast<std::size_t>(listed.index)].name);
    return names;
}

TEST(ObjectTree, lists_each_panel_and_each_seam_once) {
    const sim::Pattern pattern = tshirt_with_parts().pattern();
    for (const PanelGrouping grouping : {PanelGrouping::Garments, PanelGrouping::Fabrics}) {
        const ObjectTree tree = list_objects(pattern, grouping, "");
        ASSERT_EQ(tree.groups.size(), 1U);
        EXPECT_EQ(tree.groups[0].panels.size(), pattern.panels.size());
        EXPECT_EQ(tree.darts, 1);
        EXPECT_EQ(tree.seams.size() + 1, pattern.seams.size()) << "the dart stands under its panel";
    }
}

TEST(ObjectTree, a_panel_has_its_lines_then_its_darts_then_its_edges) {
    const sim::Pattern pattern = tshirt_with_parts().pattern();
    const ObjectTree tree = list_objects(pattern, PanelGrouping::Garments, "");
    for (const ListedPanel& listed : tree.groups.at(0).panels) {
        const sim::Panel& panel = pattern.panels[static_cast<std::size_t>(listed.index)];
        if (panel.name != "front") continue;
        ASSERT_EQ(listed.parts.size(), 2 + panel.edges.size());
        EXPECT_EQ(listed.parts[0].title, "pocket");
        EXPECT_EQ(listed.parts[1].kind, PartKind::Dart);
        EXPECT_EQ(listed.parts[2].kind, PartKind::Edge);
    }
}

TEST(ObjectTree, groups_by_garment_with_the_outermost_first_and_by_fabric) {
    sim::Pattern pattern = shipped_pattern("tshirt.json").pattern;
    put_over(pattern, shipped_pattern("skirt.json").pattern);
    const ObjectTree garments = list_objects(pattern, PanelGrouping::Garments, "");
    ASSERT_EQ(garments.groups.size(), 2U);
    EXPECT_EQ(garments.groups[0].name, "skirt");
    EXPECT_EQ(panels_in(pattern, garments.groups[0]), (std::set<std::string>{"skirt_front", "skirt_back"}));
    pattern.panels[0].fabric = "denim";
    const ObjectTree fabrics = list_objects(pattern, PanelGrouping::Fabrics, "");
    ASSERT_GE(fabrics.groups.size(), 2U);
    for (const PanelGroup& group : fabrics.groups) {
        EXPECT_EQ(group.name == "denim", panels_in(pattern, group).contains(pattern.panels[0].name));
    }
}

TEST(ObjectTree, finds_by_name_in_any_case_and_says_how_many) {
    const sim::Pattern pattern = tshirt_with_parts().pattern();
    const auto count = [&](const std::string& wanted) {
        return count_text(list_objects(pattern, PanelGrouping::Garments, wanted), wanted);
    };
    EXPECT_EQ(count("POCKET"), "1 internal line");
    EXPECT_EQ(count("nobody has this name"), "");
    const ObjectTree sleeves = list_objects(pattern, PanelGrouping::Garments, "Sleeve back");
    EXPECT_EQ(sleeves.panels, 2);
    for (const PanelGroup& group : sleeves.groups) {
        for (const std::string& name : panels_in(pattern, group))
            EXPECT_NE(name.find("sleeve_back"), std::string::npos);
    }
    EXPECT_NE(count("").find(std::to_string(pattern.panels.size()) + " panels, "), std::string::npos);
    EXPECT_EQ(count("").find("edge"), std::string::npos);
}

TEST(ObjectTree, of_a_panel_whose_name_is_not_wanted_only_the_parts_found_are_listed) {
    const ObjectTree tree = list_objects(tshirt_with_parts().pattern(), PanelGrouping::Garments, "pocket");
    ASSERT_EQ(tree.groups.size(), 1U);
    ASSERT_EQ(tree.groups[0].panels.size(), 1U);
    EXPECT_FALSE(tree.groups[0].panels[0].is_found);
    EXPECT_EQ(tree.groups[0].panels[0].parts.size(), 1U);
}

class ObjectInspector : public testing::Test {
 protected:
    ObjectInspector() : inspector(shipped_pattern("two_squares.json"), draw_objects) { settle(); }

    // So that the next click is not taken as the second of a double click.
    void settle() {
        for (int i = 0; i < 30; ++i) inspector.frame();
    }
    void click(const std::string& name) {
        inspector.click(name);
        settle();
    }
    void double_click(const std::string& name) {
        inspector.click(name);
        inspector.click(name);
        for (int i = 0; i < 5; ++i) inspector.frame();
    }
    const PanelStates& states() { return inspector.document().panel_states(); }
    std::set<std::string> selected() { return inspector.document().selection().panels; }

    InspectorFixture inspector;
};

TEST_F(ObjectInspector, a_click_selects_and_ctrl_adds_or_takes_away) {
    click("objects.panel.front.title");
    EXPECT_EQ(selected(), std::set<std::string>{"front"});
    click("objects.panel.back");
    EXPECT_EQ(selected(), std::set<std::string>{"back"});
    ImGui::GetIO().KeyCtrl = true;
    click("objects.panel.front");
    EXPECT_EQ(selected().size(), 2U);
    click("objects.panel.back");
    EXPECT_EQ(selected(), std::set<std::string>{"front"});
    ImGui::GetIO().KeyCtrl = false;
    click("objects.seam.1");
    EXPECT_EQ(inspector.document().selection().seams, std::set<int>{1});
    EXPECT_TRUE(selected().empty());
}

TEST_F(ObjectInspector, a_group_selects_its_panels) {
    click("objects.fabrics");
    click("objects.group.cotton_shirting");
    EXPECT_EQ(selected(), (std::set<std::string>{"front", "back"}));
}

TEST_F(ObjectInspector, eye_and_lock_hide_and_lock_a_panel_and_give_it_back) {
    click("objects.panel.front.eye");
    EXPECT_EQ(states(), (PanelStates{.hidden = {"front"}, .locked = {}}));
    EXPECT_TRUE(selected().empty()) << "the eye is no row";
    click("objects.panel.back.lock");
    EXPECT_EQ(states(), (PanelStates{.hidden = {"front"}, .locked = {"back"}}));
    click("objects.panel.front.eye");
    click("objects.panel.back.lock");
    EXPECT_TRUE(states().is_empty());
    EXPECT_TRUE(inspector.document().history().empty());
}

TEST_F(ObjectInspector, the_eye_of_a_group_hides_all_its_panels) {
    click("objects.fabrics");
    click("objects.panel.front.eye");
    click("objects.group.cotton_shirting.eye");
    EXPECT_EQ(states().hidden, (std::set<std::string>{"front", "back"}));
    click("objects.group.cotton_shirting.eye");
    EXPECT_TRUE(states().hidden.empty());
}

TEST_F(ObjectInspector, a_locked_panel_is_selected_in_the_list) {
    click("objects.panel.front.lock");
    click("objects.panel.front");
    EXPECT_EQ(selected(), std::set<std::string>{"front"});
}

TEST_F(ObjectInspector, a_double_click_on_a_name_lets_it_be_typed) {
    double_click("objects.panel.front.title");
    ASSERT_TRUE(inspector.widgets.contains("objects.panel.front.name"));
    inspector.type("vorn");
    inspector.key(Key::Enter);
    inspector.frame();
    EXPECT_EQ(inspector.panel(0).name, "vorn");
    EXPECT_TRUE(inspector.widgets.contains("objects.panel.vorn"));
    EXPECT_FALSE(inspector.widgets.contains("objects.panel.vorn.name"));
}

TEST_F(ObjectInspector, escape_keeps_the_name) {
    double_click("objects.panel.front.title");
    inspector.type("vorn");
    inspector.key(Key::Escape);
    settle();
    EXPECT_EQ(inspector.panel(0).name, "front");
    EXPECT_TRUE(inspector.widgets.contains("objects.panel.front"));
}

TEST_F(ObjectInspector, the_selected_seam_gets_a_name) {
    Selection seam;
    seam.seams = {2};
    inspector.document().select(seam);
    inspector.state.objects.wants_naming = true;  // as F2 does
    for (int i = 0; i < 5; ++i) inspector.frame();
    ASSERT_TRUE(inspector.widgets.contains("objects.seam.2.name"));
    inspector.type("side");
    inspector.key(Key::Enter);
    EXPECT_EQ(inspector.document().pattern().seams[2].name, "side");
}

// The rows of darts stand under their panels, which are closed at first; a search may hide any row.
TEST_F(ObjectInspector, what_is_to_be_named_is_shown_though_its_panel_is_closed_or_a_search_hides_it) {
    inspector.document().run(AddDart{.panel = "front", .edge = 0, .t = 0.5, .width = 0.02, .depth = 0.08});
    const int dart = static_cast<int>(inspector.document().pattern().seams.size()) - 1;
    const auto begin_naming = [&](const Selection& selection) {
        inspector.document().select(selection);
        inspector.state.objects.wants_naming = true;  // as F2 does
        for (int i = 0; i < 5; ++i) inspector.frame();
    };
    settle();
    ASSERT_FALSE(inspector.widgets.contains("objects.seam." + std::to_string(dart))) << "its panel is closed";
    begin_naming({.panels = {}, .vertices = {}, .edges = {}, .internal_lines = {}, .notches = {}, .seams = {dart}});
    ASSERT_TRUE(inspector.widgets.contains("objects.seam." + std::to_string(dart) + ".name"));
    inspector.type("bust dart");
    inspector.key(Key::Enter);
    EXPECT_EQ(inspector.document().pattern().seams.back().name, "bust dart");
    inspector.state.objects.wanted = "back";
    settle();
    ASSERT_FALSE(inspector.widgets.contains("objects.panel.front"));
    begin_naming({.panels = {"front"}, .vertices = {}, .edges = {}, .internal_lines = {}, .notches = {}, .seams = {}});
    EXPECT_TRUE(inspector.widgets.contains("objects.panel.front.name"));
    inspector.key(Key::Escape);
    inspector.state.objects.wanted = "front";
    begin_naming({.panels = {"front"}, .vertices = {}, .edges = {}, .internal_lines = {}, .notches = {}, .seams = {}});
    EXPECT_EQ(inspector.state.objects.wanted, "front") << "it finds the panel";
}

TEST_F(ObjectInspector, lists_only_what_is_found_while_it_is_typed) {
    inspector.state.objects.wants_find = true;  // as Ctrl+F does
    for (int i = 0; i < 5; ++i) inspector.frame();
    EXPECT_FALSE(inspector.state.objects.wants_find);
    inspector.type("Fron");
    inspector.frame();
    EXPECT_TRUE(inspector.widgets.contains("objects.panel.front"));
    EXPECT_FALSE(inspector.widgets.contains("objects.panel.back"));
    inspector.key(Key::Enter);
    inspector.frame();
    EXPECT_EQ(inspector.state.objects.wanted, "Fron");
    EXPECT_FALSE(inspector.widgets.contains("objects.panel.back"));
}

TEST_F(ObjectInspector, the_row_under_the_cursor_lights_its_panel_up) {
    const Vec2f at = inspector.widgets.at("objects.panel.back").centre();
    ImGui::GetIO().MousePos = {at.x(), at.y()};
    inspector.frame();
    EXPECT_EQ(inspector.workspace.hover, Hover{.panel = "back"});
    ImGui::GetIO().MousePos = {-1000, -1000};
    inspector.frame();
    EXPECT_EQ(inspector.workspace.hover, Hover{});
}

}  // namespace
}  // namespace selvedge::editor
