// selvedge bench, as a black box.
#include <gtest/gtest.h>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "render/image/image.h"
#include "sim/core/file.h"
#include "sim/core/json.h"
#include "tests/app/selvedge_program.h"
#include "tests/support/checkout.h"

namespace selvedge::app {
namespace {

TEST(BenchCommand, prints_the_table_that_is_asked_for_and_keeps_it_as_json) {
    const ScratchFolder folder;
    const ProgramResult result = run_selvedge("bench thesis --quick --table 3.11 --json '" + folder / "t.json" + "'");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out.rfind("## 3.11: ", 0), 0U) << result.out;
    EXPECT_EQ(result.out.find("## 3.6"), std::string::npos);
    const sim::Json json = sim::read_json(folder / "t.json");
    ASSERT_EQ(json.find("tables")->elements().size(), 1U);
    const sim::Json& table = json.find("tables")->elements()[0];
    EXPECT_EQ(table.find("name")->string(), "3.11");
    for (const sim::Json& row : table.find("rows")->elements())
        EXPECT_EQ(row.elements().size(), table.find("columns")->elements().size());
}

TEST(BenchCommand, writes_a_series_as_csv_and_svg_and_a_page_that_holds_it) {
    const ScratchFolder folder;
    const ProgramResult result =
        run_command("PATH=/nowhere '" + program_folder() + "/selvedge' bench thesis --quick --figure 3.21 6.4 --out '" +
                    folder / "figures" + "'");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(content_of(folder / "figures/figure-3.21.csv").rfind("existing triangles,", 0), 0U);
    EXPECT_NE(content_of(folder / "figures/figure-3.21.svg").find("<path"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder / "figures/figure-3.22.csv")) << "it was not asked for";
    const std::string page = content_of(folder / "figures/index.html");
    EXPECT_NE(page.find("href=\"figure-3.21.csv\""), std::string::npos);
    EXPECT_EQ(page.find(folder / ""), std::string::npos) << "links are relative";
    EXPECT_NE(result.out.find("F6.4 agrees."), std::string::npos) << result.out;
}

TEST(BenchCommand, a_tshirt_that_is_not_there_is_noticed_before_anything_is_measured) {
    const ScratchFolder folder;
    const ProgramResult result =
        run_selvedge("bench thesis --quick --figure 6.5 4.12 --tshirt none.json --out '" + folder / "figures" + "'");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(count_lines(result.err), 1) << result.err;
    EXPECT_EQ(result.out, "");
}

TEST(BenchCommand, a_picture_is_measured_for_every_kind_of_change) {
    const ScratchFolder folder;
    const std::string sheet = folder / "sheet.obj";
    std::ofstream(sheet) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
    const ProgramResult result = run_selvedge("bench picture '" + sheet + "' --side 64 --pictures 1 --triangles 30 " +
                                              "--json '" + folder / "picture.json" + "'");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const sim::Json json = sim::read_json(folder / "picture.json");
    const sim::Json& table = json.find("tables")->elements()[0];
    EXPECT_NE(table.find("note")->string().find("cloth of 32 triangles"), std::string::npos);
    ASSERT_EQ(table.find("rows")->elements().size(), 7U);
    for (const sim::Json& row : table.find("rows")->elements()) EXPECT_GT(row.elements()[1].number(), 0);
}

TEST(BenchCommand, a_table_that_is_not_there_gets_one_line_with_those_that_are) {
    for (const char* arguments : {"bench thesis --table 9.9", "bench thesis --figure 2.1"}) {
        const ProgramResult result = run_selvedge(arguments);
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_EQ(count_lines(result.err), 1) << result.err;
        EXPECT_NE(result.err.find("3.2"), std::string::npos) << result.err;
        EXPECT_EQ(result.out, "");
    }
}

}  // namespace

// selvedge check: exit codes, and the path of every fault.

namespace {

// A square of 40 cm; its outline is closed if last_endpoint is 0.
std::string square_pattern(int last_endpoint) {
    return R"({"pattern": {"panels": {"square": {
        "vertices": [[0, 0], [40, 0], [40, 40], [0, 40]], "translation": [0, 0, 0], "rotation": [0, 0, 0],
        "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, )" +
           std::to_string(last_endpoint) + R"(]}]}}, "stitches": []},
        "properties": {"curvature_coords": "relative", "normalize_panel_translation": false,
                       "normalized_edge_loops": true, "units_in_meter": 100}})";
}

ProgramResult check_text(const std::string& text, const std::string& options = "") {
    const ScratchFolder folder;
    std::ofstream(folder / "pattern.json") << text;
    return run_selvedge("check '" + folder / "pattern.json" + "' " + options);
}

TEST(CheckCommand, every_pattern_that_ships_is_clean_even_strictly) {
    int tried = 0;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() + "/patterns")) {
        if (entry.path().extension() != ".json") continue;
        const ProgramResult result = run_selvedge("check --strict '" + entry.path().string() + "'");
        EXPECT_EQ(result.exit_code, 0) << entry.path() << result.out << result.err;
        ++tried;
    }
    EXPECT_GE(tried, 5);
}

TEST(CheckCommand, a_closed_square_passes) {
    const ProgramResult result = check_text(square_pattern(0));
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
}

TEST(CheckCommand, an_open_outline_is_named_with_file_and_place) {
    const ProgramResult result = check_text(square_pattern(1));
    EXPECT_EQ(result.exit_code, 2);
    const std::string said = result.out + result.err;
    EXPECT_NE(said.find("pattern.json"), std::string::npos) << said;
    EXPECT_NE(said.find("pattern.panels.square"), std::string::npos) << said;
}

TEST(CheckCommand, a_tartan_that_dressing_would_refuse_is_a_fault) {
    const auto with_tartan = [](const std::string& tartan) {
        std::string text = square_pattern(0);
        return text.insert(1, R"("selvedge": {"tartan": ")" + tartan + R"("}, )");
    };
    EXPECT_EQ(check_text(with_tartan("gordon")).exit_code, 0);
    for (const char* tartan : {"nosuch", "B24 W4 weft: Q3"}) {
        const ProgramResult result = check_text(with_tartan(tartan));
        EXPECT_EQ(result.exit_code, 2) << tartan;
        EXPECT_EQ(count_lines(result.out), 1) << result.out;
        EXPECT_NE(result.out.find("pattern.json: selvedge.tartan: "), std::string::npos) << result.out;
    }
}

TEST(CheckCommand, text_that_is_no_json_is_a_fault) {
    EXPECT_EQ(check_text("{\"pattern\": ").exit_code, 2);
    EXPECT_EQ(check_text("").exit_code, 2);
    EXPECT_EQ(check_text(std::string(100, '[') + std::string(100, ']')).exit_code, 2);
}

}  // namespace

// selvedge diff: exit code 0 for equal pictures; 1 and a difference picture for different ones.

namespace {

const render::Rgba8 kGrey{128, 128, 128, 255};

class DiffCommand : public testing::Test {
 protected:
    ProgramResult diff(const render::Image& first, const render::Image& second) {
        write_png(folder_ / "a.png", first);
        write_png(folder_ / "b.png", second);
        return run_selvedge("diff '" + folder_ / "a.png" + "' '" + folder_ / "b.png" + "' -o '" + picture() + "'");
    }
    std::string picture() const { return folder_ / "difference.png"; }

 private:
    ScratchFolder folder_;
};

TEST_F(DiffCommand, equal_pictures_exit_0_and_leave_no_difference_picture) {
    EXPECT_EQ(diff(render::Image(8, 4, kGrey), render::Image(8, 4, kGrey)).exit_code, 0);
    EXPECT_FALSE(std::filesystem::exists(picture()));
}

TEST_F(DiffCommand, one_pixel_exits_1_and_writes_a_difference_picture) {
    render::Image other(8, 4, kGrey);
    other.at(3, 2) = {0, 128, 128, 255};
    const ProgramResult result = diff(render::Image(8, 4, kGrey), other);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.out, "");
    EXPECT_EQ(render::read_png(picture()).width_px, 8);
}

TEST_F(DiffCommand, pictures_of_two_sizes_differ) {
    EXPECT_EQ(diff(render::Image(8, 4, kGrey), render::Image(4, 8, kGrey)).exit_code, 1);
}

}  // namespace

// selvedge mannequin: identical bytes for the same measurements in both formats, and the printed girths.

namespace {

ProgramResult make_mannequin_file(const std::string& options, const std::string& file) {
    return run_selvedge("mannequin --resolution 1 " + options + " -o '" + file + "'");
}

// Reads the line "bust  96.0  96.0  117.1": measurement, requested value, measured value, height; cm.
double printed_girth(const std::string& out, const std::string& measure) {
    std::istringstream lines(out);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream text(line);
        std::string name;
        double asked = 0, read = 0;
        if (text >> name >> asked >> read && name == measure) return read;
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

TEST(EditScript, that_ends_unsaved_leaves_nothing_to_recover) {
    const ScratchFolder folder;
    const std::string script = folder / "script.txt", state = folder / "state";
    sim::write_file_atomically(
        script, "open \"" + source_folder() + "/patterns/skirt.json\"\naction edit.select_all\naction edit.delete\n");
    const ProgramResult result = run_selvedge("edit --script '" + script + "' --state '" + state + "'");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(std::filesystem::is_empty(state + "/journals"));
}

}  // namespace

}  // namespace selvedge::app
