// selvedge bench, as a black box.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "render/image/image.h"
#include "sim/core/file.h"
#include "sim/core/json.h"
#include "sim/pattern/fabric_file.h"
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

// Two squares with two seams, the second in that direction, and these members of `selvedge`.
std::string two_squares(const std::string& additions, const std::string& second = "") {
    const auto square = [](const char* name, const char* place) {
        return std::string("\"") + name +
               R"(": {"vertices": [[-20, 0], [20, 0], [20, 40], [-20, 40]], "translation": )" + place +
               R"(, "rotation": [0, 0, 0], "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]},
                  {"endpoints": [2, 3]}, {"endpoints": [3, 0]}]})";
    };
    const auto stitch = [](int first, int other, const std::string& more) {
        return R"([{"panel": "front", "edge": )" + std::to_string(first) + R"(}, {"panel": "back", "edge": )" +
               std::to_string(other) + "}" + more + "]";
    };
    return R"({"pattern": {"panels": {)" + square("front", "[0, 100, 25]") + ", " + square("back", "[0, 100, -25]") +
           R"(}, "stitches": [)" + stitch(1, 3, "") + ", " + stitch(3, 1, second) + R"(]}, "selvedge": {)" + additions +
           R"(}, "properties": {"curvature_coords": "relative", "units_in_meter": 100}})";
}

// What `dress` refuses, `check` reports: with the same words.
TEST(CheckCommand, finds_whatever_dress_refuses) {
    const ScratchFolder folder;
    const std::string garment = folder / "garment.json";
    std::ofstream(folder / "no_fabric.json") << "{}";
    std::ofstream(folder / "no_body.obj") << "v 0 0 0\n";
    std::ofstream(folder / "plaid.json") << sim::read_fabric_file("silk").text.insert(
        1, R"("surface": {"kind": "picture", "file": "missing.png"}, )");
    for (const char* additions :
         {R"("fabric": "nosuch")", R"("fabric": "nosuch.json")", R"("fabric": "no_fabric.json")",
          R"("fabric": "plaid.json")", R"("body": "missing.obj")", R"("body": "no_body.obj")",
          R"("body": "mannequin:bust=7")", R"("body": "mannequin:tail=70")",
          R"("body": "mannequin:height=170,inseam=105")", R"("body_height": 40)", R"("body_height": 120)",
          R"("body_height": 250)", R"("tartan": "nosuch")",
          R"("surface": {"kind": "picture", "file": "missing.png"})"}) {
        std::ofstream(garment) << two_squares(additions);
        const ProgramResult checked = run_selvedge("check '" + garment + "'");
        const ProgramResult dressed = run_selvedge("dress '" + garment + "' --seconds 0.01 -q");
        EXPECT_EQ(checked.exit_code, 2) << additions << checked.out;
        EXPECT_EQ(count_lines(checked.out), 1) << checked.out;
        EXPECT_EQ(dressed.exit_code, 2) << additions << dressed.out;
        EXPECT_EQ(count_lines(dressed.err), 1) << dressed.err;
        EXPECT_NE(checked.out.find("garment.json: selvedge."), std::string::npos) << checked.out;
    }
    std::ofstream(garment) << two_squares("");
    EXPECT_EQ(run_selvedge("check '" + garment + "'").exit_code, 0);
}

TEST(CheckCommand, finds_a_body_beside_the_garment_from_any_folder) {
    const ScratchFolder folder;
    std::filesystem::create_directory(folder.path() / "sub");
    ASSERT_EQ(run_selvedge("mannequin --resolution 1 -o '" + folder / "sub/body.obj" + "'").exit_code, 0);
    std::ofstream(folder / "sub/garment.json") << two_squares(R"("body": "body.obj")");
    const ProgramResult checked = run_selvedge("check '" + folder / "sub/garment.json" + "'");
    EXPECT_EQ(checked.exit_code, 0) << checked.out;
    const ProgramResult dressed = run_selvedge("dress '" + folder / "sub/garment.json" + "' --seconds 0.01 -q");
    EXPECT_EQ(dressed.exit_code, 3) << dressed.err << "it is not at rest so soon";
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

TEST_F(DiffCommand, replaces_neither_what_it_compares_nor_what_is_no_file) {
    ASSERT_EQ(::mkfifo(picture().c_str(), 0600), 0);
    EXPECT_EQ(diff(render::Image(8, 4, kGrey), render::Image(4, 8, kGrey)).exit_code, 2);
    EXPECT_TRUE(std::filesystem::is_fifo(picture()));
    const std::string a = folder_ / "a.png", b = folder_ / "b.png";
    std::filesystem::create_symlink("a.png", folder_ / "link.png");
    for (const std::string& output : {a, b, folder_ / "link.png", folder_ / "./a.png"}) {
        const ProgramResult result = run_selvedge("diff '" + a + "' '" + b + "' -o '" + output + "'");
        EXPECT_EQ(result.exit_code, 2) << output;
        EXPECT_EQ(count_lines(result.err), 1) << result.err;
    }
    EXPECT_EQ(render::read_png(a).width_px, 8);
    EXPECT_EQ(render::read_png(b).width_px, 4);
}

TEST(Outputs, are_never_inputs) {
    const ScratchFolder folder;
    const std::string skirt = source_folder() + "/patterns/skirt.json", copy = folder / "skirt.json";
    const std::string fabric = folder / "silk.json", measures = folder / "anna.json", picture = folder / "roses.png";
    std::string text = content_of(skirt);
    text.replace(text.find("\"wool_twill_light\""), 18, "\"silk.json\"");
    sim::write_file_atomically(copy, text);
    sim::write_file_atomically(fabric, sim::read_fabric_file("silk").text);
    sim::write_file_atomically(measures, "{}");
    write_png(picture, render::Image(8, 4, kGrey));
    const auto quoted = [](const std::string& name) { return " '" + name + "'"; };
    for (const std::string& command :
         {"dress" + quoted(copy) + " --report" + quoted(copy), "dress" + quoted(copy) + " --report" + quoted(fabric),
          "dress" + quoted(skirt) + " --fabric" + quoted(fabric) + " --report" + quoted(fabric),
          "dress" + quoted(skirt) + " --design" + quoted(picture) + " --render" + quoted(picture),
          "animate" + quoted(copy) + " --report" + quoted(fabric),
          "mannequin --measurements" + quoted(measures) + " -o" + quoted(measures),
          "match" + quoted(copy) + " --dry-run --json" + quoted(fabric),
          "match" + quoted(copy) + " -o" + quoted(fabric), "bench tshirt" + quoted(copy) + " --json" + quoted(copy),
          "import" + quoted(copy) + " -o" + quoted(copy)}) {
        const ProgramResult result = run_selvedge(command);
        EXPECT_EQ(result.exit_code, 2) << command << result.out;
        EXPECT_EQ(count_lines(result.err), 1) << result.err;
    }
    EXPECT_EQ(content_of(copy), text);
    EXPECT_EQ(content_of(fabric), sim::read_fabric_file("silk").text);
    EXPECT_EQ(content_of(measures), "{}");
    EXPECT_EQ(render::read_png(picture).width_px, 8);
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

TEST(MannequinCommand, says_where_its_data_end_for_a_child) {
    const ScratchFolder folder;
    const ProgramResult result = make_mannequin_file("--height 110", folder / "body.obj");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("its data are of adults and end there"), std::string::npos) << result.err;
    EXPECT_EQ(count_lines(result.err), 1) << result.err;
}

class EditScriptFiles : public testing::Test {
 protected:
    // Plays the steps on a copy of the skirt.
    ProgramResult play(const std::string& steps, const std::string& before = "") {
        sim::write_file_atomically(script_, steps);
        sim::write_file_atomically(garment_, content_of(source_folder() + "/patterns/skirt.json"));
        return run_command(before + " '" + program_folder() + "/selvedge' edit '" + garment_ + "' --script '" +
                           script_ + "'" + state_);
    }

    ScratchFolder folder_;
    std::string script_ = folder_ / "script.txt", garment_ = folder_ / "skirt.json";
    std::string state_ = " --state '" + folder_ / "state" + "'";
};

TEST_F(EditScriptFiles, saves_and_prints_over_a_file_that_is_there) {
    for (const char* name : {"saved.json", "printed.svg"}) std::ofstream(folder_ / name) << "old";
    const ProgramResult result =
        play("save \"" + folder_ / "saved.json" + "\"\nprint \"" + folder_ / "printed.svg" + "\"\n");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    for (const char* name : {"saved.json", "printed.svg"}) EXPECT_GT(content_of(folder_ / name).size(), 100U) << name;
}

TEST_F(EditScriptFiles, writes_over_neither_what_it_reads_nor_what_is_no_file) {
    ASSERT_EQ(::mkfifo((folder_ / "pipe.png").c_str(), 0600), 0);
    const std::string fabric = folder_ / "silk.json";
    sim::write_file_atomically(fabric, sim::read_fabric_file("silk").text);
    const std::string text = content_of(source_folder() + "/patterns/skirt.json");
    for (const std::string& step : std::vector<std::string>{
             "screenshot \"" + folder_ / "pipe.png" + "\"", "screenshot \"" + script_ + "\"",
             "screenshot \"" + garment_ + "\"", "screenshot /dev/null", "print \"" + garment_ + "\"",
             R"(do {"set_fabric": {"fabric": ")" + fabric + "\"}}\nsave \"" + fabric + "\"",
             R"(do {"set_fabric": {"fabric": ")" + fabric + "\"}}\nscreenshot \"" + fabric + "\""}) {
        const ProgramResult result = play(step + "\n");
        EXPECT_EQ(result.exit_code, 2) << step;
        EXPECT_EQ(count_lines(result.err), 1) << result.err;
        EXPECT_EQ(content_of(script_), step + "\n");
        EXPECT_EQ(content_of(garment_), text) << step;
    }
    EXPECT_EQ(content_of(fabric), sim::read_fabric_file("silk").text);
    EXPECT_TRUE(std::filesystem::is_fifo(folder_ / "pipe.png"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(EditScriptFiles, run_without_a_home_that_can_be_written_and_leave_nothing_in_shared_folders) {
    const std::string shared = folder_ / "shared";
    std::filesystem::create_directory(shared);
    state_.clear();
    const ProgramResult closed = play("frames 1\n", "TMPDIR='" + shared + "' XDG_STATE_HOME=/dev/null/state");
    EXPECT_EQ(closed.exit_code, 0) << closed.err;
    EXPECT_NE(closed.err.find("after a crash, nothing can be recovered"), std::string::npos) << closed.err;
    EXPECT_TRUE(std::filesystem::is_empty(shared));
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
