// Faults of a drape that follow from the size of the garment are told as what they follow from.
#include <gtest/gtest.h>

#include "sim/inspection/inspection.h"
#include "tests/support/mannequin.h"

namespace selvedge::sim::test {
namespace {

constexpr double kKnees = 0.5;  // m

DressReport report_with(std::vector<DressFault> faults) {
    DressReport report;
    report.faults = std::move(faults);
    return report;
}

const TightLevel kSmall{.y = 1,
                        .garment_girth = 0.6,
                        .limit_girth = 0.62,
                        .body_girth = 0.9,
                        .low = Vec3d(0, 1, 0),
                        .high = Vec3d(0, 1, 0)};

TEST(BlameSize, turns_faults_of_the_drape_into_notes_beside_one_of_fit) {
    DressReport report = report_with({{"limb_missed", "the left arm", 1}, {"self_crossing", "2 pairs", 0.3}});
    blame_size(kSmall, find_limbs(mannequin()), report);
    EXPECT_EQ(outcome_of(report), Outcome::DoesNotFit);
    ASSERT_EQ(report.faults.size(), 1U);
    EXPECT_NEAR(report.faults[0].value, 0.3, 1e-9);
    EXPECT_NE(cause_of(report.faults[0]).find("too small at the"), std::string::npos) << cause_of(report.faults[0]);
    ASSERT_EQ(report.notes.size(), 2U);
    EXPECT_EQ(report.notes[0].find("it cannot close round the body: "), 0U) << report.notes[0];
}

TEST(BlameSize, has_no_effect_on_a_drape_without_defects) {
    DressReport good = report_with({});
    blame_size(kSmall, find_limbs(mannequin()), good);
    EXPECT_EQ(outcome_of(good), Outcome::Dressed);
    DressReport small = report_with({{"does_not_fit", "too small at the waist by 2.0 cm", 0.02}});
    blame_size(kSmall, find_limbs(mannequin()), small);
    EXPECT_EQ(small.faults[0].value, 0.02);
}

TEST(BlameSize, keeps_a_bad_number_as_a_fault_when_the_garment_is_too_small) {
    DressReport report = report_with({{"not_finite", "'front'", 0}, {"open_seam", "seam 1", 0.1}});
    blame_size(kSmall, find_limbs(mannequin()), report);
    EXPECT_EQ(outcome_of(report), Outcome::Defect);
}

TEST(BlameLength, turns_faults_of_the_heap_on_the_floor_into_notes) {
    DressReport report = report_with({{"inside_body", "'leg'", 0.01, "", 0.03}});
    blame_length(0.4, kKnees, report);
    EXPECT_EQ(outcome_of(report), Outcome::DoesNotFit);
    ASSERT_EQ(report.faults.size(), 1U);
    EXPECT_NE(report.faults[0].place.find("too long for this body by 40 cm"), std::string::npos);
    ASSERT_EQ(report.notes.size(), 1U);
}

TEST(BlameLength, keeps_faults_above_the_knees) {
    DressReport report = report_with({{"inside_body", "'leg'", 0.01, "", 0.03},
                                      {"inside_body", "'hip'", 0.01, "", 0.9},
                                      {"limb_missed", "the left arm", 1}});
    blame_length(0.4, kKnees, report);
    EXPECT_EQ(outcome_of(report), Outcome::Defect);
    EXPECT_EQ(report.faults.size(), 3U);
}

TEST(BlameLength, has_no_effect_on_a_train_or_a_good_drape) {
    DressReport train = report_with({{"inside_body", "'leg'", 0.01, "", 0.03}});
    blame_length(0.09, kKnees, train);
    EXPECT_EQ(outcome_of(train), Outcome::Defect);
    DressReport good = report_with({});
    blame_length(0.4, kKnees, good);
    EXPECT_EQ(outcome_of(good), Outcome::Dressed);
}

}  // namespace
}  // namespace selvedge::sim::test
