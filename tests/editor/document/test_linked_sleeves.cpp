// A T-shirt whose right sleeve is kept the mirror image of its left one, under random commands: seams, notches, setts
// and what is selected stay at their places, or are removed by a command that removes them.
#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "editor/document/document.h"
#include "editor/document/journal.h"
#include "editor/geometry/draft.h"
#include "sim/pattern/edge_keys.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/halves.h"
#include "sim/pattern/outline.h"
#include "tests/editor/document/random_commands.h"
#include "tests/editor/document/support.h"

namespace selvedge::editor {
namespace {

constexpr double kSamePlace = 2e-4;  // m

struct MaterialPlace {
    std::string panel;
    Vec2d u = Vec2d::Zero();
};

// Two places that a seam joins.
struct Joint {
    MaterialPlace first;
    MaterialPlace second;
};

Vec2d point_at(const sim::Pattern& pattern, const sim::SeamSide& side, double t) {
    const sim::Panel& panel = pattern.panels[as_size(side.panel)];
    return outline_point(panel, panel.edges[as_size(side.edge)], t);
}

std::vector<Joint> joints_of(const sim::Pattern& pattern, const sim::Seam& seam,
                             const std::vector<double>& places = {0.07, 0.31, 0.5, 0.77, 0.95}) {
    std::vector<Joint> joints;
    for (const double t : places) {
        const double other = seam.is_reversed ? 1 - t : t;
        joints.push_back({{sim::panel_of(pattern, seam.first).name, point_at(pattern, seam.first, t)},
                          {sim::panel_of(pattern, seam.second).name, point_at(pattern, seam.second, other)}});
    }
    return joints;
}

std::vector<Joint> joints_of(const sim::Pattern& pattern) {
    std::vector<Joint> joints;
    for (const sim::Seam& seam : pattern.seams) std::ranges::copy(joints_of(pattern, seam), std::back_inserter(joints));
    return joints;
}

bool joins(const sim::Pattern& pattern, const sim::Seam& seam, const MaterialPlace& one, const MaterialPlace& other) {
    const sim::Panel& first = sim::panel_of(pattern, seam.first);
    if (first.name != one.panel || sim::panel_of(pattern, seam.second).name != other.panel) return false;
    const sim::NearestOnEdge nearest = nearest_on_edge(first, first.edges[as_size(seam.first.edge)], one.u);
    if (nearest.distance > kSamePlace) return false;
    const Vec2d there = point_at(pattern, seam.second, seam.is_reversed ? 1 - nearest.t : nearest.t);
    return (there - other.u).norm() < 5 * kSamePlace;  // sides of a seam may differ in length, up to four times
}

bool has_joint(const sim::Pattern& pattern, const Joint& joint) {
    return std::ranges::any_of(pattern.seams, [&](const sim::Seam& seam) {
        return joins(pattern, seam, joint.first, joint.second) || joins(pattern, seam, joint.second, joint.first);
    });
}

const sim::Panel* panel_in(const sim::Pattern& pattern, const std::string& name) {
    const auto found = std::ranges::find(pattern.panels, name, &sim::Panel::name);
    return found == pattern.panels.end() ? nullptr : &*found;
}

// The places of a panel's notches, in an order of their own.
std::vector<std::array<double, 2>> notch_places(const sim::Panel& panel) {
    std::vector<std::array<double, 2>> places;
    for (const sim::Notch& notch : panel.notches) {
        const Vec2d u = outline_point(panel, panel.edges[as_size(notch.edge)], notch.t);
        places.push_back({u.x(), u.y()});
    }
    std::ranges::sort(places);
    return places;
}

bool are_near(const std::vector<std::array<double, 2>>& one, const std::vector<std::array<double, 2>>& other) {
    return std::ranges::equal(one, other, [](const auto& a, const auto& b) {
        return std::abs(a[0] - b[0]) < kSamePlace && std::abs(a[1] - b[1]) < kSamePlace;
    });
}

// What a seam joins, by keys.
using KeySide = std::pair<std::string, sim::EdgeKey>;
using KeyedSeams = std::set<std::pair<std::set<KeySide>, bool>>;

// `later`: a state in which panels may be mirrored, which turns their seams.
KeyedSeams seams_by_key(const sim::Pattern& pattern, const sim::Pattern& later) {
    KeyedSeams seams;
    for (const sim::Seam& seam : pattern.seams) {
        std::set<KeySide> sides;
        bool is_reversed = seam.is_reversed;
        for (const sim::SeamSide& side : {seam.first, seam.second}) {
            const sim::Panel& panel = sim::panel_of(pattern, side);
            sides.insert({panel.name, edge_key(panel, side.edge)});
            if (is_turned_over(panel, *panel_in(later, panel.name))) is_reversed = !is_reversed;
        }
        seams.insert({sides, is_reversed});
    }
    return seams;
}

// What a command may do to outlines and to seams, by its kind.
struct Effect {
    bool moves = false;    // points of an outline, or a whole panel in its plane
    bool removes = false;  // seams, notches or panels
    bool adds = false;     // seams or notches, or sews them anew
};

Effect effect_of(const Command& command) {
    const auto is = [&]<class... Kinds>(std::tuple<Kinds...>*) {
        return (std::holds_alternative<Kinds>(command) || ...);
    };
    using Moving = std::tuple<MoveVertices, TransformVertices, TransformPanels, SetCurve, SlideSewing, EvenSeam,
                              MergePanels, AddDart>;
    using Removing = std::tuple<RemoveParts, MergePanels, UnfoldPanel, CutPanel, ReverseSeam, AddDart, TakeOff,
                                RenamePanel, SlideSewing>;
    using Adding = std::tuple<SewEdges, SewRuns, CutPanel, ReverseSeam, AddDart, UnfoldPanel, DuplicatePanels,
                              SymmetricCopy, AddPanels, AddNotch, MoveNotch, RenamePanel, SlideSewing>;
    return {.moves = is(static_cast<Moving*>(nullptr)),
            .removes = is(static_cast<Removing*>(nullptr)) || std::holds_alternative<MoveNotch>(command),
            .adds = is(static_cast<Adding*>(nullptr))};
}

bool has_same_edges(const sim::Pattern& before, const sim::Pattern& after) {
    return std::ranges::equal(before.panels, after.panels, [](const sim::Panel& one, const sim::Panel& other) {
        return one.name == other.name &&
               std::ranges::equal(one.edges, other.edges, {}, &sim::OutlineEdge::key, &sim::OutlineEdge::key);
    });
}

// Whether the outline of each panel that is still there lies where it lay: not where a corner was removed.
bool has_same_outlines(const sim::Pattern& before, const sim::Pattern& after) {
    const auto lies_on = [](const sim::Panel& panel, const Vec2d& u) {
        return std::ranges::any_of(panel.edges, [&](const sim::OutlineEdge& edge) {
            return nearest_on_edge(panel, edge, u).distance < kSamePlace / 4;
        });
    };
    for (const sim::Panel& panel : after.panels) {
        const sim::Panel* was = panel_in(before, panel.name);
        for (const sim::OutlineEdge& edge : panel.edges) {
            for (const double t : {0.2, 0.5, 0.8}) {
                if (was && !lies_on(*was, outline_point(panel, edge, t))) return false;
            }
        }
    }
    return true;
}

// Whether the edge was there as long as it is. Otherwise it is of several that were joined: what is sewn to them is
// then spread evenly between its ends.
bool was_there(const sim::Pattern& before, const sim::Pattern& after, const sim::SeamSide& side) {
    const sim::Panel& now = sim::panel_of(after, side);
    const sim::Panel* was = panel_in(before, now.name);
    const auto edge = was ? find_edge(*was, edge_key(now, side.edge)) : std::nullopt;
    if (!edge) return false;
    const double length = outline_length(now, now.edges[as_size(side.edge)]);
    return std::abs(outline_length(*was, was->edges[as_size(*edge)]) - length) < 1e-6;
}

void expect_same_places(const sim::Pattern& before, const sim::Pattern& after, const Effect& effect) {
    if (!effect.moves && !effect.removes) {
        for (const Joint& joint : joints_of(before)) {
            if (!has_joint(before, joint)) continue;  // a curve that goes back on itself has two places there
            ASSERT_TRUE(has_joint(after, joint)) << joint.first.panel << " to " << joint.second.panel << ": ended";
        }
    }
    if (!effect.moves && !effect.adds) {
        for (const sim::Seam& seam : after.seams) {
            const bool is_one_of_several =
                !was_there(before, after, seam.first) || !was_there(before, after, seam.second);
            for (const Joint& joint : is_one_of_several ? joints_of(after, seam, {0, 1}) : joints_of(after, seam)) {
                if (!has_joint(after, joint)) continue;
                ASSERT_TRUE(has_joint(before, joint)) << joint.first.panel << " to " << joint.second.panel << ": new";
            }
        }
    }
    if (has_same_edges(before, after) && !effect.adds && !effect.removes) {
        ASSERT_EQ(seams_by_key(before, after), seams_by_key(after, after));
    }
    for (const sim::Panel& panel : after.panels) {
        const sim::Panel* was = panel_in(before, panel.name);
        if (!was || effect.moves || effect.removes || effect.adds) continue;
        ASSERT_TRUE(are_near(notch_places(*was), notch_places(panel))) << "notches of " << panel.name;
    }
}

Selection all_edges_and_points(const sim::Pattern& pattern) {
    Selection all;
    for (const sim::Panel& panel : pattern.panels) {
        for (int e = 0; e < static_cast<int>(panel.edges.size()); ++e) all.edges.insert({panel.name, e});
        for (const sim::OutlineEdge& edge : panel.edges) all.vertices.insert({panel.name, edge.start});
    }
    return all;
}

// Each edge that is still there is selected alone as the same edge; each point that is at its place stays selected.
void expect_same_selected(const sim::Pattern& before, const sim::Pattern& after) {
    for (const PartRef& edge : all_edges_and_points(before).edges) {
        const sim::Panel* now = panel_in(after, edge.panel);
        const sim::EdgeKey key = edge_key(*panel_in(before, edge.panel), edge.index);
        Selection one;
        one.edges = {edge};
        const std::set<PartRef> found = carried(one, before, after).edges;
        const bool is_there = now && find_edge(*now, key);
        ASSERT_EQ(found.size(), is_there ? 1U : 0U);
        if (is_there) {
            ASSERT_EQ(edge_key(*now, found.begin()->index), key);
        }
    }
}

void expect_same_points(const sim::Pattern& before, const sim::Pattern& after) {
    for (const PartRef& vertex : all_edges_and_points(before).vertices) {
        const sim::Panel* now = panel_in(after, vertex.panel);
        if (!now) continue;
        const Vec2d place = panel_in(before, vertex.panel)->vertices[as_size(vertex.index)];
        Selection one;
        one.vertices = {vertex};
        const std::set<PartRef> found = carried(one, before, after).vertices;
        ASSERT_EQ(found.size(), 1U) << vertex.panel << " " << vertex.index;
        ASSERT_LT((now->vertices[as_size(found.begin()->index)] - place).norm(), 1e-9) << vertex.panel;
    }
}

// The shipped T-shirt with its right sleeve linked to the left one; notches on the heads, and a sett that is matched.
sim::PatternDocument linked_tshirt() {
    Document document(shipped("tshirt.json"));
    document.run(RemoveParts{.panels = {"right_sleeve_front", "right_sleeve_back"}});
    document.run(SymmetricCopy{.panels = {"left_sleeve_front", "left_sleeve_back"}, .is_linked = true});
    const sim::Pattern& pattern = document.pattern();
    const auto of_head = std::ranges::find_if(pattern.seams, [&](const sim::Seam& seam) {
        const std::string first = sim::panel_of(pattern, seam.first).name;
        const std::string second = sim::panel_of(pattern, seam.second).name;
        return first == "front" && second == "left_sleeve_front";
    });
    EXPECT_NE(of_head, pattern.seams.end());
    const sim::Seam seam = of_head == pattern.seams.end() ? sim::Seam{} : *of_head;
    document.run(AddNotch{.panel = "left_sleeve_front", .edge = seam.second.edge, .t = 0.4});
    document.run(AddNotch{.panel = "front", .edge = seam.first.edge, .t = 0.6});
    document.run(SetTartan{.tartan = "black_watch"});
    document.run(MatchSetts{});
    return sim::parse_pattern(document.text(), "linked.json");
}

// The unfolded sleeve: over its hem, with linked halves.
void unfold_over_hem(Document& document, const std::string& sleeve) {
    const sim::Pattern& pattern = document.pattern();
    const int panel = static_cast<int>(panel_in(pattern, sleeve) - pattern.panels.data());
    for (int e = 0; e < static_cast<int>(pattern.panels[as_size(panel)].edges.size()); ++e) {
        if (!seam_at(pattern, {panel, e})) return document.run(UnfoldPanel{sleeve, e, true});
    }
    ADD_FAILURE() << sleeve << " is sewn all round";
}

// The same with sleeves that are twice as long: each part is unfolded over the hem and has linked halves, and its image
// is sewn as it is.
sim::PatternDocument halved_tshirt() {
    Document document(shipped("tshirt.json"));
    document.run(RemoveParts{.panels = {"right_sleeve_front", "right_sleeve_back"}});
    for (const char* sleeve : {"left_sleeve_front", "left_sleeve_back"}) unfold_over_hem(document, sleeve);
    const std::vector<sim::Seam> seams = document.pattern().seams;
    for (const sim::Seam& seam : seams) {
        const sim::Panel one = sim::panel_of(document.pattern(), seam.first);
        const sim::Panel other = sim::panel_of(document.pattern(), seam.second);
        if (!one.name.starts_with("left_sleeve") || !other.name.starts_with("left_sleeve")) continue;
        const auto image = [](const sim::Panel& panel, int edge) {
            return PartRef{panel.name, *find_edge(panel, {edge_key(panel, edge).number, sim::EdgeRole::Image})};
        };
        document.run(SewEdges{image(one, seam.first.edge), image(other, seam.second.edge), seam.is_reversed});
    }
    document.run(SymmetricCopy{.panels = {"left_sleeve_front", "left_sleeve_back"}, .is_linked = true});
    document.run(AddNotch{.panel = "right_sleeve_front", .edge = 0, .t = 0.4});
    document.run(SetTartan{.tartan = "black_watch"});
    document.run(MatchSetts{});
    return sim::parse_pattern(document.text(), "halved.json");
}

TEST(LinkedSleeves, are_sewn_alike_and_stay_linked_in_the_file) {
    Document document(linked_tshirt());
    EXPECT_TRUE(document.take_notes().empty());
    EXPECT_EQ(panel_in(document.pattern(), "right_sleeve_front")->mirror_of, "left_sleeve_front");
    EXPECT_EQ(document.pattern().seams.size(), shipped("tshirt.json").pattern.seams.size());
    EXPECT_EQ(panel_in(document.pattern(), "right_sleeve_front")->notches.size(), 1U);
}

TEST(LinkedSleeves, change_only_the_drawn_panel_in_the_history_when_an_image_is_edited) {
    Document document(linked_tshirt());
    document.run(MoveVertices{.vertices = {{"right_sleeve_front", 0}}, .by = Vec2d(0.002, 0)});
    const SourcesPatch& patch = document.history().back().patch;
    ASSERT_EQ(patch.panels_after.size(), 1U);
    EXPECT_EQ(patch.panels_after.front().name, "left_sleeve_front");
    EXPECT_TRUE(patch.seams_after.empty());
    for (const sim::Panel& source : document.sources().panels) {
        EXPECT_EQ(source.edges.empty(), source.name.starts_with("right_sleeve")) << source.name;
    }
}

TEST(LinkedCopy, follows_its_source_and_leads_it_but_for_where_they_lie) {
    Document document(shipped("two_squares.json"));
    const std::size_t edges = panel_in(document.pattern(), "front")->edges.size();
    document.run(DuplicatePanels{.panels = {"front"}, .move = Vec3d(0, 0, 0.3), .is_linked = true});
    const std::string copy = document.pattern().panels.back().name;
    ASSERT_EQ(document.pattern().panels.back().copy_of, "front");
    document.run(MoveVertices{.vertices = {{copy, 0}}, .by = Vec2d(-0.01, 0)});
    document.run(AddVertex{.panel = "front", .edge = 2, .t = 0.5});
    document.run(SetFabric{.panel = copy, .fabric = "silk"});
    document.run(SetLayer{.panel = copy, .layer = 3});
    document.run(SetSettOffset{.panel = copy, .offset = Vec2d(0.02, 0)});
    document.run(MovePanels{.panels = {copy}, .by = Vec2d(0.5, 0)});
    const sim::Panel& front = *panel_in(document.pattern(), "front");
    const sim::Panel& other = *panel_in(document.pattern(), copy);
    EXPECT_EQ(front.vertices, other.vertices);
    EXPECT_EQ(front.edges, other.edges);
    EXPECT_EQ(front.edges.size(), edges + 1);
    EXPECT_EQ(front.fabric, "silk");
    EXPECT_EQ(front.layer, 0);
    EXPECT_EQ(front.sett_offset, Vec2d(0, 0));
    EXPECT_NE(front.translation, other.translation);
    EXPECT_NE(front.sheet_position, other.sheet_position);
    const std::string text = document.text("f.json");
    Document again(sim::parse_pattern(text, "f.json"));
    EXPECT_TRUE(again.take_notes().empty());
    EXPECT_EQ(again.text("f.json"), text);
    document.run(UnlinkPanel{"front"});
    document.run(SetFabric{.panel = "front", .fabric = "denim"});
    EXPECT_EQ(panel_in(document.pattern(), copy)->fabric, "silk");
}

TEST(LinkedCopy, of_a_mirror_image_belongs_to_its_family) {
    Document document(linked_tshirt());
    document.run(DuplicatePanels{.panels = {"right_sleeve_front"}, .is_linked = true});
    const std::string copy = document.pattern().panels.back().name;
    const std::size_t edges = panel_in(document.pattern(), copy)->edges.size();
    document.run(AddVertex{.panel = copy, .edge = 1, .t = 0.25});
    for (const char* name : {"left_sleeve_front", "right_sleeve_front"})
        EXPECT_EQ(panel_in(document.pattern(), name)->edges.size(), edges + 1) << name;
}

TEST(LinkedPanels, that_another_program_changed_are_told_and_kept) {
    sim::PatternDocument source = linked_tshirt();
    sim::Panel* right = nullptr;
    for (sim::Panel& panel : source.pattern.panels) {
        if (panel.name == "right_sleeve_front") right = &panel;
    }
    right->vertices[0].y() -= 0.005;
    const Vec2d place = right->vertices[0];
    Document document(source);
    ASSERT_EQ(document.take_notes().size(), 1U);
    EXPECT_TRUE(document.take_notes().empty()) << "told once";
    EXPECT_EQ(panel_in(document.pattern(), "right_sleeve_front")->vertices[0], place);
    EXPECT_EQ(panel_in(document.pattern(), "right_sleeve_front")->mirror_of, "");
    EXPECT_EQ(panel_in(document.pattern(), "right_sleeve_back")->mirror_of, "left_sleeve_back");
}

TEST(LinkedPanels, are_told_to_be_linked_no_longer_when_a_command_ends_their_link) {
    const auto notes_of = [](const Command& command) {
        Document document(linked_tshirt());
        document.run(command);
        return document.take_notes();
    };
    using Notes = std::vector<std::string>;
    const Notes fronts{"'right_sleeve_front' is no longer linked to 'left_sleeve_front'"};
    const Notes backs{"'right_sleeve_back' is no longer linked to 'left_sleeve_back'"};
    const Document document(linked_tshirt());
    const sim::Pattern& pattern = document.pattern();
    for (const char* name : {"left_sleeve_front", "right_sleeve_front"}) {
        const Eigen::AlignedBox2d box = outline_box(*panel_in(pattern, name));
        const double y = box.center().y();
        EXPECT_EQ(notes_of(CutPanel{.panel = name, .path = {Vec2d(box.min().x(), y), Vec2d(box.max().x(), y)}}),
                  fronts);
        EXPECT_EQ(notes_of(UnlinkPanel{name}), Notes{});
    }
    EXPECT_EQ(notes_of(RemoveParts{.panels = {"left_sleeve_back"}}), backs);
    EXPECT_EQ(notes_of(RemoveParts{.panels = {"right_sleeve_back"}}), Notes{}) << "the drawn one is there alone";
    EXPECT_EQ(notes_of(RenamePanel{"left_sleeve_back", "other"}), Notes{});
    const auto seam = std::ranges::find_if(pattern.seams, [&](const sim::Seam& one) {
        return sim::panel_of(pattern, one.first).name.starts_with("left_sleeve") &&
               sim::panel_of(pattern, one.second).name.starts_with("left_sleeve");
    });
    ASSERT_NE(seam, pattern.seams.end());
    const Notes both{fronts[0], backs[0]};
    EXPECT_EQ(notes_of(MergePanels{static_cast<int>(seam - pattern.seams.begin())}), both);
}

TEST(LinkedPanels, of_which_a_file_places_the_image_otherwise_are_placed_by_their_source) {
    sim::PatternDocument source = linked_tshirt();
    for (sim::Panel& panel : source.pattern.panels) {
        if (panel.name == "right_sleeve_front") panel.translation.y() += 0.1;
    }
    Document document(source);
    EXPECT_EQ(document.take_notes(),
              std::vector<std::string>{"'right_sleeve_front' was moved to where the mirror image "
                                       "of its source stands"});
    EXPECT_EQ(panel_in(document.pattern(), "right_sleeve_front")->mirror_of, "left_sleeve_front");
}

TEST(Document, of_a_newer_format_says_why_it_is_not_to_be_saved) {
    EXPECT_FALSE(Document(shipped("tshirt.json")).read_only_reason());
    sim::PatternDocument source = shipped("tshirt.json");
    source.json["selvedge"]["format"] = sim::Json(sim::kGarmentFormat + 1);
    EXPECT_TRUE(Document(source).read_only_reason());
}

// The halves of a panel that are linked are mirror images.
void expect_halves_alike(const sim::Pattern& pattern) {
    for (const sim::Panel& panel : pattern.panels) {
        if (!sim::has_linked_halves(panel)) continue;
        const auto half = half_of(panel, sim::EdgeRole::Drawn), other = half_of(panel, sim::EdgeRole::Image);
        ASSERT_TRUE(half && other) << panel.name;
        ASSERT_EQ(half->edges.size(), other->edges.size()) << panel.name;
        ASSERT_EQ(panel.notches.size(), 2 * half->notches.size()) << panel.name;
        for (const sim::OutlineEdge& edge : half->edges) {
            const auto image = find_edge(*other, edge.key);
            ASSERT_TRUE(image) << panel.name << " " << edge.key.number;
            for (const double t : {0.0, 0.3, 0.8}) {
                const Vec2d there = outline_point(*other, other->edges[as_size(*image)], 1 - t);
                ASSERT_LT((fold_reflection(*half) * outline_point(*half, edge, t) - there).norm(), 1e-9) << panel.name;
            }
        }
    }
}

struct RandomRun {
    int done = 0;
    int on_linked = 0;  // with linked panels in the pattern
    int divided = 0;    // and edges split or joined
    int on_halves = 0;  // with linked halves in the pattern
    int divided_halves = 0;
    int ended = 0;  // links that were told to have ended
};

// What is to be told after a command that may end links: which of the panels that are still there lost theirs.
std::vector<std::string> ended_links(const sim::Pattern& before, const sim::Pattern& after, const Command& command) {
    std::vector<std::string> notes;
    const bool may_end = std::holds_alternative<CutPanel>(command) || std::holds_alternative<MergePanels>(command) ||
                         std::holds_alternative<UnfoldPanel>(command) || std::holds_alternative<RemoveParts>(command);
    if (!may_end) return notes;
    for (const sim::Panel& was : before.panels) {
        const sim::Panel* now = panel_in(after, was.name);
        if (now == nullptr) continue;
        const std::string& source = was.mirror_of.empty() ? was.copy_of : was.mirror_of;
        if (!source.empty() && now->mirror_of.empty() && now->copy_of.empty())
            notes.push_back("'" + was.name + "' is no longer linked to '" + source + "'");
        if (was.fold_key > 0 && now->fold_key != was.fold_key)
            notes.push_back("the halves of '" + was.name + "' are no longer linked");
    }
    return notes;
}

void try_command(Document& document, const Command& command, RandomRun& run) {
    const sim::Pattern before = document.pattern();
    try {
        document.run(command);
    } catch (const GeometryError&) {
        ASSERT_EQ(document.pattern(), before);
        return;
    }
    const sim::Pattern& after = document.pattern();
    ASSERT_EQ(evaluate(document.sources()), after);
    ASSERT_EQ(sources_of(after), document.sources());
    const std::vector<std::string> ended = ended_links(before, after, command);
    std::vector<std::string> notes = document.take_notes();
    std::erase_if(notes, [](const std::string& note) { return note.find("' was merged into '") != std::string::npos; });
    ASSERT_EQ(notes, ended);
    run.ended += static_cast<int>(ended.size());
    Effect effect = effect_of(command);
    effect.moves = effect.moves || (std::holds_alternative<RemoveParts>(command) && !has_same_outlines(before, after));
    const bool is_linked =
        std::ranges::any_of(after.panels, [](const sim::Panel& p) { return sim::link_of(p).has_value(); });
    ++run.done;
    run.on_linked += is_linked ? 1 : 0;
    run.divided += is_linked && !has_same_edges(before, after) ? 1 : 0;
    const bool has_halves = std::ranges::any_of(after.panels, sim::has_linked_halves);
    run.on_halves += has_halves ? 1 : 0;
    run.divided_halves += has_halves && !has_same_edges(before, after) ? 1 : 0;
    expect_halves_alike(after);
    if (std::holds_alternative<RenamePanel>(command)) return;
    expect_same_places(before, after, effect);
    expect_same_selected(before, after);
    if (!effect.moves && !effect.removes) expect_same_points(before, after);
}

constexpr unsigned kRounds = 10;

// A tenth of ten thousand random commands.
RandomRun run_random_commands(const sim::PatternDocument& source, unsigned tenth) {
    RandomRun run;
    for (unsigned round = tenth * kRounds; round < (tenth + 1) * kRounds; ++round) {
        Document document(source);
        const std::string first = document.text();
        std::string journal = journal_head("linked.json", first) + "\n";
        document.set_journal([&](std::string_view line) { journal += std::string(line) + "\n"; });
        RandomCommands commands(round * 31 + 7);
        for (int i = 0; i < 100; ++i) {
            if (commands.pick(12) == 0) document.undo();
            if (commands.pick(24) == 0) document.redo();
            const Command command = commands.next(document.pattern());
            SCOPED_TRACE("round " + std::to_string(round) + ", step " + std::to_string(i) + ": " + label_of(command));
            try_command(document, command, run);
            if (::testing::Test::HasFatalFailure()) return run;
        }
        EXPECT_EQ(recover(journal)->text, document.text()) << round;
        EXPECT_FALSE(sim::has_error(sim::check_pattern_text(document.text(), "linked.json"))) << round;
        document.go_to(0);
        EXPECT_EQ(document.text(), first) << round;
        if (::testing::Test::HasFailure()) return run;
    }
    EXPECT_GT(run.done, 300);
    EXPECT_GT(run.ended, 0);
    ::testing::Test::RecordProperty("done", run.done);
    return run;
}

class RandomSleeves : public ::testing::TestWithParam<unsigned> {};

// scripts/checks leaves out what is named so, for the address sanitizer takes 20 times as long.
INSTANTIATE_TEST_SUITE_P(WithoutSanitizers, RandomSleeves, ::testing::Range(1U, 10U));
INSTANTIATE_TEST_SUITE_P(FirstTenth, RandomSleeves, ::testing::Values(0U));

TEST_P(RandomSleeves, keep_all_references_at_their_places_through_a_thousand_random_commands) {
    const RandomRun run = run_random_commands(linked_tshirt(), GetParam());
    EXPECT_GT(run.on_linked, 200);
    EXPECT_GT(run.divided, 30);
    RecordProperty("on_linked", run.on_linked);
    RecordProperty("divided", run.divided);
}

TEST_P(RandomSleeves, with_linked_halves_keep_all_references_through_a_thousand_random_commands) {
    const RandomRun run = run_random_commands(halved_tshirt(), GetParam());
    EXPECT_GT(run.on_halves, 200);
    EXPECT_GT(run.divided_halves, 10);
    RecordProperty("on_halves", run.on_halves);
    RecordProperty("divided_halves", run.divided_halves);
}

}  // namespace
}  // namespace selvedge::editor
