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
        "a,b\r\n\"x, \"\"y\"\"\",\"two\nlines\"\n\n,last",
        "t.csv");
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].fields, (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(rows[1].fields, (std::vector<std::string>{"x, \"y\"", "two\nlines"}));
    EXPECT_EQ(rows[2].fields, (std::vector<std::string>{"", "last"}));
    EXPECT_EQ(rows[2].line, 5U);
    EXPECT_THROW(parse_csv("a\n\"open", "t.csv"), sim::InputError);
    EXPECT_THROW(parse_csv("\"a\"b", "t.csv"), sim::InputError);
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

TEST(Manifest, names_are_unique_and_safe_whatever_the_files_are_called) {
    std::vector<Job> jobs;
    for (const char* garment : {"one/shirt.json", "two/shirt.json", "\u00c4rmel \u2013 1.json", "..json"})
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
              "job 'y': there are two of this name");
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
