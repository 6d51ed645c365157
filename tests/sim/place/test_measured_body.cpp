// A measured body has what the functions find that it calls, also for several threads at once.
#include "sim/place/measured_body.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "tests/support/mannequin.h"

namespace selvedge::sim::test {
namespace {

TEST(MeasuredBody, has_what_is_found_on_its_body) {
    const MeasuredBody measured(mannequin());
    const BodyLimbs limbs = find_limbs(mannequin());
    EXPECT_EQ(measured.landmarks().armpit, find_landmarks(mannequin()).armpit);
    EXPECT_EQ(measured.stature().crown, find_stature(mannequin()).crown);
    EXPECT_EQ(measured.limbs().found(), limbs.found());
    EXPECT_EQ(measured.limbs()[LimbKind::LeftArm].line, limbs[LimbKind::LeftArm].line);
}

TEST(MeasuredBody, is_measured_once_for_several_threads) {
    const MeasuredBody measured(mannequin());
    std::vector<const Vec3d*> lines(4);
    {
        std::vector<std::jthread> threads;
        for (const Vec3d*& line : lines)
            threads.emplace_back([&] { line = measured.limbs()[LimbKind::LeftLeg].line.data(); });
    }
    for (const Vec3d* line : lines) EXPECT_EQ(line, lines[0]);
    EXPECT_EQ(measured.limbs()[LimbKind::LeftLeg].line, find_limbs(mannequin())[LimbKind::LeftLeg].line);
}

}  // namespace
}  // namespace selvedge::sim::test
