// The fit table of a report against a tape that shares no code with the program (tape.py).
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/app/selvedge_program.h"

namespace selvedge::app {
namespace {

// Dresses the body in two squares for a moment: what they do does not matter.
void expect_the_tape_agrees(const ScratchFolder& folder, const std::string& body, int measures) {
    const std::string report = folder / "report.json", surface = folder / "body.obj";
    const ProgramResult dressed = run_selvedge("dress " + shipped("two_squares.json") + " --seconds 0.02 -q --body '" +
                                               body + "' --report '" + report + "' --export-body '" + surface + "'");
    ASSERT_TRUE(dressed.exit_code == 0 || dressed.exit_code == 3 || dressed.exit_code == 4) << dressed.err;
    const ProgramResult tape =
        run_command("python3 -B '" + source_folder() + "/tests/app/tape.py' '" + surface + "' '" + report + "'");
    EXPECT_EQ(tape.exit_code, 0) << body << "\n" << tape.out << tape.err;
    int measured = 0;
    for (std::size_t at = tape.out.find('\n'); at != std::string::npos; at = tape.out.find('\n', at + 1))
        measured += tape.out[at - 1] == '-' ? 0 : 1;
    EXPECT_EQ(measured, measures) << body << "\n" << tape.out;
}

// A body in OBJ with thighs so thick that they touch, or overlap by `overlap`, mm.
std::string with_thick_thighs(const ScratchFolder& folder, const std::string& body, const std::string& overlap) {
    const std::string thick = folder / "thick.obj";
    const ProgramResult made = run_command("python3 -B '" + source_folder() + "/tests/app/thick_thighs.py' '" + body +
                                           "' '" + thick + "' " + overlap);
    EXPECT_EQ(made.exit_code, 0) << made.err;
    return thick;
}

TEST(FitTableTape, agrees_on_mannequins_of_many_measures) {
    const ScratchFolder folder;
    for (const char* measures : {"", "thigh=66,hip=112,waist=90,bust=108,", "sex=male,bust=120,waist=110,hip=115,"})
        expect_the_tape_agrees(folder, std::string("mannequin:") + measures + "resolution=1", 7);
}

TEST(FitTableTape, agrees_where_the_thighs_touch_or_overlap) {
    const ScratchFolder folder;
    const std::string body = folder / "apart.obj";
    ASSERT_EQ(run_selvedge("mannequin --hip 104 --resolution 1 -o '" + body + "'").exit_code, 0);
    for (const char* overlap : {"-1", "6"}) expect_the_tape_agrees(folder, with_thick_thighs(folder, body, overlap), 7);
}

TEST(FitTableTape, agrees_on_bodies_of_others) {
    const char* data = std::getenv("SELVEDGE_TEST_DATA");
    if (!data) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set";
    const ScratchFolder folder;
    const std::filesystem::path bodies = std::filesystem::path(data) / "bodies";
    expect_the_tape_agrees(folder, bodies / "mh_female.obj", 7);
    for (const char* figure : {"CesiumMan.glb", "RiggedFigure.gltf"})
        expect_the_tape_agrees(folder, bodies / figure, 5);  // of a cartoon's proportions: neither bust nor waist
    for (const char* overlap : {"-1", "6"})
        expect_the_tape_agrees(folder, with_thick_thighs(folder, bodies / "mh_female.obj", overlap), 7);
}

TEST(TouchingThighs, have_room_for_trousers) {
    const char* data = std::getenv("SELVEDGE_TEST_DATA");
    if (!data) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set";
    const ScratchFolder folder;
    const std::filesystem::path drafts = std::filesystem::path(data) / "garmentcode";
    const std::string body = folder / "apart.obj", touching = folder / "touching.obj", report = folder / "report.json";
    ASSERT_LE(run_selvedge("mannequin --measurements '" + (drafts / "mean_all_measurements.yaml").string() +
                           "' --resolution 1 -o '" + body + "'")
                  .exit_code,
              1);
    ASSERT_EQ(run_command("python3 -B '" + source_folder() + "/tests/app/thick_thighs.py' '" + body + "' '" + touching +
                          "' 0 0")
                  .exit_code,
              0);
    const ProgramResult dressed = run_selvedge("dress '" + (drafts / "pants_long_specification.json").string() +
                                               "' -q --body '" + touching + "' --report '" + report + "'");
    EXPECT_EQ(dressed.exit_code, 0) << dressed.out << dressed.err;
}

}  // namespace
}  // namespace selvedge::app
