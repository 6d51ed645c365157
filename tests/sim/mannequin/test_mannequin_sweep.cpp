// Slow: a grid over the whole supported range of statures, busts and waists of the mannequin.
#include <gtest/gtest.h>

#include "sim/mannequin/mannequin.h"
#include "tests/support/body_checks.h"

namespace selvedge::sim {
namespace {

struct SweepCase {
    Sex sex;
    MannequinMeasures measures;
};

std::vector<SweepCase> sweep() {
    std::vector<SweepCase> cases;
    for (const Sex sex : {Sex::Female, Sex::Male}) {
        for (const double height : {1.50, 1.65, 1.80, 1.95}) {
            for (const double bust : {0.80, 0.90, 1.00, 1.10, 1.20}) {
                for (const double waist : {0.70, 0.80, 0.90, 0.98}) {
                    for (const double hip : {0.96, 1.08}) {
                        if (waist * bust < 0.60 || waist * bust > 1.15) continue;
                        cases.push_back(
                            {sex, {.height = height, .bust = bust, .waist = waist * bust, .hip = hip * bust}});
                    }
                }
            }
        }
    }
    return cases;
}

TEST(MannequinSweep, meets_its_measures_within_a_third_of_a_percent_and_never_cuts_itself) {
    const std::vector<SweepCase> cases = sweep();
    ASSERT_GT(cases.size(), 190U);
    for (const SweepCase& c : cases) {
        SCOPED_TRACE(testing::Message() << (c.sex == Sex::Male ? "male" : "female") << " height " << *c.measures.height
                                        << " bust " << *c.measures.bust << " waist " << *c.measures.waist << " hip "
                                        << *c.measures.hip);
        const Mannequin mannequin = make_mannequin({.sex = c.sex, .measures = c.measures});
        for (const MeasureReading& reading : mannequin.report.readings) {
            if (!reading.requested) continue;
            EXPECT_NEAR(reading.measured / *reading.requested, 1, 0.003) << reading.name;
        }
        EXPECT_TRUE(mannequin.report.messages.empty());
        EXPECT_EQ(count_self_intersections(mannequin.body), 0);
    }
}

}  // namespace

}  // namespace selvedge::sim
