// A garment on a body that moves as its user asks, and what becomes of it there.
#include "sim/session/live_motion.h"

#include <gtest/gtest.h>

#include "sim/body/yielding_flesh.h"
#include "sim/motion/motion_file.h"
#include "sim/place/limbs.h"
#include "sim/session/dress.h"
#include "tests/sim/dress/shapes.h"
#include "tests/support/mannequin.h"

namespace selvedge::sim::test {
namespace {

// Front and back of a towel that hangs over the left forearm.
Pattern towel(const Body& body) {
    const std::vector<LimbJoint> arm = find_limbs(body)[LimbKind::LeftArm].joints;
    const Vec3d forearm = (arm[1].centre + arm[2].centre) / 2;
    Pattern pattern = tabard(0.15, 0.25, forearm.y() + arm[1].radius - 0.24, 0.08);
    for (Panel& panel : pattern.panels) panel.translation += Vec3d(forearm.x(), 0, forearm.z());
    pattern.fabric = "silk";
    return pattern;
}

TEST(LiveMotion, reports_a_towel_when_it_slides_off_a_lowered_arm) {
    const Body level = posed(mannequin(), find_pose("T", mannequin()));
    const auto body = std::make_shared<const Body>(level);
    Dressing dressing;
    dressing.set_body(body);
    dressing.set_pattern(towel(level));
    while (dressing.advance()) {
    }
    BodyMover mover(body);
    LiveMotion motion(dressing.drape().simulation, {}, mover, dressing.options());
    for (int i = 0; i < 15; ++i) motion.advance(mover);
    EXPECT_TRUE(motion.faults({}).empty());
    mover.go_to(find_pose("A", level));
    for (int i = 0; i < 90; ++i) motion.advance(mover);
    const std::vector<std::string> faults = motion.faults({});
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_NE(faults.front().find("left the left forearm"), std::string::npos) << faults.front();
}

}  // namespace
}  // namespace selvedge::sim::test
