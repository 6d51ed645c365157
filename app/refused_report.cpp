#include "app/refused_report.h"

#include <filesystem>
#include <string_view>

#include "app/options.h"
#include "sim/core/file.h"
#include "sim/core/file_path.h"
#include "sim/core/json.h"
#include "sim/dress/report.h"

namespace selvedge::app {
namespace {

constexpr std::string_view kOption = "--report";

// The value of --report; empty if there is none.
std::filesystem::path report_file_of(std::span<const char* const> arguments) {
    for (std::size_t i = 2; i < arguments.size(); ++i) {
        const std::string_view argument = arguments[i];
        if (argument == kOption && i + 1 < arguments.size()) return arguments[i + 1];
        if (argument.starts_with(kOption) && argument.substr(kOption.size()).starts_with('='))
            return argument.substr(kOption.size() + 1);
    }
    return {};
}

bool is_report(const std::filesystem::path& file) {
    const sim::Json json = sim::read_json(file);
    return json.find(sim::report_key::kSchema) != nullptr && json.find(sim::report_key::kOutcome) != nullptr;
}

}  // namespace

void write_refused_report(std::span<const char* const> arguments, const std::string& problem) {
    if (arguments.size() < 2) return;
    const std::string_view command = arguments[1];
    if (command != "dress" && command != "animate") return;
    const std::filesystem::path file = report_file_of(arguments);
    if (file.empty()) return;
    try {
        check_output(file);
        if (sim::file_exists(file) && !is_report(file)) return;
        sim::DressReport refused;
        refused.problem = problem;
        sim::write_file_atomically(file, to_json(refused));
    } catch (const sim::InputError&) {
        // The command line's own mistake is told.
    }
}

}  // namespace selvedge::app
