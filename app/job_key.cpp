#include "app/job_key.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "app/body_buffers.h"
#include "batch/job_folder.h"
#include "sim/core/error.h"
#include "sim/core/json.h"
#include "sim/core/sha256.h"
#include "sim/core/simd_level.h"
#include "sim/inspection/report.h"
#include "sim/pattern/named_file.h"
#include "sim/pattern/pattern.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::app {
namespace {

using Path = std::filesystem::path;

// Levels of one name give the same bits (sim/core/simd_level.h).
const char* arithmetic_of(sim::SimdLevel level) {
    return level == sim::SimdLevel::Plain ? "plain" : "fused";
}

}  // namespace

JobKeys::JobKeys(JobOutputs outputs) : JobKeys(std::move(outputs), sim::sha256_of_file("/proc/self/exe")) {}

JobKeys::JobKeys(JobOutputs outputs, std::string program)
    : outputs_(std::move(outputs)), program_(std::move(program)) {}

std::string JobKeys::operator()(const batch::Job& job) {
    sim::Json json = sim::Json::object();
    json["program"] = program_;
    json["arithmetic"] = arithmetic_of(sim::simd_level());
    sim::Json& words = json["arguments"] = sim::Json::array();
    for (const std::string& word : dress_arguments(job)) words.push_back(word);
    json["picture"] = outputs_.has_pictures;
    sim::Json& exports = json["exports"] = sim::Json::array();
    for (const std::string& extension : outputs_.exports) exports.push_back(extension);
    sim::Json& inputs = json["inputs"] = sim::Json::array();
    for (const Path& file : inputs_of(job)) inputs.push_back(hash_of(file));
    return sim::sha256(write_json(json, -1));
}

// A refusal may come before the inputs were named in the report.
bool JobKeys::have_changed(const batch::Job& job, const sim::Json& report) {
    const bool is_refused = batch::outcome_in(report) == name_of(sim::Outcome::Refused);
    if (is_refused && JobKeys(outputs_, program_)(job) != (*this)(job)) return true;
    const sim::Json* inputs = report.find(sim::report_key::kInputs);
    if (inputs == nullptr || !inputs->is_array()) return false;
    return std::ranges::any_of(inputs->elements(), [&](const sim::Json& input) {
        const sim::Json *file = input.find(sim::report_key::kFile), *hash = input.find(sim::report_key::kSha256);
        if (file == nullptr || hash == nullptr) return false;
        const auto known = hashes_.find(file->string());
        return known != hashes_.end() && known->second != hash->string();
    });
}

std::string JobKeys::hash_of(const Path& file) {
    const auto [at, is_new] = hashes_.try_emplace(file.string());
    if (!is_new) return at->second;
    try {
        at->second = sim::sha256_of_file(file);
    } catch (const sim::InputError&) {
        at->second = "none";
    }
    return at->second;
}

std::vector<Path> JobKeys::inputs_of(const batch::Job& job) {
    std::vector<Path> files{job.garment};
    std::ranges::copy(job.over, std::back_inserter(files));
    for (const Path& garment : std::vector<Path>(files))
        std::ranges::copy(named_by_garment(garment), std::back_inserter(files));
    if (!job.fabric.empty()) std::ranges::copy(named_by_fabric(job.fabric), std::back_inserter(files));
    if (sim::is_body_file(job.body)) files.emplace_back(job.body);
    for (const batch::JobOption& option : job.options) {
        if (option.name == "design") files.emplace_back(option.value);  // "test" or a colour is no file
    }
    for (const Path& file : std::vector<Path>(files)) std::ranges::copy(buffers_of(file), std::back_inserter(files));
    return files;
}

const std::vector<std::string>& JobKeys::named_by_garment(const Path& garment) {
    const auto [at, is_new] = named_by_garments_.try_emplace(garment.string());
    if (!is_new) return at->second;
    try {
        at->second = named_files(sim::load_pattern(garment).pattern);
    } catch (const sim::InputError&) {
    }
    return at->second;
}

const std::vector<std::string>& JobKeys::named_by_fabric(const std::string& fabric) {
    const auto [at, is_new] = named_by_fabrics_.try_emplace(fabric);
    if (!is_new) return at->second;
    sim::Pattern pattern;
    pattern.fabric = fabric;
    at->second = named_files(pattern);
    return at->second;
}

const std::vector<Path>& JobKeys::buffers_of(const Path& body) {
    const auto [at, is_new] = buffers_.try_emplace(body.string());
    if (is_new) at->second = buffers_beside(body);
    return at->second;
}

}  // namespace selvedge::app
