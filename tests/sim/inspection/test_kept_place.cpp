#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "sim/body/joint_names.h"
#include "sim/collide/moving_body.h"
#include "sim/inspection/kept_place.h"
#include "sim/pattern/fabric.h"
#include "tests/sim/cloth/fixtures.h"
#include "tests/support/mannequin.h"

namespace selvedge::sim::test {
namespace {

Vec3d joint(Joint of) {
    const Body& body = mannequin();
    return body.bones[static_cast<std::size_t>(find_joints(body.bones)[of])].joint;
}

// A piece of cloth whose vertices are put on the body's surface near a place, the upper half higher.
class KeptPlaceTest : public testing::Test {
 protected:
    // turn: how far it is turned round the body, of a whole turn.
    void put_on(const Vec3d& place, double turn = 0) {
        const auto& vertices = cloth_.mesh.leaf_vertices();
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const double round = 2 * M_PI * (turn + double(i) / double(vertices.size()));
            const Vec3f wanted =
                (place + Vec3d(0.02 * std::sin(round), i % 2 == 0 ? 0.02 : -0.2, 0.3 * std::cos(round))).cast<float>();
            const auto closest = collider_.surface().closest(wanted, 1.0F);
            cloth_.x[vertices[i].value].head<3>() = closest->point + 0.002F * closest->normal;
        }
    }
    KeptPlace watch() const { return {cloth_, mannequin(), collider_.surface()}; }

    MovingBodyCollider collider_{mannequin()};
    Cloth cloth_ = make_patch(find_fabric("cotton_shirting"), {.side = 0.3, .quads = 6});
};

TEST_F(KeptPlaceTest, is_no_fault_of_cloth_that_slides_by_little) {
    const Vec3d waist = joint(Joint::Spine);
    put_on(waist);
    KeptPlace kept = watch();
    put_on(waist - Vec3d(0, 0.06, 0));
    kept.note(cloth_, collider_.surface(), 0.5);
    EXPECT_TRUE(kept.faults().empty());
    EXPECT_GT(kept.farthest(), 0.02);
    EXPECT_LT(kept.farthest(), 0.15);
}

TEST_F(KeptPlaceTest, is_no_fault_of_cloth_that_turns_round_the_waist) {
    put_on(joint(Joint::Spine));
    KeptPlace kept = watch();
    put_on(joint(Joint::Spine), 0.3);
    kept.note(cloth_, collider_.surface(), 0.5);
    EXPECT_TRUE(kept.faults().empty());
    EXPECT_LT(kept.farthest(), 0.05);
}

TEST_F(KeptPlaceTest, is_told_with_the_moment_and_the_part_that_carries_the_garment) {
    put_on(joint(Joint::Spine));
    KeptPlace kept = watch();
    kept.note(cloth_, collider_.surface(), 1.0);
    put_on(joint(Joint::LeftHand) + Vec3d(0.04, -0.1, 0));
    kept.note(cloth_, collider_.surface(), 1.2);
    kept.note(cloth_, collider_.surface(), 1.4);
    const std::vector<std::string> panels{"skirt_front"};
    ASSERT_EQ(kept.faults(panels).size(), 1U);
    EXPECT_EQ(kept.faults(panels)[0],
              "the garment of 'skirt_front' left the waist at 1.20 s and hangs on the left hand");
}

TEST_F(KeptPlaceTest, is_told_of_what_lies_on_the_floor_and_of_what_flies) {
    put_on(joint(Joint::Spine));
    KeptPlace kept = watch();
    for (auto& x : cloth_.x) x.head<3>() = Vec3f(x.x(), 0.01F, x.z());
    kept.note(cloth_, collider_.surface(), 2);
    ASSERT_EQ(kept.faults().size(), 1U);
    EXPECT_EQ(kept.faults()[0], "a garment left the waist at 2.00 s and lies on the floor");
    for (auto& x : cloth_.x) x.head<3>() = Vec3f(x.x(), 3, x.z());
    kept.note(cloth_, collider_.surface(), 3);
    EXPECT_EQ(kept.faults()[0], "a garment left the waist at 2.00 s and hangs on nothing");
}

// With the body: nothing moves on it.
TEST_F(KeptPlaceTest, is_none_of_a_body_that_takes_its_garment_along) {
    put_on(joint(Joint::Spine));
    KeptPlace kept = watch();
    const Eigen::AngleAxisf turn(1.0F, Vec3f::UnitY());
    std::vector<Vec3f> x;
    for (const Vec3d& p : mannequin().x) x.push_back(turn * p.cast<float>() + Vec3f(3, 0, 1));
    collider_.place(x);
    for (auto& p : cloth_.x) p.head<3>() = turn * Vec3f(p.head<3>()) + Vec3f(3, 0, 1);
    kept.note(cloth_, collider_.surface(), 4);
    EXPECT_TRUE(kept.faults().empty());
    EXPECT_LT(kept.farthest(), 0.001);
}

}  // namespace
}  // namespace selvedge::sim::test
