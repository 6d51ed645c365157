// The running drape, driven by the caller: the same bits each time, and no clock.
#include "sim/dress/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "sim/body/mannequin.h"
#include "sim/core/quantile.h"
#include "sim/dress/clearance.h"
#include "sim/dress/dress.h"
#include "sim/mesh/mesh_strain.h"
#include "sim/pattern/pattern_file.h"
#include "tests/sim/dress/session_support.h"
#include "tests/sim/dress/shapes.h"

namespace selvedge::test {
namespace {

class SessionOfTwoSquares : public testing::Test {
 protected:
    SessionOfTwoSquares() {
        session_.set_body(session_body());
        session_.set_options(coarse_options());
        session_.set_pattern(pattern_);
        session_.advance(0);
    }
    Pattern pattern_ = session_pattern("two_squares");
    Session session_{SessionDrive::Caller};
};

TEST(Session, begins_empty_with_a_frame_at_hand) {
    const Session session(SessionDrive::Caller);
    ASSERT_NE(session.frame(), nullptr);
    EXPECT_EQ(session.frame()->stage, SessionStage::Empty);
    EXPECT_TRUE(session.frame()->mesh.triangles.empty());
}

TEST(Session, without_a_body_says_that_there_is_none) {
    Session session(SessionDrive::Caller);
    session.set_pattern(session_pattern("two_squares"));
    session.start();
    session.advance(3);
    EXPECT_EQ(session.frame()->stage, SessionStage::Failed);
    EXPECT_NE(session.frame()->problem.find("no body"), std::string::npos);
}

TEST_F(SessionOfTwoSquares, shows_panels_where_they_are_placed_and_threads_of_their_seams) {
    const auto frame = session_.frame();
    EXPECT_EQ(frame->stage, SessionStage::Placed);
    EXPECT_EQ(frame->mesh.panel_names, (std::vector<std::string>{"front", "back"}));
    EXPECT_EQ(frame->hierarchy.size(), frame->mesh.triangles.size());
    ASSERT_FALSE(frame->threads.empty());
    ASSERT_EQ(frame->threads.size(), frame->thread_seams.size());
    for (const int seam : frame->thread_seams) EXPECT_LT(seam, int(pattern_.seams.size()));
    for (const auto& [a, b] : frame->threads) EXPECT_GT((a - b).norm(), 0.05F);
}

TEST_F(SessionOfTwoSquares, follows_a_panel_that_is_moved_while_it_is_only_placed) {
    const auto before = session_.frame();
    pattern_.panels[0].translation.z() += 0.125;
    session_.set_pattern(pattern_);
    session_.advance(0);
    const auto after = session_.frame();
    ASSERT_EQ(before->mesh.x.size(), after->mesh.x.size());
    EXPECT_NEAR(after->mesh.x.front().z() - before->mesh.x.front().z(), 0.125F, 1e-6F);
    EXPECT_EQ(after->mesh.x.back(), before->mesh.x.back());
}

TEST_F(SessionOfTwoSquares, settles_with_the_same_figures_as_dress) {
    DressOptions options;
    options.max_level = 1;
    const DressedGarment dressed = dress(pattern_, *session_body(), options);
    settle(session_);
    const auto frame = session_.frame();
    EXPECT_EQ(frame->stage, SessionStage::Settled);
    EXPECT_TRUE(frame->threads.empty());
    EXPECT_TRUE(frame->messages.empty()) << frame->messages.back();
    EXPECT_NEAR(int(frame->mesh.triangles.size()), dressed.report.mesh.leaf_triangles,
                0.4 * dressed.report.mesh.leaf_triangles);  // its mesh could go deeper, and look-ahead asks that
    EXPECT_NEAR(stretch_p99(frame->mesh), dressed.report.stretch.warp_weft_p99, 0.005);
    EXPECT_GT(least_clearance(frame->mesh), -0.0005F);
}

TEST_F(SessionOfTwoSquares, gives_the_same_bits_twice) {
    settle(session_);
    Session second(SessionDrive::Caller);
    second.set_body(session_body());
    second.set_options(coarse_options());
    second.set_pattern(pattern_);
    settle(second);
    EXPECT_EQ(session_.frame()->mesh, second.frame()->mesh);
    EXPECT_EQ(session_.frame()->number, second.frame()->number + 1);  // it was asked to show itself before
}

TEST_F(SessionOfTwoSquares, makes_no_frames_once_it_has_settled) {
    settle(session_);
    const auto number = session_.frame()->number;
    session_.advance(50);
    EXPECT_EQ(session_.frame()->number, number);
}

TEST_F(SessionOfTwoSquares, pauses_and_goes_on) {
    session_.start();
    session_.advance(5);
    EXPECT_EQ(session_.frame()->stage, SessionStage::Sewing);
    EXPECT_FALSE(session_.frame()->threads.empty());
    session_.pause();
    session_.advance(5);
    const auto paused = session_.frame();
    EXPECT_FALSE(paused->is_running);
    session_.advance(5);
    EXPECT_EQ(session_.frame(), paused);
    session_.start();
    session_.advance(1);
    EXPECT_NE(session_.frame()->mesh.x, paused->mesh.x);
}

TEST_F(SessionOfTwoSquares, goes_back_to_where_the_panels_are_placed) {
    const auto placed = session_.frame();
    settle(session_);
    session_.reset();
    session_.advance(3);
    EXPECT_EQ(session_.frame()->stage, SessionStage::Placed);
    EXPECT_EQ(session_.frame()->mesh, placed->mesh);
}

TEST_F(SessionOfTwoSquares, goes_on_from_where_it_hangs_when_a_point_is_moved) {
    settle(session_);
    const auto before = session_.frame();
    pattern_.panels[0].vertices[0].y() -= 0.03;
    pattern_.panels[0].vertices[1].y() -= 0.03;
    session_.set_pattern(pattern_);
    session_.advance(0);
    const auto edited = session_.frame();
    EXPECT_EQ(edited->stage, SessionStage::Draping);
    EXPECT_LT(mean_move(*before, *edited), 0.02);
    session_.advance(400);
    EXPECT_EQ(session_.frame()->stage, SessionStage::Settled);
    EXPECT_LT(mean_move(*before, *session_.frame()), 0.04);
    EXPECT_TRUE(session_.frame()->messages.empty()) << session_.frame()->messages.back();
    EXPECT_GT(least_clearance(session_.frame()->mesh), -0.0005F);
}

TEST_F(SessionOfTwoSquares, is_sewn_anew_when_a_panel_has_another_edge_and_says_so) {
    settle(session_);
    split_edge(pattern_, 0, 0);
    session_.set_pattern(pattern_);
    session_.advance(0);
    EXPECT_EQ(session_.frame()->stage, SessionStage::Sewing);
    ASSERT_EQ(session_.frame()->messages.size(), 1U);
    EXPECT_EQ(session_.frame()->messages.front(), "'front' has one edge more: sewn anew from where it is placed");
    session_.advance(600);
    EXPECT_EQ(session_.frame()->stage, SessionStage::Settled);
}

TEST_F(SessionOfTwoSquares, changes_its_fabric_where_it_hangs) {
    settle(session_);
    const auto before = session_.frame();
    pattern_.fabric = "denim";
    session_.set_pattern(pattern_);
    session_.advance(0);
    EXPECT_EQ(session_.frame()->stage, SessionStage::Draping);
    EXPECT_EQ(session_.frame()->mesh.x, before->mesh.x);
    session_.advance(400);
    EXPECT_EQ(session_.frame()->stage, SessionStage::Settled);
    EXPECT_GT(mean_move(*before, *session_.frame()), 1e-4);
}

TEST_F(SessionOfTwoSquares, keeps_the_last_drape_on_view_while_a_pattern_cannot_be_meshed) {
    settle(session_);
    const auto before = session_.frame();
    Pattern crossing = pattern_;
    std::swap(crossing.panels[0].vertices[0], crossing.panels[0].vertices[1]);
    session_.set_pattern(crossing);
    session_.advance(3);
    EXPECT_NE(session_.frame()->problem.find("front"), std::string::npos) << session_.frame()->problem;
    EXPECT_EQ(session_.frame()->mesh, before->mesh);
    EXPECT_EQ(session_.frame()->stage, SessionStage::Settled);
    Pattern unknown = pattern_;
    unknown.fabric = "cobweb";
    session_.set_pattern(unknown);
    session_.advance(3);
    EXPECT_NE(session_.frame()->problem.find("cobweb"), std::string::npos) << session_.frame()->problem;
    session_.set_pattern(pattern_);
    session_.advance(3);
    EXPECT_EQ(session_.frame()->problem, "");
    EXPECT_EQ(session_.frame()->mesh, before->mesh);
}

TEST_F(SessionOfTwoSquares, takes_levels_budget_and_bad_options_while_it_hangs) {
    settle(session_);
    SessionOptions options = coarse_options();
    options.max_level = 0;
    session_.set_options(options);
    session_.advance(60);
    EXPECT_EQ(session_.frame()->statistics.leaf_triangles, session_.frame()->statistics.base_triangles);
    options.max_level = 3;
    options.triangle_budget = 1500;
    session_.set_options(options);
    session_.advance(100);
    EXPECT_NEAR(session_.frame()->statistics.leaf_triangles, 1500, 150);
    options.max_level = 1000;
    options.shortest_edge = std::numeric_limits<double>::quiet_NaN();
    options.curvature = {.split_angle = -1, .rejoin_angle = 7};
    options.triangle_budget = -5;
    options.edge_length = 1e9;
    session_.set_options(options);
    session_.advance(20);
    for (const Vec3f& x : session_.frame()->mesh.x) ASSERT_TRUE(x.allFinite());
}

TEST_F(SessionOfTwoSquares, is_another_mesh_with_another_edge_length_and_hangs_on) {
    settle(session_);
    const auto before = session_.frame();
    SessionOptions options = coarse_options();
    options.edge_length = 0.08;
    session_.set_options(options);
    session_.advance(1);
    EXPECT_LT(session_.frame()->statistics.base_triangles, before->statistics.base_triangles);
    EXPECT_LT(mean_move(*before, *session_.frame()), 0.02);
}

TEST_F(SessionOfTwoSquares, shows_a_kept_drape_again) {
    settle(session_);
    const auto kept = session_.frame();
    session_.keep("first");
    session_.reset();
    session_.advance(0);
    session_.restore("first");
    session_.advance(0);
    EXPECT_EQ(session_.frame()->mesh, kept->mesh);
    EXPECT_EQ(session_.frame()->stage, SessionStage::Settled);
    split_edge(pattern_, 0, 0);
    session_.set_pattern(pattern_);
    session_.restore("first");
    session_.advance(0);
    EXPECT_NE(session_.frame()->messages.back().find("another cut"), std::string::npos);
    session_.restore("second");
    session_.advance(0);
    EXPECT_EQ(session_.frame()->messages.back(), "no drape was kept as 'second'");
}

TEST_F(SessionOfTwoSquares, hangs_on_when_the_body_grows_a_little) {
    settle(session_);
    session_.set_body(
        std::make_shared<const Body>(make_mannequin({.measures = {.bust = 0.90}, .subdivisions = 1}).body));
    session_.advance(0);
    EXPECT_EQ(session_.frame()->stage, SessionStage::Draping);
    EXPECT_TRUE(session_.frame()->messages.empty());
}

TEST(SessionOfATshirt, settles_with_the_same_figures_as_dress) {
    const Pattern pattern = session_pattern("tshirt");
    const DressedGarment dressed = dress(pattern, *session_body());
    Session session(SessionDrive::Caller);
    session.set_body(session_body());
    session.set_pattern(pattern);
    settle(session);
    const auto frame = session.frame();
    EXPECT_EQ(frame->stage, SessionStage::Settled);
    EXPECT_TRUE(frame->messages.empty()) << frame->messages.back();
    EXPECT_GT(least_clearance(frame->mesh), -0.0005F);
    EXPECT_NEAR(stretch_p99(frame->mesh), dressed.report.stretch.warp_weft_p99, 0.005);
    EXPECT_NEAR(frame->statistics.leaf_triangles, dressed.report.mesh.leaf_triangles,
                0.1 * dressed.report.mesh.leaf_triangles);
}

}  // namespace
}  // namespace selvedge::test
