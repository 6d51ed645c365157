#include "batch/job.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "sim/core/sha256.h"

namespace selvedge::batch {
namespace {

constexpr std::size_t kLongestName = 120;
constexpr std::size_t kLongestDescription = 96;
constexpr std::size_t kHashDigits = 10;

bool is_name_letter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '_' || c == '-';
}

// "'it'\''s'" of it's; plain words stay as they are.
std::string quoted(const std::string& word) {
    const auto is_plain = [](char c) {
        return is_name_letter(c) || std::string_view("/:=,+@%").find(c) != std::string_view::npos;
    };
    if (!word.empty() && std::ranges::all_of(word, is_plain)) return word;
    std::string text = "'";
    for (const char c : word) {
        if (c == '\'') {
            text += "'\\''";
        } else {
            text += c;
        }
    }
    return text + "'";
}

std::string with_name_letters(std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return !is_name_letter(c); }, '-');
    return text;
}

}  // namespace

bool has_option(const std::vector<JobOption>& options, const std::string& name) {
    return std::ranges::find(options, name, &JobOption::name) != options.end();
}

std::vector<std::string> dress_arguments(const Job& job) {
    std::vector<std::string> arguments{job.garment.string()};
    const auto add = [&](const std::string& option, const std::string& value) {
        arguments.push_back("--" + option);
        arguments.push_back(value);
    };
    for (const std::filesystem::path& over : job.over) add("over", over.string());
    if (!job.body.empty()) add("body", job.body);
    if (!job.fabric.empty()) add("fabric", job.fabric);
    for (const JobOption& option : job.options) {
        if (!option.is_flag) add(option.name, option.value);
    }
    // Last, so that one that needs a value does not take another option for it.
    for (const JobOption& option : job.options) {
        if (option.is_flag && !option.is_off) arguments.push_back("--" + option.name);
    }
    return arguments;
}

std::string replay_command(const Job& job) {
    std::string command = "selvedge dress";
    for (const std::string& argument : dress_arguments(job)) command += " " + quoted(argument);
    return command + " --report report.json --render picture.png";
}

std::string body_key(const Job& job) {
    std::string key = job.body;
    for (const JobOption& option : job.options) {
        if (option.name.starts_with("body-")) key += '\0' + option.name + '=' + option.value;
    }
    return key;
}

std::string describe_job(const Job& job) {
    std::string text = job.garment.stem().string();
    for (const std::filesystem::path& over : job.over) text += "+" + over.stem().string();
    std::string body = job.body;
    if (body.find('/') != std::string::npos) body = std::filesystem::path(body).stem().string();
    if (!body.empty()) text += "_" + body;
    const std::string fabric = std::filesystem::path(job.fabric).stem().string();
    if (!fabric.empty()) text += "_" + fabric;
    for (const JobOption& option : job.options) {
        if (option.is_off) continue;
        const bool is_path = option.name == "design" && option.value.find('/') != std::string::npos;
        const std::string value = is_path ? std::filesystem::path(option.value).stem().string() : option.value;
        text += "_" + option.name + (value.empty() ? "" : "-" + value);
    }
    std::string name = with_name_letters(text);
    if (name.empty() || name.front() == '.') name.insert(0, "x");
    if (name.size() > kLongestDescription) {
        const std::string hash = sim::sha256(text).substr(0, kHashDigits);
        name.resize(kLongestDescription - kHashDigits - 1);
        name += "-" + hash;
    }
    return name;
}

bool is_job_name(const std::string& text) {
    return !text.empty() && text.size() <= kLongestName && text.front() != '.' &&
           std::ranges::all_of(text, is_name_letter);
}

}  // namespace selvedge::batch
