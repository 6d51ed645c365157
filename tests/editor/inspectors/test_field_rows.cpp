// Rows of the inspectors that follow the descriptions of fields.
#include <gtest/gtest.h>

#include <string>

#include "editor/inspectors/property_inspector.h"
#include "sim/core/math.h"
#include "tests/editor/inspectors/inspector_support.h"

namespace selvedge::editor {
namespace {

void set(InspectorFixture& inspector, const std::string& widget, const std::string& text) {
    inspector.click(widget);
    inspector.type(text);
    inspector.key(Key::Enter);
    inspector.frame();
}

TEST(FieldRows, set_numbers_words_and_flags_of_a_panel) {
    InspectorFixture inspector(shipped_pattern("tshirt.json"), draw_properties);
    const sim::Pattern before = inspector.document().pattern();
    const std::string name = inspector.panel(0).name;
    Selection selected;
    selected.panels.insert(name);
    inspector.document().select(selected);
    inspector.frame();
    set(inspector, "panel.grain_angle", "45");
    EXPECT_NEAR(inspector.panel(0).grain_angle, 45 * sim::kDegree, 1e-12);
    set(inspector, "panel.layer", "900");
    EXPECT_EQ(inspector.panel(0).layer, 900) << "as high as files allow";
    set(inspector, "panel.allowance", "1.5");
    EXPECT_NEAR(inspector.panel(0).allowance.value_or(0), 0.015, 1e-12);
    set(inspector, "panel.pieces", "2");
    EXPECT_EQ(inspector.panel(0).pieces, 2);
    inspector.click("panel.is_worn");
    EXPECT_FALSE(inspector.panel(0).is_worn);
    EXPECT_EQ(inspector.document().history().back().label, "Change is worn");
    for (int i = 0; i < 5; ++i) inspector.document().undo();
    EXPECT_EQ(inspector.document().pattern(), before);
}

TEST(FieldRows, clear_a_number_that_may_be_empty) {
    sim::PatternDocument source = shipped_pattern("tshirt.json");
    source.pattern.panels[0].edges[1].allowance = 0.02;
    InspectorFixture inspector(source, draw_properties);
    Selection selected;
    selected.edges.insert({inspector.panel(0).name, 1});
    inspector.document().select(selected);
    inspector.frame();
    inspector.click("edge.allowance");
    inspector.key(Key::Delete);
    inspector.key(Key::Enter);
    EXPECT_FALSE(inspector.panel(0).edges[1].allowance);
}

TEST(FieldRows, set_the_count_of_a_notch_within_its_range) {
    sim::PatternDocument source = shipped_pattern("tshirt.json");
    source.pattern.panels[0].notches = {{.edge = 1, .t = 0.5}};
    InspectorFixture inspector(source, draw_properties);
    Selection selected;
    selected.notches.insert({inspector.panel(0).name, 0});
    inspector.document().select(selected);
    inspector.frame();
    EXPECT_TRUE(inspector.widgets.contains("notch.kind"));
    set(inspector, "notch.count", "2");
    EXPECT_EQ(inspector.panel(0).notches[0], (sim::Notch{.edge = 1, .t = 0.5, .count = 2}));
    set(inspector, "notch.count", "10");
    EXPECT_EQ(inspector.panel(0).notches[0].count, 2);
}

TEST(FieldRows, set_the_mesh_of_a_garment_no_coarser_than_files_allow) {
    InspectorFixture inspector(shipped_pattern("tshirt.json"), draw_properties);
    inspector.frame();
    set(inspector, "pattern.edge_length", "3");
    EXPECT_NEAR(inspector.document().pattern().edge_length.value_or(0), 0.03, 1e-12);
    set(inspector, "pattern.edge_length", "40");
    EXPECT_NEAR(inspector.document().pattern().edge_length.value_or(0), 0.03, 1e-12);
}

}  // namespace
}  // namespace selvedge::editor
