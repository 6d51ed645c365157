// Sessions whose outlines get and lose points while the garment hangs.
#include <gtest/gtest.h>

#include "sim/pattern/edge_keys.h"
#include "sim/pattern/edge_shape.h"
#include "sim/session/session.h"
#include "tests/sim/session/session_support.h"

namespace selvedge::sim::test {
namespace {

// Splits a seam at the fraction t of its first side, and that side and the other one.
void split_seam(Pattern& pattern, std::size_t index, double t) {
    Seam& seam = pattern.seams[index];
    Seam rest = seam;
    selvedge::sim::split_edge(pattern.panels[as_size(seam.first.panel)], seam.first.edge, t);
    selvedge::sim::split_edge(pattern.panels[as_size(seam.second.panel)], seam.second.edge, 1 - t);
    for (Seam& other : pattern.seams) {
        for (SeamSide* side : {&other.first, &other.second}) {
            for (const SeamSide& split : {rest.first, rest.second}) {
                if (side->panel == split.panel && side->edge > split.edge) ++side->edge;
            }
        }
    }
    ++rest.first.edge;
    ++pattern.seams[index].second.edge;
    pattern.seams.push_back(rest);
}

TEST(SessionOfChangingOutlines, goes_on_from_where_it_hangs_when_points_are_added_and_removed) {
    Pattern pattern = session_pattern("two_squares");
    for (Panel& panel : pattern.panels) give_keys(panel);
    Session session{SessionDrive::Caller};
    session.set_body(session_body());
    session.set_options(coarse_options());
    session.set_pattern(pattern);
    session.advance(0);
    settle(session);
    const auto before = session.frame();
    Pattern split = pattern;
    split_seam(split, 0, 0.3);
    for (const Pattern& next : {split, pattern}) {
        session.set_pattern(next);
        session.advance(0);
        EXPECT_EQ(session.frame()->stage, SessionStage::Draping);
        EXPECT_LT(mean_move(*before, *session.frame()), 0.02);
        session.advance(400);
        EXPECT_EQ(session.frame()->stage, SessionStage::Settled);
    }
    EXPECT_TRUE(session.frame()->messages.empty());
}

}  // namespace
}  // namespace selvedge::sim::test
