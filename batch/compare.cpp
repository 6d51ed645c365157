#include "batch/compare.h"

#include <optional>
#include <system_error>

#include "batch/job_folder.h"
#include "render/image/image.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/file_path.h"
#include "sim/dress/report.h"

namespace selvedge::batch {
namespace {

using Path = std::filesystem::path;

void compare_pictures(const Path& now, const Path& before, const Path& differences, JobChange& change) {
    if (!sim::file_exists(now) || !sim::file_exists(before)) return;
    const render::Image new_picture = render::read_png(now), old_picture = render::read_png(before);
    const render::Comparison comparison = compare(old_picture, new_picture);
    if (is_alike(comparison)) return;
    change.has_new_picture = true;
    change.differing_share =
        comparison.has_same_size ? static_cast<double>(comparison.beyond) / static_cast<double>(comparison.pixels) : 1;
    std::error_code error;
    std::filesystem::create_directories(differences, error);
    if (error) throw sim::InputError(differences.string(), "", "cannot be made: " + error.message());
    write_png(differences / (change.job + ".before.png"), old_picture);
    write_png(differences / (change.job + ".png"), difference_picture(old_picture, new_picture));
}

}  // namespace

void check_earlier_run(const Path& before, const Path& output) {
    if (!sim::is_folder(before / "jobs"))
        throw sim::InputError(before.string(), "--compare", "is not the output of a batch");
    std::error_code error;
    if (std::filesystem::equivalent(before, output, error))
        throw sim::InputError(before.string(), "--compare", "is the output of this batch: there is no earlier run");
}

std::vector<JobChange> compare_runs(const std::vector<sim::Json>& rows, const Path& output, const Path& before,
                                    const std::function<void(double fraction)>& progress) {
    check_earlier_run(before, output);
    std::error_code error;
    std::filesystem::remove_all(output / "differences", error);
    std::vector<JobChange> changes;
    for (const sim::Json& row : rows) {
        JobChange& change = changes.emplace_back();
        change.job = row.find("job")->string();
        const Path folder = job_folder(before, change.job);
        const std::optional<sim::Json> report = read_report(folder);
        change.is_new = !report;
        if (report) change.outcome_before = outcome_in(*report);
        change.has_new_outcome = report && change.outcome_before != outcome_in(row);
        compare_pictures(job_folder(output, change.job) / job_file::kPicture, folder / job_file::kPicture,
                         output / "differences", change);
        if (progress) progress(static_cast<double>(changes.size()) / static_cast<double>(rows.size()));
    }
    return changes;
}

}  // namespace selvedge::batch
