#include "editor/document/journal.h"

#include <gtest/gtest.h>

#include <utility>

#include "editor/document/command.h"
#include "editor/document/document.h"
#include "sim/core/error.h"
#include "tests/editor/document/support.h"
#include "tests/support/checkout.h"

namespace selvedge::editor {
namespace {

// A document with its journal as text.
struct Journaled {
    explicit Journaled(const std::string& name) : Journaled(shipped(name), name) {}
    Journaled(sim::PatternDocument source, const std::string& file) : document(std::move(source)) {
        text = journal_head(file, document.text()) + "\n";
        document.set_journal([this](std::string_view line) { text += std::string(line) + "\n"; });
    }
    Document document;
    std::string text;
};

TEST(Journal, gives_back_all_that_was_done) {
    Journaled journaled("tshirt.json");
    Document& document = journaled.document;
    document.run(MoveVertices{.vertices = {{"front", 0}}, .by = Vec2d(0.0123456789, -0.02)});
    document.run(AddVertex{.panel = "back", .edge = 2, .t = 1.0 / 3});
    document.undo();
    document.run(SetGrain{.panel = "back", .angle = 0.1});
    document.preview(MoveVertices{.vertices = {{"back", 1}}, .by = Vec2d(0.01, 0)});
    document.preview(MoveVertices{.vertices = {{"back", 1}}, .by = Vec2d(0.011, 0)});
    document.commit();
    const auto recovery = recover(journaled.text);
    ASSERT_TRUE(recovery);
    EXPECT_EQ(recovery->file, "tshirt.json");
    EXPECT_EQ(recovery->text, document.text());
}

TEST(Journal, gives_back_garments_that_were_put_on_and_taken_off) {
    Journaled journaled("tshirt.json");
    const std::string skirt = write_pattern(sim::load_pattern(source_folder() + "/patterns/skirt.json"));
    for (int i = 0; i < 2; ++i) journaled.document.run(PutOver{.file = "skirt.json", .text = skirt});
    journaled.document.run(TakeOff{.garment = "skirt"});
    const auto recovery = recover(journaled.text);
    ASSERT_TRUE(recovery);
    EXPECT_EQ(recovery->text, journaled.document.text());
    EXPECT_NE(recovery->text.find("skirt_2"), std::string::npos);
}

TEST(Journal, of_a_document_that_was_never_saved_can_be_opened_with_the_body_file_that_it_names) {
    Journaled journaled(shipped("tshirt.json"), "");
    journaled.document.run(SetBody{.body = "/scans/anna.obj"});
    const auto recovery = recover(journaled.text);
    ASSERT_TRUE(recovery);
    EXPECT_EQ(recovery->file, "");
    EXPECT_EQ(sim::parse_pattern(recovery->text, recovery->file).pattern.body, "/scans/anna.obj");
}

TEST(Journal, gives_back_a_garment_that_was_just_begun) {
    Journaled journaled(sim::PatternDocument{}, "");
    const auto begun = recover(journaled.text);
    ASSERT_TRUE(begun);
    EXPECT_EQ(begun->changes, 0);
    journaled.document.run(SetBody{.body = "mannequin:sex=male"});
    const auto recovery = recover(journaled.text);
    ASSERT_TRUE(recovery);
    EXPECT_EQ(recovery->changes, 1);
    EXPECT_EQ(sim::parse_pattern(recovery->text, "").pattern.body, "mannequin:sex=male");
}

TEST(Journal, gives_back_what_was_edited_of_fabrics_and_not_saved) {
    Journaled journaled("two_squares.json");
    const auto add = [&](const sim::Json& line) { journaled.text += write_json(line, -1) + "\n"; };
    sim::Fabric silk = sim::find_fabric("silk"), mine = sim::find_fabric("denim");
    silk.area_density = 0.1234567890123;
    add(journal_draft("silk", silk));
    journaled.document.run(SetEdgeLength{.length = 0.03});
    mine.surface = sim::SurfaceDesign{.kind = sim::DesignKind::Picture, .source = "/pictures/roses.png"};
    add(journal_draft("/f/mine.json", mine));
    silk.name = "of me";
    add(journal_draft("silk", silk));
    add(journal_draft("linen", mine));
    add(journal_no_draft("linen"));
    add(journal_no_draft("jersey"));
    const auto recovery = recover(journaled.text + "{\"draft\": {\"fabric\": \"wool\", \"te");
    ASSERT_TRUE(recovery);
    EXPECT_EQ(recovery->changes, 1) << "of the document";
    EXPECT_EQ(recovery->text, journaled.document.text());
    EXPECT_EQ(recovery->drafts, (std::map<std::string, sim::Fabric>{{"/f/mine.json", mine}, {"silk", silk}}));
}

TEST(Journal, gives_back_several_commands_as_one_step) {
    Journaled journaled("two_squares.json");
    const std::string before = journaled.document.text();
    journaled.document.run_together(
        {SetFabric{.panel = "front", .fabric = "silk"}, SetLayer{.panel = "back", .layer = 2}});
    EXPECT_EQ(recover(journaled.text)->text, journaled.document.text());
    EXPECT_EQ(recover(journaled.text)->changes, 1);
    journaled.document.undo();
    EXPECT_EQ(recover(journaled.text)->text, before);
}

TEST(Journal, counts_a_drag_as_one_change) {
    Journaled journaled("tshirt.json");
    const auto drag = [&](int moves) {
        for (int i = 1; i <= moves; ++i)
            journaled.document.preview(MoveVertices{.vertices = {{"back", 1}}, .by = Vec2d(0.0005 * i, 0)});
    };
    drag(24);
    journaled.document.commit();
    EXPECT_EQ(recover(journaled.text)->changes, 1);
    drag(12);
    EXPECT_EQ(recover(journaled.text)->changes, 2) << "one and a half";
    journaled.document.rollback();
    EXPECT_EQ(recover(journaled.text)->changes, 1);
    journaled.document.undo();
    EXPECT_EQ(recover(journaled.text)->changes, 0);
    EXPECT_TRUE(recover(journaled.text)->has_changes()) << "it may be redone";
}

TEST(Journal, gives_back_a_drag_that_was_under_way) {
    Journaled journaled("tshirt.json");
    journaled.document.preview(MoveVertices{.vertices = {{"back", 1}}, .by = Vec2d(0.01, 0)});
    const auto recovery = recover(journaled.text);
    ASSERT_TRUE(recovery);
    EXPECT_EQ(recovery->text, journaled.document.text());
}

TEST(Journal, torn_at_any_byte_gives_back_what_came_before) {
    Journaled journaled("two_squares.json");
    std::vector<std::string> states{journaled.document.text()};
    for (int i = 0; i < 5; ++i) {
        journaled.document.run(SetLayer{.panel = journaled.document.pattern().panels[0].name, .layer = i + 1});
        states.push_back(journaled.document.text());
    }
    const std::size_t head = journaled.text.find('\n') + 1;
    for (std::size_t size = 0; size < journaled.text.size(); ++size) {
        const auto recovery = recover(std::string_view(journaled.text).substr(0, size));
        EXPECT_EQ(recovery.has_value(), size >= head);
        if (recovery) {
            EXPECT_EQ(recovery->text, states[static_cast<std::size_t>(recovery->changes)]);
        }
    }
}

TEST(Journal, lines_that_are_no_journals_end_it) {
    Journaled journaled("two_squares.json");
    journaled.document.run(SetEdgeLength{.length = 0.03});
    const std::string sound = journaled.document.text();
    for (const char* line : {"nonsense", "{\"do\": {\"fly\": {}}}", "{\"do\": {\"set_layer\": {\"panel\": 3}}}", "{}",
                             "{\"do\": []}", "{\"try\": {\"rename_panel\": {\"panel\": \"front\", \"to\": \"a\"}}}"}) {
        const auto recovery = recover(journaled.text + line + "\n{\"undo\":true}\n{\"torn");
        ASSERT_TRUE(recovery) << line;
        EXPECT_EQ(recovery->text, sound) << line;
        EXPECT_EQ(recovery->unread_lines, 2) << line;
    }
    EXPECT_EQ(recover(journaled.text + "{\"torn")->unread_lines, 0) << "as a crash leaves it";
    EXPECT_FALSE(recover(""));
    EXPECT_FALSE(recover("{\"selvedge_journal\": 1}\n"));
    EXPECT_FALSE(recover("{\"selvedge_journal\": 2, \"file\": \"\", \"text\": \"{}\"}\n"));
}

TEST(CommandJson, every_command_survives) {
    sim::Panel panel;
    panel.name = "gore";
    panel.vertices = {{0, 0}, {0.2, 0}, {0.1, 0.3}};
    panel.edges = {
        {.start = 0, .end = 1, .kind = sim::CurveKind::Cubic, .control = {Vec2d(0.1, -0.01), Vec2d(0.15, 0)}},
        {.start = 1, .end = 2, .kind = sim::CurveKind::Arc, .arc_radius = 0.4, .turns_right = true},
        {.start = 2, .end = 0, .label = "side"}};
    panel.notches = {{.edge = 1, .t = 0.25}};
    panel.label = "leg";
    panel.sheet_position = Vec2d(1, 2);
    panel.internal_lines = {{.name = "pocket", .points = {{0.05, 0.05}, {0.1, 0.05}}}};
    const std::vector<Command> commands{
        AddPanels{
            .panels = {panel},
            .seams = {{.first = {0, 0}, .second = {0, 1}, .is_reversed = false, .name = "tuck", .is_eased = true}}},
        DuplicatePanels{.panels = {"a", "b"}, .shift = Vec2d(0.3, 0), .move = Vec3d(0.4, 0, 0)},
        SetBody{.body = "mannequin:bust=92", .shifts = {Vec3d(0, 0.01, 0)}},
        TransformPanels{.panels = {"a", "b"}, .map = {.x_axis = {0, 1}, .y_axis = {-1, 0}}, .what = "Rotate"},
        SetEdgeLength{},
        ReplaceFabric{.from = "silk", .to = "/f/mine.json"},
        SetAllowance{.panel = "a", .edge = 2, .width = 0.01, .corner = sim::AllowanceCorner::Squared},
        SetSurface{.panel = "a", .surface = sim::SurfaceDesign{.kind = sim::DesignKind::Colour, .source = "#102030"}},
        SetUnderlays{.underlays = {{.file = "a.png", .position = Vec2d(1, 2), .pixel_size = 0.002, .opacity = 0.5}}},
        SewRuns{.first = {{"a", 1, 0.25, 1}}, .second = {{"b", 2, 0, 0.5}, {"b", 3, 0, 1}}, .is_reversed = false},
        PlacePanel{.panel = "a", .translation = Vec3d(1, 2, 3), .wrap_radius = 0.2},
        SetTartan{.tartan = "K/8 R24 W/4", .size = 0.1, .position = Vec2d(0.01, 0)},
        RemoveParts{.vertices = {{"a", 1}}, .seams = {2, 3}}};
    for (const Command& command : commands) {
        const std::string text = write_json(to_json(command));
        const sim::Json json = sim::parse_json(text, "test");
        const Command again = parse_command(sim::JsonView(json, "test"));
        EXPECT_EQ(again.index(), command.index());
        EXPECT_EQ(write_json(to_json(again)), text);
    }
    const sim::Json json = to_json(commands[0]);
    EXPECT_EQ(std::get<AddPanels>(parse_command(sim::JsonView(json, "test"))).panels[0], panel);
    EXPECT_EQ(std::get<AddPanels>(parse_command(sim::JsonView(json, "test"))).seams,
              std::get<AddPanels>(commands[0]).seams);
}

TEST(CommandJson, says_where_it_is_wrong) {
    const auto problem_of = [](const std::string& text) {
        const sim::Json json = sim::parse_json(text, "script");
        try {
            parse_command(sim::JsonView(json, "script"));
        } catch (const sim::InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(problem_of(R"({"fly": {}})"), "script: there is no command 'fly'");
    EXPECT_EQ(problem_of(R"({"set_layer": {"layr": 1}})"), "script: set_layer.layr: there is no such field");
    EXPECT_NE(problem_of(R"({"move_vertices": {"by": [1]}})"), "");
    EXPECT_NE(problem_of(R"({"move_vertices": {"by": [1, 1e300]}})"), "");
    EXPECT_NE(problem_of(R"({"set_curve": {"curve": {"kind": "wavy"}}})"), "");
    EXPECT_NE(problem_of(R"({"undo": {}, "redo": {}})"), "");
}

}  // namespace
}  // namespace selvedge::editor
