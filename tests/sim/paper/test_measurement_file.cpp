// Files of measurements of four programs; wrong ones are refused with their place.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "sim/core/error.h"
#include "sim/paper/measurement_file.h"
#include "sim/paper/measurement_formula.h"

namespace selvedge::sim {
namespace {

double length_of(const MeasurementFile& file, const std::string& name) {
    const auto found = std::ranges::find(file.lengths, name, &Measurement::name);
    return found == file.lengths.end() ? -1 : found->value;
}

std::string refusal(const std::string& text) {
    try {
        parse_measurements(text, "file");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(MeasurementFile, freesewing_yaml_in_mm_cm_and_inches) {
    const MeasurementFile mm = parse_measurements("units: metric\nmeasurements:\n  chest: 925\n  waist: 750\n", "a");
    EXPECT_EQ(mm.format, "FreeSewing");
    EXPECT_NEAR(length_of(mm, "chest"), 0.925, 1e-12);
    EXPECT_EQ(mm.notes.size(), 1U);
    const MeasurementFile cm = parse_measurements("measurements: {chest: 92.5, shoulderSlope: 13}", "a");
    EXPECT_NEAR(length_of(cm, "chest"), 0.925, 1e-12);
    EXPECT_EQ(length_of(cm, "shoulderSlope"), -1);  // an angle
    const MeasurementFile inches = parse_measurements("units: imperial\nmeasurements:\n  chest: 36.5\n", "a");
    EXPECT_NEAR(length_of(inches, "chest"), 0.9271, 1e-12);
}

TEST(MeasurementFile, freesewing_json_names_its_unit_and_set) {
    const MeasurementFile file = parse_measurements(
        R"({"units": "mm", "measurementSet": "cisMaleAdult42", "measurements": {"chest": 1105, "seat": 1084}})", "a");
    EXPECT_NEAR(length_of(file, "chest"), 1.105, 1e-12);
    EXPECT_EQ(file.sex, MeasuredSex::Male);
    EXPECT_TRUE(file.notes.empty());
}

TEST(MeasurementFile, garmentcode_yaml_is_in_cm) {
    const MeasurementFile file = parse_measurements("body:\n  height: 171.99\n  arm_pose_angle: 45\n", "a");
    EXPECT_EQ(file.format, "GarmentCode");
    EXPECT_NEAR(length_of(file, "height"), 1.7199, 1e-12);
    EXPECT_EQ(file.lengths.size(), 1U);
}

TEST(MeasurementFile, valentina_formulas_have_values) {
    const MeasurementFile file = parse_measurements(R"(<?xml version="1.0"?>
<vit><version>0.5.0</version><unit>cm</unit><personal><gender>female</gender></personal>
<body-measurements><m name="height" value="168"/><m name="waist_circ" value="(height/2 - 10)*1"/>
<m name="hip_circ" value="waist_circ + 2 * 12.5"/><m name="bad" value="nothing + 1"/><m name="empty" value=""/>
</body-measurements></vit>)",
                                                    "a");
    EXPECT_EQ(file.format, "Valentina");
    EXPECT_NEAR(length_of(file, "waist_circ"), 0.74, 1e-12);
    EXPECT_NEAR(length_of(file, "hip_circ"), 0.99, 1e-12);
    EXPECT_EQ(file.sex, MeasuredSex::Female);
    EXPECT_EQ(file.notes.size(), 1U);
    EXPECT_EQ(file.lengths.size(), 3U);
}

TEST(MeasurementFile, decimals_may_follow_a_comma) {
    const MeasurementFile file = parse_measurements(
        "<smis><unit>cm</unit><body-measurements><m name=\"bust_circ\" value=\"92,5\"/>"
        "<m name=\"waist_circ\" value=\"(bust_circ-12,5)/2,0*2+0,25\"/><m name=\"hip_circ\" value=\"98.5\"/>"
        "</body-measurements></smis>",
        "a");
    EXPECT_EQ(file.format, "Seamly2D");
    EXPECT_NEAR(length_of(file, "bust_circ"), 0.925, 1e-12);
    EXPECT_NEAR(length_of(file, "waist_circ"), 0.8025, 1e-12);
    EXPECT_NEAR(length_of(file, "hip_circ"), 0.985, 1e-12);
    const MeasurementFile yaml = parse_measurements("body:\n  height: 171,99\n  bust: 92 cm\n", "a");
    EXPECT_NEAR(length_of(yaml, "height"), 1.7199, 1e-12);
    EXPECT_EQ(length_of(yaml, "bust"), -1);
    ASSERT_EQ(yaml.notes.size(), 1U);
    EXPECT_EQ(yaml.notes[0], "bust: '92 cm' is no number, left out");
}

TEST(MeasurementFile, freesewings_names_are_told_in_files_of_other_programs) {
    const std::string lines =
        "<m name=\"waistToFloor\" value=\"105,5\"/><m name=\"hpsToBust\" value=\"27\"/><m name=\"hips\" value=\"90\"/>";
    const MeasurementFile file =
        parse_measurements("<smis><unit>cm</unit><body-measurements>" + lines + "</body-measurements></smis>", "a");
    EXPECT_EQ(file.notes, (std::vector<std::string>{"its names are FreeSewing's: 'hips' is the high hip"}));
    const MeasurementFile flat = parse_measurements("waistToFloor: 105\nhpsToBust: 27\n", "a");
    EXPECT_EQ(flat.format, "FreeSewing");
    EXPECT_EQ(flat.notes.front(), "its names are FreeSewing's");
    EXPECT_EQ(flat.lengths.size(), 2U);
}

TEST(MeasurementFile, seamly_multisize_takes_the_base) {
    const MeasurementFile file = parse_measurements(
        "<smms><unit>inch</unit><body-measurements><m name=\"bust_circ\" base=\"36\" size_increase=\"1\"/>"
        "</body-measurements></smms>",
        "a");
    EXPECT_EQ(file.format, "Seamly2D");
    EXPECT_NEAR(length_of(file, "bust_circ"), 0.9144, 1e-12);
}

TEST(MeasurementFile, wrong_files_are_refused_with_their_place) {
    EXPECT_EQ(refusal(""), "file: empty");
    EXPECT_NE(refusal("- a\n- b\n").find("no file of measurements"), std::string::npos);
    EXPECT_NE(refusal("a: [1, 2\nb: 3\n").find("line "), std::string::npos);
    EXPECT_NE(refusal("name: x\n").find("no measurements"), std::string::npos);
    EXPECT_NE(refusal("<vit>\n<unit>cm</units></vit>").find("line 2"), std::string::npos);
    EXPECT_NE(refusal("<svg/>").find("<svg>"), std::string::npos);
    EXPECT_NE(refusal("<vit><body-measurements/></vit>").find("no measurement"), std::string::npos);
    EXPECT_NE(refusal("measurements:\n  chest: -4\n").find("line 2"), std::string::npos);
    EXPECT_NE(refusal(std::string(2000000, ' ')), "");
    EXPECT_NE(refusal(std::string(100000, '[')), "");
}

TEST(MeasurementFile, formulas_that_never_end_have_no_value) {
    Formulas formulas{{"a", "b+1"}, {"b", "a+1"}, {"c", "2*(3-1)/-4"}, {"d", "1/0"}, {"e", "(1"}, {"f", "1 1"}};
    for (int k = 0; k < 60; ++k)
        formulas["x" + std::to_string(k)] = "x" + std::to_string(k + 1) + "+x" + std::to_string(k + 1);
    formulas["x60"] = "1";
    for (const char* name : {"a", "b", "d", "e", "f", "x0", "none"})
        EXPECT_FALSE(value_of_formula(formulas, name)) << name;
    EXPECT_EQ(value_of_formula(formulas, "c"), -1.0);
    EXPECT_EQ(value_of_formula(formulas, "x57"), 8.0);
}

TEST(MeasurementFile, mutants_give_finite_lengths_or_one_line) {
    const std::string yaml = "units: metric\nmeasurements:\n  chest: 925\n  waist: 750\n";
    const std::string xml =
        "<vit><unit>cm</unit><body-measurements><m name=\"height\" value=\"168/2*(1+1)\"/>"
        "</body-measurements></vit>";
    std::mt19937 random(7);
    for (int k = 0; k < 3000; ++k) {
        std::string text = k % 2 == 0 ? yaml : xml;
        for (int change = 0; change < 3; ++change) {
            const std::size_t at = random() % text.size();
            if (random() % 3 == 0)
                text.erase(at, 1 + random() % 8);
            else
                text[at] = static_cast<char>(random() % 256);
            if (text.empty()) text = "x";
        }
        try {
            for (const Measurement& one : parse_measurements(text, "mutant").lengths)
                EXPECT_TRUE(std::isfinite(one.value) && one.value >= 0);
        } catch (const InputError&) {
        }
    }
}

}  // namespace
}  // namespace selvedge::sim
