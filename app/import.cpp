// selvedge import FILE... -o garment.json: makes a garment of patterns that other programs drew.
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/import_garment.h"
#include "app/options.h"
#include "sim/core/error.h"
#include "sim/core/printable.h"
#include "sim/paper/drawing_unit.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::app {
namespace {

struct ImportArguments {
    std::vector<std::filesystem::path> files;
    std::filesystem::path output;
    std::string unit;
    std::optional<double> allowance_mm;
    BodyOptions body;
    ImportOptions options;
    bool lists_all = false;
};

void print_list(const char* title, const std::vector<std::string>& lines) {
    if (lines.empty()) return;
    std::printf("%s\n", title);
    for (const std::string& line : lines) std::printf("  %s\n", sim::printable(line).c_str());
}

void check_pictures(const std::vector<UnderlayFile>& files, const std::vector<std::filesystem::path>& inputs) {
    std::vector<std::filesystem::path> outputs;
    for (const UnderlayFile& file : files) {
        check_output(file.path);
        outputs.push_back(file.path);
    }
    check_distinct(outputs, inputs);
}

int run(ImportArguments& arguments) {
    ImportOptions options = arguments.options;
    if (!arguments.unit.empty()) options.panels.metres_per_unit = sim::metres_of_unit(arguments.unit);
    if (arguments.allowance_mm) options.panels.allowance = *arguments.allowance_mm / 1000;
    if (!arguments.body.source.empty()) options.body = arguments.body.source;
    std::vector<std::filesystem::path> inputs = arguments.files;
    if (!options.measurements.empty()) inputs.emplace_back(options.measurements);
    if (arguments.body.is_file()) inputs.emplace_back(arguments.body.source);
    check_output(arguments.output);
    check_distinct({arguments.output}, inputs);
    check_output(arguments.output, kGarmentExtensions);
    ImportedGarment garment = import_garment(arguments.files, options);
    name_beside(garment.pictures, garment.pattern, arguments.output);
    check_pictures(garment.pictures, inputs);
    print_list("Read:", garment.notes);
    print_list("Body:", garment.body);
    print_list("Panels:", garment.panels);
    print_list("Seams:", garment.sewn);
    std::vector<std::string> possible = garment.possible;
    constexpr std::size_t kMostListed = 12;
    if (!arguments.lists_all && possible.size() > kMostListed) possible.resize(kMostListed);
    print_list("Possible, not sewn:", possible);
    if (possible.size() < garment.possible.size()) {
        std::printf("  and %zu less likely ones (--list-all)\n", garment.possible.size() - possible.size());
    }
    WrittenUnderlays pictures(garment.pictures);
    sim::save_pattern({.pattern = garment.pattern, .json = {}}, arguments.output);
    pictures.keep();
    for (const UnderlayFile& file : garment.pictures)
        std::printf("wrote %s: page %zu, %s, to be traced\n", sim::printable(file.path.string()).c_str(), file.page,
                    file.size.c_str());
    std::printf("wrote %s: %s, %s\n", sim::printable(arguments.output.string()).c_str(),
                sim::count_text(garment.pattern.panels.size(), "panel").c_str(),
                sim::count_text(garment.pattern.seams.size(), "seam").c_str());
    return 0;
}

}  // namespace

void add_import_command(Command& app, int& exit_code) {
    auto arguments = std::make_shared<ImportArguments>();
    Command& command = add_command(app, "import", "Make a garment of patterns that other programs drew");
    add_option(command, "FILES", arguments->files,
               "SVG, DXF, PDF, or a draft of FreeSewing as JSON; several make one garment",
               {.type = "FILE", .is_required = true});
    add_option(command, "-o,--output", arguments->output, "Garment file to write",
               {.type = "FILE", .is_required = true});
    add_option(command, "--unit", arguments->unit, "Unit of the files: mm, cm, m, in, pt or px (default: the file's)",
               {.type = "UNIT"});
    add_option(command, "--allowance", arguments->allowance_mm,
               "Seam allowance in mm that outlines include where only the cut line is drawn (default: the file's)",
               {.type = "MM", .range = Limits<double>{0.0, 100.0}});
    add_option(command, "--size", arguments->options.panels.size, "Which size to take from a file with several",
               {.type = "SIZE"});
    add_option(command, "--confidence", arguments->options.least_confidence,
               "Least confidence of the seams that are sewn, 0.05 to 1 (default 0.5)",
               {.type = "P", .range = Limits<double>{0.05, 1.0}});
    add_flag(command, "--list-all", arguments->lists_all, "List all seams that are possible, likely or not");
    add_option(command, "--measurements", arguments->options.measurements,
               "Body measurements of FreeSewing, Valentina, Seamly2D or GarmentCode (default: the drawing's)",
               {.type = "FILE"});
    add_body_options(
        command, arguments->body,
        "Body round which the panels are placed (default: of the measurements, else the female mannequin)");
    set_footer(
        command,
        "Files of these programs have no seams and no placement. Seams are proposed from lengths, shapes, notches and\n"
        "names, each with a confidence and a reason; those above --confidence are sewn. Panels are placed by their "
        "names\n"
        "and seams. Correct both in the editor.\n"
        "Pages of a PDF that hold only a scan are written as NAME_pageN.jpg beside the garment and lie under its "
        "sheet,\n"
        "at true size, to be traced in the editor.\n"
        "Exit code: 0 written; 2 wrong input.\n"
        "Examples:\n"
        "  selvedge import teagan.svg -o teagan.json && selvedge dress teagan.json --render teagan.png\n"
        "  selvedge import drawing.svg -o skirt.json --unit mm --allowance 10\n"
        "  selvedge import blouse.pdf -o blouse.json --size 40");
    set_action(command, [arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace selvedge::app
