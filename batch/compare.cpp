#include "batch/compare.h"

#include <optional>
#include <system_error>

#include "batch/job_folder.h"
#include "render/image/image.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/file_path.h"
#include "sim/inspection/report.h"

namespace selvedge::batch {
namespace {

using Path = std::filesystem::path;

// None if there is none, or it is broken.
std::optional<render::Image> picture_in(const Path& folder) {
    if (!sim::file_exists(folder / job_file::kPicture)) return std::nullopt;
    try {
        return render::read_png(folder / job_file::kPicture);
    } catch (const sim::InputError&) {
        return std::nullopt;
    }
}

void compare_pictures(const Path& now, const Path& before, const Path& differences, JobChange& change) {
    const std::optional<render::Image> new_picture = picture_in(now), old_picture = picture_in(before);
    if (!new_picture || !old_picture) return;
    const render::Comparison comparison = compare(*old_picture, *new_picture);
    if (is_alike(comparison)) return;
    change.has_new_picture = true;
    change.differing_share =
        comparison.has_same_size ? static_cast<double>(comparison.beyond) / static_cast<double>(comparison.pixels) : 1;
    std::error_code error;
    std::filesystem::create_directories(differences, error);
    if (error) throw sim::InputError(differences.string(), "", "cannot be made: " + error.message());
    // No job has an '@' in its name.
    write_png(differences / (change.job + "@before.png"), *old_picture);
    write_png(differences / (change.job + "@difference.png"), difference_picture(*old_picture, *new_picture));
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
        compare_pictures(job_folder(output, change.job), folder, output / "differences", change);
        if (progress) progress(static_cast<double>(changes.size()) / static_cast<double>(rows.size()));
    }
    return changes;
}

}  // namespace selvedge::batch
