// Sessions: stages, edits while draping, dragging and pinning, the worker thread. Also the plain data of a frame:
// levels, hierarchy, strain and clearance.
#include <gtest/gtest.h>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>

#include "sim/cloth/cloth.h"
#include "sim/core/math.h"
#include "sim/core/parallel.h"
#include "sim/dress/dressing.h"
#include "sim/inspection/report.h"
#include "sim/mannequin/mannequin.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/mesh/sew.h"
#include "sim/pattern/pattern_file.h"
#include "sim/place/fit.h"
#include "sim/session/dress.h"
#include "sim/session/session.h"
#include "sim/session/session_frame.h"
#include "tests/sim/dress/shapes.h"
#include "tests/sim/session/session_support.h"
#include "tests/support/bodies.h"
#include "tests/support/wait_until.h"

namespace selvedge::sim::test {
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
    ASSERT_FALSE(frame->seam_lines.empty());
    ASSERT_EQ(frame->seam_lines.size(), frame->seam_line_seams.size());
    for (const int seam : frame->seam_line_seams) EXPECT_LT(seam, int(pattern_.seams.size()));
    for (const auto& [a, b] : frame->seam_lines) EXPECT_GT((a - b).norm(), 0.05F);
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
    EXPECT_TRUE(frame->seam_lines.empty());
    EXPECT_TRUE(frame->messages.empty()) << frame->messages.back();
    EXPECT_NEAR(int(frame->mesh.triangles.size()), dressed.report.mesh.leaf_triangles,
                0.4 * dressed.report.mesh.leaf_triangles);  // its mesh may be finer, as look-ahead requests
    EXPECT_NEAR(stretch_p99(frame->mesh), dressed.report.stretch.warp_weft_p99, 0.005);
    EXPECT_GT(min_clearance(frame->mesh), -0.0005F);
}

TEST_F(SessionOfTwoSquares, gives_the_cloth_at_rest_and_copies_it_once) {
    settle(session_);
    const auto first = session_.frame();
    ASSERT_TRUE(first->cloth);
    EXPECT_EQ(draw_mesh(*first->cloth, first->mesh.panel_names), first->mesh);
    ASSERT_TRUE(first->collider);
    EXPECT_GT(first->collider->contact(first->mesh.x.front()).distance, 0);
    session_.pin(furthest_point(*first, 0, {0, 1, 0}));
    session_.advance(0);
    EXPECT_NE(session_.frame(), first);
    EXPECT_EQ(session_.frame()->cloth, first->cloth);
    pattern_.fabric = "denim";
    session_.set_pattern(pattern_);
    session_.advance(1);
    EXPECT_FALSE(session_.frame()->cloth) << "it moves";
    session_.advance(400);
    ASSERT_TRUE(session_.frame()->cloth);
    EXPECT_EQ(draw_mesh(*session_.frame()->cloth, first->mesh.panel_names), session_.frame()->mesh);
}

TEST_F(SessionOfTwoSquares, gives_the_same_bits_twice) {
    settle(session_);
    Session second(SessionDrive::Caller);
    second.set_body(session_body());
    second.set_options(coarse_options());
    second.set_pattern(pattern_);
    settle(second);
    EXPECT_EQ(session_.frame()->mesh, second.frame()->mesh);
    EXPECT_EQ(session_.frame()->number, second.frame()->number + 1);  // the fixture has published one frame before
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
    EXPECT_FALSE(session_.frame()->seam_lines.empty());
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
    EXPECT_GT(min_clearance(session_.frame()->mesh), -0.0005F);
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

TEST(Session, of_default_options_may_be_refined_further_while_it_hangs) {
    Session session(SessionDrive::Caller);
    session.set_body(session_body());
    session.set_options({});
    session.set_pattern(session_pattern("two_squares"));
    settle(session);
    ASSERT_EQ(session.frame()->stage, SessionStage::Settled);
    ASSERT_LE(session.frame()->statistics.by_level.size(), 4U);
    SessionOptions finer;
    finer.max_level = 5;
    finer.shortest_edge = 0.002;
    finer.triangle_budget = 20000;
    session.set_options(finer);
    session.advance(20);
    EXPECT_GT(session.frame()->statistics.by_level.size(), 4U);
}

TEST(Session, refuses_an_edge_length_that_cannot_be_meshed_and_takes_the_other_options) {
    Pattern pattern = session_pattern("two_squares");
    for (Panel& panel : pattern.panels) {
        for (Vec2d& vertex : panel.vertices) vertex *= 4;
    }
    Session session(SessionDrive::Caller);
    session.set_body(session_body());
    session.set_options(coarse_options());
    session.set_pattern(pattern);
    session.start();
    session.advance(3);
    ASSERT_EQ(session.frame()->stage, SessionStage::Sewing);
    const auto before = session.frame();
    SessionOptions options = coarse_options();
    options.edge_length = 0.005;
    options.max_level = 0;
    session.set_options(options);
    session.advance(0);
    EXPECT_NE(session.frame()->problem, "");
    EXPECT_EQ(session.frame()->stage, SessionStage::Sewing);
    EXPECT_EQ(session.frame()->mesh.x, before->mesh.x);
    session.advance(1);
    EXPECT_EQ(session.frame()->statistics.base_triangles, before->statistics.base_triangles);
    options.edge_length = 0.2;
    session.set_options(options);
    session.advance(0);
    EXPECT_LT(session.frame()->statistics.base_triangles, before->statistics.base_triangles);
}

TEST_F(SessionOfTwoSquares, wears_a_sett_that_was_moved_while_it_was_sewn) {
    session_.start();
    session_.advance(3);
    ASSERT_EQ(session_.frame()->stage, SessionStage::Sewing);
    pattern_.panels[0].sett_offset = Vec2d(0.05, 0.02);
    session_.set_pattern(pattern_);
    session_.advance(600);
    ASSERT_EQ(session_.frame()->stage, SessionStage::Settled);
    EXPECT_EQ(session_.frame()->mesh.panel_sett_offsets.at(0), Vec2f(0.05F, 0.02F));
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
    session_.save_drape("first");
    session_.reset();
    session_.advance(0);
    session_.restore_drape("first");
    session_.advance(0);
    EXPECT_EQ(session_.frame()->mesh, kept->mesh);
    EXPECT_EQ(session_.frame()->stage, SessionStage::Settled);
    split_edge(pattern_, 0, 0);
    session_.set_pattern(pattern_);
    session_.restore_drape("first");
    session_.advance(0);
    EXPECT_NE(session_.frame()->messages.back().find("another cut"), std::string::npos);
    session_.restore_drape("second");
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
    EXPECT_GT(min_clearance(frame->mesh), -0.0005F);
    EXPECT_NEAR(stretch_p99(frame->mesh), dressed.report.stretch.warp_weft_p99, 0.005);
    EXPECT_NEAR(frame->statistics.leaf_triangles, dressed.report.mesh.leaf_triangles,
                0.1 * dressed.report.mesh.leaf_triangles);
}

// Position of the mesh vertex nearest in the material to a point of another mesh, in the same panel, m.
Vec3f nearest_vertex(const DrawMesh& mesh, const DrawMesh& other, const ClothPoint& point) {
    Vec2f wanted = Vec2f::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
        wanted += point.weights[static_cast<Eigen::Index>(k)] * other.u[point.triangle][k];
    }
    Vec3f found = Vec3f::Zero();
    float least = 10;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (mesh.panel[t] != other.panel[point.triangle]) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const float distance = (mesh.u[t][k] - wanted).norm();
            if (distance >= least) continue;
            least = distance;
            found = mesh.x[mesh.triangles[t][k]];
        }
    }
    return found;
}

// The corner nearest to the plane x = 0 on the lowest edge of a panel, as a point of its triangle.
ClothPoint middle_of_hem(const SessionFrame& frame, int panel) {
    const DrawMesh& mesh = frame.mesh;
    float hem = std::numeric_limits<float>::max(), least = hem;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (mesh.panel[t] != panel) continue;
        for (const Vec2f& u : mesh.u[t]) hem = std::min(hem, u.y());
    }
    ClothPoint middle{.frame = frame.number};
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (mesh.panel[t] != panel) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const float off = std::abs(mesh.x[mesh.triangles[t][k]].x());
            if (mesh.u[t][k].y() > hem + 1e-4F || off >= least) continue;
            least = off;
            middle.triangle = static_cast<std::uint32_t>(t);
            middle.weights = Vec3f::Unit(static_cast<int>(k));
        }
    }
    return middle;
}

class SessionDrags : public testing::Test {
 protected:
    SessionDrags() {
        session_.set_body(session_body());
        SessionOptions options = coarse_options();
        options.max_level = 2;
        session_.set_options(options);
        session_.set_pattern(session_pattern("two_squares"));
        settle(session_);
    }

    // m, to the nearest vertex of the displayed cloth.
    float nearest_to(const Vec3f& place) const {
        float least = 10;
        for (const Vec3f& x : session_.frame()->mesh.x) least = std::min(least, (x - place).norm());
        return least;
    }

    Session session_{SessionDrive::Caller};
};

TEST_F(SessionDrags, a_pulled_point_comes_along_and_to_rest) {
    const auto before = session_.frame();
    const ClothPoint hem = middle_of_hem(*before, 0);
    const Vec3f goal = position_of(*before, hem) + Vec3f(0, 0.05F, 0.08F);
    session_.pull(hem, goal);
    session_.advance(1);
    EXPECT_EQ(session_.frame()->stage, SessionStage::Draping);
    session_.advance(400);
    EXPECT_EQ(session_.frame()->stage, SessionStage::Settled);
    EXPECT_LT(nearest_to(goal), 0.005F);
    EXPECT_GT(min_clearance(session_.frame()->mesh), -0.0005F);
    session_.let_go();
    session_.advance(400);
    EXPECT_EQ(session_.frame()->stage, SessionStage::Settled);
    EXPECT_GT(nearest_to(goal), 0.01F);
}

// An editor sets the drag's target in each of its frames.
TEST_F(SessionDrags, a_garment_that_a_hand_holds_still_settles_and_costs_no_steps) {
    const auto before = session_.frame();
    const ClothPoint hem = middle_of_hem(*before, 0);
    const Vec3f goal = position_of(*before, hem) + Vec3f(0, 0.05F, 0.08F);
    session_.pull(hem, goal);
    for (int i = 0; i < 400; ++i) {
        session_.pull_to(goal);
        session_.advance(1);
    }
    EXPECT_EQ(session_.frame()->stage, SessionStage::Settled);
    const double settled_at = session_.frame()->statistics.simulated_seconds;
    for (int i = 0; i < 30; ++i) {
        session_.pull_to(goal);
        session_.advance(1);
    }
    EXPECT_EQ(session_.frame()->statistics.simulated_seconds, settled_at);
    session_.pull_to(goal + Vec3f(0, 0.02F, 0));
    session_.advance(1);
    EXPECT_EQ(session_.frame()->stage, SessionStage::Draping);
}

TEST_F(SessionDrags, a_pull_that_the_cloth_cannot_follow_neither_tears_it_nor_pushes_it_into_the_body) {
    const auto before = session_.frame();
    const ClothPoint hem = middle_of_hem(*before, 0);
    for (const Vec3f& way : {Vec3f(0, 0, 3), Vec3f(0, 0.1F, -1), Vec3f(0, -4, 0)}) {
        session_.pull(hem, position_of(*before, hem) + way);
        for (int i = 0; i < 10; ++i) {
            session_.advance(6);
            ASSERT_EQ(session_.frame()->problem, "");
            EXPECT_LT(stretch_p99(session_.frame()->mesh), 0.08);
            EXPECT_GT(min_clearance(session_.frame()->mesh), -0.0005F);
        }
    }
    session_.let_go();
    session_.advance(400);
    EXPECT_EQ(session_.frame()->stage, SessionStage::Settled);
}

TEST_F(SessionDrags, a_pin_holds_its_point_exactly_whatever_is_pulled) {
    const auto before = session_.frame();
    const ClothPoint hem = furthest_point(*before, 0, Vec3f(0, -1, 0));
    session_.pin(hem);
    session_.advance(0);
    ASSERT_EQ(session_.frame()->pins.size(), 1U);
    const Vec3f pinned = session_.frame()->pins.front();
    EXPECT_EQ(pinned, position_of(*before, hem));
    // On the other side of the body: where hems meet in a seam, the lowest points of both panels are one
    const ClothPoint pulled = furthest_point(*before, 1, Vec3f(pinned.x() > 0 ? -1.0F : 1.0F, -1, 0));
    ASSERT_GT((position_of(*before, pulled) - pinned).norm(), 0.1F);
    session_.pull(pulled, Vec3f(0.4F, 1.2F, -0.4F));
    for (int i = 0; i < 30; ++i) {
        session_.advance(3);
        ASSERT_EQ(session_.frame()->pins.size(), 1U);
        EXPECT_EQ(session_.frame()->pins.front(), pinned);
        EXPECT_EQ(nearest_to(pinned), 0);
    }
    session_.unpin_all();
    session_.advance(60);
    EXPECT_TRUE(session_.frame()->pins.empty());
    EXPECT_GT(nearest_to(pinned), 0);
}

TEST_F(SessionDrags, a_pin_outlives_other_levels_and_an_edited_outline) {
    session_.pin(furthest_point(*session_.frame(), 0, Vec3f(1, 0, 1)));
    SessionOptions options = coarse_options();
    options.max_level = 0;
    session_.set_options(options);
    session_.advance(40);
    ASSERT_EQ(session_.frame()->pins.size(), 1U);
    Pattern pattern = session_pattern("two_squares");
    pattern.panels[0].vertices[0].y() -= 0.02;
    session_.set_pattern(pattern);
    session_.advance(40);
    EXPECT_EQ(session_.frame()->pins.size(), 1U);
    EXPECT_EQ(nearest_to(session_.frame()->pins.front()), 0);
}

TEST_F(SessionDrags, take_hold_of_what_was_seen_some_frames_ago) {
    const auto before = session_.frame();
    const ClothPoint hem = furthest_point(*before, 0, Vec3f(0, -1, 0));
    SessionOptions options = coarse_options();
    options.max_level = 0;  // other triangles
    session_.set_options(options);
    session_.advance(10);
    session_.pin(hem);
    session_.advance(0);
    ASSERT_EQ(session_.frame()->pins.size(), 1U);
    EXPECT_EQ(session_.frame()->pins.front(), nearest_vertex(session_.frame()->mesh, before->mesh, hem));
    for (int i = 0; i < 10; ++i) {
        options.max_level = 1 - options.max_level;  // or it would come to rest
        session_.set_options(options);
        session_.advance(10);
    }
    session_.pin(hem);
    session_.advance(0);
    EXPECT_EQ(session_.frame()->pins.size(), 1U);
    ASSERT_FALSE(session_.frame()->messages.empty());
    EXPECT_EQ(session_.frame()->messages.back(), "what was to be pinned is no longer there");
}

TEST_F(SessionDrags, go_with_a_reset) {
    session_.pin(furthest_point(*session_.frame(), 0, Vec3f(0, -1, 0)));
    session_.reset();
    settle(session_);
    EXPECT_TRUE(session_.frame()->pins.empty());
}

// A small box: its collider is built quickly.
std::shared_ptr<const Body> small_body() {
    static const auto body = std::make_shared<const Body>(shapes::box(Vec3d(-0.1, 0, -0.06), Vec3d(0.1, 1.7, 0.06), 6));
    return body;
}

Pattern small_pattern() {
    Pattern pattern = tube(0.40, 0.2, 1.2, 0.15);
    pattern.body = "mannequin:sex=female,height=170,resolution=1";
    pattern.edge_length = 0.08;
    return pattern;
}

TEST(SessionThread, settles_by_itself_and_then_makes_no_frames) {
    Session session;
    session.set_options(coarse_options());
    session.set_body(session_body());
    session.set_pattern(session_pattern("two_squares"));
    session.start();
    ASSERT_TRUE(wait_until([&] { return session.frame()->stage == SessionStage::Settled; }));
    const auto number = session.frame()->number;
    EXPECT_FALSE(wait_until([&] { return session.frame()->number != number; }, std::chrono::milliseconds(150)));
    session.pull(furthest_point(*session.frame(), 0, Vec3f(0, -1, 0)), Vec3f(0, 1, 0.3F));
    EXPECT_TRUE(wait_until([&] { return session.frame()->number > number + 3; }));
}

// A session's thread ends by an exception that the dressing's interrupt throws: the long operation, making the
// collider, must call it often, and let its exception through. From some call on, the interrupt throws at every call,
// as a session's does: each other thread calls it once more at most.
TEST(Dressing, can_be_interrupted_while_a_collider_is_made) {
    struct Stop {};
    // The calls of the interrupt; it throws from the call `first` on.
    const auto calls_until = [](int first) -> int {
        std::atomic<int> calls = 0;
        Dressing dressing([&] {
            if (++calls >= first) throw Stop();
        });
        dressing.set_body(session_body());
        dressing.set_pattern(session_pattern("two_squares"));
        if (first == std::numeric_limits<int>::max())
            dressing.collider();
        else
            EXPECT_THROW(dressing.collider(), Stop) << first;
        return calls;
    };
    const int in_all = calls_until(std::numeric_limits<int>::max());
    EXPECT_GE(in_all, 100);
    for (const int first : {1, in_all / 2}) EXPECT_LE(calls_until(first), first + allowed_threads() - 1);
}

TEST(SessionThread, takes_whatever_is_asked_for_in_quick_succession) {
    for (int round = 0; round < 200; ++round) {
        Session session;
        SessionOptions options = coarse_options();
        options.keeps_real_time = round % 2 == 0;
        options.max_level = round % 3;
        session.set_options(options);
        Pattern pattern = small_pattern();
        session.set_pattern(pattern);
        session.set_body(small_body());
        session.start();
        if (round % 4 == 1) session.pause();
        pattern.panels[0].vertices[0].x() -= 0.001 * round;
        session.set_pattern(pattern);
        session.pull({.frame = session.frame()->number}, Vec3f(0, 1, 1));
        if (round % 5 == 0) session.reset();
        session.start();
        session.pin({.frame = session.frame()->number, .triangle = 3});
        session.save_drape("it");
        session.restore_drape("it");
        if (round % 25 == 0) {  // ends while it sews, at another frame each time
            const auto last = static_cast<std::uint64_t>(2 + round / 25);
            ASSERT_TRUE(wait_until([&] { return session.frame()->number >= last; })) << "round " << round;
        }
        session.let_go();
        session.unpin_all();
        ASSERT_NE(session.frame(), nullptr);
    }
}

Cloth flat_tube() {
    Pattern pattern = tube(0.4, 0.3, 0.8, 0.15);
    pattern.seams.clear();
    return make_cloth(assemble(pattern), {Fabric{}, Fabric{}});
}

void split_all_base_edges(Cloth& cloth) {
    for (std::size_t e = 0; e < cloth.mesh.base_edge_count(); ++e)
        cloth.mesh.split(EdgeId(static_cast<std::uint32_t>(e)));
    cloth.mesh.retriangulate(0);
    cloth.mesh.refresh_lists();
    size_state(cloth, cloth.mesh.vertex_capacity());
}

TEST(Hierarchy, lists_every_triangle_once_each_before_what_it_was_refined_to) {
    Cloth cloth = flat_tube();
    const std::size_t base = cloth.mesh.base_triangle_count();
    EXPECT_EQ(triangle_hierarchy(cloth).size(), base);
    split_all_base_edges(cloth);
    const TriangleHierarchy all = triangle_hierarchy(cloth);
    ASSERT_EQ(all.size(), 5 * base);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(all[i].level, i % 5 == 0 ? 0 : 1) << i;
        EXPECT_EQ(all[i].is_leaf, i % 5 != 0) << i;
        EXPECT_EQ(all[i].panel, all[i - i % 5].panel) << i;
    }
}

TEST(DrawMeshOfCloth, vertices_carry_the_level_that_they_were_born_at) {
    Cloth cloth = flat_tube();
    split_all_base_edges(cloth);
    const DrawMesh mesh = draw_mesh(cloth, {"front", "back"});
    ASSERT_EQ(mesh.vertex_level.size(), mesh.x.size());
    const auto base = std::count(mesh.vertex_level.begin(), mesh.vertex_level.end(), 0);
    EXPECT_EQ(static_cast<std::size_t>(base), cloth.mesh.base_vertex_count());
    EXPECT_EQ(mesh.x.size(), cloth.mesh.base_vertex_count() + cloth.mesh.base_edge_count());
}

TEST(MeshStrainOfCloth, is_what_the_solver_measures) {
    Cloth cloth = flat_tube();
    cloth.material.grain_angles = {0.3F, -0.8F};
    for (Vec4f& x : cloth.x) x = Vec4f(1.04F * x.x() + 0.1F * x.y(), 0.98F * x.y(), x.z() + 0.2F * x.x(), 0);
    const std::vector<TriangleStrain> expected = measure_strain(cloth);
    const std::vector<MeshStrain> strain = measure_strain(draw_mesh(cloth, {"front", "back"}));
    ASSERT_EQ(strain.size(), expected.size());
    for (std::size_t i = 0; i < strain.size(); ++i) {
        EXPECT_NEAR(strain[i].warp, expected[i].warp, 1e-4F);
        EXPECT_NEAR(strain[i].weft, expected[i].weft, 1e-4F);
    }
}

TEST(Clearance, is_the_distance_to_the_surface_and_negative_inside) {
    const Body ball = shapes::sphere(Vec3d(0, 1, 0), 0.2, 48);
    const std::vector<float> distances =
        measure_clearance({Vec3f(0, 1.25F, 0), Vec3f(0.5F, 1, 0), Vec3f(0, 1, 0.19F), Vec3f(0, 6, 0)}, ball);
    ASSERT_EQ(distances.size(), 4U);
    EXPECT_NEAR(distances[0], 0.05F, 1e-3F);
    EXPECT_NEAR(distances[1], 0.30F, 1e-3F);
    EXPECT_NEAR(distances[2], -0.01F, 1e-3F);
    EXPECT_NEAR(distances[3], 4.80F, 1e-3F);
}

}  // namespace
}  // namespace selvedge::sim::test
