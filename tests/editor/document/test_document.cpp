#include <gtest/gtest.h>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "editor/document/document.h"
#include "editor/document/journal.h"
#include "editor/geometry/draft.h"
#include "sim/pattern/garments.h"
#include "tests/editor/document/random_commands.h"
#include "tests/editor/document/support.h"

namespace selvedge::editor {
namespace {

Command move_point(const std::string& panel, int vertex, const Vec2d& by) {
    return MoveVertices{.vertices = {{panel, vertex}}, .by = by};
}

const sim::Panel& panel_named(const Document& document, const std::string& name) {
    for (const sim::Panel& panel : document.pattern().panels) {
        if (panel.name == name) return panel;
    }
    throw std::runtime_error("no panel " + name);
}

// Of the T-shirt, whose right sleeve is rounded otherwise than the left one that it mirrors, one number differs.
TEST(Document, of_a_shipped_file_has_its_text) {
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() + "/patterns")) {
        if (entry.path().extension() != ".json") continue;
        Document document(sim::load_pattern(entry.path()));
        EXPECT_TRUE(document.take_notes().empty()) << entry.path();
        std::string text = write_json(sim::read_json(entry.path()));
        if (const std::size_t rounded = text.find("0.1005"); entry.path().filename() == "tshirt.json")
            text.replace(rounded, 6, "0.1004");
        EXPECT_EQ(document.text(entry.path().string()), text) << entry.path();
    }
}

TEST(Document, a_command_is_undone_and_redone_byte_for_byte) {
    Document document(shipped("tshirt.json"));
    const std::string first = document.text();
    document.run(move_point("front", 0, Vec2d(0.01, 0.02)));
    const std::string second = document.text();
    EXPECT_NE(first, second);
    document.undo();
    EXPECT_EQ(document.text(), first);
    EXPECT_FALSE(document.can_undo());
    document.redo();
    EXPECT_EQ(document.text(), second);
    EXPECT_FALSE(document.can_redo());
}

TEST(Document, takes_no_value_that_a_file_may_not_hold) {
    Document document(shipped("tshirt.json"));
    const std::string before = document.text();
    const std::vector<Command> commands{SetLayer{.panel = "front", .layer = sim::kHighestLayer + 1},
                                        SetLayer{.panel = "front", .layer = -sim::kHighestLayer - 1},
                                        PlacePanel{.panel = "front", .translation = {0, 0, 101}},
                                        TranslateAll{.by = {-120, 0, 0}},
                                        MovePanels{.panels = {"front"}, .by = {0, 150}},
                                        SetSettOffset{.panel = "front", .offset = {101, 0}}};
    for (const Command& command : commands) {
        EXPECT_THROW(document.run(command), GeometryError) << label_of(command);
        EXPECT_THROW(document.preview(command), GeometryError) << label_of(command);
        EXPECT_EQ(document.text(), before) << label_of(command);
    }
    document.run(SetLayer{.panel = "front", .layer = sim::kHighestLayer});
    document.run(PlacePanel{.panel = "front", .translation = {0, 0, 99}});
    EXPECT_NO_THROW(sim::parse_pattern(document.text(), "f.json"));
}

TEST(Document, several_commands_are_one_step_or_none) {
    Document document(shipped("tshirt.json"));
    const std::string before = document.text();
    document.run_together(
        {SetFabric{.panel = "front", .fabric = "silk"}, SetFabric{.panel = "back", .fabric = "silk"}});
    EXPECT_EQ(panel_named(document, "front").fabric, "silk");
    EXPECT_EQ(panel_named(document, "back").fabric, "silk");
    ASSERT_EQ(document.history().size(), 1U);
    EXPECT_EQ(document.history()[0].label, "Change fabric");
    document.undo();
    EXPECT_EQ(document.text(), before);
    EXPECT_THROW(document.run_together({SetLayer{.panel = "front", .layer = 1}, SetLayer{.panel = "nobody"}}),
                 GeometryError);
    EXPECT_THROW(document.run_together({SetLayer{.panel = "front", .layer = 1}, RenamePanel{"front", "vorn"}}),
                 GeometryError);
    EXPECT_EQ(document.text(), before);
}

// A shape that is locked stays as it is: the change of the panel that it mirrors is refused.
TEST(Document, a_locked_panel_does_not_follow_its_mirror_image) {
    for (const bool is_image_locked : {true, false}) {
        Document document(shipped("two_squares.json"));
        document.run(SymmetricCopy{.panels = {"front"}, .is_linked = true});
        const std::string image = document.pattern().panels.back().name;
        ASSERT_EQ(document.pattern().panels.back().mirror_of, "front");
        const std::string locked = is_image_locked ? image : "front", other = is_image_locked ? "front" : image;
        document.set_panel_states({.hidden = {}, .locked = {locked}});
        const std::string before = document.text();
        const std::vector<Command> refused{move_point(other, 0, Vec2d(-0.01, 0)),
                                           AddDart{.panel = other, .edge = 0, .width = 0.02, .depth = 0.08},
                                           SetFabric{.panel = other, .fabric = "silk"}};
        for (const Command& command : refused) {
            try {
                document.run(command);
                FAIL() << label_of(command);
            } catch (const GeometryError& error) {
                EXPECT_EQ(std::string(error.what()), "'" + locked + "' is locked and linked to its mirror image '" +
                                                         other + "': unlock or unlink it first");
                EXPECT_EQ(error.places().at(0).panel, locked);
            }
            EXPECT_THROW(document.preview(command), GeometryError);
            EXPECT_FALSE(document.is_previewing());
            EXPECT_EQ(document.text(), before);
        }
        document.run(TranslateAll{.by = Vec3d(0.1, 0, 0)});  // is about all panels
        document.run(move_point("back", 0, Vec2d(-0.01, 0)));
        document.run(UnlinkPanel{locked});
        document.run(move_point(other, 0, Vec2d(-0.01, 0)));
        document.undo();
        document.undo();
        document.set_panel_states({});
        document.run(move_point(other, 0, Vec2d(-0.01, 0)));
    }
}

TEST(Document, a_garment_is_put_over_taken_off_and_both_are_undone) {
    Document document(shipped("tshirt.json"));
    const std::string alone = document.text();
    document.run(PutOver{.file = "skirt.json", .text = write_pattern(shipped("skirt.json"))});
    EXPECT_EQ(garment_names(document.pattern()), (std::vector<std::string>{"tshirt", "skirt"}));
    EXPECT_EQ(document.selection().panels, (std::set<std::string>{"skirt_front", "skirt_back"}));
    const std::string both = document.text();
    document.run(TakeOff{.garment = "tshirt"});
    EXPECT_EQ(garment_names(document.pattern()), std::vector<std::string>{"skirt"});
    document.undo();
    EXPECT_EQ(document.text(), both);
    document.undo();
    EXPECT_EQ(document.text(), alone);
    EXPECT_THROW(document.run(TakeOff{.garment = "skirt"}), GeometryError);
    EXPECT_THROW(document.run(PutOver{.file = "f.json", .text = "{}"}), GeometryError);
    EXPECT_EQ(document.text(), alone);
}

TEST(Document, tells_each_warning_once_and_ended_links_last_when_a_file_is_opened) {
    sim::Json file = sim::read_json(source_folder() + "/patterns/two_squares.json");
    sim::Json& back = file["pattern"]["panels"]["back"]["selvedge"];
    back["copy_of"] = "front";
    back["grainlin"] = sim::Json(0.0);
    const std::string text = write_json(file);
    const std::vector<std::string> expected{
        "pattern.panels.back.selvedge.grainlin: unknown key 'grainlin': is 'grainline' meant?",
        "'back' is not the copy of 'front': the link is not followed"};
    Document opened(sim::parse_pattern(text, "two.json"));
    EXPECT_EQ(opened.take_notes(), expected);
    Document under(shipped("tshirt.json"));
    under.run(PutOver{.file = "two.json", .text = text});
    EXPECT_EQ(under.take_notes(), expected);
    file["selvedge"]["format"] = sim::Json(sim::kGarmentFormat + 1);
    Document newer(sim::parse_pattern(write_json(file), "two.json"));
    EXPECT_TRUE(newer.read_only_reason());
    EXPECT_EQ(newer.take_notes(), expected) << "that it is not saved is told apart";
}

TEST(Document, a_failed_command_changes_nothing) {
    Document document(shipped("tshirt.json"));
    const sim::Pattern before = document.pattern();
    EXPECT_THROW(document.run(move_point("nobody", 0, Vec2d(0.01, 0))), GeometryError);
    EXPECT_THROW(document.run(SetFabric{.panel = "", .fabric = "cardboard"}), GeometryError);
    EXPECT_THROW(document.run(ReverseSeam{.seam = 99}), GeometryError);
    EXPECT_THROW(document.run(SetPins{.panel = "front", .vertices = {77}}), GeometryError);
    EXPECT_EQ(document.pattern(), before);
    EXPECT_TRUE(document.history().empty());
}

TEST(Document, a_drag_is_one_entry_of_the_history) {
    Document document(shipped("tshirt.json"));
    const std::string first = document.text();
    const Vec2d start = panel_named(document, "front").vertices[0];
    for (int i = 1; i <= 10; ++i) document.preview(move_point("front", 0, Vec2d(0.001 * i, 0)));
    EXPECT_TRUE(document.is_previewing());
    EXPECT_NEAR(panel_named(document, "front").vertices[0].x() - start.x(), 0.010, 1e-12);
    document.commit();
    ASSERT_EQ(document.history().size(), 1U);
    EXPECT_EQ(document.history()[0].label, "Move point");
    document.undo();
    EXPECT_EQ(document.text(), first);
}

TEST(Document, a_dropped_drag_leaves_no_trace) {
    Document document(shipped("tshirt.json"));
    const sim::Pattern before = document.pattern();
    document.preview(move_point("front", 0, Vec2d(0.05, 0)));
    document.rollback();
    EXPECT_EQ(document.pattern(), before);
    EXPECT_TRUE(document.history().empty());
    EXPECT_FALSE(document.has_unsaved_changes());
}

TEST(Document, a_drag_that_goes_wrong_stays_at_its_last_sound_place) {
    Document document(shipped("tshirt.json"));
    document.preview(move_point("front", 0, Vec2d(0.01, 0)));
    const sim::Pattern sound = document.pattern();
    EXPECT_THROW(document.preview(move_point("front", 0, Vec2d(0.30, 0.45))), GeometryError);  // crosses the outline
    EXPECT_EQ(document.pattern(), sound);
    document.commit();
    EXPECT_EQ(document.pattern(), sound);
    EXPECT_EQ(document.history().size(), 1U);
}

TEST(Document, what_changes_nothing_is_nothing_to_undo) {
    Document document(shipped("tshirt.json"));
    document.run(SetLayer{.panel = "front", .layer = 0});
    EXPECT_TRUE(document.history().empty());
}

TEST(Document, a_new_command_forgets_what_was_undone) {
    Document document(shipped("tshirt.json"));
    document.run(SetLayer{.panel = "front", .layer = 1});
    document.run(SetLayer{.panel = "front", .layer = 2});
    document.go_to(1);
    document.run(SetLayer{.panel = "back", .layer = 3});
    ASSERT_EQ(document.history().size(), 2U);
    EXPECT_EQ(panel_named(document, "front").layer, 1);
    document.go_to(0);
    EXPECT_EQ(panel_named(document, "back").layer, 0);
}

TEST(Document, knows_whether_it_is_saved) {
    Document document(shipped("tshirt.json"));
    EXPECT_FALSE(document.has_unsaved_changes());
    document.run(SetLayer{.panel = "front", .layer = 1});
    EXPECT_TRUE(document.has_unsaved_changes());
    document.mark_saved();
    EXPECT_FALSE(document.has_unsaved_changes());
    document.undo();
    EXPECT_TRUE(document.has_unsaved_changes());
    document.redo();
    EXPECT_FALSE(document.has_unsaved_changes());
    document.undo();
    document.run(SetLayer{.panel = "front", .layer = 2});  // undo and redo cannot reach the saved state any more
    document.undo();
    EXPECT_TRUE(document.has_unsaved_changes());
}

TEST(Document, a_renamed_panel_keeps_its_place_in_the_file) {
    Document document(shipped("tshirt.json"));
    const std::string first = document.text();
    document.run(RenamePanel{.panel = "front", .to = "vorn"});
    const std::string renamed = document.text();
    EXPECT_LT(renamed.find("\"vorn\""), renamed.find("\"back\""));
    EXPECT_EQ(renamed.find("\"front\""), std::string::npos);
    EXPECT_THROW(document.run(RenamePanel{.panel = "vorn", .to = "back"}), GeometryError);
    document.undo();
    EXPECT_EQ(document.text(), first);
}

Selection all_parts(const std::string& panel) {
    Selection parts;
    parts.panels = {panel};
    parts.vertices = {{panel, 0}};
    parts.edges = {{panel, 1}};
    return parts;
}

TEST(PanelStates, follow_a_renamed_panel_also_when_it_is_undone_and_redone) {
    Document document(shipped("tshirt.json"));
    document.set_panel_states({.hidden = {"front"}, .locked = {"back", "front"}});
    const PanelStates first = document.panel_states(), second{.hidden = {"vorn"}, .locked = {"back", "vorn"}};
    document.run(RenamePanel{.panel = "front", .to = "vorn"});
    EXPECT_EQ(document.panel_states(), second);
    document.undo();
    EXPECT_EQ(document.panel_states(), first);
    document.redo();
    EXPECT_EQ(document.panel_states(), second);
}

TEST(PanelStates, are_left_by_removed_panels_and_have_no_unknown_ones) {
    Document document(shipped("tshirt.json"));
    document.set_panel_states({.hidden = {"front", "nobody"}, .locked = {"back"}});
    EXPECT_EQ(document.panel_states().hidden, std::set<std::string>{"front"});
    document.run(RemoveParts{.panels = {"front"}});
    EXPECT_EQ(document.panel_states(), (PanelStates{.hidden = {}, .locked = {"back"}}));
    document.undo();
    EXPECT_EQ(document.panel_states(), (PanelStates{.hidden = {}, .locked = {"back"}}));
}

TEST(PanelStates, are_no_part_of_the_pattern_and_are_not_undone) {
    Document document(shipped("tshirt.json"));
    std::string journal;
    document.set_journal([&](std::string_view line) { journal += line; });
    const std::string text = document.text();
    const std::uint64_t revision = document.revision();
    document.set_panel_states({.hidden = {"front"}, .locked = {}});
    EXPECT_EQ(document.text(), text);
    EXPECT_EQ(document.revision(), revision);
    EXPECT_FALSE(document.can_undo());
    EXPECT_FALSE(document.has_unsaved_changes());
    EXPECT_TRUE(journal.empty());
    document.run(move_point("back", 0, Vec2d(0.01, 0)));
    document.undo();
    EXPECT_EQ(document.panel_states().hidden, std::set<std::string>{"front"});
}

TEST(PanelStates, take_panels_out_of_the_selection_and_out_of_what_may_be_changed) {
    Document document(shipped("tshirt.json"));
    document.select(all_parts("front"));
    document.set_panel_states({.hidden = {"back"}, .locked = {}});
    EXPECT_EQ(document.selection(), all_parts("front"));
    document.set_panel_states({.hidden = {}, .locked = {"front"}});
    EXPECT_TRUE(document.selection().is_empty());
    document.select(all_parts("front"));  // as a click in the tree of objects does
    EXPECT_EQ(document.selection(), all_parts("front"));
    EXPECT_TRUE(document.changeable().is_empty());
}

TEST(Document, names_that_change_hands_come_back_with_their_panels) {
    Document document(shipped("tshirt.json"));
    const std::string first = document.text();
    document.run(RemoveParts{.panels = {"back"}});
    document.run(RenamePanel{.panel = "front", .to = "back"});
    document.run(RenamePanel{.panel = "left_sleeve_back", .to = "front"});
    EXPECT_FALSE(sim::has_error(sim::check_pattern_text(document.text(), "")));
    const std::string last = document.text();
    document.go_to(0);
    EXPECT_EQ(document.text(), first);
    document.go_to(3);
    EXPECT_EQ(document.text(), last);
}

TEST(Document, the_selection_follows_what_is_there) {
    Document document(shipped("tshirt.json"));
    Selection selection;
    selection.panels = {"front", "nobody"};
    selection.vertices = {{"front", 2}, {"front", 99}};
    selection.seams = {0, 99};
    document.select(selection);
    EXPECT_EQ(document.selection().panels, (std::set<std::string>{"front"}));
    EXPECT_EQ(document.selection().vertices, (std::set<PartRef>{{"front", 2}}));
    EXPECT_EQ(document.selection().seams, (std::set<int>{0}));
    document.run(RemoveParts{.panels = {"front"}});
    EXPECT_TRUE(document.selection().is_empty());
    document.undo();
    EXPECT_EQ(document.selection().panels, (std::set<std::string>{"front"}));
}

TEST(Document, undo_keeps_all_that_the_command_did_not_change) {
    sim::PatternDocument source = shipped("tshirt.json");
    source.pattern.allowance = 0.01;
    source.pattern.size = "40";
    source.pattern.underlays = {{.file = "front.jpg"}};
    Document document(std::move(source));
    const sim::Pattern before = document.pattern();
    document.run(SetTartan{.tartan = "black_watch"});
    document.undo();
    EXPECT_EQ(document.pattern(), before);
    document.run(SetUnderlays{});
    document.undo();
    EXPECT_EQ(document.pattern(), before);
    EXPECT_THROW(document.run(SetUnderlays{.underlays = {{.file = "a", .pixel_size = 0}}}), GeometryError);
}

TEST(Document, allowances_are_of_an_edge_a_panel_or_the_garment) {
    Document document(shipped("tshirt.json"));
    document.run(SetAllowance{.width = 0.01});
    document.run(SetAllowance{.panel = "front", .width = 0.015});
    document.run(SetAllowance{.panel = "front", .edge = 0, .width = 0.03, .corner = sim::AllowanceCorner::Mirrored});
    const sim::Panel& front = document.pattern().panels[0];
    EXPECT_EQ(document.pattern().allowance, 0.01);
    EXPECT_EQ(front.allowance, 0.015);
    EXPECT_EQ(front.edges[0].allowance, 0.03);
    EXPECT_EQ(front.edges[0].allowance_corner, sim::AllowanceCorner::Mirrored);
    document.run(SetAllowance{.panel = "front", .edge = 0});
    EXPECT_FALSE(document.pattern().panels[0].edges[0].allowance);
    EXPECT_THROW(document.run(SetAllowance{.width = 0.6}), GeometryError);
    EXPECT_THROW(document.run(SetAllowance{.panel = "front", .edge = 99, .width = 0.01}), GeometryError);
}

TEST(Document, what_panels_show_is_checked) {
    Document document(shipped("tshirt.json"));
    const sim::SurfaceDesign red{.kind = sim::DesignKind::Colour, .source = "#FF0000"};
    document.run(SetSurface{.panel = "front", .surface = red});
    EXPECT_EQ(document.pattern().panels[0].surface, red);
    document.run(SetSurface{.surface = red});
    document.run(SetTartan{.tartan = "gingham"});
    EXPECT_FALSE(document.pattern().surface) << "a tartan that is chosen is shown";
    const auto refused = [&](const sim::SurfaceDesign& design) {
        EXPECT_THROW(document.run(SetSurface{.surface = design}), GeometryError) << design.source;
    };
    refused({.kind = sim::DesignKind::Colour, .source = "red"});
    refused({.kind = sim::DesignKind::Picture});
    refused({.kind = sim::DesignKind::Test, .size = 0.0});
    refused({.source = "Q5 nonsense"});
}

TEST(Document, matching_at_seams_is_a_command) {
    Document document(shipped("tshirt.json"));
    document.run(SetTartan{});
    EXPECT_THROW(document.run(MatchSetts{}), GeometryError) << "plain cloth has no stripes";
    document.run(SetTartan{.tartan = "black_watch"});
    document.run(MatchSetts{});
    ASSERT_TRUE(document.pattern().matched_sett);
    EXPECT_EQ(document.pattern().matched_sett->tartan, "black_watch");
    EXPECT_THROW(document.run(SetTartan{.tartan = "Q5 nonsense"}), GeometryError);
}

TEST(Document, one_that_takes_the_place_of_another_has_no_revision_of_its) {
    Document first;
    const std::uint64_t seen = first.revision();
    Document second(shipped("tshirt.json"));
    second.continue_revisions(first);
    EXPECT_GT(second.revision(), seen);
}

// Runs `count` random commands, with undo, redo and drags between them. Returns the number of commands applied.
int run_commands(Document& document, unsigned seed, int count) {
    RandomCommands commands(seed);
    int done = 0;
    for (int i = 0; i < count; ++i) {
        const int what = commands.pick(10);
        if (what == 0) document.undo();
        if (what == 1) document.redo();
        if (what == 2)
            document.go_to(document.position() - static_cast<std::size_t>(commands.pick(document.position())) / 8);
        const Command command = commands.next(document.pattern());
        const bool is_dragged = what == 3 && !std::holds_alternative<RenamePanel>(command);
        try {
            is_dragged ? document.preview(command) : document.run(command);
            ++done;
        } catch (const GeometryError&) {
        }
        if (is_dragged && commands.pick(3) > 0) document.commit();
    }
    return done;
}

class RandomCommandsOn : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Usual, RandomCommandsOn, ::testing::Values("tshirt"),
                         [](const auto& garment) { return std::string(garment.param); });
INSTANTIATE_TEST_SUITE_P(Thorough, RandomCommandsOn,
                         ::testing::Values("skirt", "poncho", "two_squares", "tshirt_thesis", "vest"),
                         [](const auto& garment) { return std::string(garment.param); });

TEST_P(RandomCommandsOn, a_garment_undone_give_the_first_document_byte_for_byte) {
    const std::string name = std::string(GetParam()) + ".json";
    Document document(shipped(name));
    const std::string first = document.text();
    int done = 0;
    for (int round = 0; round < 20; ++round) {  // continues with the garment of the previous round
        done += run_commands(document, 100 * static_cast<unsigned>(round) + static_cast<unsigned>(first.size()), 1000);
        document.commit();  // commits an unfinished drag
        const std::string last = document.text();
        EXPECT_FALSE(sim::has_error(sim::check_pattern_text(last, name)))
            << sim::describe(sim::check_pattern_text(last, name).front());
        const std::size_t position = document.position();
        document.go_to(0);
        ASSERT_TRUE(document.text() == first) << name << ", round " << round;
        document.go_to(position);
        ASSERT_TRUE(document.text() == last) << name << ", round " << round;
        if (round % 4 == 3) document.go_to(0);
    }
    EXPECT_GT(done, 3000);
}

TEST(RandomCommands, are_given_back_by_the_journal) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        Document document(shipped("tshirt.json"));
        std::string journal = journal_head("tshirt.json", document.text()) + "\n";
        document.set_journal([&](std::string_view line) { journal += std::string(line) + "\n"; });
        run_commands(document, seed, 300);
        const auto recovery = recover(journal);
        ASSERT_TRUE(recovery);
        EXPECT_EQ(recovery->text, document.text()) << seed;
    }
}

}  // namespace

}  // namespace selvedge::editor
