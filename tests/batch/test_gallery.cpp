// The gallery carries what its rows hold and no text that could act as code; comparison finds what changed.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "batch/compare.h"
#include "batch/gallery.h"
#include "batch/job_folder.h"
#include "batch/results.h"
#include "batch/thumbnail.h"
#include "render/image/image.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/inspection/report.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::batch {
namespace {

using Path = std::filesystem::path;

struct Finished {
    std::string name;
    render::Rgba8 colour{200, 10, 10, 255};
    bool has_fault = false;
};

void finish(const Path& output, const Finished& job) {
    UnfinishedJob folder(output, job.name);
    sim::DressReport report;
    if (job.has_fault) report.faults = {{"self_crossing", "</script><b>", 0.1}};
    sim::write_file_atomically(folder.file(job_file::kReport), write_json(json_without_times(report)));
    write_png(folder.file(job_file::kPicture), render::Image(8, 8, job.colour));
    folder.finish({.key = "k", .exit_code = exit_code_of(outcome_of(report))});
}

std::string key_of(const Job&) {
    return "k";
}

Job job_called(const std::string& name) {
    return {.name = name, .garment = name + ".json", .over = {}, .body = {}, .fabric = {}, .options = {}};
}

TEST(Gallery, holds_rows_as_data_that_cannot_end_its_script) {
    const sim::TemporaryFolder folder;
    finish(folder / "out", {.name = "a", .has_fault = true});
    const Results results = gather_results({job_called("a")}, folder / "out", key_of);
    const std::string page = gallery_html(results.rows, {});
    EXPECT_EQ(page.find("</script><b>"), std::string::npos);
    EXPECT_NE(page.find("\\u003c/script>\\u003cb>"), std::string::npos);
    const std::size_t first = page.find("application/json\">") + 18;
    const sim::Json rows = sim::parse_json(page.substr(first, page.find("</script>", first) - first), "rows");
    EXPECT_EQ(rows.elements().at(0).find("outcome")->string(), "defect");
    EXPECT_TRUE(rows.elements().at(0).find("picture")->boolean());
    EXPECT_EQ(page.find("http://"), std::string::npos) << "it needs no network";
    EXPECT_EQ(page.find("https://"), std::string::npos);
}

TEST(Results, name_the_cause_of_the_fault_that_makes_the_outcome) {
    const sim::TemporaryFolder folder;
    UnfinishedJob job(folder / "out", "a");
    sim::DressReport report;
    report.faults = {{"does_not_fit", "too small at the waist by 3.2 cm", 0.032}, {"self_crossing", "it", 0.1}};
    sim::write_file_atomically(job.file(job_file::kReport), write_json(json_without_times(report)));
    job.finish({.key = "k", .exit_code = exit_code_of(outcome_of(report))});
    const Results results = gather_results({job_called("a")}, folder / "out", key_of);
    EXPECT_EQ(results.rows.front().find("outcome")->string(), "defect");
    EXPECT_NE(first_cause(results.rows.front()).find("crossing itself"), std::string::npos);
}

TEST(CompareRuns, finds_new_jobs_new_outcomes_and_new_pictures) {
    const sim::TemporaryFolder folder;
    finish(folder / "old", {.name = "same"});
    finish(folder / "old", {.name = "fault"});
    finish(folder / "old", {.name = "picture"});
    finish(folder / "out", {.name = "same"});
    finish(folder / "out", {.name = "fault", .has_fault = true});
    finish(folder / "out", {.name = "picture", .colour = {10, 200, 10, 255}});
    finish(folder / "out", {.name = "added"});
    const Results results = gather_results(
        {job_called("added"), job_called("fault"), job_called("picture"), job_called("same")}, folder / "out", key_of);
    const std::vector<JobChange> changes = compare_runs(results.rows, folder / "out", folder / "old");
    ASSERT_EQ(changes.size(), 4U);
    EXPECT_TRUE(changes[0].is_new);
    EXPECT_TRUE(changes[1].has_new_outcome && !changes[1].has_new_picture);
    EXPECT_EQ(changes[1].outcome_before, "dressed");
    EXPECT_TRUE(changes[2].has_new_picture);
    EXPECT_EQ(changes[2].differing_share, 1);
    EXPECT_TRUE(std::filesystem::exists(folder / "out/differences/picture@difference.png"));
    EXPECT_TRUE(std::filesystem::exists(folder / "out/differences/picture@before.png"));
    EXPECT_FALSE(changes[3].is_changed());
    EXPECT_NE(gallery_html(results.rows, changes).find("\"has_new_picture\":true"), std::string::npos);
    EXPECT_THROW(compare_runs(results.rows, folder / "out", folder / "none"), sim::InputError);
    EXPECT_THROW(compare_runs(results.rows, folder / "out", folder / "out"), sim::InputError);
}

// How a job compares with an earlier run, in whose folder this file is broken.
JobChange change_since_broken(std::string_view file, std::string_view content) {
    const sim::TemporaryFolder folder;
    for (const char* run : {"old", "out"}) finish(folder / run, {.name = "job"});
    sim::write_file_atomically(job_folder(folder / "old", "job") / file, content);
    const Results results = gather_results({job_called("job")}, folder / "out", key_of);
    return compare_runs(results.rows, folder / "out", folder / "old").front();
}

TEST(CompareRuns, a_picture_that_is_broken_is_not_compared) {
    EXPECT_FALSE(change_since_broken(job_file::kPicture, "\x89PNG").has_new_picture);
}

TEST(CompareRuns, a_job_whose_earlier_report_is_broken_is_new) {
    EXPECT_TRUE(change_since_broken(job_file::kReport, "{\"outcome\": ").is_new);
}

TEST(Thumbnail, is_the_mean_of_what_it_covers) {
    render::Image image(4, 2, {0, 0, 0, 255});
    image.at(0, 0) = {200, 0, 0, 255};
    image.at(3, 1) = {0, 100, 0, 255};
    const render::Image small = shrunk(image, 2);
    EXPECT_EQ(small.width_px, 2);
    EXPECT_EQ(small.height_px, 1);
    EXPECT_EQ(small.at(0, 0), (render::Rgba8{50, 0, 0, 255}));
    EXPECT_EQ(small.at(1, 0), (render::Rgba8{0, 25, 0, 255}));
    EXPECT_EQ(shrunk(image, 4), image);
}

}  // namespace
}  // namespace selvedge::batch
