// selvedge import: the garment that it writes can be checked, and wrong files are refused on one line.
#include <gtest/gtest.h>

#include <filesystem>

#include "sim/core/file.h"
#include "sim/pattern/pattern_file.h"
#include "tests/app/selvedge_program.h"
#include "tests/sim/paper/drawings.h"

namespace selvedge::app {
namespace {

// The half front of the tests of drawings, and a back of the same shape.
std::string half_shirt() {
    std::string front = sim::half_front_json();
    const std::size_t begin = front.find("\"test.front\""), end = front.rfind("}}");
    std::string back = front.substr(begin, end - begin);
    back.replace(back.find("test.front"), 10, "test.back");
    return front.substr(0, end) + ", " + back + front.substr(end);
}

TEST(ImportCommand, writes_a_garment_with_seams_that_check_accepts) {
    const ScratchFolder folder;
    const std::string drawn = folder / "shirt.json", garment = folder / "garment.json";
    sim::write_file_atomically(drawn, half_shirt());
    const ProgramResult result = run_selvedge("import '" + drawn + "' -o '" + garment + "'");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("front: torso, front"), std::string::npos) << result.out;
    const sim::Pattern pattern = sim::load_pattern(garment).pattern;
    ASSERT_EQ(pattern.panels.size(), 2U);
    EXPECT_EQ(pattern.seams.size(), 4U);  // two sides, two shoulders
    EXPECT_GT(pattern.panels[0].translation.z(), pattern.panels[1].translation.z());
    EXPECT_EQ(pattern.body, "mannequin:sex=female,bust=92.50");
    EXPECT_EQ(run_selvedge("check '" + garment + "'").exit_code, 0);
}

// File > Import and File > Print pattern, by the script's steps for them.
TEST(ImportInTheEditor, shows_a_drawing_saves_it_and_prints_it) {
    const ScratchFolder folder;
    const std::string drawn = folder / "shirt.json", garment = folder / "garment.json", pages = folder / "shirt.pdf";
    const std::string script = folder / "script.txt", state = folder / "state";
    sim::write_file_atomically(drawn, half_shirt());
    sim::write_file_atomically(
        script, "import \"" + drawn + "\"\nframes 3\nprint \"" + pages + "\"\nsave \"" + garment + "\"\n");
    const ProgramResult result = run_selvedge("edit --script '" + script + "' --state '" + state + "'");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(sim::load_pattern(garment).pattern.seams.size(), 4U);
    EXPECT_TRUE(sim::read_file(pages, 10000000).starts_with("%PDF"));
}

TEST(ImportCommand, draws_the_body_of_the_draft_s_measurements) {
    const ScratchFolder folder;
    const std::string drawn = folder / "shirt.json", measures = folder / "measures.yaml",
                      garment = folder / "garment.json";
    sim::write_file_atomically(drawn, half_shirt());
    sim::write_file_atomically(measures,
                               "units: metric\nmeasurements:\n  chest: 980\n  underbust: 960\n  waist: 820\n");
    ASSERT_EQ(run_selvedge("import '" + drawn + "' -o '" + garment + "'").exit_code, 0);
    EXPECT_EQ(sim::load_pattern(garment).pattern.body, "mannequin:sex=female,bust=92.50");
    ASSERT_EQ(run_selvedge("import '" + drawn + "' -o '" + garment + "' --measurements '" + measures + "'").exit_code,
              0);
    EXPECT_EQ(sim::load_pattern(garment).pattern.body, "mannequin:sex=male,bust=98,underbust=96,waist=82");
}

TEST(ImportCommand, places_what_selvedge_printed_as_it_was_placed) {
    const ScratchFolder folder;
    const std::string tshirt = source_folder() + "/patterns/tshirt.json", garment = folder / "garment.json";
    const sim::Pattern original = sim::load_pattern(tshirt).pattern;
    for (const char* name : {"a.svg", "a.dxf"}) {
        const std::string paper = folder / name;
        ASSERT_EQ(run_selvedge("print '" + tshirt + "' -o '" + paper + "'").exit_code, 0);
        const ProgramResult result = run_selvedge("import '" + paper + "' -o '" + garment + "'");
        ASSERT_EQ(result.exit_code, 0) << result.err;
        const sim::Pattern read = sim::load_pattern(garment).pattern;
        EXPECT_EQ(read.body, original.body);
        EXPECT_EQ(read.seams.size(), original.seams.size());
        ASSERT_EQ(read.panels.size(), original.panels.size());
        for (std::size_t p = 0; p < read.panels.size(); ++p) {
            EXPECT_EQ(read.panels[p].name, original.panels[p].name);
            EXPECT_LT((read.panels[p].translation - original.panels[p].translation).norm(), 1e-5);
            EXPECT_LT((read.panels[p].rotation - original.panels[p].rotation).norm(), 1e-5);
            EXPECT_NEAR(read.panels[p].wrap_radius, original.panels[p].wrap_radius, 1e-5);
        }
    }
}

TEST(ImportCommand, refuses_wrong_input_on_one_line_and_writes_nothing) {
    const ScratchFolder folder;
    const std::string drawn = folder / "a.svg", garment = folder / "garment.json";
    const auto refused = [&](const std::string& text, const std::string& options = "") {
        sim::write_file_atomically(drawn, text);
        const ProgramResult result = run_selvedge("import '" + drawn + "' -o '" + garment + "' " + options);
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_FALSE(std::filesystem::exists(garment));
        return result.err;
    };
    EXPECT_NE(refused("").find("the file is empty"), std::string::npos);
    EXPECT_NE(refused("hello").find("neither SVG, DXF nor a draft of FreeSewing"), std::string::npos);
    EXPECT_NE(refused(half_shirt(), "--unit ell").find("'ell' is none of mm, cm, m, in, pt, px"), std::string::npos);
    EXPECT_NE(refused(half_shirt(), "--size 40").find("the file names no sizes"), std::string::npos);
}

}  // namespace
}  // namespace selvedge::app
