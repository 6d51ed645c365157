// Arms are lowered only for what they belong in.
#include "sim/dress/wearer.h"

#include <gtest/gtest.h>

#include "sim/body/yielding_flesh.h"
#include "sim/mesh/sew.h"
#include "sim/motion/motion_file.h"
#include "tests/sim/dress/shapes.h"
#include "tests/support/mannequin.h"

namespace selvedge::sim::test {
namespace {

std::shared_ptr<const PreparedBody> in_pose(const std::string& name) {
    const Body& body = mannequin();
    MadeBody made{.body = std::make_shared<const Body>(name.empty() ? body : posed(body, find_pose(name, body)))};
    return std::make_shared<const PreparedBody>(std::move(made));
}

std::shared_ptr<const PreparedBody> wearer(const Pattern& pattern, const std::shared_ptr<const PreparedBody>& body) {
    return wearer_of(assemble(pattern), pattern, body);
}

Pattern skirt() {
    return tube(0.5, 0.6, 0.4, 0.2);
}

Pattern shirt() {
    return tabard(0.5, 0.6, 0.95, 0.2);
}

TEST(Wearer, keeps_its_arms_level_when_it_is_dressed_in_a_skirt) {
    const auto body = in_pose("T");
    const auto as_given = wearer(skirt(), body);
    ASSERT_NE(as_given, body);
    EXPECT_FALSE(as_given->stands_otherwise());
    EXPECT_EQ(as_given->stands(), body->made().body);
    EXPECT_EQ(wearer(skirt(), body), as_given) << "made once, with its collider";
}

TEST(Wearer, lowers_its_arms_when_it_is_dressed_in_a_shirt) {
    const auto body = in_pose("T");
    EXPECT_EQ(wearer(shirt(), body), body);
    Pattern both = shirt();
    for (const Panel& panel : skirt().panels) both.panels.push_back(panel);
    EXPECT_EQ(wearer(both, body), body);
}

TEST(Wearer, is_the_body_itself_when_its_arms_hang) {
    const auto body = in_pose("");
    EXPECT_EQ(body->as_given(), nullptr);
    EXPECT_EQ(wearer(skirt(), body), body);
}

}  // namespace
}  // namespace selvedge::sim::test
