// selvedge check FILE...: prints one line for every fault in garment files.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/pattern_faults.h"
#include "sim/pattern/fault.h"

namespace selvedge::app {
namespace {

struct CheckArguments {
    std::vector<std::string> files;
    bool is_strict = false;
};

int check_files(const CheckArguments& arguments) {
    bool has_warning = false;
    bool has_fault = false;
    for (const std::string& file : arguments.files) {
        const std::vector<sim::Fault> faults = faults_of_file(file);
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
