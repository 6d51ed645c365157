// What all subcommands have in common: help with an example; invalid input gives one line and exit code 2.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>

#include "sim/core/file.h"
#include "tests/app/selvedge_program.h"
#include "tests/support/checkout.h"

namespace selvedge::app {
namespace {

void expect_one_line_and_exit_2(const std::string& arguments) {
    SCOPED_TRACE("selvedge " + arguments);
    const ProgramResult result = run_selvedge(arguments);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(count_lines(result.err), 1) << result.err;
    EXPECT_EQ(result.err.rfind("selvedge: ", 0), 0U) << result.err;
    EXPECT_EQ(result.out, "");
}

TEST(Usage, every_subcommand_explains_itself_with_an_example) {
    for (const char* command : {"dress", "check", "mannequin", "render", "diff", "bench", "bench drop", "bench fabric",
                                "bench rest", "bench tshirt"}) {
        SCOPED_TRACE(command);
        const ProgramResult result = run_selvedge(std::string(command) + " --help");
        EXPECT_EQ(result.exit_code, 0);
        EXPECT_EQ(result.err, "");
        const std::size_t example = result.out.find("Example");
        ASSERT_NE(example, std::string::npos) << result.out;
        EXPECT_NE(result.out.find(std::string("selvedge ") + command, example), std::string::npos) << result.out;
    }
}

TEST(Usage, help_lists_every_subcommand) {
    const ProgramResult result = run_selvedge("--help");
    EXPECT_EQ(result.exit_code, 0);
    for (const char* command : {"dress", "check", "mannequin", "render", "diff", "bench"})
        EXPECT_NE(result.out.find(command), std::string::npos) << command;
}

TEST(Usage, version_tells_build_and_kernels) {
    const ProgramResult result = run_command("SELVEDGE_SIMD=plain " + program() + " --version");
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_TRUE(
        std::regex_match(result.out, std::regex("selvedge [0-9]+\\.[0-9]+\\.[0-9]+\n"
                                                "commit ([0-9a-f]{12}(, changed)?|unknown: not built from git); "
                                                "[A-Za-z]+ [0-9.]+, [A-Za-z]+\n"
                                                "SIMD plain(, of avx2|, of avx512)?\n")))
        << result.out;
    EXPECT_EQ(run_selvedge("--version").out, run_selvedge("--version").out);
}

TEST(Usage, version_refuses_a_simd_level_that_it_does_not_know) {
    const ProgramResult result = run_command("SELVEDGE_SIMD=best " + program() + " --version");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(count_lines(result.err), 1) << result.err;
}

TEST(Usage, words_it_does_not_know_get_one_line) {
    for (const char* arguments :
         {"", "knit", "dress", "dress --no-such-option", "check", "render", "diff one.png", "mannequin --sex robot"})
        expect_one_line_and_exit_2(arguments);
}

TEST(Usage, a_mistyped_command_is_named_with_the_one_that_is_meant) {
    EXPECT_NE(run_selvedge("dres x.json").err.find("no command 'dres': is 'dress' meant?"), std::string::npos);
    EXPECT_NE(run_selvedge("knit x.json").err.find("no command 'knit': there are dress, "), std::string::npos);
}

TEST(Usage, output_that_a_full_disk_does_not_take_is_an_error) {
    const ScratchFolder folder;
    sim::write_file_atomically(folder / "broken.json", "{");
    for (const std::string& arguments : {std::string("--version"), "check '" + folder / "broken.json" + "'"}) {
        const ProgramResult result = run_selvedge(arguments + " > /dev/full");
        EXPECT_EQ(result.exit_code, 2) << arguments;
        EXPECT_EQ(result.err.rfind("selvedge: standard output: cannot write", 0), 0U) << arguments;
        EXPECT_EQ(count_lines(result.err), 1) << arguments;
    }
    EXPECT_EQ(run_selvedge("check " + shipped("tshirt.json") + " > /dev/full").exit_code, 0) << "it prints nothing";
}

#if !defined(SELVEDGE_ADDRESS_SANITIZER)
TEST(Usage, too_little_memory_to_draw_is_one_line) {
    const ScratchFolder folder;
    sim::write_file_atomically(folder / "t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    for (const char* kilobytes : {"400000", "600000", "700000"}) {
        const ProgramResult result = run_command("ulimit -v " + std::string(kilobytes) + "; " + program() +
                                                 " render '" + folder / "t.obj" + "' -o '" + folder / "t.png" + "'");
        EXPECT_EQ(result.exit_code, 2) << kilobytes;
        EXPECT_EQ(count_lines(result.err), 1) << kilobytes << ": " << result.err;
        EXPECT_FALSE(std::filesystem::exists(folder / "t.png"));
    }
}
#endif

TEST(Usage, one_full_disk_is_one_line) {
    const ScratchFolder folder;
    const std::string a = folder / "a.obj", b = folder / "b.obj";
    const ProgramResult result =
        run_command("trap '' XFSZ; ulimit -f 8; " + program() + " dress " + shipped("poncho.json") +
                    " --body mannequin:resolution=1 --max-level 0 --seconds 0.01 -q --no-textures --export '" + a +
                    "' --export-body '" + b + "'");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err, "selvedge: " + a + ", " + b + ": cannot write: File too large\n");
    EXPECT_FALSE(std::filesystem::exists(a) || std::filesystem::exists(b));
}

TEST(Usage, a_missing_file_is_named_on_one_line) {
    const ScratchFolder folder;
    const std::string missing = "'" + folder / "missing" + "'";
    for (const std::string& arguments :
         {"dress " + missing, "render " + missing + " -o '" + folder / "x.png" + "'", "diff " + missing + " " + missing,
          "dress " + shipped("tshirt.json") + " --body " + missing + ".obj"}) {
        expect_one_line_and_exit_2(arguments);
        EXPECT_NE(run_selvedge(arguments).err.find(folder / "missing"), std::string::npos) << arguments;
    }
}

TEST(Usage, check_lists_a_missing_file_like_any_other_fault) {
    const ProgramResult result = run_selvedge("check /no/such/pattern.json");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(count_lines(result.out + result.err), 1) << result.out << result.err;
    EXPECT_NE((result.out + result.err).find("/no/such/pattern.json"), std::string::npos);
}

TEST(Usage, values_that_dress_cannot_use_get_one_line) {
    for (const char* option : {"--fabric no_such_cloth",
                               "--tartan 'no such tartan!'",
                               "--body mannequin:bust",
                               "--body mannequin:bust=wide",
                               "--body mannequin:wings=2",
                               "--body mannequin:bust=-3",
                               "--size 12by30 --render x.png",
                               "--size 0x100 --render x.png",
                               "--size 999999x999999 --render x.png",
                               "--view below --render x.png",
                               "--show bones --render x.png",
                               "--camera 1 --render x.png",
                               "--samples 5 --render x.png",
                               "--supersample x --render x.png",
                               "--turntable film.avi",
                               "--turntable /no/such/folder/film.mp4",
                               "--turntable out/ --frames 0",
                               "--max-level -1",
                               "--max-level 99",
                               "--criteria curvature,taste",
                               "--seconds -1",
                               "--seconds nan",
                               "--threads 0",
                               "--export garment.docx",
                               "--export-body body.docx"})
        expect_one_line_and_exit_2("dress " + shipped("tshirt.json") + " " + option);
}

TEST(Usage, a_folder_that_cannot_be_written_is_said_before_the_work) {
    expect_one_line_and_exit_2("dress " + shipped("tshirt.json") + " --render /no/such/folder/x.png");
    expect_one_line_and_exit_2("dress " + shipped("tshirt.json") + " --report /no/such/folder/x.json");
    expect_one_line_and_exit_2("mannequin -o /no/such/folder/x.obj");
}

TEST(Usage, dress_writes_over_nothing_that_it_reads_and_no_file_twice) {
    const ScratchFolder folder;
    std::filesystem::copy_file(source_folder() + "/patterns/two_squares.json", folder / "garment.json");
    const std::string before = content_of(folder / "garment.json");
    const std::string dress =
        "cd '" + folder.path().string() + "' && '" + program_folder() + "/selvedge' dress garment.json ";
    for (const char* outputs :
         {"--report ./garment.json", "--export a.obj --export-body ./a.obj", "--render a.png --report ./a.png"}) {
        const ProgramResult result = run_command(dress + outputs);
        EXPECT_EQ(result.exit_code, 2) << outputs;
        EXPECT_EQ(count_lines(result.err), 1) << result.err;
    }
    EXPECT_EQ(content_of(folder / "garment.json"), before);
}

TEST(Usage, dress_refuses_a_name_that_is_no_file_or_has_the_wrong_ending) {
    const ScratchFolder folder;
    ASSERT_EQ(run_command("mkfifo '" + folder / "pipe" + "'").exit_code, 0);
    for (const char* name : {"pipe", "", "."})
        expect_one_line_and_exit_2("dress " + shipped("tshirt.json") + " --report '" + folder / name + "'");
    for (const char* option :
         {"--render x.jpg", "--export x.fbx", "--edge-length 0", "--body-unit feet", "--body-up x"})
        expect_one_line_and_exit_2("dress " + shipped("tshirt.json") + " " + option);
}

TEST(Usage, values_that_mannequin_cannot_use_get_one_line) {
    for (const char* option : {"--bust wide -o x.obj", "--bust nan -o x.obj", "--bust -3 -o x.obj", "-o x.docx"})
        expect_one_line_and_exit_2(std::string("mannequin ") + option);
}

// The editor saves a garment that was only begun; what needs panels says that there are none.
TEST(Usage, a_garment_without_panels_is_opened_by_the_editor_and_refused_by_what_needs_panels) {
    const ScratchFolder folder;
    const std::string garment = folder / "begun.json", script = folder / "save.txt", again = folder / "again.json";
    const std::string edit = "edit --state '" + folder / "state" + "' --script '" + script + "'";
    std::ofstream(script) << "new\nsave \"" << garment << "\"\n";
    EXPECT_EQ(run_selvedge(edit).exit_code, 0);
    std::ofstream(script) << "save \"" << again << "\"\n";
    const ProgramResult opened = run_selvedge(edit + " '" + garment + "'");
    EXPECT_EQ(opened.exit_code, 0) << opened.err;
    EXPECT_EQ(content_of(again), content_of(garment));
    const ProgramResult checked = run_selvedge("check '" + garment + "'");
    EXPECT_EQ(checked.exit_code, 0);
    EXPECT_NE(checked.out.find("pattern.panels: warning: no panels"), std::string::npos) << checked.out;
    EXPECT_EQ(run_selvedge("check --strict '" + garment + "'").exit_code, 1);
    expect_one_line_and_exit_2("dress '" + garment + "' --render '" + folder / "a.png" + "'");
    expect_one_line_and_exit_2("animate '" + garment + "' --film '" + folder / "a.gif" + "'");
    expect_one_line_and_exit_2("print '" + garment + "' -o '" + folder / "a.pdf" + "'");
}

// The names would clear a terminal, move its cursor, and take two lines.
TEST(Usage, names_of_a_file_reach_a_terminal_as_one_printable_line) {
    const ScratchFolder folder;
    const std::string name = "\\u001b[2Jfront\\nsecond line" + std::string(2000, 'x');
    std::ofstream(folder / "names.json") << R"({"pattern": {"panels": {")" + name +
                                                R"(": {"vertices": [[0, 0]], "edges": 7}}}})";
    for (const char* command : {"check", "dress"}) {
        const ProgramResult result = run_selvedge(std::string(command) + " '" + folder / "names.json" + "'");
        EXPECT_EQ(result.exit_code, 2);
        const std::string text = result.out + result.err;
        EXPECT_EQ(text.find('\x1b'), std::string::npos) << command;
        EXPECT_NE(text.find("second line"), std::string::npos) << command;
        EXPECT_LT(text.size(), 4500U) << command;
        EXPECT_LT(count_lines(text), 4) << text;
    }
}

TEST(Usage, a_file_that_is_no_picture_gets_one_line) {
    const ScratchFolder folder;
    std::ofstream(folder / "text.png") << "no picture\n";
    expect_one_line_and_exit_2("diff '" + folder / "text.png" + "' '" + folder / "text.png" + "'");
}

}  // namespace
}  // namespace selvedge::app
