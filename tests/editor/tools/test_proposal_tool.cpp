// The tool that goes through proposed seams: one key sews, refuses, turns round or goes on.
#include "editor/tools/proposal_tool.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/editor/tools/tool_support.h"

namespace selvedge::editor {
namespace {

// A front and a back of one shape, beside each other, so that their sides and shoulders are alike.
sim::PatternDocument two_bodices() {
    sim::Panel front;
    front.name = "front";
    front.vertices = {{0, 0},       {0.5, 0},     {0.52, 0.3}, {0.45, 0.5},
                      {0.33, 0.55}, {0.17, 0.55}, {0.05, 0.5}, {-0.02, 0.3}};
    for (int i = 0; i < 8; ++i) front.edges.push_back({i, (i + 1) % 8});
    front.sheet_position = Vec2d(0, 0);
    sim::Panel back = front;
    back.name = "back";
    back.sheet_position = Vec2d(0.7, 0);
    sim::PatternDocument document;
    document.pattern.panels = {front, back};
    return document;
}

struct ProposalUser : SheetUser {
    ProposalUser() : SheetUser(two_bodices()) {
        tools.choose(host(), proposal_tool());
        move({0.6, 0.2});
    }
    std::size_t shown() {
        return static_cast<std::size_t>(
            std::ranges::count_if(overlay().labels, [](const auto& label) { return label.text.ends_with("%"); }));
    }
};

TEST(ProposalTool, shows_a_dashed_link_with_its_confidence_for_each_proposal) {
    ProposalUser user;
    EXPECT_GE(user.shown(), 3U);
    EXPECT_EQ(user.pattern().seams.size(), 0U);
    const ToolOverlay overlay = user.overlay();
    EXPECT_GE(std::ranges::count_if(overlay.lines, [](const OverlayLine& line) { return line.is_dashed; }), 3);
    ASSERT_GE(overlay.readout.size(), 2U);
    EXPECT_TRUE(overlay.readout[1].starts_with("lengths")) << overlay.readout[1];
}

TEST(ProposalTool, enter_sews_the_marked_one_and_undo_takes_it_back) {
    ProposalUser user;
    const std::size_t before = user.shown();
    EXPECT_TRUE(user.key(Key::Enter));
    ASSERT_FALSE(user.pattern().seams.empty());  // one for each pair of edges that it runs over
    for (const sim::Seam& seam : user.pattern().seams) EXPECT_TRUE(seam.is_reversed);
    user.move({0.61, 0.2});
    EXPECT_LT(user.shown(), before);
    user.document.undo();
    EXPECT_EQ(user.pattern().seams.size(), 0U);
    user.move({0.6, 0.2});
    EXPECT_EQ(user.shown(), before);
}

TEST(ProposalTool, proposes_no_seam_to_a_hidden_or_locked_panel) {
    ProposalUser user;
    ASSERT_GE(user.shown(), 3U);
    user.document.set_panel_states({.hidden = {}, .locked = {"back"}});
    user.move({0.61, 0.2});
    EXPECT_EQ(user.shown(), 0U);
    EXPECT_FALSE(user.key(Key::Enter));
    user.document.set_panel_states({});
    user.move({0.6, 0.2});
    EXPECT_GE(user.shown(), 3U);
}

// The drawing of a garment may say in its title what its panels do not.
TEST(ProposalTool, proposes_what_the_texts_of_the_drawing_suggest) {
    const auto first_with = [](const std::string& hints) {
        SheetUser user(two_bodices());
        user.document.set_hints(hints);
        user.tools.choose(user.host(), proposal_tool());
        user.move({0.6, 0.2});
        return user.overlay().readout;
    };
    sim::Pattern pattern = two_bodices().pattern;
    const auto proposals = propose_seams(pattern, {.least_confidence = 0.15, .hints = "trousers"});
    ASSERT_FALSE(proposals.empty());
    const std::string expected = describe(pattern, proposals.front());
    EXPECT_EQ(first_with("trousers").at(0), expected.substr(0, expected.find(':')));
    EXPECT_NE(first_with("trousers"), first_with(""));
}

TEST(ProposalTool, delete_refuses_tab_goes_on_and_r_turns_round) {
    ProposalUser user;
    const std::size_t before = user.shown();
    const std::string first = user.overlay().readout[0];
    EXPECT_TRUE(user.key(Key::Tab));
    const std::string second = user.overlay().readout[0];
    EXPECT_NE(second, first);
    EXPECT_TRUE(user.key(Key::Delete));
    EXPECT_EQ(user.shown(), before - 1);
    EXPECT_NE(user.overlay().readout[0], second);
    EXPECT_TRUE(user.key(key_of('R')));
    EXPECT_TRUE(user.key(Key::Enter));
    ASSERT_FALSE(user.pattern().seams.empty());
    for (const sim::Seam& seam : user.pattern().seams) EXPECT_FALSE(seam.is_reversed);
}

}  // namespace
}  // namespace selvedge::editor
