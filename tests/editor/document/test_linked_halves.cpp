// A panel whose halves are linked: whatever is edited in one half happens in the other.
#include <gtest/gtest.h>
#include <algorithm>
#include <string>
#include <vector>

#include "editor/document/document.h"
#include "editor/document/journal.h"
#include "editor/geometry/draft.h"
#include "sim/pattern/edge_keys.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/halves.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/sources.h"
#include "tests/editor/document/support.h"

namespace selvedge::editor {
namespace {

const sim::Panel& piece_named(const Document& document, const std::string& name) {
    return *std::ranges::find(document.pattern().panels, name, &sim::Panel::name);
}

const sim::Panel& front_of(const Document& document) {
    return piece_named(document, "front");
}

int edge_by_key(const Document& document, int number, sim::EdgeRole role = sim::EdgeRole::Drawn) {
    return find_edge(front_of(document), {number, role}).value();
}

// Front and back, each with four edges.
sim::PatternDocument two_pieces() {
    sim::PatternDocument source = shipped("two_squares.json");
    source.pattern.seams.clear();
    for (sim::Panel& panel : source.pattern.panels) {
        panel.vertices = {{-0.28, 0}, {0.28, 0}, {0.28, 0.56}, {-0.28, 0.56}};
        panel.edges = {{.start = 0, .end = 1}, {.start = 1, .end = 2}, {.start = 2, .end = 3}, {.start = 3, .end = 0}};
        panel.is_mirrored = false;
    }
    return sim::parse_pattern(sim::write_pattern(source), "pieces.json");
}

// The front, unfolded over its last edge: drawn edges 1, 2, 3 and their images.
Document unfolded_front() {
    Document document(two_pieces());
    document.run(UnfoldPanel{.panel = "front", .edge = 3, .is_linked = true});
    return document;
}

// The halves are mirror images, in all that is drawn on them, and the sources hold the one.
void expect_alike(const Document& document) {
    const sim::Panel& panel = front_of(document);
    ASSERT_TRUE(sim::has_linked_halves(panel));
    const sim::Panel half = *half_of(panel, sim::EdgeRole::Drawn);
    EXPECT_EQ(whole_of(half), panel);
    EXPECT_EQ(evaluate(document.sources()), document.pattern());
    EXPECT_EQ(sources_of(document.pattern()), document.sources());
    const std::string text = document.text("f.json");
    Document again(sim::parse_pattern(text, "f.json"));
    EXPECT_TRUE(again.take_notes().empty());
    EXPECT_EQ(again.text("f.json"), text);
}

Vec2d image_in(const sim::Panel& panel, const Vec2d& point) {
    return fold_reflection(*half_of(panel, sim::EdgeRole::Drawn)) * point;
}

// The commands that a test runs are one step each, and undoing them gives the same bytes.
void expect_undone(Document& document, const std::string& before) {
    const std::string after = document.text();
    document.undo();
    EXPECT_EQ(document.text(), before);
    document.redo();
    EXPECT_EQ(document.text(), after);
}

TEST(LinkedHalves, move_a_point_of_the_other_half_when_one_is_moved) {
    for (const sim::EdgeRole role : {sim::EdgeRole::Drawn, sim::EdgeRole::Image}) {
        Document document = unfolded_front();
        const std::string before = document.text();
        const int edge = edge_by_key(document, 2, role);
        const int vertex = front_of(document).edges[as_size(edge)].start;
        const Vec2d to = front_of(document).vertices[as_size(vertex)] + Vec2d(0.013, -0.007);
        document.run(MoveVertices{.vertices = {{"front", vertex}}, .by = Vec2d(0.013, -0.007)});
        const sim::Panel& panel = front_of(document);
        const sim::EdgeRole other = role == sim::EdgeRole::Drawn ? sim::EdgeRole::Image : sim::EdgeRole::Drawn;
        const sim::OutlineEdge& own = panel.edges[as_size(edge_by_key(document, 2, role))];
        const sim::OutlineEdge& image = panel.edges[as_size(edge_by_key(document, 2, other))];
        EXPECT_LT((panel.vertices[as_size(own.start)] - to).norm(), 1e-12);
        EXPECT_LT((panel.vertices[as_size(image.end)] - image_in(panel, to)).norm(), 1e-12);
        expect_alike(document);
        expect_undone(document, before);
    }
}

TEST(LinkedHalves, keep_the_bits_of_unedited_parts_when_the_image_is_edited) {
    Document document(two_pieces());
    document.run(TransformPanels{
        .panels = {"front"}, .map = {.x_axis = Vec2d(0.96, 0.28), .y_axis = Vec2d(-0.28, 0.96)}, .what = "Turn"});
    document.run(UnfoldPanel{.panel = "front", .edge = 3, .is_linked = true});
    const sim::Panel was = front_of(document);
    const int moved = was.edges[as_size(edge_by_key(document, 2, sim::EdgeRole::Image))].end;
    document.run(MoveVertices{.vertices = {{"front", moved}}, .by = Vec2d(0.01, 0.01)});
    const sim::Panel& panel = front_of(document);
    int changed = 0;
    for (std::size_t v = 0; v < panel.vertices.size(); ++v) changed += panel.vertices[v] == was.vertices[v] ? 0 : 1;
    EXPECT_EQ(changed, 2);
}

TEST(LinkedHalves, turn_their_axis_when_a_point_of_the_fold_is_moved) {
    Document document = unfolded_front();
    const int vertex = front_of(document).edges[as_size(edge_by_key(document, 1))].start;
    document.run(MoveVertices{.vertices = {{"front", vertex}}, .by = Vec2d(0.02, -0.03)});
    expect_alike(document);
}

TEST(LinkedHalves, keep_a_seam_of_the_image_at_its_place_when_the_drawn_edge_is_split) {
    Document document = unfolded_front();
    document.run(SewEdges{.first = {"front", edge_by_key(document, 2, sim::EdgeRole::Image)}, .second = {"back", 1}});
    const std::string before = document.text();
    const std::size_t seams = document.pattern().seams.size(), back = piece_named(document, "back").edges.size();
    document.run(AddVertex{.panel = "front", .edge = edge_by_key(document, 2), .t = 0.3});
    expect_alike(document);
    EXPECT_EQ(front_of(document).edges.size(), 8U);
    ASSERT_EQ(document.pattern().seams.size(), seams + 1);
    EXPECT_EQ(piece_named(document, "back").edges.size(), back + 1) << "split where the new point meets it";
    for (const sim::Seam& seam : document.pattern().seams) {
        if (sim::panel_of(document.pattern(), seam.first).name != "front") continue;
        const sim::Panel& first = sim::panel_of(document.pattern(), seam.first);
        const sim::Panel& second = sim::panel_of(document.pattern(), seam.second);
        EXPECT_EQ(edge_key(first, seam.first.edge).role, sim::EdgeRole::Image);
        EXPECT_NEAR(outline_length(first, first.edges[as_size(seam.first.edge)]),
                    outline_length(second, second.edges[as_size(seam.second.edge)]), 1e-9);
    }
    expect_undone(document, before);
}

TEST(LinkedHalves, split_and_join_an_edge_and_its_image_together) {
    for (const sim::EdgeRole role : {sim::EdgeRole::Drawn, sim::EdgeRole::Image}) {
        for (const int number : {1, 2, 3}) {
            Document document = unfolded_front();
            const std::string before = document.text();
            document.run(AddVertex{.panel = "front", .edge = edge_by_key(document, number, role), .t = 0.3});
            expect_alike(document);
            const sim::Panel& split = front_of(document);
            ASSERT_EQ(split.edges.size(), 8U);
            const sim::EdgeKey added{split.last_key, role};
            const int vertex = split.edges[as_size(find_edge(split, added).value())].start;
            EXPECT_EQ(split.edges[as_size(edge_by_key(document, number, role))].end, vertex);
            expect_undone(document, before);
            document.run(RemoveParts{.vertices = {{"front", vertex}}});
            EXPECT_EQ(front_of(document).edges.size(), 6U);
            expect_alike(document);
        }
    }
}

TEST(LinkedHalves, have_marks_and_curves_and_darts_alike) {
    for (const sim::EdgeRole role : {sim::EdgeRole::Drawn, sim::EdgeRole::Image}) {
        Document document = unfolded_front();
        const auto edge = [&](int number) { return edge_by_key(document, number, role); };
        document.run(AddNotch{.panel = "front", .edge = edge(1), .t = 0.2});
        EXPECT_EQ(front_of(document).notches.size(), 2U);
        expect_alike(document);
        const sim::Panel half = *half_of(front_of(document), role);
        const sim::OutlineEdge& third = half.edges[as_size(*find_edge(half, {3}))];
        const Vec2d bow = outline_point(half, third, 0.5) + Vec2d(0, 0.02);
        document.run(SetCurve{.panel = "front",
                              .edge = edge(3),
                              .curve = {.kind = sim::CurveKind::Quadratic, .control = {bow, Vec2d(0, 0)}}});
        for (const sim::EdgeRole each : {sim::EdgeRole::Drawn, sim::EdgeRole::Image}) {
            const int curved = edge_by_key(document, 3, each);
            EXPECT_EQ(front_of(document).edges[as_size(curved)].kind, sim::CurveKind::Quadratic);
        }
        const Vec2d inside = outline_point(half, third, 0.5) + Vec2d(0, -0.05);
        document.run(AddInternalLine{.panel = "front", .line = {"line", {inside, inside + Vec2d(0.01, -0.02)}}});
        ASSERT_EQ(front_of(document).internal_lines.size(), 2U);
        expect_alike(document);
        document.run(AddDart{.panel = "front", .edge = edge(1), .t = 0.5, .width = 0.02, .depth = 0.05});
        EXPECT_EQ(sim::darts_of(document.pattern(), 0).size(), 2U);
        expect_alike(document);
        const std::string before = document.text();
        document.run(RemoveParts{.internal_lines = {{"front", role == sim::EdgeRole::Drawn ? 0 : 1}}});
        EXPECT_TRUE(front_of(document).internal_lines.empty());
        expect_undone(document, before);
    }
}

TEST(LinkedHalves, of_a_linked_copy_are_sewn_to_each_other_as_those_of_its_source) {
    Document document = unfolded_front();
    document.run(DuplicatePanels{.panels = {"front"}, .move = Vec3d(0, 0, 0.3), .is_linked = true});
    const std::string copy = document.pattern().panels.back().name;
    const std::string before = document.text();
    document.run(SewEdges{.first = {copy, edge_by_key(document, 1)},
                          .second = {copy, edge_by_key(document, 3, sim::EdgeRole::Image)}});
    EXPECT_EQ(sim::darts_of(document.pattern(), 0).size(), 1U);
    EXPECT_EQ(piece_named(document, copy).copy_of, "front");
    expect_alike(document);
    expect_undone(document, before);
}

TEST(LinkedHalves, end_where_the_panel_is_cut) {
    Document document = unfolded_front();
    document.run(CutPanel{.panel = "front", .path = {Vec2d(-1, 0.3), Vec2d(1, 0.3)}});
    EXPECT_EQ(document.take_notes(), std::vector<std::string>{"the halves of 'front' are no longer linked"});
    for (const sim::Panel& panel : document.pattern().panels) EXPECT_FALSE(sim::has_linked_halves(panel)) << panel.name;
}

TEST(LinkedHalves, are_told_to_be_linked_no_longer_when_the_panel_is_unfolded_again) {
    for (const bool is_linked : {false, true}) {
        Document document = unfolded_front();
        ASSERT_TRUE(document.take_notes().empty());
        document.run(UnfoldPanel{.panel = "front", .edge = edge_by_key(document, 2), .is_linked = is_linked});
        EXPECT_EQ(document.take_notes(), std::vector<std::string>{"the halves of 'front' are no longer linked"});
        EXPECT_EQ(sim::has_linked_halves(front_of(document)), is_linked);
    }
}

// The part that is sewn is divided where the whole edge is, which is divided where the part is: towards one end, at a
// third of what was left each time.
TEST(LinkedCopy, is_not_sewn_to_its_source_where_joints_would_come_closer_than_a_tenth_of_a_millimetre) {
    Document document(two_pieces());
    document.run(DuplicatePanels{.panels = {"front"}, .move = Vec3d(0, 0, 0.3), .is_linked = true});
    const std::string copy = document.pattern().panels.back().name;
    const std::string before = document.text();
    try {
        document.run(SewRuns{.first = {{.panel = "front", .edge = 1, .from = 0.7, .to = 1}},
                             .second = {{.panel = copy, .edge = 1, .from = 0, .to = 1}},
                             .is_reversed = false});
        FAIL() << document.pattern().seams.size() << " seams";
    } catch (const GeometryError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "Linked panels are sewn to each other so that their seams cannot be split alike.");
    }
    EXPECT_EQ(document.text(), before);
}

// A fold point belongs to both halves, and is no reason for the drawn one to lead.
TEST(LinkedHalves, follow_a_point_that_is_moved_together_with_points_of_the_fold) {
    for (const sim::EdgeRole role : {sim::EdgeRole::Drawn, sim::EdgeRole::Image}) {
        const sim::EdgeRole other = role == sim::EdgeRole::Drawn ? sim::EdgeRole::Image : sim::EdgeRole::Drawn;
        for (const bool is_curved : {false, true}) {
            for (const bool has_both_ends : {false, true}) {
                Document document = unfolded_front();
                if (is_curved) {
                    document.run(SetCurve{
                        .panel = "front",
                        .edge = edge_by_key(document, 1),
                        .curve = {.kind = sim::CurveKind::Quadratic, .control = {Vec2d(0, -0.05), Vec2d(0, 0)}}});
                }
                const std::string before = document.text();
                const sim::Panel was = front_of(document);
                const bool is_drawn = role == sim::EdgeRole::Drawn;
                const sim::OutlineEdge& first = was.edges[as_size(edge_by_key(document, 1, role))];
                const sim::OutlineEdge& third = was.edges[as_size(edge_by_key(document, 3, role))];
                const int corner = is_drawn ? first.end : first.start;
                std::vector<PartRef> moved{{"front", is_drawn ? first.start : first.end}, {"front", corner}};
                if (has_both_ends) moved.push_back({"front", is_drawn ? third.end : third.start});
                const Vec2d by(0.03, -0.02);
                document.run(MoveVertices{.vertices = moved, .by = by});
                const sim::Panel& panel = front_of(document);
                const auto at = [&](int vertex) { return was.vertices[as_size(vertex)] + by; };
                for (const PartRef& part : moved) {
                    const bool is_there = std::ranges::any_of(
                        panel.vertices, [&](const Vec2d& point) { return (point - at(part.index)).norm() < 1e-12; });
                    EXPECT_TRUE(is_there) << part.index;
                }
                const sim::OutlineEdge& image = panel.edges[as_size(edge_by_key(document, 1, other))];
                const Vec2d follows = panel.vertices[as_size(is_drawn ? image.start : image.end)];
                EXPECT_LT((follows - image_in(panel, at(corner))).norm(), 1e-12);
                expect_alike(document);
                expect_undone(document, before);
            }
        }
    }
}

// The front with points 5 and 8 in the middle of edges of different halves, and with two lines in each half.
Document marked_front() {
    Document document = unfolded_front();
    document.run(AddVertex{.panel = "front", .edge = edge_by_key(document, 1), .t = 0.3});
    document.run(AddVertex{.panel = "front", .edge = edge_by_key(document, 2), .t = 0.3});
    document.run(AddInternalLine{.panel = "front", .line = {"a", {Vec2d(0, 0.1), Vec2d(0.05, 0.1)}}});
    document.run(AddInternalLine{.panel = "front", .line = {"b", {Vec2d(0, 0.2), Vec2d(0.05, 0.2)}}});
    return document;
}

int start_by_key(const Document& document, int number) {
    return front_of(document).edges[as_size(edge_by_key(document, number))].start;
}

// The vertex of the other half whose image is where that edge starts.
int image_of_start(const Document& document, int number) {
    return front_of(document).edges[as_size(edge_by_key(document, number, sim::EdgeRole::Image))].end;
}

TEST(LinkedHalves, refuse_an_edit_that_changes_them_differently) {
    Document document = marked_front();
    const PartRef drawn{"front", start_by_key(document, 5)}, other{"front", image_of_start(document, 6)};
    const std::vector<Command> commands{RemoveParts{.internal_lines = {{"front", 0}, {"front", 3}}},
                                        RemoveParts{.vertices = {drawn, other}},
                                        MoveVertices{.vertices = {drawn, other}, .by = Vec2d(0.01, 0.02)},
                                        SetPins{.panel = "front", .vertices = {drawn.index, other.index}}};
    const std::string before = document.text();
    for (const Command& command : commands) {
        try {
            document.run(command);
            ADD_FAILURE() << "no error: " << label_of(command);
        } catch (const GeometryError& error) {
            EXPECT_EQ(std::string(error.what()),
                      "The halves of panel front are linked and would not be alike: change one of them at a time, or "
                      "unlink the panel first.");
            EXPECT_EQ(error.places(), (std::vector<PartLocation>{{"front", -1, -1}}));
        }
        EXPECT_EQ(document.text(), before);
    }
}

TEST(LinkedHalves, refuse_an_edit_that_removes_different_darts_or_a_dart_and_a_point) {
    Document document = unfolded_front();
    for (const int number : {1, 2}) {
        const int edge = edge_by_key(document, number);
        document.run(AddDart{.panel = "front", .edge = edge, .t = 0.5, .width = 0.01, .depth = 0.02});
    }
    const auto seam_at = [&](sim::EdgeRole role, std::size_t which) {
        std::vector<int> seams = sim::darts_of(document.pattern(), 0);
        std::erase_if(seams, [&](int seam) {
            return edge_key(front_of(document), document.pattern().seams[as_size(seam)].first.edge).role != role;
        });
        return seams.at(which);
    };
    const int drawn = seam_at(sim::EdgeRole::Drawn, 0), image = seam_at(sim::EdgeRole::Image, 1);
    const PartRef corner{"front", start_by_key(document, 2)};
    const std::string before = document.text();
    for (const RemoveParts& parts :
         {RemoveParts{.seams = {drawn, image}}, RemoveParts{.vertices = {corner}, .seams = {image}}}) {
        EXPECT_THROW(document.run(parts), GeometryError);
        EXPECT_EQ(document.text(), before);
    }
    document.run(RemoveParts{.seams = {drawn, seam_at(sim::EdgeRole::Image, 0)}});
    EXPECT_EQ(sim::darts_of(document.pattern(), 0).size(), 2U);
    expect_alike(document);
    expect_undone(document, before);
}

TEST(LinkedHalves, take_an_edit_that_changes_them_alike) {
    const Document start = marked_front();
    std::vector<PartRef> all;
    for (int v = 0; v < static_cast<int>(front_of(start).vertices.size()); ++v) all.push_back({"front", v});
    const PartRef drawn{"front", start_by_key(start, 5)}, image{"front", image_of_start(start, 5)};
    const std::vector<Command> commands{
        RemoveParts{.vertices = {drawn, image}},
        RemoveParts{.internal_lines = {{"front", 0}, {"front", 2}}},
        SetPins{.panel = "front", .vertices = {drawn.index, image.index}},
        MoveVertices{.vertices = {drawn, image}, .by = Vec2d(0, 0.02)},
        MoveVertices{.vertices = all, .by = Vec2d(0.1, 0.02)},
        TransformPanels{
            .panels = {"front"}, .map = {.x_axis = Vec2d(0.96, 0.28), .y_axis = Vec2d(-0.28, 0.96)}, .what = "Turn"},
        TransformPanels{
            .panels = {"front"}, .map = {.x_axis = Vec2d(-1.5, 0), .y_axis = Vec2d(0, 1.5)}, .what = "Mirror"},
    };
    for (const Command& command : commands) {
        SCOPED_TRACE(label_of(command));
        Document document = marked_front();
        const std::string before = document.text();
        ASSERT_NO_THROW(document.run(command));
        EXPECT_NE(document.text(), before);
        expect_alike(document);
        expect_undone(document, before);
    }
}

TEST(LinkedHalves, are_not_mistaken_for_a_panel_with_any_name) {
    for (const std::string name : {"front\n(other half)", "front (other half)"}) {
        Document document = unfolded_front();
        document.run(RenamePanel{"back", name});
        const sim::Panel back = piece_named(document, name);
        document.run(AddVertex{.panel = "front", .edge = edge_by_key(document, 2), .t = 0.3});
        EXPECT_EQ(piece_named(document, name), back);
        EXPECT_EQ(front_of(document).edges.size(), 8U);
        document.run(SewEdges{.first = {"front", edge_by_key(document, 1)}, .second = {name, 0}});
        const std::size_t seams = document.pattern().seams.size();
        document.run(AddVertex{.panel = name, .edge = 2, .t = 0.3});
        EXPECT_EQ(document.pattern().seams.size(), seams);
        expect_alike(document);
    }
}

TEST(LinkedHalves, refuse_to_lose_a_point_where_they_meet) {
    Document document = unfolded_front();
    for (const int vertex : {front_of(document).edges[as_size(edge_by_key(document, 1))].start,
                             front_of(document).edges[as_size(edge_by_key(document, 3))].end}) {
        const std::string before = document.text();
        try {
            document.run(RemoveParts{.vertices = {{"front", vertex}}});
            FAIL() << "no error";
        } catch (const GeometryError& error) {
            EXPECT_EQ(std::string(error.what()),
                      "The halves of panel front are linked and meet in this point: unlink the panel first.");
        }
        EXPECT_EQ(document.text(), before);
    }
}

TEST(LinkedHalves, go_their_own_ways_when_the_panel_is_unlinked) {
    Document document = unfolded_front();
    const std::string before = document.text();
    document.run(UnlinkPanel{"front"});
    EXPECT_TRUE(document.take_notes().empty()) << "that is what was asked for";
    EXPECT_FALSE(sim::has_linked_halves(front_of(document)));
    expect_undone(document, before);
    document.run(AddVertex{.panel = "front", .edge = edge_by_key(document, 2), .t = 0.3});
    EXPECT_EQ(front_of(document).edges.size(), 7U);
}

TEST(LinkedHalves, are_unfolded_again_from_the_journal) {
    Document document(two_pieces());
    std::string journal = journal_head("f.json", document.text()) + "\n";
    document.set_journal([&](std::string_view line) { journal += std::string(line) + "\n"; });
    document.run(UnfoldPanel{.panel = "front", .edge = 3, .is_linked = true});
    document.run(AddVertex{.panel = "front", .edge = edge_by_key(document, 2, sim::EdgeRole::Image), .t = 0.3});
    EXPECT_EQ(recover(journal)->text, document.text());
}

}  // namespace
}  // namespace selvedge::editor
