// selvedge import: the garment that it writes can be checked, and wrong files are refused on one line.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "render/image/photo.h"
#include "sim/core/file.h"
#include "sim/pattern/pattern_file.h"
#include "tests/app/selvedge_program.h"
#include "tests/sim/paper/drawings.h"
#include "tests/sim/paper/pdf_text.h"
#include "tests/support/checkout.h"

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

// What `import` makes of a draft in a file of its own.
struct Imported {
    ScratchFolder folder;
    std::string drawn = folder / "shirt.json", garment = folder / "garment.json";
    ProgramResult result;
    sim::Pattern pattern;  // empty if it failed

    explicit Imported(const std::string& draft, const std::string& options = "") {
        sim::write_file_atomically(drawn, draft);
        result = run_selvedge("import '" + drawn + "' -o '" + garment + "' " + options);
        if (result.exit_code == 0) pattern = sim::load_pattern(garment).pattern;
    }
};

TEST(ImportCommand, writes_a_garment_with_seams_that_check_accepts) {
    const Imported imported(half_shirt());
    ASSERT_EQ(imported.result.exit_code, 0) << imported.result.err;
    const std::string& out = imported.result.out;
    EXPECT_NE(out.find("front: torso, front"), std::string::npos) << out;
    const sim::Pattern& pattern = imported.pattern;
    ASSERT_EQ(pattern.panels.size(), 2U);
    EXPECT_EQ(pattern.seams.size(), 4U);  // two sides, two shoulders
    EXPECT_GT(pattern.panels[0].translation.z(), pattern.panels[1].translation.z());
    EXPECT_EQ(pattern.body, "mannequin:sex=female,bust=92.50");
    EXPECT_EQ(run_selvedge("check '" + imported.garment + "'").exit_code, 0);
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

TEST(ImportCommand, never_writes_over_what_it_reads_or_over_what_is_no_file) {
    const ScratchFolder folder;
    const std::string paper = folder / "a.svg", pipe = folder / "pipe";
    ASSERT_EQ(run_selvedge("print " + shipped("vest.json") + " -o '" + paper + "'").exit_code, 0);
    const std::string before = sim::read_file(paper, 1U << 20);
    ProgramResult result = run_selvedge("import '" + paper + "' -o '" + paper + "'");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("the same command reads or writes it already"), std::string::npos) << result.err;
    EXPECT_EQ(sim::read_file(paper, 1U << 20), before);
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    result = run_selvedge("import '" + paper + "' -o '" + pipe + "'");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("it is no regular file"), std::string::npos) << result.err;
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST(ImportCommand, places_anew_what_was_printed_round_a_body_that_it_does_not_know) {
    const ScratchFolder folder;
    const std::string paper = folder / "a.svg", garment = folder / "garment.json";
    ASSERT_EQ(run_selvedge("print " + shipped("vest.json") + " -o '" + paper + "'").exit_code, 0);
    std::string text = sim::read_file(paper, 1U << 20);
    const std::string female = "mannequin:sex=female";
    ASSERT_NE(text.find(female), std::string::npos);
    sim::write_file_atomically(paper, text.replace(text.find(female), female.size(), "mannequin:sex=fish"));
    const ProgramResult result = run_selvedge("import '" + paper + "' -o '" + garment + "'");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("the file's body is not used"), std::string::npos) << result.out;
    EXPECT_EQ(sim::load_pattern(garment).pattern.body, female);
}

// The lines of what the program printed below a title.
std::vector<std::string> lines_below(const std::string& text, const std::string& title) {
    std::vector<std::string> lines;
    std::istringstream stream(text.substr(std::min(text.size(), text.find(title + "\n"))));
    std::string line;
    std::getline(stream, line);
    while (std::getline(stream, line) && line.starts_with("  ")) lines.push_back(line.substr(2));
    return lines;
}

// Halves that are not cut on the fold: left and right ones.
std::string halves_of_a_shirt() {
    std::string text = half_shirt();
    for (std::size_t at = text.find("cutOnFoldAnd"); at != text.npos; at = text.find("cutOnFoldAnd"))
        text.erase(at, 12);
    for (std::size_t at = text.find("\"cutonfold\""); at != text.npos; at = text.find("\"cutonfold\""))
        text.replace(at, 11, "\"grain\"");
    // The back is no mirror image of the front.
    const std::string neck = "\"to\": [0, 100]";
    return text.replace(text.rfind(neck), neck.size(), "\"to\": [0, 60]");
}

TEST(ImportCommand, names_panels_and_edges_of_seams_as_the_garment_has_them) {
    const Imported imported(halves_of_a_shirt(), "--list-all");
    const ProgramResult& result = imported.result;
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const sim::Pattern& pattern = imported.pattern;
    ASSERT_EQ(pattern.panels.size(), 4U);
    EXPECT_TRUE(std::ranges::count(pattern.panels, "left_front", &sim::Panel::name) == 1) << result.out;
    const std::vector<std::string> seams = lines_below(result.out, "Seams:");
    std::vector<std::string> all = lines_below(result.out, "Possible, not sewn:");
    EXPECT_FALSE(seams.empty()) << result.out;
    all.insert(all.end(), seams.begin(), seams.end());
    for (const std::string& line : all) {
        std::istringstream words(line.substr(0, line.find('(')));
        for (std::string word; words >> word;) {
            const std::size_t dot = word.find('.');
            if (dot == word.npos) continue;
            const auto panel = std::ranges::find(pattern.panels, word.substr(0, dot), &sim::Panel::name);
            ASSERT_NE(panel, pattern.panels.end()) << line;
            EXPECT_LT(std::stoul(word.substr(dot + 1)), panel->edges.size()) << line;
        }
    }
}

// A sleeve for the shirt, mm: 475 mm round its cap.
std::string sleeve(const std::string& name, int length) {
    const std::string hem = std::to_string(length);
    return R"(, "test.)" + name + R"(": {"paths": {"seam": {"class": "fabric", "ops": [
  {"type": "move", "to": [-150, )" +
           hem + R"(]}, {"type": "line", "to": [150, )" + hem + R"(]},
  {"type": "line", "to": [180, 0]},
  {"type": "curve", "to": [0, -140], "cp1": [110, 0], "cp2": [90, -140]},
  {"type": "curve", "to": [-180, 0], "cp1": [-90, -140], "cp2": [-110, 0]},
  {"type": "line", "to": [-150, )" +
           hem + R"(]}, {"type": "close"}]}}})";
}

TEST(ImportCommand, tells_which_of_two_sleeves_that_fit_is_sewn_in) {
    const std::string text = half_shirt();
    const Imported imported(text.substr(0, text.rfind("}}")) + sleeve("short_sleeve", 150) +
                            sleeve("long_sleeve", 450) + text.substr(text.rfind("}}")));
    const ProgramResult& result = imported.result;
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(
        result.out.find("short_sleeve: no seam joins it to the garment, where 'left_long_sleeve' is sewn in as the "
                        "sleeve: on the sheet, but not worn"),
        std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find("'right_long_sleeve' is sewn in"), std::string::npos) << result.out;
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
    EXPECT_NE(refused("hello").find("neither SVG, DXF, PDF nor a draft of FreeSewing"), std::string::npos);
    EXPECT_EQ(refused(sim::read_file(source_folder() + "/patterns/tshirt.json", 1000000)),
              "selvedge: " + drawn +
                  ": a garment file already, not a drawing: open it with selvedge dress or selvedge edit\n");
    const std::string cut_off = refused(half_shirt().substr(0, 400));
    EXPECT_NE(cut_off.find(": not JSON at line "), std::string::npos) << cut_off;
    EXPECT_LT(cut_off.size(), drawn.size() + 150) << cut_off;
    EXPECT_NE(refused(half_shirt(), "--unit ell").find("'ell' is none of mm, cm, m, in, pt, px"), std::string::npos);
    EXPECT_NE(refused(half_shirt(), "--size 40").find("the file names no sizes"), std::string::npos);
    sim::write_file_atomically(drawn, half_shirt());
    const ProgramResult other = run_selvedge("import '" + drawn + "' -o '" + folder / "garment.txt" + "'");
    EXPECT_EQ(other.exit_code, 2);
    EXPECT_NE(other.err.find(".json"), std::string::npos) << other.err;
}

TEST(ImportCommand, leaves_a_garment_of_a_newer_program_alone) {
    const ScratchFolder folder;
    const std::string drawn = folder / "a.svg", garment = folder / "garment.json";
    sim::write_file_atomically(drawn, half_shirt());
    const std::string newer = R"({"pattern": {"panels": {}}, "selvedge": {"format": 99}})";
    sim::write_file_atomically(garment, newer);
    const ProgramResult result = run_selvedge("import '" + drawn + "' -o '" + garment + "'");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("selvedge.format: not written over"), std::string::npos) << result.err;
    EXPECT_EQ(content_of(garment), newer);
}

// ---- Scans.

// A page of A4 with a picture over all of it; a second page has an outline too.
std::string scanned_pdf(bool has_lines) {
    sim::PdfTextFile file{
        .pages = {{.content = "q " + sim::pdf_number(210) + "0 0 " + sim::pdf_number(297) + "0 0 cm /I Do Q\n",
                   .resources = "/XObject << /I 4 0 R >>"}},
        .objects = {"<< /Type /XObject /Subtype /Image /Width 2 /Height 2 /ColorSpace /DeviceGray "
                    "/BitsPerComponent 8 /Length 4 >>\nstream\nabcd\nendstream"}};
    if (has_lines) file.pages.push_back({.content = sim::pdf_line({{20, 40}, {190, 50}, {170, 280}, {30, 270}})});
    return file.bytes();
}

class ImportOfScans : public testing::Test {
 protected:
    ProgramResult import(bool has_lines) {
        sim::write_file_atomically(pdf_, scanned_pdf(has_lines));
        return run_selvedge("import '" + pdf_ + "' -o '" + garment_ + "'");
    }
    ProgramResult edit(const std::string& script) {
        const std::string file = folder_ / "script.txt";
        sim::write_file_atomically(file, script);
        return run_selvedge("edit --script '" + file + "' --state '" + (folder_ / "state") + "'");
    }
    void expect_true_size(const sim::Underlay& underlay) {
        const render::Photo photo = render::read_photo(underlay.file);
        EXPECT_NEAR(underlay.pixel_size * photo.image.width_px, 0.210, 5e-4);
        EXPECT_NEAR(underlay.pixel_size * photo.image.height_px, 0.297, 5e-4);
    }

    const ScratchFolder folder_;
    const std::string pdf_ = folder_ / "scan.pdf", garment_ = folder_ / "skirt.json",
                      picture_ = folder_ / "skirt_page1.jpg";
};

TEST_F(ImportOfScans, lays_pages_under_the_sheet_at_true_size_when_they_hold_only_scans) {
    const ProgramResult result = import(false);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("page 1: only a scan, 21.0 x 29.7 cm: no panel is read of it"), std::string::npos);
    EXPECT_NE(result.out.find("skirt_page1.jpg: page 1, 21.0 x 29.7 cm, to be traced"), std::string::npos);
    EXPECT_NE(result.out.find("skirt.json: 0 panels, 0 seams"), std::string::npos) << result.out;
    EXPECT_NE(content_of(garment_).find("\"skirt_page1.jpg\""), std::string::npos) << "named from the garment's folder";
    const sim::Pattern pattern = sim::load_pattern(garment_).pattern;
    EXPECT_TRUE(pattern.panels.empty());
    ASSERT_EQ(pattern.underlays.size(), 1U);
    expect_true_size(pattern.underlays[0]);
    EXPECT_EQ(run_selvedge("check '" + garment_ + "'").exit_code, 0);
    const ProgramResult dressed = run_selvedge("dress '" + garment_ + "'");
    EXPECT_EQ(dressed.exit_code, 2);
    EXPECT_EQ(count_lines(dressed.err), 1);
    EXPECT_NE(dressed.err.find("no panel that is worn: nothing to dress before its photos are traced"),
              std::string::npos);
    EXPECT_EQ(edit("open \"" + garment_ + "\"\nframes 3\n").exit_code, 0);
}

TEST_F(ImportOfScans, beside_lines_gives_panels_and_underlays_clear_of_them) {
    ASSERT_EQ(import(true).exit_code, 0);
    const sim::Pattern pattern = sim::load_pattern(garment_).pattern;
    EXPECT_EQ(pattern.panels.size(), 1U);
    ASSERT_EQ(pattern.underlays.size(), 1U);
    expect_true_size(pattern.underlays[0]);
    EXPECT_GT(pattern.underlays[0].position.x() - 0.105, 0.17) << "the panel is 17 cm wide";
}

TEST_F(ImportOfScans, again_writes_the_same_and_other_files_of_these_names_stay) {
    ASSERT_EQ(import(false).exit_code, 0);
    const std::string first = content_of(garment_);
    EXPECT_EQ(import(false).exit_code, 0);
    EXPECT_EQ(content_of(garment_), first);
    sim::write_file_atomically(picture_, "my holidays");
    sim::write_file_atomically(garment_, R"({"pattern": {"panels": {}}})");
    const ProgramResult refused = import(false);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_NE(refused.err.find("skirt_page1.jpg: not replaced: a file of this name holds something else"),
              std::string::npos)
        << refused.err;
    EXPECT_EQ(content_of(picture_), "my holidays");
    EXPECT_EQ(content_of(garment_), R"({"pattern": {"panels": {}}})");
}

TEST_F(ImportOfScans, that_cannot_write_the_garment_leaves_no_picture) {
    sim::write_file_atomically(garment_, R"({"pattern": {"panels": {}}, "selvedge": {"format": 99}})");
    EXPECT_EQ(import(false).exit_code, 2);
    EXPECT_FALSE(std::filesystem::exists(picture_));
}

TEST_F(ImportOfScans, together_with_a_drawing_makes_one_garment_of_both) {
    const std::string drawn = folder_ / "shirt.json";
    sim::write_file_atomically(drawn, half_shirt());
    sim::write_file_atomically(pdf_, scanned_pdf(false));
    ASSERT_EQ(run_selvedge("import '" + pdf_ + "' '" + drawn + "' '" + pdf_ + "' -o '" + garment_ + "'").exit_code, 0);
    const sim::Pattern pattern = sim::load_pattern(garment_).pattern;
    EXPECT_EQ(pattern.panels.size(), 2U);
    ASSERT_EQ(pattern.underlays.size(), 2U);
    EXPECT_TRUE(pattern.underlays[1].file.ends_with("skirt_page1_2.jpg"));
}

TEST_F(ImportOfScans, beside_lines_have_the_unit_that_is_stated_for_these) {
    sim::write_file_atomically(pdf_, scanned_pdf(true));
    ASSERT_EQ(run_selvedge("import '" + pdf_ + "' --unit cm -o '" + garment_ + "'").exit_code, 0);
    const sim::Pattern pattern = sim::load_pattern(garment_).pattern;
    ASSERT_EQ(pattern.underlays.size(), 1U);
    const render::Photo photo = render::read_photo(pattern.underlays[0].file);
    EXPECT_NEAR(pattern.underlays[0].pixel_size * photo.image.width_px, 2.10, 5e-3);
}

TEST_F(ImportOfScans, of_more_pages_in_all_than_underlays_are_cut_off_and_told) {
    sim::PdfTextFile file{.pages = {},
                          .objects = {"<< /Type /XObject /Subtype /Image /Width 2 /Height 2 /ColorSpace /DeviceGray "
                                      "/BitsPerComponent 8 /Length 4 >>\nstream\nabcd\nendstream"}};
    file.pages.resize(40, {.content = "q " + sim::pdf_number(10) + "0 0 " + sim::pdf_number(10) + "0 0 cm /I Do Q\n",
                           .size = {10, 10},
                           .resources = "/XObject << /I 4 0 R >>"});
    sim::write_file_atomically(pdf_, file.bytes());
    const ProgramResult result = run_selvedge("import '" + pdf_ + "' '" + pdf_ + "' -o '" + garment_ + "'");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(sim::load_pattern(garment_).pattern.underlays.size(), 64U);
    EXPECT_NE(result.out.find("scan.pdf: 16 scans, from page 25 on, left out: at most 64"), std::string::npos)
        << result.out;
}

TEST_F(ImportOfScans, in_the_editor_that_cannot_be_written_leave_the_panels_and_no_picture) {
    const std::string name(250, 'x');  // a file of it with "_page1.jpg" cannot be made
    const std::string long_named = folder_ / (name + ".pdf");
    sim::write_file_atomically(long_named, scanned_pdf(true));
    const ProgramResult result = edit("import \"" + long_named + "\"\nframes 3\nsave \"" + garment_ + "\"\n");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const sim::Pattern pattern = sim::load_pattern(garment_).pattern;
    EXPECT_EQ(pattern.panels.size(), 1U);
    EXPECT_TRUE(pattern.underlays.empty());
}

TEST_F(ImportOfScans, in_the_editor_writes_them_beside_the_drawing) {
    sim::write_file_atomically(pdf_, scanned_pdf(false));
    const ProgramResult result = edit("import \"" + pdf_ + "\"\nframes 3\nsave \"" + garment_ + "\"\n");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const sim::Pattern pattern = sim::load_pattern(garment_).pattern;
    ASSERT_EQ(pattern.underlays.size(), 1U);
    EXPECT_TRUE(pattern.underlays[0].file.ends_with("scan_page1.jpg"));
    expect_true_size(pattern.underlays[0]);
}

}  // namespace
}  // namespace selvedge::app
