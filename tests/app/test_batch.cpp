// selvedge batch, as a black box: results for every job, with the bits of dress; resumed; the same for any workers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "render/image/image.h"
#include "sim/core/json.h"
#include "tests/app/selvedge_program.h"

namespace selvedge::app {
namespace {

// Three jobs: one that is dressed, one that is refused, one that does not settle.
std::string manifest_in(const ScratchFolder& folder) {
    const std::string vest = source_folder() + "/patterns/vest.json";
    std::ofstream(folder / "broken.json") << "{";
    std::ofstream(folder / "jobs.csv") << "name,garment,body,max-level,seconds\n"
                                       << "good," << vest << ",mannequin:resolution=1,0,\n"
                                       << "broken,broken.json,mannequin:resolution=1,0,\n"
                                       << "hasty," << vest << ",mannequin:resolution=1,0,0.05\n";
    return folder / "jobs.csv";
}

ProgramResult batch_into(const ScratchFolder& folder, const std::string& output, const std::string& options) {
    return run_selvedge("batch '" + manifest_in(folder) + "' -o '" + folder / output + "' --cache '" +
                        folder / "cache" + "' " + options);
}

TEST(BatchCommand, gives_each_job_a_report_a_picture_and_a_row) {
    const ScratchFolder folder;
    const ProgramResult run = batch_into(folder, "out", "--set size=96x128 --export glb");
    EXPECT_EQ(run.exit_code, 1) << run.err;
    EXPECT_NE(run.out.find("3 of 3 jobs done: 1 dressed, 0 do not fit, 1 with a defect, 1 refused, 0 failed"),
              std::string::npos)
        << run.out;
    EXPECT_EQ(render::read_png(folder / "out/jobs/good/picture.png").width_px, 96);
    EXPECT_TRUE(std::filesystem::exists(folder / "out/jobs/good/thumbnail.png"));
    EXPECT_EQ(content_of(folder / "out/jobs/good/garment.glb").substr(0, 4), "glTF");
    const std::string results = content_of(folder / "out/results.jsonl");
    EXPECT_EQ(count_lines(results), 3);
    const sim::Json first = sim::parse_json(results.substr(0, results.find('\n')), "results.jsonl");
    EXPECT_EQ(first.find("job")->string(), "broken");
    EXPECT_EQ(first.find("outcome")->string(), "refused");
    EXPECT_NE(first.find("problem")->string().find("broken.json"), std::string::npos);
    EXPECT_EQ(count_lines(content_of(folder / "out/results.csv")), 4);
    EXPECT_EQ(count_lines(content_of(folder / "out/times.csv")), 4);
    EXPECT_TRUE(std::filesystem::exists(folder / "out/index.html"));
}

TEST(BatchCommand, has_the_bits_of_dress_and_of_any_other_run_and_goes_on_where_it_stopped) {
    const ScratchFolder folder;
    batch_into(folder, "one", "--no-pictures --export ply --jobs 1");
    batch_into(folder, "two", "--no-pictures --export ply --jobs 2 --no-cache");
    batch_into(folder, "shards", "--no-pictures --export ply --shard 2/2");
    const ProgramResult early = batch_into(folder, "shards", "--no-pictures --export ply --merge");
    EXPECT_EQ(early.exit_code, 5);
    EXPECT_NE(early.err.find("2 of 3 jobs are not done"), std::string::npos) << early.err;
    batch_into(folder, "shards", "--no-pictures --export ply --shard 1/2");
    batch_into(folder, "shards", "--no-pictures --export ply --merge");
    for (const char* file : {"results.jsonl", "results.csv", "index.html", "jobs/good/garment.ply"}) {
        EXPECT_EQ(content_of(folder / ("one/" + std::string(file))), content_of(folder / ("two/" + std::string(file))));
        EXPECT_EQ(content_of(folder / ("one/" + std::string(file))),
                  content_of(folder / ("shards/" + std::string(file))));
    }
    const ProgramResult dressed =
        run_selvedge("dress " + shipped("vest.json") + " --body mannequin:resolution=1 --max-level 0 --export '" +
                     folder / "garment.ply" + "'");
    EXPECT_EQ(content_of(folder / "garment.ply"), content_of(folder / "one/jobs/good/garment.ply")) << dressed.err;
    const ProgramResult again = batch_into(folder, "one", "--no-pictures --export ply");
    EXPECT_NE(again.out.find("3 of them before"), std::string::npos) << again.out;
}

TEST(BatchCommand, compares_with_an_earlier_run) {
    const ScratchFolder folder;
    batch_into(folder, "old", "--set size=64x64 --set tartan=gordon");
    const ProgramResult compared = batch_into(folder, "new", "--set size=64x64 --compare '" + folder / "old" + "'");
    EXPECT_NE(compared.out.find("2 of 3 jobs changed since"), std::string::npos) << compared.out;
    EXPECT_TRUE(std::filesystem::exists(folder / "new/differences/good@difference.png"));
}

TEST(BatchCommand, a_body_that_cannot_be_made_refuses_its_jobs_only) {
    const ScratchFolder folder;
    std::ofstream(folder / "bodies.txt") << "mannequin:bust=7\nmannequin:resolution=1\n";
    const ProgramResult run =
        run_selvedge("batch --patterns " + shipped("vest.json") + " --bodies '" + folder / "bodies.txt" +
                     "' --set max-level=0 --no-pictures --no-cache -o '" + folder / "out" + "'");
    EXPECT_EQ(run.exit_code, 1) << run.err;
    EXPECT_NE(run.out.find("2 of 2 jobs done: 1 dressed, 0 do not fit, 0 with a defect, 1 refused, 0 failed"),
              std::string::npos)
        << run.out;
    const sim::Json report = sim::read_json(folder / "out/jobs/vest_mannequin-bust-7/report.json");
    EXPECT_NE(report.find("problem")->string().find("bust"), std::string::npos) << report.find("problem")->string();
    EXPECT_EQ(report.find("inputs")->elements().size(), 2U);
    EXPECT_EQ(report.find("options")->find("max_level")->number(), 0) << "the job's own";
}

TEST(BatchCommand, writes_over_nothing_that_it_reads) {
    const ScratchFolder folder;
    for (const char* manifest : {"results.csv", "times.csv"}) {
        std::ofstream(folder / manifest) << "garment\n" << source_folder() << "/patterns/vest.json\n";
        const ProgramResult run = run_selvedge("batch '" + folder / manifest + "' -o '" + folder.path().string() + "'");
        EXPECT_EQ(run.exit_code, 2) << run.out;
        EXPECT_NE(run.err.find("reads or writes it already"), std::string::npos) << run.err;
        EXPECT_EQ(content_of(folder / manifest).substr(0, 7), "garment");
    }
    std::filesystem::create_directories(folder / "jobs/mine");
    std::filesystem::copy_file(source_folder() + "/patterns/vest.json", folder / "jobs/mine/vest.json");
    const ProgramResult run =
        run_selvedge("batch --patterns '" + folder / "jobs/mine/vest.json" + "' -o '" + folder.path().string() + "'");
    EXPECT_EQ(run.exit_code, 2) << run.out;
    EXPECT_NE(run.err.find("is in a folder of the output"), std::string::npos) << run.err;
}

TEST(BatchCommand, a_flag_that_a_job_sets_to_false_stays_off) {
    const ScratchFolder folder;
    std::ofstream(folder / "broken.json") << "{";
    std::ofstream(folder / "jobs.json")
        << R"({"jobs": [{"name": "off", "garment": "broken.json", "options": {"no-self-collision": false}},
                        {"name": "on", "garment": "broken.json"}]})";
    run_selvedge("batch '" + folder / "jobs.json" + "' -o '" + folder / "out" +
                 "' --no-pictures --no-cache --set no-self-collision");
    const std::string rows = content_of(folder / "out/results.jsonl");
    const sim::Json off = sim::parse_json(rows.substr(0, rows.find('\n')), "off");
    const sim::Json on = sim::parse_json(rows.substr(rows.find('\n') + 1), "on");
    EXPECT_EQ(off.find("job_options")->find("no-self-collision"), nullptr);
    EXPECT_TRUE(on.find("job_options")->find("no-self-collision")->boolean());
}

TEST(BatchCommand, refuses_what_is_wrong_before_it_begins) {
    const ScratchFolder folder;
    const auto refusal = [&](const std::string& arguments) {
        const ProgramResult run = run_selvedge("batch " + arguments);
        EXPECT_EQ(run.exit_code, 2) << run.out;
        EXPECT_EQ(count_lines(run.err), 1) << run.err;
        return run.err;
    };
    const std::string manifest = "'" + manifest_in(folder) + "'";
    const std::string output = " -o '" + folder / "out" + "'";
    EXPECT_NE(refusal(manifest + output + " --set seconds=many").find("seconds"), std::string::npos);
    EXPECT_NE(refusal(manifest + output + " --set report=x").find("'report' is no option of a job"), std::string::npos);
    EXPECT_NE(refusal(manifest + output + " --set seconds=4 --set seconds=5").find("'seconds' is set twice"),
              std::string::npos);
    EXPECT_NE(refusal(manifest + output + " --shard 3/2").find("--shard"), std::string::npos);
    EXPECT_NE(refusal(manifest + output + " --compare '" + folder / "none" + "'").find("--compare"), std::string::npos);
    EXPECT_NE(refusal(output).find("name a manifest"), std::string::npos);
    EXPECT_NE(refusal("'" + folder / "none.json" + "'" + output).find("none.json"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

// Two jobs that are refused, which takes no time.
std::string broken_jobs_in(const ScratchFolder& folder) {
    std::ofstream(folder / "broken.json") << "{";
    std::ofstream(folder / "broken_jobs.json") << R"({"options": {"seconds": 8, "max-level": 1},
               "jobs": [{"name": "own", "garment": "broken.json", "options": {"seconds": 2}},
                        {"name": "plain", "garment": "broken.json"}]})";
    return folder / "broken_jobs.json";
}

TEST(BatchCommand, an_option_of_a_job_counts_before_set_and_that_before_the_manifest_s) {
    const ScratchFolder folder;
    const ProgramResult run = run_selvedge("batch '" + broken_jobs_in(folder) + "' -o '" + folder / "out" +
                                           "' --no-pictures --no-cache --set seconds=4");
    EXPECT_EQ(run.exit_code, 1) << run.err;
    const std::string results = content_of(folder / "out/results.jsonl");
    EXPECT_NE(results.find(R"("job_options":{"max-level":"1","seconds":"2"})"), std::string::npos) << results;
    EXPECT_NE(results.find(R"("job_options":{"max-level":"1","seconds":"4"})"), std::string::npos) << results;
}

TEST(BatchCommand, goes_on_without_a_cache_that_nobody_asked_for) {
    const ScratchFolder folder;
    std::ofstream(folder / "file") << "no folder";
    const std::string command = "env -u XDG_CACHE_HOME HOME='" + folder / "file" + "' '" + program_folder() +
                                "/selvedge' batch '" + broken_jobs_in(folder) + "' -o '" + folder / "out" +
                                "' --no-pictures";
    const ProgramResult run = run_command(command);
    EXPECT_EQ(run.exit_code, 1) << run.err;
    EXPECT_NE(run.err.find("warning: no cache for bodies: "), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("2 of 2"), std::string::npos) << "the last line of the progress: " << run.err;
    EXPECT_EQ(run_command(command + " --cache '" + folder / "file/cache" + "'").exit_code, 2);
}

TEST(BatchCommand, merging_on_a_cluster_fails_while_jobs_are_missing) {
    const ScratchFolder folder;
    const std::string shard = "batch '" + broken_jobs_in(folder) + "' --no-cache -o '" + folder / "out" + "' --shard ";
    const std::string merge = "SELVEDGE='" + program_folder() + "/selvedge' MANIFEST='" + folder / "broken_jobs.json" +
                              "' OUTPUT='" + folder / "out" + "' bash '" + source_folder() +
                              "/scripts/slurm/merge.sbatch'";
    EXPECT_EQ(run_selvedge(shard + "1/2").exit_code, 1);
    const ProgramResult early = run_command(merge);
    EXPECT_EQ(early.exit_code, 5);
    EXPECT_NE(early.err.find("1 of 2 jobs are not done"), std::string::npos) << early.err;
    EXPECT_EQ(run_selvedge(shard + "2/2").exit_code, 1);
    EXPECT_EQ(run_command(merge).exit_code, 0);
    std::ofstream(folder / "broken.json") << "{}";
    EXPECT_EQ(run_command(merge).exit_code, 5) << "the garment is another one";
}

}  // namespace
}  // namespace selvedge::app
