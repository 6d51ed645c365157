// A session on its own thread: nobody waits, nothing is lost at the end.
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <thread>

#include "tests/sim/body/shapes.h"
#include "tests/sim/dress/session_support.h"
#include "tests/sim/dress/shapes.h"

namespace selvedge::test {
namespace {

// Small: its collider is made in no time.
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

// Whether it came to be within a time that is far more than it needs.
bool comes_to_be(const std::function<bool()>& is_so) {
    for (int i = 0; i < 6000; ++i) {
        if (is_so()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

TEST(SessionThread, settles_by_itself_and_then_makes_no_frames) {
    Session session;
    session.set_options(coarse_options());
    session.set_body(session_body());
    session.set_pattern(session_pattern("two_squares"));
    session.start();
    ASSERT_TRUE(comes_to_be([&] { return session.frame()->stage == SessionStage::Settled; }));
    const auto number = session.frame()->number;
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    EXPECT_EQ(session.frame()->number, number);
    session.pull(furthest_point(*session.frame(), 0, Vec3f(0, -1, 0)), Vec3f(0, 1, 0.3F));
    EXPECT_TRUE(comes_to_be([&] { return session.frame()->number > number + 3; }));
}

TEST(SessionThread, ends_at_once_while_a_collider_is_made_or_panels_are_sewn) {
    for (int i = 0; i < 6; ++i) {
        Session session;
        session.set_body(session_body());
        session.set_pattern(session_pattern("two_squares"));
        session.start();
        std::this_thread::sleep_for(std::chrono::milliseconds(60 * i));
    }
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
        session.keep("it");
        session.restore("it");
        if (round % 7 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(round % 11));
        session.let_go();
        session.unpin_all();
        ASSERT_NE(session.frame(), nullptr);
    }
}

}  // namespace
}  // namespace selvedge::test
