// A fabric's values are edited as a draft that stays until it is saved or dropped.
#include <gtest/gtest.h>
#include <map>
#include <string>

#include "editor/inspectors/material_inspector.h"
#include "sim/core/error.h"
#include "tests/editor/inspectors/inspector_support.h"

namespace selvedge::editor {
namespace {

using Asked = std::vector<std::string>;

class FabricInspector : public testing::Test {
 protected:
    FabricInspector() {
        inspector_.workspace.fabrics = FabricLibrary([this](const std::string& name) -> sim::FabricFile {
            if (!name.ends_with(".json")) return sim::read_fabric_file(name);
            ++reads_;
            if (texts_.at(name) == "{") throw sim::InputError(name, "", "not JSON");
            return {sim::parse_fabric(texts_.at(name), name), texts_.at(name)};
        });
        inspector_.frame();
    }
    FabricLibrary& fabrics() { return inspector_.workspace.fabrics; }
    const sim::Fabric& draft(const std::string& name) { return fabrics().find(name).draft.value(); }
    void set(const std::string& widget, const std::string& text) {
        inspector_.click(widget);
        inspector_.type(text);
        inspector_.key(Key::Enter);
    }
    void choose(const std::string& list, const std::string& item) {
        inspector_.click(list);
        inspector_.frame();
        inspector_.click(list + "." + item);
        inspector_.frame();
        inspector_.frame();
    }
    bool has(const std::string& widget) { return inspector_.widgets.contains(widget); }

    std::map<std::string, std::string> texts_{{"/f/mine.json", sim::read_fabric_file("silk").text}};
    int reads_ = 0;
    InspectorFixture inspector_{shipped_pattern("skirt.json"), draw_fabric};  // of wool_twill_light
    std::string fabric_ = inspector_.document().pattern().fabric;
};

TEST_F(FabricInspector, edits_a_draft_and_leaves_the_document_alone) {
    const sim::Fabric before = fabrics().find(fabric_).file.fabric;
    EXPECT_FALSE(has("fabric.area_density"));
    inspector_.click("material.fabric.edit");
    set("fabric.area_density", "150");
    set("fabric.bending_warp", "2.9");
    set("fabric.strain_limit", "7%");
    sim::Fabric expected = before;
    expected.area_density = 0.15;
    expected.bending_warp = 2.9e-6;
    expected.strain_limit = 0.07;
    EXPECT_EQ(draft(fabric_), expected) << "to the bit";
    EXPECT_EQ(fabrics().changed(), Asked{fabric_});
    EXPECT_TRUE(inspector_.document().history().empty());
    EXPECT_FALSE(inspector_.document().has_unsaved_changes());
}

TEST_F(FabricInspector, has_a_row_with_the_range_of_files_for_each_value) {
    inspector_.click("material.fabric.edit");
    for (const sim::FabricKey& key : sim::fabric_keys()) {
        EXPECT_EQ(has(std::string("fabric.") + key.key), key.key != std::string("air_drag")) << key.key;
    }
    const double before = draft(fabric_).thickness;
    set("fabric.thickness", "21");
    EXPECT_EQ(draft(fabric_).thickness, before);
    EXPECT_NE(inspector_.workspace.messages.all().back().text.find("It is 20 mm at most"), std::string::npos);
    set("fabric.thickness", "20");
    EXPECT_EQ(draft(fabric_).thickness, 0.02);
    set("fabric.bending_weft", "-0.0005");  // within the rounding that a box allows
    EXPECT_EQ(draft(fabric_).bending_weft, 0);
}

TEST_F(FabricInspector, follows_a_label_that_is_dragged_and_goes_back_with_escape) {
    inspector_.click("material.fabric.edit");
    const double before = draft(fabric_).friction;
    inspector_.drag("drag fabric.friction", 40);
    EXPECT_GT(draft(fabric_).friction, before);
    inspector_.key(Key::Escape);
    inspector_.let_go();
    EXPECT_EQ(draft(fabric_).friction, before);
}

TEST_F(FabricInspector, keeps_the_draft_while_another_fabric_is_shown_and_drops_it_on_cancel) {
    inspector_.click("material.fabric.edit");
    set("fabric.shear", "33");
    choose("material.fabric", "0");
    EXPECT_NE(fabrics().shown(), fabric_);
    EXPECT_FALSE(has("fabric.shear"));
    EXPECT_EQ(draft(fabric_).shear, 33);
    fabrics().show(fabric_);
    inspector_.frame();
    ASSERT_TRUE(has("fabric.shear"));
    inspector_.click("material.fabric.cancel");
    EXPECT_FALSE(fabrics().find(fabric_).draft);
    EXPECT_TRUE(fabrics().changed().empty());
}

TEST_F(FabricInspector, saves_a_shipped_fabric_as_another_file_only) {
    inspector_.click("material.fabric.edit");
    EXPECT_FALSE(has("material.fabric.save"));
    inspector_.click("material.fabric.save_as");
    EXPECT_EQ(inspector_.asked, Asked{"save fabric as " + fabric_});
}

TEST_F(FabricInspector, saves_a_file_once_something_is_changed) {
    inspector_.click("material.fabric.open");
    EXPECT_EQ(inspector_.asked, Asked{"open fabric"});
    inspector_.asked.clear();
    fabrics().open("/f/mine.json");
    inspector_.frame();
    inspector_.click("material.fabric.edit");
    inspector_.click("material.fabric.save");
    EXPECT_TRUE(inspector_.asked.empty());
    set("fabric.gloss", "0.2");
    inspector_.click("material.fabric.save");
    EXPECT_EQ(inspector_.asked, Asked{"save fabric /f/mine.json"});
    EXPECT_EQ(reads_, 1) << "not in every frame";
}

TEST_F(FabricInspector, edits_what_the_fabric_shows_apart_from_the_garment) {
    inspector_.click("material.fabric.edit");
    choose("fabric.surface.kind", "2");
    ASSERT_TRUE(draft(fabric_).surface);
    EXPECT_EQ(draft(fabric_).surface->kind, sim::DesignKind::Colour);
    choose("fabric.surface.kind", "4");
    set("fabric.surface.size", "12");
    set("fabric.surface.rotation", "30");
    EXPECT_EQ(draft(fabric_).surface->size, 0.12);
    EXPECT_NEAR(draft(fabric_).surface->rotation, 0.5236, 1e-4);
    choose("fabric.surface.kind", "3");
    EXPECT_EQ(inspector_.asked, Asked{"open picture for " + fabric_});
    choose("fabric.surface.kind", "0");
    EXPECT_FALSE(draft(fabric_).surface);
    EXPECT_FALSE(inspector_.document().pattern().surface);
    EXPECT_TRUE(inspector_.document().history().empty());
}

TEST_F(FabricInspector, tells_of_a_broken_file_and_reads_it_again) {
    const std::string good = texts_["/f/mine.json"];
    texts_["/f/mine.json"] = "{";
    EXPECT_THROW(fabrics().open("/f/mine.json"), sim::InputError);
    EXPECT_EQ(fabrics().shown(), "");
    fabrics().show("/f/mine.json");
    inspector_.frame();
    inspector_.frame();
    EXPECT_EQ(reads_, 2);
    EXPECT_EQ(fabrics().find("/f/mine.json").problem, "/f/mine.json: not JSON");
    inspector_.click("material.fabric.edit");
    EXPECT_FALSE(fabrics().find("/f/mine.json").draft);
    texts_["/f/mine.json"] = good;
    inspector_.click("material.fabric.again");
    EXPECT_EQ(fabrics().find("/f/mine.json").problem, "");
    inspector_.frame();
    inspector_.click("material.fabric.edit");
    EXPECT_TRUE(fabrics().find("/f/mine.json").draft);
}

TEST_F(FabricInspector, is_used_for_several_panels_by_one_step_of_undo) {
    Selection selection;
    for (const sim::Panel& panel : inspector_.document().pattern().panels) selection.panels.insert(panel.name);
    ASSERT_EQ(selection.panels.size(), 2U);
    inspector_.document().select(selection);
    fabrics().show("denim");
    inspector_.frame();
    inspector_.click("material.fabric.panels");
    for (const sim::Panel& panel : inspector_.document().pattern().panels) EXPECT_EQ(panel.fabric, "denim");
    EXPECT_EQ(inspector_.document().history().size(), 1U);
    inspector_.document().undo();
    for (const sim::Panel& panel : inspector_.document().pattern().panels) EXPECT_EQ(panel.fabric, "");
}

TEST_F(FabricInspector, stays_inside_a_narrow_window) {
    InspectorFixture narrow(shipped_pattern("skirt.json"), draw_fabric, {.width_px = 17 * 13});
    narrow.click("material.fabric.edit");
    narrow.frame();
    EXPECT_LE(narrow.overhang_px(), 0.5F);
}

TEST(FabricLibrary, keeps_a_draft_when_its_file_is_read_again_or_opened_or_written) {
    std::string text = sim::read_fabric_file("linen").text;
    FabricLibrary fabrics([&](const std::string& name) {
        return sim::FabricFile{sim::parse_fabric(text, name), text};
    });
    fabrics.begin_draft("a.json");
    sim::Fabric draft = fabrics.find("a.json").draft.value();
    draft.shear = 70;
    fabrics.set_draft("a.json", draft);
    text = sim::read_fabric_file("denim").text;
    fabrics.open("a.json");
    EXPECT_EQ(fabrics.find("a.json").file.fabric.name, "linen") << "of which it is a draft";
    EXPECT_EQ(fabrics.version(), 0U);
    fabrics.read_again("a.json");
    EXPECT_EQ(fabrics.find("a.json").file.fabric.name, "denim");
    fabrics.begin_draft("a.json");
    EXPECT_EQ(fabrics.find("a.json").draft, draft);
    fabrics.take_written("a.json", {draft, text});
    EXPECT_EQ(fabrics.find("a.json").draft, draft);
    EXPECT_TRUE(fabrics.changed().empty());
    EXPECT_EQ(fabrics.version(), 2U);
    EXPECT_EQ(fabrics.files(), Asked{"a.json"});
}

}  // namespace
}  // namespace selvedge::editor
