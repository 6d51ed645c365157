// selvedge check FILE...: prints one line for every fault in garment files.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/commands.h"
#include "render/looks/cloth_looks.h"
#include "sim/core/error.h"
#include "sim/core/json.h"
#include "sim/dress/dress_check.h"
#include "sim/pattern/pattern_file.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge::app {
namespace {

struct CheckArguments {
    std::vector<std::string> files;
    bool is_strict = false;
};

// What dress refuses. A warning about the same value says no more.
void add_faults_of_dressing(const sim::Pattern& pattern, const std::string& file, std::vector<sim::Fault>& faults) {
    for (sim::Fault& found : dress_faults(pattern, file)) {
        std::erase_if(faults, [&](const sim::Fault& other) { return other.place == found.place; });
        faults.push_back(std::move(found));
    }
}

// Looks up the names in the pattern in the same way as dress does.
void add_faults_of_names(const sim::Pattern& pattern, const std::string& file, std::vector<sim::Fault>& faults) {
    try {
        if (!pattern.tartan.empty()) sim::find_tartan(pattern.tartan);
    } catch (const sim::InputError& error) {
        const std::string place = error.place() == "tartan" ? "" : error.place() + ": ";
        faults.push_back({.severity = sim::Severity::Error,
                          .file = file,
                          .place = "selvedge.tartan",
                          .problem = place + error.problem()});
    }
}

// Reads pictures and looks up tartans of surface designs.
void add_faults_of_designs(const sim::Pattern& pattern, const std::string& file, std::vector<sim::Fault>& faults) {
    const auto check = [&](const std::optional<sim::SurfaceDesign>& design, const std::string& place) {
        if (!design) return;
        try {
            sim::Pattern one;
            one.surface = design;
            render::ClothLooks(render::ClothLooks::Unknown::Fail).read(one);
        } catch (const sim::InputError& error) {
            const std::string picture = error.file().empty() ? "" : error.file() + ": ";
            faults.push_back(
                {.severity = sim::Severity::Error, .file = file, .place = place, .problem = picture + error.problem()});
        }
    };
    check(pattern.surface, "selvedge.surface");
    for (const sim::Panel& panel : pattern.panels)
        check(panel.surface, sim::json_path("pattern.panels", panel.name) + ".selvedge.surface");
    if (has_error(faults)) return;
    try {
        render::ClothLooks(render::ClothLooks::Unknown::Fail).read(pattern);  // those of fabrics too
    } catch (const sim::InputError& error) {
        faults.push_back(
            {.severity = sim::Severity::Error, .file = file, .place = "selvedge.fabric", .problem = error.what()});
    }
}

int check_files(const CheckArguments& arguments) {
    bool has_warning = false;
    bool has_fault = false;
    for (const std::string& file : arguments.files) {
        std::vector<sim::Fault> faults = sim::check_pattern_file(file);
        if (!has_error(faults)) {
            const sim::Pattern pattern = sim::load_pattern(file).pattern;
            add_faults_of_dressing(pattern, file, faults);
            add_faults_of_names(pattern, file, faults);
            if (!has_error(faults)) add_faults_of_designs(pattern, file, faults);
        }
        for (const sim::Fault& fault : faults) std::printf("%s\n", describe(fault).c_str());
        has_warning = has_warning || !faults.empty();
        has_fault = has_fault || has_error(faults);
    }
    if (has_fault) return 2;
    return has_warning && arguments.is_strict ? 1 : 0;
}

}  // namespace

void add_check_command(CLI::App& app, int& exit_code) {
    auto arguments = std::make_shared<CheckArguments>();
    CLI::App* command = app.add_subcommand("check", "List every fault of garment files");
    command->add_option("files", arguments->files, "Garment files")->required()->type_name("FILE");
    command->add_flag("--strict", arguments->is_strict, "Exit 1 when there are warnings and no faults");
    command->footer(
        "Exit code: 0 clean (or warnings only), 1 warnings with --strict, 2 faults.\n"
        "Example: selvedge check patterns/tshirt.json");
    command->callback([arguments, &exit_code] { exit_code = check_files(*arguments); });
}

}  // namespace selvedge::app
