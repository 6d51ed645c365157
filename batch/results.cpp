#include "batch/results.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <string_view>

#include "batch/csv.h"
#include "batch/job_folder.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/file_path.h"
#include "sim/inspection/report.h"

namespace selvedge::batch {
namespace {

using Path = std::filesystem::path;
using sim::Json;
namespace key = sim::report_key;

Json json_of_options(const Job& job) {
    Json json = Json::object();
    for (const JobOption& option : job.options) json[option.name] = option.is_flag ? Json(true) : Json(option.value);
    return json;
}

// What a job left for its user, in alphabetical order.
Json files_in(const Path& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (const Path& path : sim::entries_of(folder, error)) {
        const std::string name = path.filename().string();
        if (name.starts_with('.')) continue;  // of a process that was killed while it wrote
        if (name != job_file::kRecord && name != job_file::kTimes && name != job_file::kLog) names.push_back(name);
    }
    std::ranges::sort(names);
    Json list = Json::array();
    for (std::string& name : names) list.push_back(std::move(name));
    return list;
}

Json row_of(const Job& job, const JobResult& result, const Path& output) {
    const Path folder = job_folder(output, job.name);
    Json row = Json::object();
    row["job"] = job.name;
    row["garment"] = job.garment.string();
    Json& over = row["over"] = Json::array();
    for (const Path& one : job.over) over.push_back(one.string());
    row["body"] = job.body;
    row["fabric"] = job.fabric;
    row["job_options"] = json_of_options(job);
    row["exit_code"] = result.record.exit_code;
    for (const std::string_view member :
         {key::kSchema, key::kVersion, key::kOutcome, key::kProblem, key::kInputs, key::kOptions, key::kFaults,
          key::kFit, key::kNotes, key::kSimulatedSeconds, key::kMesh, key::kContact, key::kStretch})
        row[member] = member_of(result.report, member);
    row["files"] = files_in(folder);
    row["replay"] = replay_command(job);
    return row;
}

std::string text_at(const Json& row, std::string_view member) {
    const Json* found = row.find(member);
    if (found == nullptr) return {};
    if (found->is_string()) return found->string();
    if (found->is_number()) return found->number_text();
    return {};
}

std::string hash_of(const Json& row, std::string_view role) {
    for (const Json& input : row.find(key::kInputs)->elements()) {
        if (text_at(input, key::kRole) == role) return text_at(input, key::kSha256);
    }
    return {};
}

// "4.2", in cm; empty if it was not measured.
std::string ease_of(const Json& row, std::string_view measure) {
    for (const Json& one : row.find(key::kFit)->elements()) {
        const Json* ease = one.find(key::kEaseM);
        if (text_at(one, key::kMeasure) != measure || ease == nullptr || !ease->is_number()) continue;
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "%.1f", 100 * ease->number());
        return text.data();
    }
    return {};
}

constexpr std::array<std::string_view, 8> kMeasures{"bust",        "waist",        "hip",        "neck",
                                                    "left_sleeve", "right_sleeve", "left_thigh", "right_thigh"};

std::string csv_of(const std::vector<Json>& rows) {
    std::vector<std::string> names{"job",  "garment", "body",        "fabric",    "outcome",
                                   "exit", "faults",  "first_cause", "triangles", "simulated_s"};
    for (const std::string_view measure : kMeasures) names.push_back("ease_" + std::string(measure) + "_cm");
    for (const char* name : {"version", "garment_sha256", "body_sha256", "replay"}) names.emplace_back(name);
    std::string text = csv_line(names);
    for (const Json& row : rows) {
        const Json* mesh = row.find(key::kMesh);
        std::vector<std::string> fields{text_at(row, "job"),
                                        text_at(row, "garment"),
                                        text_at(row, "body"),
                                        text_at(row, "fabric"),
                                        text_at(row, key::kOutcome),
                                        text_at(row, "exit_code"),
                                        std::to_string(row.find(key::kFaults)->elements().size()),
                                        first_cause(row),
                                        mesh == nullptr ? "" : text_at(*mesh, key::kLeafTriangles),
                                        text_at(row, key::kSimulatedSeconds)};
        for (const std::string_view measure : kMeasures) fields.push_back(ease_of(row, measure));
        fields.push_back(text_at(row, key::kVersion));
        fields.push_back(hash_of(row, "garment"));
        fields.push_back(hash_of(row, "body"));
        fields.push_back(text_at(row, "replay"));
        text += csv_line(fields);
    }
    return text;
}

std::string number_text(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3f", value);
    return text.data();
}

std::string times_csv(const std::vector<Json>& rows, const Path& output) {
    std::string text = csv_line({"job", "wall_s", "cpu_s", "peak_memory_mb"});
    for (const Json& row : rows) {
        const std::string name = text_at(row, "job");
        const JobRecord record = read_record(output, name).value_or(JobRecord{});
        text +=
            csv_line({name, number_text(record.wall_s), number_text(record.cpu_s), number_text(record.peak_memory_mb)});
    }
    return text;
}

}  // namespace

std::vector<Path> result_files(const Path& output) {
    return {output / result_file::kLines, output / result_file::kTable, output / result_file::kTimes,
            output / result_file::kGallery};
}

Json member_of(const Json& object, std::string_view name) {
    const Json* found = object.find(name);
    return found == nullptr ? Json() : *found;
}

std::string first_cause(const Json& row) {
    const std::vector<Json>& faults = row.find(key::kFaults)->elements();
    const std::string problem = text_at(row, key::kProblem);
    if (faults.empty() || !problem.empty()) return problem;
    const std::string outcome = text_at(row, key::kOutcome);
    const auto decides = [&](const Json& fault) { return text_at(fault, key::kClass) == outcome; };
    const auto first = std::ranges::find_if(faults, decides);
    return text_at(first == faults.end() ? faults.front() : *first, key::kCause);
}

Results gather_results(const std::vector<Job>& jobs, const Path& output,
                       const std::function<std::string(const Job&)>& key_of) {
    Results results;
    for (const Job& job : jobs) {
        if (const std::optional<JobResult> result = read_result(output, job.name, key_of(job))) {
            results.rows.push_back(row_of(job, *result, output));
        } else {
            results.missing.push_back(job.name);
        }
    }
    return results;
}

void write_results(const Results& results, const Path& output) {
    std::string lines;
    constexpr int kOneLine = -1;
    for (const Json& row : results.rows) lines += write_json(row, kOneLine) + '\n';
    sim::write_file_atomically(output / result_file::kLines, lines);
    sim::write_file_atomically(output / result_file::kTable, csv_of(results.rows));
    sim::write_file_atomically(output / result_file::kTimes, times_csv(results.rows, output));
}

}  // namespace selvedge::batch
