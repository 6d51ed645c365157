#include "app/job_key.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <iterator>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/file_extension.h"
#include "sim/core/file_path.h"
#include "sim/core/json.h"
#include "sim/core/sha256.h"
#include "sim/core/simd_level.h"
#include "sim/dress/report.h"
#include "sim/pattern/named_file.h"
#include "sim/pattern/pattern.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::app {
namespace {

using Path = std::filesystem::path;

// "my body.bin" of "my%20body.bin".
std::string percent_decoded(const std::string& text) {
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        unsigned char byte = 0;
        const char* const digits = text.data() + i + 1;
        const bool is_code =
            text[i] == '%' && i + 2 < text.size() && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2;
        decoded += is_code ? static_cast<char>(byte) : text[i];
        if (is_code) i += 2;
    }
    return decoded;
}

// The files beside a .gltf that hold its numbers, by both spellings that its reader may take.
std::vector<Path> buffers_beside(const Path& gltf) {
    std::vector<Path> files;
    const sim::Json json = sim::read_json(gltf);
    const sim::Json* buffers = json.find("buffers");
    if (buffers == nullptr || !buffers->is_array()) return files;
    for (const sim::Json& buffer : buffers->elements()) {
        const sim::Json* uri = buffer.find("uri");
        if (uri == nullptr || !uri->is_string() || uri->string().starts_with("data:")) continue;
        files.push_back(sim::folder_of(gltf) / uri->string());
        files.push_back(sim::folder_of(gltf) / percent_decoded(uri->string()));
    }
    return files;
}

}  // namespace

JobKeys::JobKeys(JobOutputs outputs) : outputs_(std::move(outputs)), program_(sim::sha256_of_file("/proc/self/exe")) {}

std::string JobKeys::operator()(const batch::Job& job) {
    sim::Json json = sim::Json::object();
    json["program"] = program_;
    json["simd"] = sim::name_of(sim::simd_level());  // the levels round differently
    sim::Json& words = json["arguments"] = sim::Json::array();
    for (const std::string& word : dress_arguments(job)) words.push_back(word);
    json["picture"] = outputs_.has_pictures;
    sim::Json& exports = json["exports"] = sim::Json::array();
    for (const std::string& extension : outputs_.exports) exports.push_back(extension);
    sim::Json& inputs = json["inputs"] = sim::Json::array();
    for (const Path& file : inputs_of(job)) inputs.push_back(hash_of(file));
    return sim::sha256(write_json(json, -1));
}

bool JobKeys::differ_from(const sim::Json& report) const {
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
    for (const Path& file : std::vector<Path>(files)) {
        if (sim::lower_extension(file) == ".gltf") std::ranges::copy(buffers_of(file), std::back_inserter(files));
    }
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
    if (!is_new) return at->second;
    try {
        at->second = buffers_beside(body);
    } catch (const sim::InputError&) {
    }
    return at->second;
}

}  // namespace selvedge::app
