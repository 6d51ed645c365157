// A body is made from a text, stands as patterns expect it, and has its colliders when they are needed.
#include "sim/dress/prepared_body.h"

#include <gtest/gtest.h>

#include <thread>

#include "sim/body/yielding_flesh.h"
#include "sim/core/error.h"
#include "sim/dress/dressing_pose.h"
#include "sim/motion/motion_file.h"
#include "tests/support/mannequin.h"

namespace selvedge::sim::test {
namespace {

std::shared_ptr<const Body> on_heap(Body body) {
    return std::make_shared<const Body>(std::move(body));
}

PreparedBody prepared(Body body) {
    return PreparedBody(MadeBody{.body = on_heap(std::move(body))});
}

TEST(MadeBody, says_where_it_came_from_when_it_is_made_from_a_text) {
    const std::string text = "mannequin:bust=96,resolution=1";
    const MadeBody made = make_body(text);
    EXPECT_EQ(made.source, text);
    EXPECT_EQ(made.body->x, make_mannequin(parse_mannequin(text)).body.x);
    ASSERT_TRUE(made.readings);
    EXPECT_EQ(made.readings->readings.size(), measure_names().size());
    EXPECT_TRUE(made.clips.empty());
    EXPECT_THROW(make_body("mannequin.obj"), InputError) << "there is no such file";
    EXPECT_THROW(make_body("mannequin:bust=0"), InputError);
}

TEST(PreparedBody, keeps_its_pose_when_its_arms_are_lowered_already) {
    const PreparedBody mannequin_body = prepared(mannequin());
    EXPECT_FALSE(mannequin_body.stands_otherwise());
    EXPECT_EQ(mannequin_body.stands().get(), &mannequin_body.body());
    EXPECT_EQ(&mannequin_body.measured().body(), &mannequin_body.body());
    EXPECT_EQ(mannequin_body.own_collider(), nullptr);
}

TEST(PreparedBody, builds_its_colliders_when_they_are_asked_for_and_once) {
    const PreparedBody t_pose = prepared(posed(mannequin(), find_pose("T", mannequin())));
    ASSERT_TRUE(t_pose.stands_otherwise());
    EXPECT_EQ(t_pose.stands()->x, posed(t_pose.body(), dressing_pose(t_pose.body())).x);
    EXPECT_FALSE(t_pose.has_colliders());
    const auto collider = t_pose.collider();
    EXPECT_EQ(&collider->body(), t_pose.stands().get());
    EXPECT_FALSE(t_pose.has_colliders()) << "that of its own pose is missing";
    const auto own = t_pose.own_collider();
    EXPECT_TRUE(t_pose.has_colliders());
    EXPECT_EQ(own->body().x.size(), t_pose.body().x.size());
    EXPECT_EQ(t_pose.collider(), collider);
    EXPECT_EQ(t_pose.own_collider(), own);
}

TEST(PreparedBody, keeps_its_arms_when_it_is_dressed_in_the_given_pose) {
    const auto body = on_heap(posed(mannequin(), find_pose("T", mannequin())));
    const auto given = PreparedBody::in_given_pose(body);
    EXPECT_EQ(given->stands(), body);
    EXPECT_EQ(given->dressing_pose(), nullptr);
}

TEST(PreparedBody, keeps_its_poses_when_it_is_dressed_as_given) {
    const PreparedBody t_pose = prepared(posed(mannequin(), find_pose("T", mannequin())));
    const auto given = t_pose.as_given();
    ASSERT_NE(given, nullptr);
    EXPECT_EQ(given, t_pose.as_given());
    EXPECT_EQ(given->stands(), t_pose.made().body);
    EXPECT_EQ(given->own_pose(), t_pose.own_pose());
    EXPECT_EQ(given->dressing_pose(), t_pose.own_pose());
    EXPECT_EQ(prepared(mannequin()).as_given(), nullptr);
}

TEST(PreparedBody, is_built_by_the_next_thread_when_one_is_interrupted) {
    const PreparedBody body = prepared(mannequin());
    struct Stop {};
    EXPECT_THROW(body.collider([] { throw Stop(); }), Stop);
    EXPECT_FALSE(body.has_colliders());
    std::shared_ptr<const BodyCollider> first, second;
    std::thread other([&] { first = body.collider(); });
    second = body.collider();
    other.join();
    ASSERT_NE(first, nullptr);
    EXPECT_EQ(first, second);
}

}  // namespace
}  // namespace selvedge::sim::test
