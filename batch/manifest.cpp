#include "batch/manifest.h"

#include <glob.h>

#include <algorithm>
#include <array>
#include <map>
#include <sstream>
#include <utility>

#include "batch/csv.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/file_path.h"
#include "sim/core/json.h"
#include "sim/core/lower_case.h"
#include "sim/core/sha256.h"
#include "sim/core/trimmed.h"
#include "sim/pattern/pattern.h"

namespace selvedge::batch {
namespace {

using Path = std::filesystem::path;
using sim::InputError;
using sim::JsonView;

constexpr std::size_t kMostManifestBytes = std::size_t(256) << 20;

// Outputs, which the batch chooses, and what a job says in a place of its own.
constexpr std::array<std::string_view, 15> kNotOptions{"garment",
                                                       "over",
                                                       "body",
                                                       "fabric",
                                                       "render",
                                                       "export",
                                                       "export-body",
                                                       "export-surface",
                                                       "with-body",
                                                       "thickness",
                                                       "export-garmentcode",
                                                       "report",
                                                       "turntable",
                                                       "threads",
                                                       "quiet"};

bool is_fabric_file(const std::string& text) {
    return text.ends_with(".json");
}

// No path begins as an option does.
std::string in_folder(const Path& folder, const std::string& file) {
    const std::string path = (folder / file).lexically_normal().string();
    return path.starts_with('-') ? "./" + path : path;
}

// A pattern of names that matches the text alone.
std::string as_pattern(const std::string& text) {
    std::string pattern;
    for (const char c : text) {
        if (std::string_view("*?[]\\").find(c) != std::string_view::npos) pattern += '\\';
        pattern += c;
    }
    return pattern;
}

// The file of this name, or else the files whose names match, in alphabetical order. Only `text` is a pattern of names.
std::vector<std::string> files_like(const Path& folder, const std::string& text) {
    const std::string file = in_folder(folder, text);
    if (sim::file_exists(file)) return {file};
    const std::string pattern = in_folder(as_pattern(folder.string()), text);
    glob_t found{};
    const int end = ::glob(pattern.c_str(), 0, nullptr, &found);
    std::vector<std::string> files;
    if (end == 0) files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
    ::globfree(&found);
    if (files.empty()) throw InputError(file, "", "there is no such file");
    return files;
}

void add_bodies(const std::string& text, const Path& folder, std::vector<std::string>& bodies) {
    if (text.empty()) return;
    if (!sim::is_body_file(text)) {
        bodies.push_back(text);
    } else if (text.ends_with(".txt")) {
        const Path list = folder / text;
        std::istringstream lines(sim::read_file(list, kMostManifestBytes));
        for (std::string line; std::getline(lines, line);) {
            while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
            if (!line.starts_with('#') && !line.ends_with(".txt")) add_bodies(line, list.parent_path(), bodies);
        }
    } else {
        std::ranges::move(files_like(folder, text), std::back_inserter(bodies));
    }
}

std::string fabric_in(const Path& folder, const std::string& text) {
    return is_fabric_file(text) ? in_folder(folder, text) : text;
}

void resolve(std::vector<JobOption>& options, const Path& folder) {
    for (JobOption& option : options) {
        const std::string& value = option.value;
        const bool is_file = option.name == "design" && !value.empty() && value != "test" && !value.starts_with('#');
        if (is_file) option.value = in_folder(folder, value);
    }
}

// Makes the paths relative to the manifest's folder.
void resolve(Job& job, const Path& folder) {
    resolve(job.options, folder);
    job.garment = in_folder(folder, job.garment.string());
    for (Path& over : job.over) over = in_folder(folder, over.string());
    if (sim::is_body_file(job.body)) job.body = in_folder(folder, job.body);
    job.fabric = fabric_in(folder, job.fabric);
}

JobOption option_of(const std::string& name, const JsonView& value) {
    switch (value.value().kind()) {
        case sim::Json::Kind::Bool:
            return {.name = name, .value = "", .is_flag = true, .is_off = !value.value().boolean()};
        case sim::Json::Kind::Number:
            return {.name = name, .value = value.value().number_text()};
        case sim::Json::Kind::String:
            return {.name = name, .value = value.string()};
        default:
            value.fail("neither a number, a text nor true");
    }
}

bool is_option_name(const std::string& text) {
    return !text.empty() && !text.starts_with('-') &&
           text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
}

// Behind a flag, such a value would be read as an option. "-1.5" is a number.
bool looks_like_option(const std::string& value) {
    return value.size() > 1 && value.front() == '-' && value[1] != '.' && !(value[1] >= '0' && value[1] <= '9');
}

void check_option(const JobOption& option, const std::string& file, const std::string& place) {
    if (!is_option_name(option.name) || std::ranges::find(kNotOptions, option.name) != kNotOptions.end())
        throw InputError(file, place, "'" + option.name + "' is no option of a job");
    if (looks_like_option(option.value))
        throw InputError(file, place, "'" + option.value + "' is no value of '" + option.name + "'");
}

std::vector<JobOption> options_of(const JsonView& object) {
    std::vector<JobOption> options;
    for (const std::string& name : object.keys()) {
        const JsonView value = object.at(name);
        const JobOption option = option_of(name, value);
        check_option(option, object.file(), value.path());
        options.push_back(option);
    }
    return options;
}

// Options of all jobs of the manifest.
std::vector<JobOption> common_options(const JsonView& root, const Path& folder) {
    if (!root.has("options")) return {};
    std::vector<JobOption> options = options_of(root.at("options"));
    for (JobOption& option : options) option.is_common = true;
    resolve(options, folder);
    return options;
}

// Puts the common options before those of the job, but for those that it sets itself, be it to false.
void add_common(const std::vector<JobOption>& common, Job& job) {
    std::vector<JobOption> options;
    for (const JobOption& option : common) {
        if (!has_option(job.options, option.name)) options.push_back(option);
    }
    std::ranges::move(job.options, std::back_inserter(options));
    job.options = std::move(options);
}

std::vector<std::string> texts_of(const JsonView& parent, const char* key) {
    std::vector<std::string> texts;
    if (!parent.has(key)) return texts;
    const JsonView list = parent.at(key);
    for (std::size_t i = 0; i < list.size(); ++i) texts.push_back(list.at(i).string());
    return texts;
}

void check_keys(const JsonView& object, std::initializer_list<std::string_view> known) {
    for (const std::string& key : object.keys()) {
        if (std::ranges::find(known, key) == known.end()) object.at(key).fail("unknown key");
    }
}

Job job_of(const JsonView& object) {
    check_keys(object, {"name", "garment", "over", "body", "fabric", "options"});
    Job job;
    if (object.has("name")) {
        job.name = object.at("name").string();
        if (!is_job_name(job.name))
            object.at("name").fail("a name has 1 to 120 letters, digits, '.', '_' or '-', and starts with no '.'");
    }
    job.garment = object.at("garment").string();
    for (const std::string& over : texts_of(object, "over")) job.over.emplace_back(over);
    if (object.has("body")) job.body = object.at("body").string();
    if (object.has("fabric")) job.fabric = object.at("fabric").string();
    if (object.has("options")) job.options = options_of(object.at("options"));
    return job;
}

void check_count(std::size_t count, const std::string& file) {
    if (count > kMostJobs) throw InputError(file, "", "more than " + std::to_string(kMostJobs) + " jobs");
}

std::vector<Job> jobs_of_json(std::string_view text, const Path& file) {
    const sim::Json json = sim::parse_json(text, file.string());
    const JsonView root(json, file.string());
    check_keys(root, {"options", "jobs", "product"});
    const Path folder = file.parent_path();
    const std::vector<JobOption> common = common_options(root, folder);
    std::vector<Job> jobs;
    if (root.has("jobs")) {
        const JsonView list = root.at("jobs");
        check_count(list.size(), file.string());
        for (std::size_t i = 0; i < list.size(); ++i) {
            Job& job = jobs.emplace_back(job_of(list.at(i)));
            job.origin = file.string() + ": " + list.at(i).path();
            resolve(job, folder);
            add_common(common, job);
        }
    }
    if (root.has("product")) {
        const JsonView product = root.at("product");
        check_keys(product, {"garments", "bodies", "fabrics"});
        std::ranges::move(jobs_of({.garments = texts_of(product, "garments"),
                                   .bodies = texts_of(product, "bodies"),
                                   .fabrics = texts_of(product, "fabrics"),
                                   .options = common},
                                  folder),
                          std::back_inserter(jobs));
        check_count(jobs.size(), file.string());
    }
    if (jobs.empty()) throw InputError(file.string(), "", "neither jobs nor a product: nothing to do");
    return jobs;
}

std::vector<Path> paths_in(const std::string& text) {
    std::vector<Path> paths;
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, ';');) {
        if (!part.empty()) paths.emplace_back(part);
    }
    return paths;
}

// Column names as they may be written in a spreadsheet: " Garment".
std::vector<std::string> column_names(const std::vector<std::string>& fields) {
    std::vector<std::string> names;
    for (const std::string& field : fields) names.push_back(sim::lower_case(sim::trimmed(field)));
    return names;
}

// Spreadsheets write "TRUE" for "true".
JobOption option_of(const std::string& name, const std::string& field) {
    const bool is_on = field == "true" || field == "TRUE", is_off = field == "false" || field == "FALSE";
    if (!is_on && !is_off) return {.name = name, .value = field};
    return {.name = name, .value = "", .is_flag = true, .is_off = is_off};
}

// A column is a key of a job, or else an option; an empty field is none.
void take_field(Job& job, const std::string& column, const std::string& field) {
    if (column == "name") job.name = field;
    if (column == "garment") job.garment = field;
    if (column == "over") job.over = paths_in(field);
    if (column == "body") job.body = field;
    if (column == "fabric") job.fabric = field;
}

std::vector<Job> jobs_of_csv(std::string_view text, const Path& file) {
    const std::vector<CsvRow> rows = parse_csv(text, file.string());
    constexpr std::array<std::string_view, 5> kKeys{"name", "garment", "over", "body", "fabric"};
    if (rows.size() < 2) throw InputError(file.string(), "", "no row below the names of the columns: nothing to do");
    check_count(rows.size(), file.string());
    const std::vector<std::string> columns = column_names(rows.front().fields);
    if (std::ranges::find(columns, "garment") == columns.end())
        throw InputError(file.string(), "line 1", "there is no column 'garment'");
    std::vector<Job> jobs;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const std::string place = "line " + std::to_string(rows[i].line);
        if (rows[i].fields.size() > columns.size())
            throw InputError(file.string(), place, "has more fields than there are columns");
        Job job;
        job.origin = file.string() + ": " + place;
        for (std::size_t k = 0; k < rows[i].fields.size(); ++k) {
            const std::string field(sim::trimmed(rows[i].fields[k]));
            take_field(job, columns[k], field);
            if (field.empty() || std::ranges::find(kKeys, columns[k]) != kKeys.end()) continue;
            job.options.push_back(option_of(columns[k], field));
            check_option(job.options.back(), file.string(), place);
        }
        if (job.garment.empty()) throw InputError(file.string(), place, "names no garment");
        if (!job.name.empty() && !is_job_name(job.name))
            throw InputError(file.string(), place, "'" + job.name + "' cannot be the name of a folder");
        resolve(job, file.parent_path());
        jobs.push_back(std::move(job));
    }
    return jobs;
}

}  // namespace

std::vector<Job> jobs_of(const Product& product, const Path& folder) {
    std::vector<std::string> garments, bodies, fabrics;
    for (const std::string& text : product.garments)
        std::ranges::move(files_like(folder, text), std::back_inserter(garments));
    for (const std::string& text : product.bodies) add_bodies(text, folder, bodies);
    for (const std::string& text : product.fabrics) fabrics.push_back(fabric_in(folder, text));
    if (bodies.empty()) bodies.emplace_back();
    if (fabrics.empty()) fabrics.emplace_back();
    if (garments.size() > kMostJobs / bodies.size() / fabrics.size())
        throw InputError("", "", "more than " + std::to_string(kMostJobs) + " jobs");
    std::vector<Job> jobs;
    for (const std::string& body : bodies) {
        for (const std::string& garment : garments) {
            for (const std::string& fabric : fabrics) {
                jobs.push_back({.name = {},
                                .garment = garment,
                                .over = {},
                                .body = body,
                                .fabric = fabric,
                                .options = product.options,
                                .origin = {}});
            }
        }
    }
    return jobs;
}

std::vector<Job> parse_manifest(std::string_view text, const Path& file) {
    return file.extension() == ".csv" ? jobs_of_csv(text, file) : jobs_of_json(text, file);
}

std::vector<Job> read_manifest(const Path& path) {
    return parse_manifest(sim::read_file(path, kMostManifestBytes), path);
}

JobOption parse_option(const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    const JobOption option = equals == std::string::npos ? JobOption{.name = name, .value = "", .is_flag = true}
                                                         : option_of(name, text.substr(equals + 1));
    check_option(option, "", "--set");
    return option;
}

void name_jobs(std::vector<Job>& jobs) {
    std::map<std::string, std::size_t> uses;
    std::vector<Job*> unnamed;
    for (Job& job : jobs) {
        if (job.name.empty()) {
            job.name = describe_job(job);
            unnamed.push_back(&job);
        }
        ++uses[job.name];
    }
    // Files of one name in two folders.
    for (Job* job : unnamed) {
        if (uses[job->name] < 2) continue;
        std::string all;
        for (const std::string& argument : dress_arguments(*job)) all += argument + '\0';
        constexpr std::size_t kDigits = 10;
        job->name += "-" + sim::sha256(all).substr(0, kDigits);
    }
    std::ranges::stable_sort(jobs, {}, &Job::name);
    const auto same = std::ranges::adjacent_find(jobs, {}, &Job::name);
    if (same == jobs.end()) return;
    const std::string& other = std::next(same)->origin;
    throw InputError(same->origin, "job '" + same->name + "'",
                     "there are two of this name" + (other.empty() ? "" : ", the other is " + other));
}

}  // namespace selvedge::batch
