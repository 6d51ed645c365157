// selvedge batch MANIFEST -o DIR: dresses many garments on many bodies, and shows what came of them in a gallery.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "app/arguments.h"
#include "app/batch_progress.h"
#include "app/commands.h"
#include "app/dress_command.h"
#include "app/job_key.h"
#include "app/option_texts.h"
#include "app/stop_signal.h"
#include "batch/compare.h"
#include "batch/gallery.h"
#include "batch/job_folder.h"
#include "batch/manifest.h"
#include "batch/results.h"
#include "batch/run.h"
#include "batch/thumbnail.h"
#include "render/image/image.h"
#include "sim/core/content_store.h"
#include "sim/core/error.h"
#include "sim/core/file_path.h"
#include "sim/core/json.h"
#include "sim/core/printable.h"
#include "sim/core/trimmed.h"
#include "sim/pattern/fabric_file.h"

namespace selvedge::app {
namespace {

using Path = std::filesystem::path;

constexpr int kThumbnailSide = 320;     // px
constexpr int kNotAllDone = 5;          // exit code
constexpr double kUsualCacheMb = 4096;  // of bodies and their fields: some 300 of them

// About what a gallery shows at once, of the garment rather than the body.
const std::array<batch::JobOption, 2> kUsualLook{{{"size", "480x640", false}, {"frame", "garment", false}}};

struct BatchArguments {
    Path manifest;
    batch::Product product;
    std::vector<std::string> options;  // --set
    batch::BatchOptions batch;
    std::string shard;
    bool has_pictures = true;
    std::vector<std::string> exports;  // extensions
    Path compared;                     // an earlier output; empty: none
    Path cache;                        // empty: the user's
    bool has_cache = true;
    double cache_mb = kUsualCacheMb;
    bool only_merges = false;
    bool is_quiet = false;
};

// The folder in which programs keep for this user what can be made again; empty if there is no home folder.
Path usual_cache_folder() {
    const auto folder = [](const char* variable) -> Path {
        const char* value = std::getenv(variable);
        return value == nullptr ? Path() : Path(value);
    };
    if (const Path cache = folder("XDG_CACHE_HOME"); cache.is_absolute()) return cache / "selvedge";
    if (const Path home = folder("HOME"); home.is_absolute()) return home / ".cache/selvedge";
    return {};
}

// Adds what a job does not say of its picture.
void add_usual_look(batch::Job& job) {
    for (const batch::JobOption& usual : kUsualLook) {
        if (!has_option(job.options, usual.name)) job.options.push_back(usual);
    }
}

// Those of --set.
std::vector<batch::JobOption> options_for_all(const BatchArguments& arguments) {
    std::vector<batch::JobOption> options;
    for (const std::string& text : arguments.options) {
        const batch::JobOption option = batch::parse_option(text);
        if (has_option(options, option.name)) throw sim::InputError("", "--set", "'" + option.name + "' is set twice");
        options.push_back(option);
    }
    return options;
}

// The items of a list that was written with blanks: 'silk, denim'.
std::vector<std::string> without_blanks(std::vector<std::string> items) {
    for (std::string& item : items) item = std::string(sim::trimmed(item));
    std::erase(items, "");
    return items;
}

// Of an option, a job's own value counts before that of --set, and this before the manifest's for all jobs.
std::vector<batch::Job> jobs_of(const BatchArguments& arguments) {
    const std::vector<batch::JobOption> options = options_for_all(arguments);
    const bool has_product = !arguments.product.garments.empty();
    batch::Product product = arguments.product;
    product.fabrics = without_blanks(product.fabrics);
    if (arguments.manifest.empty() != has_product)
        throw sim::InputError("", "", "name a manifest, or --patterns with --bodies and --fabrics");
    std::vector<batch::Job> jobs = has_product ? jobs_of(product, "") : batch::read_manifest(arguments.manifest);
    for (batch::Job& job : jobs) {
        std::erase_if(job.options,
                      [&](const batch::JobOption& one) { return one.is_common && has_option(options, one.name); });
    }
    name_jobs(jobs);  // what all have in common is not in their names
    for (batch::Job& job : jobs) {
        for (const batch::JobOption& option : options) {
            if (!has_option(job.options, option.name)) job.options.push_back(option);
        }
        std::erase_if(job.options, &batch::JobOption::is_off);
        if (arguments.has_pictures) add_usual_look(job);
    }
    return jobs;
}

// The manifest and what the jobs read must not be among the files that the batch writes or replaces. Throws InputError.
void check_files(const BatchArguments& arguments, const std::vector<batch::Job>& jobs) {
    const Path& output = arguments.batch.output;
    std::set<Path> inputs{arguments.manifest};
    for (const batch::Job& job : jobs) {
        inputs.insert(job.garment);
        inputs.insert(job.over.begin(), job.over.end());
        if (sim::is_body_file(job.body)) inputs.insert(job.body);
        if (sim::is_fabric_file(job.fabric)) inputs.insert(job.fabric);
    }
    inputs.erase(Path());
    check_distinct(batch::result_files(output), {inputs.begin(), inputs.end()});
    const Path folders = sim::canonical_path(output / "jobs");
    for (const Path& input : inputs) {
        const Path relative = sim::canonical_path(input).lexically_relative(folders);
        if (!relative.empty() && *relative.begin() != "..")
            throw sim::InputError(input.string(), "", "is in a folder of the output, which is replaced");
    }
}

// As the command dress reads them, but for the body, which is not read here: measurements that make none refuse the
// job, as a garment does that cannot be read.
DressArguments parse_dress(const batch::Job& job) {
    batch::Job without_body = job;
    without_body.body.clear();
    DressArguments dress = read_dress_options(dress_arguments(without_body));
    dress.body.source = job.body;
    return dress;
}

// Finds wrong options before the work begins. Jobs differ mostly in their garments and bodies; what is wrong there
// refuses these jobs only. Throws InputError that names the job.
void check_options(const std::vector<batch::Job>& jobs) {
    std::set<std::string> seen;
    for (const batch::Job& job : jobs) {
        std::string text;
        for (const batch::JobOption& option : job.options) text += option.name + '\0' + option.value + '\0';
        if (!seen.insert(text).second) continue;
        try {
            parse_dress(job);
        } catch (const sim::InputError& error) {
            throw sim::InputError(job.origin, "job '" + job.name + "'", error.what());
        }
    }
}

int dress_job(const BatchArguments& arguments, const batch::Job& job, const Path& folder, const KnownBodies& known) {
    DressArguments dress = parse_dress(job);
    dress.garment.threads = 1;
    dress.garment.is_quiet = true;
    dress.report_file = folder / batch::job_file::kReport;
    dress.times_file = folder / batch::job_file::kTimes;
    if (arguments.has_pictures) dress.picture_file = folder / batch::job_file::kPicture;
    for (const std::string& extension : arguments.exports)
        dress.exports.files.push_back(folder / ("garment." + extension));
    const int code = run_dress(dress, known);
    if (sim::file_exists(dress.picture_file))
        write_png(folder / batch::job_file::kThumbnail,
                  batch::shrunk(render::read_png(dress.picture_file), kThumbnailSide));
    return code;
}

// What garments name themselves is not known here.
void prepare_last_body(const batch::Job& job, LastBody& last_body) {
    const BodyOptions body = parse_dress(job).body;
    if (!body.source.empty()) last_body.prepare(body);
}

// None if nobody asked for one and the user's cannot be made.
std::optional<sim::ContentStore> open_store(const BatchArguments& arguments, const std::string& program) {
    if (!arguments.has_cache) return std::nullopt;
    const Path folder = arguments.cache.empty() ? usual_cache_folder() : arguments.cache;
    if (folder.empty()) return std::nullopt;
    try {
        return sim::ContentStore(folder, program, static_cast<std::uint64_t>(arguments.cache_mb * 1e6));
    } catch (const sim::InputError& error) {
        if (!arguments.cache.empty()) throw;
        std::fprintf(stderr, "selvedge: warning: no cache for bodies: %s\n", error.what());
        return std::nullopt;
    }
}

void print_counts(const batch::BatchCounts& counts) {
    std::printf("%zu of %zu jobs done", counts.skipped + counts.done, counts.jobs);
    if (counts.skipped > 0) std::printf(", %zu of them before", counts.skipped);
    std::printf(": %zu dressed, %zu do not fit, %zu with a defect, %zu refused, %zu failed\n", counts.dressed,
                counts.does_not_fit, counts.defects, counts.refused, counts.failed);
}

// Why the first few jobs failed, and the commands that do them again.
void print_replays(const std::vector<sim::Json>& rows) {
    constexpr std::size_t kMost = 5;
    std::size_t count = 0;
    for (const sim::Json& row : rows) {
        const std::string& outcome = row.find("outcome")->string();
        if (outcome == "dressed" || outcome == "does_not_fit") continue;
        if (++count > kMost) continue;
        constexpr std::size_t kLongest = 10'000;  // characters: a command that is cut is of no use
        std::printf("%s: %s\n  %s\n", sim::printable(outcome).c_str(), sim::printable(batch::first_cause(row)).c_str(),
                    sim::printable(row.find("replay")->string(), kLongest).c_str());
    }
    if (count > kMost) std::printf("and %zu more: see results.jsonl\n", count - kMost);
}

// The folders of jobs that are not in this list: another list of jobs made them.
std::size_t count_others(const std::vector<batch::Job>& jobs, const Path& output) {
    std::set<std::string> own;
    for (const batch::Job& job : jobs) own.insert(job.name);
    std::error_code error;
    const std::vector<Path> folders = sim::entries_of(output / "jobs", error);
    return std::size_t(std::ranges::count_if(folders, [&](const Path& folder) {
        const std::string name = folder.filename().string();
        return batch::is_job_name(name) && !own.contains(name);
    }));
}

void write_all(const BatchArguments& arguments, const std::vector<batch::Job>& jobs, const batch::Results& results) {
    const Path& output = arguments.batch.output;
    write_results(results, output);
    std::vector<batch::JobChange> changes;
    if (!arguments.compared.empty()) {
        ProgressBar bar(progress_bar_options(arguments.is_quiet));
        changes = batch::compare_runs(results.rows, output, arguments.compared,
                                      [&](double fraction) { bar.show("comparing", fraction); });
    }
    write_gallery(results.rows, changes, output);
    if (arguments.is_quiet) return;
    print_replays(results.rows);
    if (!changes.empty()) {
        const auto changed = std::ranges::count_if(changes, &batch::JobChange::is_changed);
        std::printf("%td of %zu jobs changed since %s\n", changed, changes.size(),
                    sim::printable(arguments.compared.string()).c_str());
    }
    if (const std::size_t others = count_others(jobs, output); others > 0)
        std::printf("note: %s also holds %zu jobs that are not in this list, and not in its tables\n",
                    sim::printable(output.string()).c_str(), others);
    std::printf("wrote %s, with results.jsonl, results.csv and times.csv beside it\n",
                sim::printable((output / "index.html").string()).c_str());
}

bool is_sound(const std::vector<sim::Json>& rows) {
    return std::ranges::all_of(rows, [](const sim::Json& row) { return row.find("outcome")->string() == "dressed"; });
}

// Gathers what is done.
batch::Results gather(const BatchArguments& arguments, const std::vector<batch::Job>& jobs, JobKeys& keys) {
    batch::Results results =
        gather_results(jobs, arguments.batch.output, [&](const batch::Job& job) { return keys(job); });
    write_all(arguments, jobs, results);
    return results;
}

// The same; returns the exit code.
int merge(const BatchArguments& arguments, const std::vector<batch::Job>& jobs, JobKeys& keys) {
    const batch::Results results = gather(arguments, jobs, keys);
    if (results.missing.empty()) return is_sound(results.rows) ? 0 : 1;
    std::fprintf(stderr, "selvedge: %zu of %zu jobs are not done with these inputs, options and program: '%s'%s\n",
                 results.missing.size(), jobs.size(), sim::printable(results.missing.front()).c_str(),
                 results.missing.size() > 1 ? " and others" : "");
    return kNotAllDone;
}

// The exit code when all jobs of the run have ended. The results of a shard wait for those of the others.
int conclude(const BatchArguments& arguments, const std::vector<batch::Job>& jobs, JobKeys& keys,
             const batch::BatchCounts& counts) {
    int code = counts.dressed == counts.jobs ? 0 : 1;
    if (arguments.batch.shard.count == 1) {
        code = merge(arguments, jobs, keys);
    } else if (!arguments.is_quiet) {
        std::printf("when all shards are done: selvedge batch ... --merge\n");
    }
    if (counts.unrecorded == 0) return code;
    std::fprintf(stderr, "selvedge: %zu jobs left no result: %s\n", counts.unrecorded, counts.problem.c_str());
    return kNotAllDone;
}

int run(BatchArguments arguments) {
    if (arguments.batch.output.empty()) throw sim::InputError("", "--output", "names no folder");
    if (!arguments.shard.empty()) arguments.batch.shard = batch::parse_shard(arguments.shard);
    if (!arguments.compared.empty()) batch::check_earlier_run(arguments.compared, arguments.batch.output);
    const std::vector<batch::Job> jobs = jobs_of(arguments);
    check_options(jobs);
    check_files(arguments, jobs);
    JobKeys keys(JobOutputs{.has_pictures = arguments.has_pictures, .exports = arguments.exports});
    if (arguments.only_merges) return merge(arguments, jobs, keys);

    const std::optional<sim::ContentStore> store = open_store(arguments, keys.program());
    LastBody last_body(store ? &*store : nullptr);
    const StopSignal stop;
    BatchProgress progress(progress_bar_options(arguments.is_quiet));
    const batch::BatchCounts counts = run_batch(
        jobs, arguments.batch,
        {.key = [&](const batch::Job& job) { return keys(job); },
         .prepare = [&](const batch::Job& job) { prepare_last_body(job, last_body); },
         .dress =
             [&](const batch::Job& job, const Path& folder) {
                 return dress_job(arguments, job, folder, {.store = store ? &*store : nullptr, .ready = &last_body});
             },
         .have_inputs_changed = [&](const batch::Job& job,
                                    const sim::Json& report) { return keys.have_changed(job, report); },
         .progress = [&](const batch::BatchCounts& now) { progress.show(now); },
         .is_stopped = [&] { return stop.is_raised(); }});
    progress.finish();
    if (!arguments.is_quiet) print_counts(counts);
    if (!stop.is_raised()) return conclude(arguments, jobs, keys, counts);
    if (arguments.batch.shard.count == 1) gather(arguments, jobs, keys);
    std::fprintf(stderr, "selvedge: stopped; the same command goes on from here\n");
    return stop.exit_code();
}

void add_job_options(Command& command, BatchArguments& arguments) {
    add_option(command, "MANIFEST", arguments.manifest, "List of jobs, JSON or CSV (docs/batch.md)", {.type = "FILE"});
    const auto add = [&](const char* name, std::vector<std::string>& values, const char* help, const char* type,
                         char delimiter = 0) {
        add_option(command, name, values, help,
                   {.type = type, .group = "Jobs", .takes_one_value = true, .delimiter = delimiter});
    };
    add("--patterns", arguments.product.garments,
        "Instead of a manifest: garment files, such as 'patterns/*.json'; may "
        "be repeated",
        "GLOB");
    add("--bodies", arguments.product.bodies,
        "Bodies for each of them: mannequin:..., files, or a .txt file with one a line; may be repeated", "GLOB|LIST");
    add("--fabrics", arguments.product.fabrics, "Fabrics for each of them, with commas between", "LIST", ',');
    add("--set", arguments.options,
        "An option of dress for all jobs, such as seconds=8 or no-self-collision; may be "
        "repeated",
        "NAME=VALUE");
}

void add_output_options(Command& command, BatchArguments& arguments) {
    add_option(command, "-o,--output", arguments.batch.output, "Folder for the results; made if it is not there",
               {.type = "DIR", .is_required = true});
    add_flag(command, "--no-pictures{false}", arguments.has_pictures, "No pictures, which is faster");
    add_option(command, "--export", arguments.exports, "Each garment as obj, glb, ply or stl; may be repeated",
               {.type = "FORMAT", .takes_one_value = true, .one_of = {"obj", "glb", "ply", "stl"}});
    add_option(command, "--compare", arguments.compared, "The output of an earlier run: the gallery shows what changed",
               {.type = "DIR"});
}

void add_worker_options(Command& command, BatchArguments& arguments) {
    batch::BatchOptions& options = arguments.batch;
    options.workers = int(std::max(1U, std::thread::hardware_concurrency()));
    add_number<int>(command, "-j,--jobs", {1, 1024}, "Jobs at a time (default: one per CPU core)", {.type = "N"},
                    [&](int jobs) { options.workers = jobs; });
    add_number<double>(command, "--time-limit", {1, 86400}, "Longest time for one job, s (default 300)", {.type = "S"},
                       [&](double seconds) { options.limits.seconds = seconds; });
    add_number<double>(command, "--memory-limit", {64, 1e6}, "Most memory for one job, MB (default 4000)",
                       {.type = "MB"},
                       [&](double megabytes) { options.limits.memory_bytes = std::size_t(megabytes * 1e6); });
    add_option(command, "--cache", arguments.cache, "Folder that keeps bodies and their fields (default: the user's)",
               {.type = "DIR"});
    add_number<double>(command, "--cache-size", {50, 1e7}, "Most that it keeps, MB (default 4096)", {.type = "MB"},
                       [&](double megabytes) { arguments.cache_mb = megabytes; });
    add_flag(command, "--no-cache{false}", arguments.has_cache, "Keep no bodies");
    add_option(command, "--shard", arguments.shard, "Only the jobs I, I + N, I + 2 N, ... of the list",
               {.type = "I/N"});
    add_flag(command, "--merge", arguments.only_merges, "Do no jobs: gather the results of all shards");
    add_flag(command, "--again", options.does_all_again, "Do also what was done before with the same inputs");
    add_flag(command, "-q,--quiet", arguments.is_quiet, "Show no progress and no summary");
}

}  // namespace

void add_batch_command(Command& app, int& exit_code) {
    auto arguments = std::make_shared<BatchArguments>();
    Command& command = add_command(app, "batch", "Dress many garments on many bodies");
    add_job_options(command, *arguments);
    add_output_options(command, *arguments);
    add_worker_options(command, *arguments);
    set_footer(
        command,
        "What was done before with the same inputs, options and program is not done again, so a batch that was "
        "stopped\n"
        "goes on. Ctrl+C lets the jobs that run end; twice stops at once.\n"
        "Exit code: 0 all dressed without a fault, 1 not all, 2 wrong input, 5 not all done, 130 stopped.\n"
        "Examples:\n"
        "  selvedge batch jobs.csv -o out\n"
        "  selvedge batch --patterns 'patterns/*.json' --bodies mannequin:bust=88 --bodies mannequin:bust=104 \\\n"
        "      --fabrics cotton_shirting,denim -o out --export glb\n"
        "  selvedge batch jobs.json -o new --compare old\n"
        "  selvedge batch jobs.json -o out --shard 3/8        # and when all are done: --merge");
    set_action(command, [arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace selvedge::app
