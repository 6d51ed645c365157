// selvedge check FILE...: prints one line for every fault in garment files.
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "app/commands.h"
#include "render/output/pattern_faults.h"
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
        const std::vector<sim::Fault> faults = render::faults_of_file(file);
        for (const sim::Fault& fault : faults) std::printf("%s\n", describe(fault).c_str());
        has_warning = has_warning || !faults.empty();
        has_fault = has_fault || has_error(faults);
    }
    if (has_fault) return 2;
    return has_warning && arguments.is_strict ? 1 : 0;
}

}  // namespace

void add_check_command(Command& app, int& exit_code) {
    auto arguments = std::make_shared<CheckArguments>();
    Command& command = add_command(app, "check", "List every fault of garment files");
    add_option(command, "files", arguments->files, "Garment files", {.type = "FILE", .is_required = true});
    add_flag(command, "--strict", arguments->is_strict, "Exit 1 when there are warnings and no faults");
    set_footer(command,
               "Exit code: 0 clean (or warnings only), 1 warnings with --strict, 2 faults.\n"
               "Example: selvedge check patterns/tshirt.json");
    set_action(command, [arguments, &exit_code] { exit_code = check_files(*arguments); });
}

}  // namespace selvedge::app
