// selvedge mannequin: makes a body from measurements, writes it, and prints requested and measured values.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/fitted_mannequin.h"
#include "app/options.h"
#include "sim/core/error.h"
#include "sim/core/printable.h"
#include "sim/exchange/mesh_file.h"
#include "sim/mannequin/mannequin.h"

namespace selvedge::app {
namespace {

struct MannequinArguments {
    sim::MannequinOptions options;  // in cm until run
    std::string sex = {};           // empty: of the file of measurements, else female
    std::filesystem::path measurements;
    std::filesystem::path output;
};

// "--high-hip,--high_hip": accepts hyphens, as usual on a command line, and underscores, as in the --body text.
std::string flags_of(std::string_view name) {
    const std::string flag = "--" + std::string(name);
    if (name == "hip") return flag + ",--hips";
    std::string hyphenated = flag;
    std::replace(hyphenated.begin(), hyphenated.end(), '_', '-');
    return hyphenated == flag ? flag : hyphenated + "," + flag;
}

void add_measures(Command& command, MannequinArguments& arguments) {
    for (const std::string_view name : sim::measure_names()) {
        add_option(command, flags_of(name), *find_measure(arguments.options.measures, name), "",
                   {.type = "CM", .group = "Measures (what is not given follows the others)"});
    }
}

void print_readings(const sim::MeasureReport& report) {
    std::printf("%-10s %9s %9s %9s\n", "cm", "asked", "measured", "at height");
    for (const sim::MeasureReading& reading : report.readings) {
        std::printf("%-10s ", std::string(reading.name).c_str());
        reading.requested ? std::printf("%9.1f ", 100 * *reading.requested) : std::printf("%9s ", "-");
        std::printf("%9.1f ", 100 * reading.measured);
        reading.level ? std::printf("%9.1f\n", 100 * *reading.level) : std::printf("\n");
    }
    for (const std::string& message : report.messages) std::printf("not met: %s\n", sim::printable(message).c_str());
}

// Those of the file, where the command line has none.
void take_measurements(MannequinArguments& arguments) {
    FittedMannequin body = read_fitted_mannequin(arguments.measurements);
    for (const std::string& line : body.lines) std::printf("%s\n", sim::printable(line).c_str());
    for (const std::string_view name : sim::measure_names()) {
        std::optional<double>& measure = *find_measure(arguments.options.measures, name);
        if (!measure) measure = *find_measure(body.fit.options.measures, name);
    }
    arguments.options.sex = body.fit.options.sex;
}

int run(MannequinArguments arguments) {
    check_output(arguments.output, sim::mesh_extensions());
    if (!arguments.measurements.empty()) check_distinct({arguments.output}, {arguments.measurements});
    for (const std::string_view name : sim::measure_names()) {
        std::optional<double>& measure = *find_measure(arguments.options.measures, name);
        if (measure) *measure /= 100;
    }
    if (!arguments.measurements.empty()) take_measurements(arguments);
    if (!arguments.sex.empty()) arguments.options.sex = arguments.sex == "male" ? sim::Sex::Male : sim::Sex::Female;
    if (!arguments.measurements.empty()) std::printf("%s\n", mannequin_text(arguments.options).c_str());
    const sim::Mannequin mannequin = make_mannequin(arguments.options);
    write_body(mannequin.body, arguments.output);
    print_readings(mannequin.report);
    std::printf("%s: %zu vertices, %zu triangles\n", sim::printable(arguments.output.string()).c_str(),
                mannequin.body.x.size(), mannequin.body.triangles.size());
    return mannequin.report.messages.empty() ? 0 : 1;
}

}  // namespace

void add_mannequin_command(Command& app, int& exit_code) {
    auto arguments = std::make_shared<MannequinArguments>();
    Command& command = add_command(app, "mannequin", "Make a body from measurements");
    add_option(command, "--sex", arguments->sex, "Which base body: female (default) or male",
               {.one_of = {"female", "male"}});
    add_option(command, "--measurements", arguments->measurements,
               "File of FreeSewing, Valentina, Seamly2D or GarmentCode; options win over it", {.type = "FILE"});
    add_measures(command, *arguments);
    add_option(command, "--resolution", arguments->options.subdivisions, "Steps of subdivision, 1 to 4",
               {.shows_default = true});
    add_option(command, "-o,--output", arguments->output, "body.glb, .obj, .ply or .stl", {.is_required = true});
    set_footer(command,
               "Exit code: 0 made as asked, 1 made but some measure could not be met, 2 wrong input.\n"
               "Examples:\n"
               "  selvedge mannequin --sex female --height 168 --bust 92 --waist 74 --hip 98 -o body.glb\n"
               "  selvedge mannequin --measurements anna.vit -o anna.glb");
    set_action(command, [arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace selvedge::app
