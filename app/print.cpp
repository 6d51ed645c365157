// selvedge print GARMENT -o FILE: writes a pattern for the cutting table, as pages to print, as a file for a plotter or
// another program, or as a cutting layout.
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/garment_options.h"
#include "app/options.h"
#include "app/print_files.h"
#include "sim/core/printable.h"
#include "sim/pattern/named_file.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::app {
namespace {

struct PrintArguments {
    std::string garment;
    std::filesystem::path output;
    std::optional<double> allowance_mm;
    double fabric_width_cm = 150;
    PrintSettings settings;
};

int run(PrintArguments& arguments) {
    check_output(arguments.output, kPrintFormats);
    check_distinct({arguments.output}, {arguments.garment});
    sim::PatternDocument document = sim::load_pattern(arguments.garment);
    sim::Pattern& pattern = document.pattern;
    const std::vector<std::string> named = named_files(pattern);
    check_distinct({arguments.output}, {named.begin(), named.end()});
    if (arguments.allowance_mm) pattern.allowance = *arguments.allowance_mm / 1000;
    arguments.settings.fabric_width = arguments.fabric_width_cm / 100;
    const Printed printed = print_pattern(pattern, arguments.output, arguments.settings);
    tell_warnings(document.warnings);
    for (const std::string& note : printed.notes)
        std::fprintf(stderr, "selvedge: note: %s\n", sim::printable(note).c_str());
    std::printf("wrote %s: %s, %s\n", sim::printable(arguments.output.string()).c_str(),
                sim::count_text(pattern.panels.size(), "panel").c_str(), sim::printable(printed.what).c_str());
    return 0;
}

void add_layout_options(Command& command, PrintArguments& arguments) {
    add_flag(command, "--layout", arguments.settings.is_layout,
             "A cutting layout: all pieces on fabric, and how much it takes", {.group = "Cutting layout"});
    add_option(command, "--fabric-width", arguments.fabric_width_cm, "Width of the fabric in cm, without its selvedges",
               {.type = "CM", .group = "Cutting layout", .shows_default = true, .range = Limits<double>{10.0, 1000.0}});
    add_flag(command, "--folded", arguments.settings.is_folded,
             "The fabric is folded along its length: pairs are cut at once", {.group = "Cutting layout"});
    add_flag(command, "--one-way", arguments.settings.is_one_way, "All pieces point one way, as on velvet",
             {.group = "Cutting layout"});
}

}  // namespace

void add_print_command(Command& app, int& exit_code) {
    auto arguments = std::make_shared<PrintArguments>();
    Command& command = add_command(app, "print", "Write a pattern for the cutting table: PDF, SVG or DXF");
    add_option(command, "GARMENT", arguments->garment, "Garment file", {.type = "FILE", .is_required = true});
    add_option(command, "-o,--output", arguments->output, "File to write: .pdf, .svg or .dxf",
               {.type = "FILE", .is_required = true});
    add_option(command, "--paper", arguments->settings.paper,
               "a4, a3, a2, a1, a0, letter, legal, tabloid, or WIDTHxHEIGHT in mm; of a PDF",
               {.type = "PAPER", .shows_default = true});
    add_flag(command, "--one-page", arguments->settings.is_one_page,
             "One page at true size for a plotter, as wide as the paper, or as the fabric of a layout");
    add_option(command, "--layers", arguments->settings.layers,
               "What is drawn: cut,sew,fold,grain,notches,drill,internal,labels (default: all); not for DXF",
               {.type = "LIST", .delimiter = ','});
    add_option(command, "--allowance", arguments->allowance_mm,
               "Seam allowance in mm where panel and edge name none (default: the garment's)",
               {.type = "MM", .range = Limits<double>{0.0, 100.0}});
    add_flag(command, "--on-fold", arguments->settings.is_on_fold,
             "Symmetric panels as halves to cut on a fold; only in a PDF");
    add_flag(command, "--all-pieces", arguments->settings.prints_all,
             "Draw mirror images, too, instead of \"cut 1 pair\"; SVG and DXF always do");
    add_flag(command, "--astm", arguments->settings.is_astm,
             "DXF by ASTM D6673 instead of AAMA: notches tell their kind");
    add_layout_options(command, *arguments);
    set_footer(
        command,
        "A PDF has a cover with a 10 cm test square and a map, then pages that overlap by 1 cm. Print at 100 %.\n"
        "Its layers are the kinds of line, which viewers can hide.\n"
        "SVG and DXF are read back by selvedge import with the same outlines, notches and seams.\n"
        "Exit code: 0 written; 2 wrong input.\n"
        "Examples:\n"
        "  selvedge print patterns/tshirt.json -o tshirt.pdf --allowance 10\n"
        "  selvedge print patterns/tshirt.json -o layout.pdf --layout --fabric-width 140");
    set_action(command, [arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace selvedge::app
