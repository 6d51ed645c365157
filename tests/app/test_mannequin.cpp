// selvedge mannequin: identical bytes for the same measurements in both formats, and the printed girths.
#include <gtest/gtest.h>

#include <sstream>

#include "tests/app/selvedge_program.h"

namespace selvedge::app {
namespace {

ProgramResult make_mannequin_file(const std::string& options, const std::string& file) {
    return run_selvedge("mannequin --resolution 1 " + options + " -o '" + file + "'");
}

// Reads the line "bust  96.0  96.0  117.1": measurement, requested value, measured value, height; cm.
double printed_girth(const std::string& out, const std::string& measure) {
    std::istringstream lines(out);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string name;
        double asked = 0, read = 0;
        if (words >> name >> asked >> read && name == measure) return read;
    }
    ADD_FAILURE() << "no line for " << measure << " in\n" << out;
    return 0;
}

TEST(MannequinCommand, prints_the_girths_that_were_asked_for) {
    const ScratchFolder folder;
    const ProgramResult result = make_mannequin_file("--bust 96 --waist 78 --hip 102", folder / "body.obj");
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
    EXPECT_NEAR(printed_girth(result.out, "bust"), 96, 0.3);
    EXPECT_NEAR(printed_girth(result.out, "waist"), 78, 0.3);
    EXPECT_NEAR(printed_girth(result.out, "hip"), 102, 0.35);
}

TEST(MannequinCommand, writes_the_same_bytes_twice_and_others_for_other_measures) {
    const ScratchFolder folder;
    for (const std::string extension : {".obj", ".glb"}) {
        ASSERT_EQ(make_mannequin_file("--bust 96", folder / "a" + extension).exit_code, 0);
        ASSERT_EQ(make_mannequin_file("--bust 96", folder / "b" + extension).exit_code, 0);
        ASSERT_EQ(make_mannequin_file("--bust 97", folder / "c" + extension).exit_code, 0);
        const std::string bytes = content_of(folder / "a" + extension);
        EXPECT_GT(bytes.size(), 100000U);
        EXPECT_TRUE(bytes == content_of(folder / "b" + extension)) << extension;
        EXPECT_FALSE(bytes == content_of(folder / "c" + extension)) << extension;
    }
}

TEST(MannequinCommand, male_and_female_are_two_bodies) {
    const ScratchFolder folder;
    ASSERT_EQ(make_mannequin_file("--sex female", folder / "female.obj").exit_code, 0);
    ASSERT_EQ(make_mannequin_file("--sex male", folder / "male.obj").exit_code, 0);
    EXPECT_FALSE(content_of(folder / "female.obj") == content_of(folder / "male.obj"));
}

TEST(MannequinCommand, a_measure_that_contradicts_another_is_said_and_not_silently_changed) {
    const ScratchFolder folder;
    const ProgramResult result = make_mannequin_file("--height 170 --inseam 105", folder / "body.obj");
    EXPECT_NE(result.exit_code, 0);
    EXPECT_NE((result.out + result.err).find("inseam"), std::string::npos);
}

}  // namespace
}  // namespace selvedge::app
