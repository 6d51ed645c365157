// Hands on a running drape: pulling and pinning.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/sim/dress/session_support.h"

namespace selvedge::test {
namespace {

// Where the vertex of a mesh is that is nearest to a point of another in the same panel's material, m.
Vec3f nearest_vertex(const PlainMesh& mesh, const PlainMesh& other, const ClothPoint& point) {
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

class SessionHands : public testing::Test {
 protected:
    SessionHands() {
        session_.set_body(session_body());
        SessionOptions options = coarse_options();
        options.max_level = 2;
        session_.set_options(options);
        session_.set_pattern(session_pattern("two_squares"));
        settle(session_);
    }

    // m, from the point of the cloth that is nearest
    float nearest_to(const Vec3f& place) const {
        float least = 10;
        for (const Vec3f& x : session_.frame()->mesh.x) least = std::min(least, (x - place).norm());
        return least;
    }

    Session session_{SessionDrive::Caller};
};

TEST_F(SessionHands, a_pulled_point_comes_along_and_to_rest) {
    const auto before = session_.frame();
    const ClothPoint hem = furthest_point(*before, 0, Vec3f(0, -1, 0.2F));
    const Vec3f goal = position_of(*before, hem) + Vec3f(0, 0.05F, 0.08F);
    session_.pull(hem, goal);
    session_.advance(1);
    EXPECT_EQ(session_.frame()->stage, SessionStage::Draping);
    session_.advance(400);
    EXPECT_EQ(session_.frame()->stage, SessionStage::Settled);
    EXPECT_LT(nearest_to(goal), 0.005F);
    EXPECT_GT(least_clearance(session_.frame()->mesh), -0.0005F);
    session_.let_go();
    session_.advance(400);
    EXPECT_EQ(session_.frame()->stage, SessionStage::Settled);
    EXPECT_GT(nearest_to(goal), 0.01F);
}

// An editor says in each of its frames where the hand is.
TEST_F(SessionHands, a_garment_that_a_hand_holds_still_settles_and_costs_no_steps) {
    const auto before = session_.frame();
    const ClothPoint hem = furthest_point(*before, 0, Vec3f(0, -1, 0.2F));
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

TEST_F(SessionHands, a_pull_that_the_cloth_cannot_follow_neither_tears_it_nor_pushes_it_into_the_body) {
    const auto before = session_.frame();
    const ClothPoint hem = furthest_point(*before, 0, Vec3f(0, -1, 0.2F));
    for (const Vec3f& way : {Vec3f(0, 0, 3), Vec3f(0, 0.1F, -1), Vec3f(0, -4, 0)}) {
        session_.pull(hem, position_of(*before, hem) + way);
        for (int i = 0; i < 10; ++i) {
            session_.advance(6);
            ASSERT_EQ(session_.frame()->problem, "");
            EXPECT_LT(stretch_p99(session_.frame()->mesh), 0.08);
            EXPECT_GT(least_clearance(session_.frame()->mesh), -0.0005F);
        }
    }
    session_.let_go();
    session_.advance(400);
    EXPECT_EQ(session_.frame()->stage, SessionStage::Settled);
}

TEST_F(SessionHands, a_pin_holds_its_point_exactly_whatever_is_pulled) {
    const auto before = session_.frame();
    const ClothPoint hem = furthest_point(*before, 0, Vec3f(0, -1, 0));
    session_.pin(hem);
    session_.advance(0);
    ASSERT_EQ(session_.frame()->pins.size(), 1U);
    const Vec3f pinned = session_.frame()->pins.front();
    EXPECT_EQ(pinned, position_of(*before, hem));
    // On the other side of the body: where two panels' hems meet in a seam the lowest points of both are one.
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

TEST_F(SessionHands, a_pin_outlives_other_levels_and_an_edited_outline) {
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

TEST_F(SessionHands, take_hold_of_what_was_seen_some_frames_ago) {
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
    session_.advance(100);
    session_.pin(hem);
    session_.advance(0);
    EXPECT_EQ(session_.frame()->pins.size(), 1U);
    EXPECT_EQ(session_.frame()->messages.back(), "what was to be pinned is no longer there");
}

TEST_F(SessionHands, go_with_a_reset) {
    session_.pin(furthest_point(*session_.frame(), 0, Vec3f(0, -1, 0)));
    session_.reset();
    settle(session_);
    EXPECT_TRUE(session_.frame()->pins.empty());
}

}  // namespace
}  // namespace selvedge::test
