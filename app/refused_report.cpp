#include "app/refused_report.h"

#include <filesystem>
#include <optional>
#include <string>

#include "app/arguments.h"
#include "app/options.h"
#include "sim/core/file.h"
#include "sim/core/file_path.h"
#include "sim/core/json.h"
#include "sim/inspection/report.h"

namespace selvedge::app {
namespace {

bool is_report(const std::filesystem::path& file) {
    const sim::Json json = sim::read_json(file);
    return json.find(sim::report_key::kSchema) != nullptr && json.find(sim::report_key::kOutcome) != nullptr;
}

}  // namespace

void write_refused_report(const Command& app, const std::string& problem) {
    const std::optional<std::string> name = given_value(app, "--report");
    if (!name) return;
    const std::filesystem::path file = *name;
    try {
        check_output(file);
        if (sim::file_exists(file) && !is_report(file)) return;
        sim::DressReport refused;
        refused.problem = problem;
        sim::write_file_atomically(file, to_json(refused));
    } catch (const sim::InputError&) {
        // The command line's own mistake is the message.
    }
}

}  // namespace selvedge::app
