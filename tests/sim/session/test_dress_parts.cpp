// Garments on bodies of separate parts, as games build them.
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>

#include "sim/exchange/mesh_file.h"
#include "sim/mannequin/mannequin.h"
#include "sim/pattern/pattern_file.h"
#include "sim/session/dress.h"
#include "tests/support/checkout.h"
#include "tests/support/parted_body.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

DressReport dress_parts(const char* garment, shapes::Joints joints) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "parts.glb";
    write_body(shapes::in_parts(make_mannequin({}).body, joints), file);
    const auto prepared = std::make_shared<const PreparedBody>(make_body(file.string(), {.must_be_person = true}, {}));
    return dress(load_pattern(std::filesystem::path(source_folder()) / "patterns" / garment).pattern, prepared).report;
}

void expect_dressed(const DressReport& report) {
    EXPECT_EQ(outcome_of(report), Outcome::Dressed);
    for (const DressFault& fault : report.faults) ADD_FAILURE() << fault.kind << ": " << fault.place;
    EXPECT_TRUE(report.settled);
    EXPECT_EQ(report.contact.self_crossings, 0);
    EXPECT_LT(report.stretch.warp_weft_max, 0.06) << "cotton stretches by 4 %";
}

TEST(DressParts, a_t_shirt_has_both_arms_in_its_sleeves) {
    expect_dressed(dress_parts("tshirt.json", shapes::Joints::Balls));
}

TEST(DressParts, a_skirt_hangs_on_a_trunk_with_gaps) {
    expect_dressed(dress_parts("skirt.json", shapes::Joints::Gaps));
}

}  // namespace
}  // namespace selvedge::sim
