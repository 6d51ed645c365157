// Manifests give the jobs that they list, with names of their own, and refuse what is wrong with its place.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "batch/csv.h"
#include "batch/manifest.h"
#include "sim/core/error.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::batch {
namespace {

std::string refusal(const std::string& text, const char* file) {
    try {
        std::vector<Job> jobs = parse_manifest(text, file);
        name_jobs(jobs);
    } catch (const sim::InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Csv, reads_quotes_line_ends_and_marks) {
    const auto rows = parse_csv(
        "\xEF\xBB\xBF"
        "a,b\r\n\"x, \"\"y\"\"\",\"two\nlines\"\n\n,last\n,,\n",
        "t.csv");
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].fields, (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(rows[1].fields, (std::vector<std::string>{"x, \"y\"", "two\nlines"}));
    EXPECT_EQ(rows[2].fields, (std::vector<std::string>{"", "last"}));
    EXPECT_EQ(rows[2].line, 5U);
    EXPECT_THROW(parse_csv("a\n\"open", "t.csv"), sim::InputError);
    EXPECT_THROW(parse_csv("\"a\"b", "t.csv"), sim::InputError);
}

TEST(Csv, reads_what_spreadsheets_write) {
    for (const char* text : {"a;b\n1,5;\"x;y\"\n", "a\tb\n1,5\tx;y\n"}) {
        const auto rows = parse_csv(text, "t.csv");
        ASSERT_EQ(rows.size(), 2U) << text;
        EXPECT_EQ(rows[1].fields, (std::vector<std::string>{"1,5", "x;y"})) << text;
    }
    EXPECT_THROW(parse_csv("\xFF\xFEg", "t.csv"), sim::InputError) << "UTF-16";
}

TEST(Csv, what_is_written_is_read_again) {
    const std::vector<std::string> fields{"plain", "with, comma", "with \"quotes\"", "two\nlines", ""};
    EXPECT_EQ(parse_csv(csv_line(fields), "t.csv").at(0).fields, fields);
}

TEST(Manifest, json_lists_jobs_with_paths_in_its_folder) {
    const std::vector<Job> jobs = parse_manifest(R"({
        "options": {"seconds": 8},
        "jobs": [{"name": "one", "garment": "a/shirt.json", "over": ["vest.json"], "body": "../bodies/b.obj",
                  "fabric": "silk", "options": {"no-self-collision": true, "coarse-back-faces": false}},
                 {"garment": "/abs/skirt.json", "body": "mannequin:bust=92", "fabric": "f.json"}]})",
                                                 "lists/m.json");
    ASSERT_EQ(jobs.size(), 2U);
    EXPECT_EQ(dress_arguments(jobs[0]),
              (std::vector<std::string>{"lists/a/shirt.json", "--over", "lists/vest.json", "--body", "bodies/b.obj",
                                        "--fabric", "silk", "--seconds", "8", "--no-self-collision"}));
    EXPECT_EQ(dress_arguments(jobs[1]), (std::vector<std::string>{"/abs/skirt.json", "--body", "mannequin:bust=92",
                                                                  "--fabric", "lists/f.json", "--seconds", "8"}));
}

TEST(Manifest, a_job_s_own_option_replaces_that_of_all_jobs) {
    const std::vector<Job> jobs = parse_manifest(R"({
        "options": {"seconds": 8, "no-self-collision": true},
        "jobs": [{"garment": "a.json", "options": {"seconds": 4}},
                 {"garment": "b.json", "options": {"no-self-collision": false}}]})",
                                                 "m.json");
    ASSERT_EQ(jobs.size(), 2U);
    EXPECT_EQ(dress_arguments(jobs[0]), (std::vector<std::string>{"a.json", "--seconds", "4", "--no-self-collision"}));
    EXPECT_EQ(dress_arguments(jobs[1]), (std::vector<std::string>{"b.json", "--seconds", "8"}));
    EXPECT_TRUE(jobs[0].options[0].is_common);
    EXPECT_FALSE(jobs[0].options[1].is_common);
}

TEST(Manifest, the_picture_of_a_design_is_in_its_folder) {
    const auto designs = [](const std::string& text, const char* file) {
        std::vector<std::string> all;
        for (const Job& job : parse_manifest(text, file)) all.push_back(job.options.at(0).value);
        return all;
    };
    EXPECT_EQ(designs(R"({"options": {"design": "all.png"}, "jobs": [{"garment": "a.json"},
                          {"garment": "b.json", "options": {"design": "../own.png"}},
                          {"garment": "c.json", "options": {"design": "#ff0000"}}]})",
                      "lists/m.json"),
              (std::vector<std::string>{"lists/all.png", "own.png", "#ff0000"}));
    EXPECT_EQ(designs("garment,design\na.json,print.png\nb.json,test\n", "lists/m.csv"),
              (std::vector<std::string>{"lists/print.png", "test"}));
}

TEST(Manifest, csv_has_a_column_per_key_or_option) {
    const std::vector<Job> jobs = parse_manifest(
        "garment,body,fabric,seconds,no-self-collision\ns.json,\"mannequin:bust=92,waist=70\",,9,true\nt.json,,silk,,"
        "\n",
        "m.csv");
    ASSERT_EQ(jobs.size(), 2U);
    EXPECT_EQ(dress_arguments(jobs[0]), (std::vector<std::string>{"s.json", "--body", "mannequin:bust=92,waist=70",
                                                                  "--seconds", "9", "--no-self-collision"}));
    EXPECT_EQ(dress_arguments(jobs[1]), (std::vector<std::string>{"t.json", "--fabric", "silk"}));
}

TEST(Manifest, a_spreadsheet_may_write_names_and_flags_in_its_own_way) {
    const std::vector<Job> jobs =
        parse_manifest("Garment; body ;no-self-collision\ns.json;mannequin;TRUE\nt.json; b.obj;FALSE\n", "m.csv");
    ASSERT_EQ(jobs.size(), 2U);
    EXPECT_EQ(dress_arguments(jobs[0]),
              (std::vector<std::string>{"s.json", "--body", "mannequin", "--no-self-collision"}));
    EXPECT_EQ(dress_arguments(jobs[1]), (std::vector<std::string>{"t.json", "--body", "b.obj"}));
    EXPECT_TRUE(jobs[1].options.at(0).is_off) << "which counts before --set";
}

TEST(Manifest, a_name_that_was_given_stays) {
    std::vector<Job> jobs = parse_manifest(
        R"({"jobs": [{"name": "vest", "garment": "x/vest.json"}, {"garment": "y/vest.json"}]})", "m.json");
    name_jobs(jobs);
    EXPECT_EQ(jobs[0].name, "vest");
    EXPECT_EQ(jobs[1].name.substr(0, 5), "vest-");
}

TEST(Manifest, a_product_is_every_garment_on_every_body_in_every_fabric) {
    const sim::TemporaryFolder folder;
    for (const char* name : {"a.json", "b.json", "c.obj"}) std::ofstream(folder / name) << "{}";
    std::ofstream(folder / "bodies.txt") << "# two\nmannequin:bust=88\r\nc.obj\n\n";
    std::vector<Job> jobs = jobs_of(
        {.garments = {"*.json"}, .bodies = {"bodies.txt", "mannequin"}, .fabrics = {"silk", "denim"}, .options = {}},
        folder / "");
    EXPECT_EQ(jobs.size(), 2U * 3U * 2U);
    name_jobs(jobs);
    EXPECT_TRUE(std::ranges::is_sorted(jobs, {}, &Job::name));
    EXPECT_EQ(jobs.front().name, "a_c_denim");
    EXPECT_EQ(jobs.back().name, "b_mannequin_silk");
    EXPECT_THROW(jobs_of({.garments = {"none*"}, .bodies = {}, .fabrics = {}, .options = {}}, folder / ""),
                 sim::InputError);
}

TEST(Manifest, only_what_is_written_in_it_is_a_pattern_of_names) {
    const sim::TemporaryFolder folder;
    const std::filesystem::path inner = folder / "a[1]*";
    std::filesystem::create_directories(inner / "mannequins");
    for (const char* name : {"one.json", "two[2].json", "mannequins/m.obj"}) std::ofstream(inner / name) << "{}";
    const auto jobs =
        jobs_of({.garments = {"*.json"}, .bodies = {"mannequins/*.obj"}, .fabrics = {}, .options = {}}, inner);
    ASSERT_EQ(jobs.size(), 2U);
    EXPECT_EQ(jobs[0].garment, inner / "one.json");
    EXPECT_EQ(jobs[0].body, (inner / "mannequins/m.obj").string());
    const auto named = jobs_of({.garments = {"two[2].json"}, .bodies = {}, .fabrics = {}, .options = {}}, inner);
    ASSERT_EQ(named.size(), 1U);
    EXPECT_EQ(named[0].garment, inner / "two[2].json");
}

TEST(Manifest, nothing_in_it_can_be_read_as_another_option) {
    EXPECT_EQ(dress_arguments(parse_manifest("garment,body\n--export=x.obj,-b.obj\n", "m.csv").at(0)),
              (std::vector<std::string>{"./--export=x.obj", "--body", "./-b.obj"}));
    for (const char* text : {"export=/x.obj", "Seconds", "-q", "", "seconds x"})
        EXPECT_THROW(parse_option(std::string(text) + "=1"), sim::InputError) << text;
    EXPECT_EQ(refusal(R"({"jobs": [{"garment": "x", "options": {"export=/x.obj": true}}]})", "m.json"),
              "m.json: jobs[0].options[\"export=/x.obj\"]: 'export=/x.obj' is no option of a job");
    EXPECT_EQ(refusal("garment,export=/x.obj\na,true\n", "m.csv"),
              "m.csv: line 2: 'export=/x.obj' is no option of a job");
    EXPECT_EQ(refusal("garment,no-self-collision\na,--export=x.obj\n", "m.csv"),
              "m.csv: line 2: '--export=x.obj' is no value of 'no-self-collision'");
    EXPECT_EQ(parse_option("camera=-30,10").value, "-30,10");
    for (const char* text : {"no-textures", "no-textures=true", "no-textures=TRUE"}) {
        EXPECT_EQ(parse_option(text).name, "no-textures") << text;
        EXPECT_TRUE(parse_option(text).is_flag) << text;
        EXPECT_FALSE(parse_option(text).is_off) << text;
    }
    EXPECT_TRUE(parse_option("no-textures=false").is_off);
}

TEST(Manifest, names_are_unique_and_safe_whatever_the_files_are_called) {
    std::vector<Job> jobs;
    for (const char* garment :
         {"one/shirt.json", "two/shirt.json", "a b.json", "a-b.json", "\u00c4rmel \u2013 1.json", "..json"})
        jobs.push_back({.name = {}, .garment = garment, .over = {}, .body = {}, .fabric = {}, .options = {}});
    jobs.push_back(
        {.name = {}, .garment = std::string(300, 'x') + ".json", .over = {}, .body = {}, .fabric = {}, .options = {}});
    name_jobs(jobs);
    for (const Job& job : jobs) EXPECT_TRUE(is_job_name(job.name)) << job.name;
    const std::vector<Job> first = jobs;
    std::ranges::reverse(jobs);
    for (Job& job : jobs) job.name.clear();
    name_jobs(jobs);
    EXPECT_EQ(jobs, first) << "whatever their order";
}

TEST(Manifest, says_what_is_wrong_and_where) {
    EXPECT_EQ(refusal("{", "m.json").substr(0, 7), "m.json:");
    EXPECT_EQ(refusal("{}", "m.json"), "m.json: neither jobs nor a product: nothing to do");
    EXPECT_EQ(refusal(R"({"jobs": [{"body": "x"}]})", "m.json"), "m.json: jobs[0]: no key 'garment'");
    EXPECT_EQ(refusal(R"({"jobs": [{"garment": "x", "fabrik": "y"}]})", "m.json"),
              "m.json: jobs[0].fabrik: unknown key");
    EXPECT_EQ(refusal(R"({"jobs": [{"garment": "x", "options": {"report": "y"}}]})", "m.json"),
              "m.json: jobs[0].options.report: 'report' is no option of a job");
    EXPECT_EQ(refusal(R"({"jobs": [{"garment": "x", "name": "../y"}]})", "m.json").substr(0, 22),
              "m.json: jobs[0].name: ");
    EXPECT_EQ(refusal(R"({"jobs": [{"garment": "x", "name": "y"}, {"garment": "z", "name": "y"}]})", "m.json"),
              "m.json: jobs[0]: job 'y': there are two of this name, the other is m.json: jobs[1]");
    EXPECT_EQ(refusal("body\nx\n", "m.csv"), "m.csv: line 1: there is no column 'garment'");
    EXPECT_EQ(refusal("garment\na,b\n", "m.csv"), "m.csv: line 2: has more fields than there are columns");
    EXPECT_EQ(refusal("garment,threads\na,2\n", "m.csv"), "m.csv: line 2: 'threads' is no option of a job");
}

TEST(Manifest, a_replay_command_survives_a_shell) {
    const Job job{.name = "x",
                  .garment = "it's a shirt.json",
                  .over = {},
                  .body = "mannequin:bust=92,waist=70",
                  .fabric = "$(x)",
                  .options = {{"seconds", "8", false}}};
    EXPECT_EQ(replay_command(job),
              "selvedge dress 'it'\\''s a shirt.json' --body mannequin:bust=92,waist=70 --fabric '$(x)' --seconds 8 "
              "--report report.json --render picture.png");
}

}  // namespace
}  // namespace selvedge::batch
