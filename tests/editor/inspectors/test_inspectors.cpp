// All inspectors with the shipped patterns, in an offscreen window.
#include <gtest/gtest.h>
#include <array>

#include "editor/inspectors/body_inspector.h"
#include "editor/inspectors/drape_inspector.h"
#include "editor/inspectors/material_inspector.h"
#include "sim/tartan/tartan_file.h"
#include "tests/editor/inspectors/inspector_support.h"

namespace selvedge::editor {
namespace {

constexpr std::array<InspectorFixture::Draw, 6> kInspectors{draw_properties, draw_seams, draw_materials,
                                                            draw_body,       draw_drape, draw_history};
constexpr std::array<const char*, 5> kPatterns{"tshirt.json", "tshirt_thesis.json", "skirt.json", "poncho.json",
                                               "two_squares.json"};

std::vector<Selection> selections(const sim::Pattern& pattern) {
    std::vector<Selection> list(7);
    const std::string& first = pattern.panels[0].name;
    list[1].panels.insert(first);
    for (const sim::Panel& panel : pattern.panels) list[2].panels.insert(panel.name);
    list[3].vertices.insert({first, 0});
    list[4].vertices = {{first, 0}, {first, 1}};
    for (int i = 0; i < static_cast<int>(pattern.panels[0].edges.size()); ++i) list[5].edges.insert({first, i});
    for (int i = 0; i < static_cast<int>(pattern.seams.size()); ++i) list[6].seams.insert(i);
    Selection one;
    one.seams.insert(0);
    one.notches.insert({first, 0});
    one.internal_lines.insert({first, 0});
    list.push_back(one);
    return list;
}

void add_parts(Document& document) {
    const std::string panel = document.pattern().panels[0].name;
    document.run(AddNotch{.panel = panel, .edge = 0, .t = 0.3});
    document.run(AddInternalLine{.panel = panel, .line = {"pocket", {{0.01, 0.02}, {0.05, 0.02}}}});
    sim::OutlineEdge arc = document.pattern().panels[0].edges[0];
    arc.kind = sim::CurveKind::Arc;
    arc.arc_radius = 2;
    document.run(SetCurve{.panel = panel, .edge = 0, .curve = arc});
}

bool is_inside(const WidgetBox& box, const WindowSize& size) {
    return box.low.x() >= 0 && box.high.x() <= size.width_px * size.scale;
}

class AllInspectors : public testing::TestWithParam<WindowSize> {};

TEST_P(AllInspectors, stay_inside_their_window_whatever_is_selected) {
    for (const char* file : kPatterns) {
        InspectorFixture desk(shipped_pattern(file), draw_properties, GetParam());
        add_parts(desk.document());
        desk.document().undo();
        for (const Selection& selected : selections(desk.document().pattern())) {
            desk.document().select(selected);
            for (std::size_t i = 0; i < kInspectors.size(); ++i) {
                desk.show(kInspectors[i]);
                desk.frame();
                desk.frame();
                EXPECT_LE(desk.overhang_px(), 0.5F) << file << ", inspector " << i;
                for (const auto& [name, box] : desk.widgets) EXPECT_TRUE(is_inside(box, GetParam())) << name;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Widths, AllInspectors,
                         testing::Values(WindowSize{.width_px = 260, .scale = 1},
                                         WindowSize{.width_px = 300, .scale = 2},
                                         WindowSize{.width_px = 420, .scale = 1},
                                         WindowSize{.width_px = 420, .scale = 2}));

TEST(Inspectors, show_an_empty_pattern) {
    InspectorFixture desk({}, draw_properties);
    for (const InspectorFixture::Draw draw : kInspectors) {
        desk.show(draw);
        desk.frame();
        desk.frame();
    }
    EXPECT_TRUE(desk.document().history().empty());
}

TEST(SeamInspector, a_click_selects_a_seam_and_the_buttons_change_it) {
    InspectorFixture desk(shipped_pattern("tshirt.json"), draw_seams);
    desk.click("seams.2");
    EXPECT_EQ(desk.document().selection().seams, std::set<int>{2});
    EXPECT_EQ(desk.workspace.hover.seam, std::optional<int>(2)) << "lights up where the cursor rests";
    const bool was_reversed = desk.document().pattern().seams[2].is_reversed;
    desk.click("seam.reverse");
    EXPECT_NE(desk.document().pattern().seams[2].is_reversed, was_reversed);
    desk.click("seam.delete");
    EXPECT_EQ(desk.document().pattern().seams.size(), 11U);
}

TEST(MaterialInspector, a_click_takes_a_tartan_and_its_picture_is_made_once) {
    InspectorFixture desk(shipped_pattern("skirt.json"), draw_materials);
    desk.frame();
    EXPECT_TRUE(desk.output.pictures.empty()) << "held since the first frame";
    desk.click("tartan.anderson");
    EXPECT_EQ(desk.document().pattern().tartan, "anderson");
}

TEST(MaterialInspector, a_threadcount_is_tried_in_the_preview_and_told_when_it_is_wrong) {
    InspectorFixture desk(shipped_pattern("skirt.json"), draw_materials);
    desk.click("tartan.threadcount");
    desk.type("K8 W");
    EXPECT_FALSE(desk.state.boxes.typed.wrong.empty());
    desk.type("8");
    EXPECT_TRUE(desk.state.boxes.typed.wrong.empty());
    desk.frame();
    EXPECT_EQ(desk.state.material.previewed.substr(0, 5), "K8 W8");
    EXPECT_NE(desk.document().pattern().tartan, "K8 W8") << "not before Enter";
    desk.key(ImGuiKey_Enter);
    EXPECT_EQ(desk.document().pattern().tartan, "K8 W8");
}

TEST(MaterialInspector, stripes_are_matched_and_the_result_is_told_by_seam) {
    InspectorFixture desk(shipped_pattern("skirt.json"), draw_materials);
    desk.frame();
    desk.click("material.match");
    EXPECT_EQ(desk.state.material.matched.size(), desk.document().pattern().seams.size());
    EXPECT_TRUE(desk.document().pattern().matched_sett);
}

TEST(HistoryInspector, a_click_goes_back_and_forth) {
    InspectorFixture desk(shipped_pattern("skirt.json"), draw_history);
    desk.document().run(RenamePattern{"a"});
    desk.document().run(RenamePattern{"b"});
    desk.frame();
    desk.click("history.1");
    EXPECT_EQ(desk.document().pattern().name, "a");
    EXPECT_EQ(desk.document().position(), 1U);
    desk.click("history.2");
    EXPECT_EQ(desk.document().pattern().name, "b");
    desk.click("history.0");
    EXPECT_EQ(desk.document().position(), 0U);
}

TEST(BodyInspector, a_measure_becomes_the_documents_with_the_panels_moved_along) {
    InspectorFixture desk(shipped_pattern("tshirt.json"), draw_body);
    desk.workspace.drape.follow(desk.document(), desk.workspace.messages);
    desk.frame();
    const double before = desk.panel(0).translation.y();
    desk.click("body.height");
    desk.type("175");
    desk.key(ImGuiKey_Enter);
    EXPECT_EQ(desk.state.body.pending, "mannequin:sex=female,height=175");
    desk.workspace.drape.follow(desk.document(), desk.workspace.messages);
    desk.frame();
    EXPECT_EQ(desk.document().pattern().body, "mannequin:sex=female,height=175");
    EXPECT_GT(desk.panel(0).translation.y(), before + 0.05) << "the panel stands as high on the taller body";
    EXPECT_TRUE(desk.state.body.pending.empty());
    desk.document().undo();
    EXPECT_EQ(desk.panel(0).translation.y(), before);
}

TEST(BodyInspector, a_measure_that_no_body_has_is_told_and_not_worn) {
    InspectorFixture desk(shipped_pattern("tshirt.json"), draw_body);
    desk.click("body.bust");
    desk.type("12");
    desk.key(ImGuiKey_Enter);
    EXPECT_NE(desk.state.body.wrong.find("bust"), std::string::npos);
    EXPECT_TRUE(desk.state.body.pending.empty());
    EXPECT_TRUE(desk.document().history().empty());
}

TEST(DrapeInspector, options_are_typed_and_switched) {
    InspectorFixture desk(shipped_pattern("skirt.json"), draw_drape);
    desk.click("drape.max_level");
    desk.type("2");
    desk.key(ImGuiKey_Enter);
    EXPECT_EQ(desk.workspace.drape.options().max_level, 2);
    desk.click("drape.gravity");
    EXPECT_FALSE(desk.workspace.drape.options().has_gravity);
    desk.click("drape.budget");
    desk.type("2500");
    desk.key(ImGuiKey_Enter);
    EXPECT_EQ(desk.workspace.drape.options().triangle_budget, std::optional<int>(2500));
}

}  // namespace

// Text of fabrics, threadcounts, mannequins and drapes.

namespace {

std::string value_of(const sim::Fabric& fabric, const std::string& label) {
    for (const FabricRow& row : fabric_rows(fabric)) {
        if (row.label == label) return row.value;
    }
    return "";
}

TEST(FabricText, speaks_in_units_of_the_trade) {
    const sim::Fabric fabric;
    EXPECT_EQ(value_of(fabric, "Weight"), "120 g/m\u00B2");
    EXPECT_EQ(value_of(fabric, "Stretch"), "8000 \u00D7 5000 N/m");
    EXPECT_EQ(value_of(fabric, "Bending"), "9 \u00D7 6 \u00B5N\u00B7m");
    EXPECT_EQ(value_of(fabric, "Thickness"), "0.28 mm");
    EXPECT_EQ(value_of(fabric, "Strain limit"), "3 %");
}

TEST(FabricText, names_are_made_readable) {
    EXPECT_EQ(readable_name("wool_twill_light"), "Wool twill light");
    EXPECT_EQ(readable_name("cloths/my_wool.json"), "my_wool.json");
}

TEST(ThreadcountText, every_tartan_that_ships_is_woven_alike_from_it) {
    EXPECT_FALSE(sim::shipped_tartans().empty());
    for (const std::string& name : sim::shipped_tartans()) {
        const sim::Sett sett = sim::find_tartan(name);
        const std::string text = threadcount_of(sett);
        ASSERT_EQ(tartan_error(text), "") << name << ": " << text;
        const sim::Sett again = sim::find_tartan(text);
        EXPECT_EQ(thread_colours(again), thread_colours(sett)) << name << ": " << text;
        EXPECT_EQ(weft_thread_colours(again), weft_thread_colours(sett)) << name << ": " << text;
        EXPECT_EQ(again.weave, sett.weave) << name;
    }
}

TEST(ThreadcountText, tells_what_is_wrong) {
    EXPECT_NE(tartan_error("K8 ?5"), "");
    EXPECT_EQ(tartan_error("K8 W8"), "");
    sim::Pattern pattern;
    pattern.tartan = "K8 ?5";
    EXPECT_FALSE(valid_sett(pattern));
}

TEST(ThreadcountText, tartans_are_found_by_parts_of_their_words) {
    EXPECT_TRUE(has_words("Hunting Stewart", "stew hunt"));
    EXPECT_FALSE(has_words("Hunting Stewart", "stew dress"));
    EXPECT_TRUE(has_words("Hunting Stewart", ""));
}

TEST(BodyText, only_what_is_set_is_written_and_read_back) {
    sim::MannequinOptions options{.sex = sim::Sex::Male};
    options.measures.bust = 1.02;
    options.measures.mid_thigh = 0.525;
    options.stance = 0.0349065850398866;  // 2 degrees
    const std::string text = mannequin_text(options);
    EXPECT_EQ(text, "mannequin:sex=male,bust=102,mid_thigh=52.5,stance=2");
    EXPECT_EQ(wrong_with_body(text), "");
    EXPECT_EQ(mannequin_text(sim::parse_mannequin(text)), text);
}

TEST(BodyText, measures_out_of_range_are_told) {
    EXPECT_NE(wrong_with_body("mannequin:bust=20").find("bust"), std::string::npos);
    EXPECT_EQ(wrong_with_body("somebody.obj"), "") << "files are tried by those who read them";
}

TEST(BodyText, every_measure_has_words) {
    for (const std::string_view name : sim::measure_names()) EXPECT_STRNE(measure_tip(name), "") << name;
    EXPECT_EQ(measure_label("bust", sim::Sex::Male), "Chest");
    EXPECT_EQ(measure_label("high_hip", sim::Sex::Female), "High hip");
}

TEST(DrapeText, counts_have_commas) {
    EXPECT_EQ(count_text(0), "0");
    EXPECT_EQ(count_text(999), "999");
    EXPECT_EQ(count_text(1000), "1,000");
    EXPECT_EQ(count_text(1234567), "1,234,567");
}

TEST(DrapeText, rejoining_stays_below_splitting) {
    const sim::CurvatureOptions usual;
    EXPECT_LT(curvature_with(usual, 0.05, {}).rejoin_angle, 0.05F);
    EXPECT_LT(curvature_with(usual, {}, 1.0).rejoin_angle, usual.split_angle);
    EXPECT_EQ(curvature_with(usual, {}, {}).rejoin_angle, usual.rejoin_angle);
}

TEST(DrapeText, kept_drapes_get_names_of_their_own) {
    EXPECT_EQ(free_drape_name({}, ""), "drape");
    EXPECT_EQ(free_drape_name({"drape", "drape 2"}, ""), "drape 3");
    EXPECT_EQ(free_drape_name({"wide"}, "wide"), "wide 2");
}

sim::SessionFrame running_frame(std::uint64_t number) {
    sim::SessionFrame frame;
    frame.number = number;
    frame.is_running = true;
    frame.statistics.leaf_triangles = static_cast<int>(number);
    return frame;
}

TEST(DrapeTrace, keeps_the_newest_frames_in_their_order) {
    DrapeTrace trace;
    for (std::uint64_t number = 1; number <= DrapeTrace::kLength + 5; ++number) trace.take(running_frame(number));
    ASSERT_EQ(trace.size(), DrapeTrace::kLength);
    EXPECT_EQ(trace.triangles(0), 6.0F);
    EXPECT_EQ(trace.triangles(trace.size() - 1), static_cast<float>(DrapeTrace::kLength + 5));
}

TEST(DrapeTrace, takes_no_frame_twice_and_none_that_stands) {
    DrapeTrace trace;
    trace.take(running_frame(1));
    trace.take(running_frame(1));
    sim::SessionFrame paused = running_frame(2);
    paused.is_running = false;
    trace.take(paused);
    EXPECT_EQ(trace.size(), 1U);
}

}  // namespace

}  // namespace selvedge::editor
