// Sessions whose body moves: poses, a motion that is played and sought, back to the start, edits meanwhile.
#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>

#include "sim/body/yielding_flesh.h"
#include "sim/motion/motion_file.h"
#include "sim/place/fit.h"
#include "sim/session/animation.h"
#include "sim/session/session.h"
#include "tests/sim/session/session_support.h"
#include "tests/support/wait_until.h"

namespace selvedge::sim::test {
namespace {

// Where the body is in that frame.
Body body_of(const SessionFrame& frame) {
    Body body = *session_body();
    if (frame.motion.x)
        std::ranges::transform(*frame.motion.x, body.x.begin(), [](const Vec3f& x) { return Vec3d(x.cast<double>()); });
    return body;
}

float clearance(const SessionFrame& frame) {
    const std::vector<float> all = measure_clearance(frame.mesh.x, body_of(frame));
    return *std::ranges::min_element(all);
}

class SessionOnMovingBody : public testing::Test {
 protected:
    SessionOnMovingBody() {
        session_.set_body(session_body());
        session_.set_options(coarse_options());
        session_.set_pattern(pattern_);
        session_.advance(0);
    }
    void settle() {
        session_.start();
        session_.advance(600);
        ASSERT_EQ(session_.frame()->stage, SessionStage::Settled);
    }
    std::shared_ptr<const Clip> clip(const std::string& name) const {
        return std::make_shared<const Clip>(find_motion(name, *session_body()));
    }
    void go_to(const std::string& pose) { session_.go_to(session_body(), find_pose(pose, *session_body())); }
    std::shared_ptr<const SessionFrame> after(int frames) {
        session_.advance(frames);
        return session_.frame();
    }
    Pattern pattern_ = session_pattern("two_squares");
    Session session_{SessionDrive::Caller};
};

TEST_F(SessionOnMovingBody, carries_the_garment_along_to_a_pose_where_it_comes_to_rest) {
    settle();
    go_to("stride");
    auto frame = after(20);
    EXPECT_EQ(frame->stage, SessionStage::Moving);
    EXPECT_TRUE(frame->motion.is_blending);
    ASSERT_NE(frame->motion.x, nullptr);
    EXPECT_GT(clearance(*frame), -0.001F) << "m";
    frame = after(600);
    EXPECT_EQ(frame->stage, SessionStage::Settled);
    EXPECT_GT(clearance(*frame), -0.001F) << "m";
    EXPECT_LT(stretch_p99(frame->mesh), 0.1);
    EXPECT_FALSE(frame->motion.is_at_rest);
    EXPECT_NE(frame->cloth, nullptr);
    EXPECT_NE(frame->collider, nullptr);
}

TEST_F(SessionOnMovingBody, waits_with_a_pose_until_the_garment_hangs) {
    go_to("T");
    auto frame = after(5);
    EXPECT_EQ(frame->stage, SessionStage::Placed);
    EXPECT_TRUE(frame->motion.is_waiting);
    EXPECT_EQ(frame->motion.x, nullptr);
    session_.start();
    frame = after(900);
    EXPECT_EQ(frame->stage, SessionStage::Settled);
    EXPECT_FALSE(frame->motion.is_waiting);
    EXPECT_NE(frame->motion.x, nullptr);
}

TEST_F(SessionOnMovingBody, plays_a_motion_and_the_garment_goes_with_it) {
    settle();
    session_.set_clip(session_body(), clip("walk"));
    EXPECT_EQ(after(3)->stage, SessionStage::Settled) << "a motion alone moves nothing";
    EXPECT_GT(session_.frame()->motion.length, 0.5);
    session_.play();
    const auto frame = after(150);
    EXPECT_TRUE(frame->motion.is_playing);
    EXPECT_GT(frame->motion.way.norm(), 1.5F) << "m";
    EXPECT_GT(clearance(*frame), -0.002F) << "m";
    EXPECT_LT(stretch_p99(frame->mesh), 0.2);
    session_.pause_motion();
    EXPECT_EQ(after(600)->stage, SessionStage::Settled);
    EXPECT_EQ(session_.frame()->motion.seconds, frame->motion.seconds) << "paused before the next frame";
}

TEST_F(SessionOnMovingBody, follows_a_hasty_hand_on_the_timeline) {
    settle();
    const auto walk = clip("walk");
    session_.set_clip(session_body(), walk);
    for (int i = 0; i < 40; ++i) {
        session_.seek(walk->seconds * (i % 5) / 5);
        const auto frame = after(1);
        ASSERT_NE(frame->stage, SessionStage::Failed);
        ASSERT_GT(clearance(*frame), -0.003F) << "m, frame " << i;
    }
    EXPECT_NEAR(after(60)->motion.seconds, walk->seconds * 4 / 5, 1e-9);
}

TEST_F(SessionOnMovingBody, carries_the_garment_along_while_a_joint_is_turned) {
    settle();
    const Pose goal = find_pose("stride", *session_body());
    for (int i = 1; i <= 20; ++i) {
        session_.follow(session_body(), blend(rest_pose(*session_body()), goal, i / 20.0));
        const auto frame = after(1);
        ASSERT_EQ(frame->stage, SessionStage::Moving);
        ASSERT_GT(clearance(*frame), -0.002F) << "m, frame " << i;
    }
    const auto frame = after(600);
    EXPECT_EQ(frame->stage, SessionStage::Settled);
    ASSERT_NE(frame->motion.pose, nullptr);
    for (std::size_t i = 0; i < goal.bones.size(); ++i)
        EXPECT_LT(frame->motion.pose->bones[i].rotation.angularDistance(goal.bones[i].rotation), 1e-3);
}

TEST_F(SessionOnMovingBody, shows_the_garment_as_it_was_dressed_back_at_the_start) {
    settle();
    const auto dressed = session_.frame();
    session_.set_clip(session_body(), clip("walk"));
    session_.play();
    EXPECT_NE(after(90)->mesh.x, dressed->mesh.x);
    session_.back_to_start();
    const auto frame = after(0);
    EXPECT_EQ(frame->stage, SessionStage::Settled);
    EXPECT_EQ(frame->mesh.x, dressed->mesh.x);
    EXPECT_EQ(frame->motion.x, nullptr);
    EXPECT_TRUE(frame->motion.is_at_rest);
    EXPECT_EQ(frame->motion.seconds, 0);
}

TEST_F(SessionOnMovingBody, dresses_an_edited_pattern_and_goes_back_into_the_pose) {
    settle();
    go_to("stride");
    EXPECT_NE(after(100)->motion.x, nullptr);
    pattern_.panels[0].vertices[0].y() -= 0.02;
    session_.set_pattern(pattern_);
    auto frame = after(0);
    EXPECT_EQ(frame->motion.x, nullptr);
    EXPECT_TRUE(frame->motion.is_waiting);
    frame = after(900);
    EXPECT_NE(frame->motion.x, nullptr);
    EXPECT_GT(clearance(*frame), -0.001F) << "m";
}

TEST_F(SessionOnMovingBody, forgets_what_the_body_was_to_do_when_it_is_reset) {
    settle();
    go_to("T");
    after(30);
    session_.reset();
    auto frame = after(0);
    EXPECT_EQ(frame->stage, SessionStage::Placed);
    EXPECT_FALSE(frame->motion.is_waiting);
    session_.start();
    EXPECT_EQ(after(600)->motion.x, nullptr);
}

TEST_F(SessionOnMovingBody, takes_a_budget_while_it_moves) {
    settle();
    session_.set_clip(session_body(), clip("walk"));
    session_.play();
    const int before = after(60)->statistics.leaf_triangles;
    SessionOptions options = coarse_options();
    options.max_level = 3;
    session_.set_options(options);
    const int finer = after(60)->statistics.leaf_triangles;
    EXPECT_GT(finer, before);
    options.triangle_budget = before;
    session_.set_options(options);
    EXPECT_LT(after(90)->statistics.leaf_triangles, finer);
}

TEST_F(SessionOnMovingBody, cannot_be_pulled_while_its_body_is_elsewhere_and_says_so) {
    settle();
    go_to("T");
    const auto frame = after(10);
    session_.pull(furthest_point(*frame, 0, -Vec3f::UnitY()), Vec3f(0, 0.2F, 0.5F));
    ASSERT_FALSE(after(1)->messages.empty());
    EXPECT_NE(session_.frame()->messages.back().find("back to the start"), std::string::npos);
}

TEST_F(SessionOnMovingBody, ignores_poses_of_another_body) {
    settle();
    const auto other = std::make_shared<const Body>(*session_body());
    session_.go_to(other, find_pose("T", *other));
    session_.set_clip(other, clip("walk"));
    session_.play();
    EXPECT_EQ(after(5)->stage, SessionStage::Settled);
    EXPECT_EQ(session_.frame()->motion.length, 0);
}

// Leaf triangles of the front panel, and of the back panel.
std::array<int, 2> triangles_by_panel(const SessionFrame& frame) {
    std::array<int, 2> counts{};
    for (const std::uint16_t panel : frame.mesh.panel) ++counts.at(panel);
    return counts;
}

TEST_F(SessionOnMovingBody, is_coarser_where_it_faces_away_from_the_viewer) {
    SessionOptions options = coarse_options();
    options.max_level = 2;
    session_.set_options(options);
    settle();
    const auto [front_before, back_before] = triangles_by_panel(*session_.frame());
    options.coarsens_back_faces = true;
    session_.set_options(options);
    session_.look_from({.eye = Vec3f(0, 1, 4)});
    auto [front, back] = triangles_by_panel(*after(300));
    EXPECT_LT(back, 0.7 * back_before);
    EXPECT_GT(front, 0.7 * front_before);
    ASSERT_EQ(session_.frame()->stage, SessionStage::Settled);
    session_.look_from({.eye = Vec3f(0.05F, 1, 4)});
    EXPECT_EQ(after(1)->stage, SessionStage::Settled) << "a small turn";
    session_.look_from({.eye = Vec3f(0, 1, -4)});
    EXPECT_EQ(after(1)->stage, SessionStage::Draping);
    const auto [front_behind, back_behind] = triangles_by_panel(*after(300));
    EXPECT_LT(front_behind, 0.7 * front);
    EXPECT_GT(back_behind, 1.3 * back);
    session_.set_clip(session_body(), clip("walk"));
    session_.play();
    const auto [walking_front, walking_back] = triangles_by_panel(*after(60));
    EXPECT_LT(walking_front, walking_back);
    options.coarsens_back_faces = false;
    session_.set_options(options);
    EXPECT_GT(triangles_by_panel(*after(60))[0], 1.3 * walking_front);
}

// Greatest distance of the cloth from the middle, to the side, m: on raised arms it is large.
float widest(const SessionFrame& frame) {
    float widest = 0;
    for (const Vec3f& x : frame.mesh.x) widest = std::max(widest, std::abs(x.x()));
    return widest;
}

TEST(Session, dresses_a_body_in_a_t_pose_with_lowered_arms_that_then_go_up) {
    const auto t_pose = std::make_shared<const Body>(posed(*session_body(), find_pose("T", *session_body())));
    Session session(SessionDrive::Caller);
    session.set_body(t_pose);
    SessionOptions options = coarse_options();
    options.max_level = 0;
    session.set_options(options);
    session.set_pattern(session_pattern("tshirt"));
    session.advance(0);
    session.start();
    for (int i = 0; i < 900 && session.frame()->stage != SessionStage::Moving; ++i) session.advance(1);
    ASSERT_EQ(session.frame()->stage, SessionStage::Moving);
    EXPECT_TRUE(std::ranges::any_of(session.frame()->messages, [](const std::string& message) {
        return message.find("lowered arms") != std::string::npos;
    }));
    const float lowered = widest(*session.frame());
    session.advance(600);
    const auto frame = session.frame();
    ASSERT_EQ(frame->stage, SessionStage::Settled);
    EXPECT_GT(widest(*frame), lowered + 0.03F) << "m: the sleeves have gone up";
    ASSERT_NE(frame->motion.x, nullptr);
    Body stands = *t_pose;
    double farthest = 0;  // of the body from its own pose, m
    for (std::size_t v = 0; v < t_pose->x.size(); ++v) {
        stands.x[v] = (*frame->motion.x)[v].cast<double>();
        farthest = std::max(farthest, (stands.x[v] - t_pose->x[v]).norm());
    }
    EXPECT_LT(farthest, 0.001);
    EXPECT_GT(std::ranges::min(measure_clearance(frame->mesh.x, stands)), -0.002F) << "m";
    session.back_to_start();
    session.advance(0);
    EXPECT_EQ(session.frame()->stage, SessionStage::Settled) << "with lowered arms, where it can be pulled";
    EXPECT_TRUE(session.frame()->motion.is_at_rest);
    EXPECT_NEAR(widest(*session.frame()), lowered, 0.02F);
    session.reset();
    session.advance(0);
    EXPECT_TRUE(session.frame()->motion.is_waiting) << "it will go up again";
}

TEST(SessionThread, plays_seeks_and_poses_as_asked_in_quick_succession) {
    Session session;
    SessionOptions options = coarse_options();
    options.max_level = 0;
    session.set_options(options);
    session.set_body(session_body());
    session.set_pattern(session_pattern("two_squares"));
    session.start();
    ASSERT_TRUE(wait_until([&] { return session.frame()->stage == SessionStage::Settled; }));
    const auto walk = std::make_shared<const Clip>(find_motion("walk", *session_body()));
    const Pose stride = find_pose("stride", *session_body());
    session.set_clip(session_body(), walk);
    session.play();
    std::uint64_t number = session.frame()->number;
    for (int round = 0; round < 12; ++round) {
        ASSERT_TRUE(wait_until([&] { return session.frame()->number != number; })) << "round " << round;
        number = session.frame()->number;
        switch (round % 4) {
            case 0:
                session.seek(walk->seconds * round / 12);
                break;
            case 1:
                session.pause_motion();
                session.follow(session_body(), stride);
                break;
            case 2:
                session.go_to(session_body(), stride);
                break;
            default:
                session.set_clip(session_body(), walk);
                session.play();
        }
        if (round == 7) session.back_to_start();  // while it plays
        if (round == 8) session.play();           // from there
        ASSERT_NE(session.frame()->stage, SessionStage::Failed);
    }
    EXPECT_LT(stretch_p99(session.frame()->mesh), 0.2);
}

TEST(Session, of_a_body_without_bones_does_not_move) {
    auto stiff = std::make_shared<Body>(*session_body());
    stiff->bones.clear();
    stiff->skin.clear();
    Session session(SessionDrive::Caller);
    session.set_body(stiff);
    session.play();
    session.seek(1);
    session.back_to_start();
    session.advance(1);
    EXPECT_FALSE(session.frame()->motion.can_move);
}

}  // namespace
}  // namespace selvedge::sim::test
