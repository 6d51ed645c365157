// selvedge print GARMENT -o FILE: writes a pattern for the cutting table, as pages to print, as a file for a plotter or
// another program, or as a cutting layout.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/options.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/pattern/pattern_file.h"
#include "sim/print/dxf_file.h"
#include "sim/print/print_pdf.h"
#include "sim/print/svg_file.h"

namespace selvedge::app {
namespace {

struct PrintArguments {
    std::string garment;
    std::filesystem::path output;
    std::string paper = "a4";
    std::vector<std::string> layers;
    std::optional<double> allowance_mm;
    double fabric_width_cm = 150;
    bool is_one_page = false;
    bool prints_all = false;
    bool is_layout = false;
    bool is_one_way = false;
    bool is_folded = false;
    bool is_astm = false;
};

sim::LayerChoice choose_layers(const std::vector<std::string>& names) {
    if (names.empty()) return sim::kAllLayers;
    sim::LayerChoice chosen{};
    for (const std::string& name : names) {
        const std::optional<sim::PaperLayer> layer = sim::find_layer(name);
        if (!layer)
            throw sim::InputError("", "--layers",
                                  "'" + name + "' is none of cut, sew, fold, grain, notches, drill, internal, labels");
        chosen[static_cast<std::size_t>(*layer)] = true;
    }
    return chosen;
}

std::string sheet_text(const sim::PaperSheet& sheet) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.1f x %.1f cm", 100 * sheet.size.x(), 100 * sheet.size.y());
    return text.data();
}

std::string write_pdf(const sim::Pattern& pattern, const PrintArguments& arguments, std::string& done) {
    const sim::PrintedPdf printed = print_pdf(pattern, {.paper = sim::parse_page_size(arguments.paper),
                                                        .layers = choose_layers(arguments.layers),
                                                        .is_one_page = arguments.is_one_page,
                                                        .draws_mirror_images = arguments.prints_all});
    if (arguments.is_one_page) {
        done = "one page";
    } else {
        done = std::to_string(printed.pages) + " pages, " + std::to_string(printed.columns) + " across and " +
               std::to_string(printed.rows) + " down, and a cover";
        const int left_out = printed.columns * printed.rows - printed.pages;
        if (left_out > 0)
            done +=
                " (" + std::to_string(left_out) + " left out, with no piece on " + (left_out == 1 ? "it)" : "them)");
    }
    return printed.bytes;
}

std::string write_layout(const sim::Pattern& pattern, const PrintArguments& arguments, const std::string& extension,
                         std::string& done) {
    const std::vector<sim::PaperSheet> layouts = cutting_layouts(pattern, {.width = arguments.fabric_width_cm / 100,
                                                                           .is_one_way = arguments.is_one_way,
                                                                           .is_folded = arguments.is_folded});
    for (const sim::PaperSheet& layout : layouts) {
        done += (done.empty() ? "" : "; ") + describe_layout(layout);
        for (const std::string& note : layout.notes) std::fprintf(stderr, "selvedge: note: %s\n", note.c_str());
    }
    if (extension == ".pdf")
        return print_layouts(layouts, sim::parse_page_size(arguments.paper), arguments.is_one_page).bytes;
    if (layouts.size() > 1)
        throw sim::InputError(
            arguments.output.string(), "",
            "an SVG holds the layout of one fabric, and there are " + std::to_string(layouts.size()) + ": write a PDF");
    return svg_of(pattern, layouts.front(), choose_layers(arguments.layers));
}

std::string write_svg(const sim::Pattern& pattern, const PrintArguments& arguments, std::string& done) {
    constexpr double kWidth = 1.5;  // m
    const sim::PaperSheet sheet = paper_sheet(pattern, paper_pieces(pattern), kWidth);
    done = sheet_text(sheet);
    return svg_of(pattern, sheet, choose_layers(arguments.layers));
}

bool has_allowance(const sim::Pattern& pattern) {
    return std::ranges::any_of(pattern.panels, [&](const sim::Panel& panel) {
        return std::ranges::any_of(panel.edges, [&](const sim::OutlineEdge& edge) {
            return allowance_of(panel, edge, pattern.allowance) > 0;
        });
    });
}

int run(const PrintArguments& arguments) {
    constexpr std::array<std::string_view, 3> kFormats{".pdf", ".svg", ".dxf"};
    check_output(arguments.output, kFormats);
    check_distinct({arguments.output}, {arguments.garment});
    sim::Pattern pattern = sim::load_pattern(arguments.garment).pattern;
    if (pattern.panels.empty()) throw sim::InputError(arguments.garment, "", "no panels: nothing to print");
    if (arguments.allowance_mm) pattern.allowance = *arguments.allowance_mm / 1000;
    if (!has_allowance(pattern))
        std::fprintf(stderr,
                     "selvedge: note: no seam allowance, so the sewing line is cut; --allowance 10 adds 10 mm\n");
    std::string extension = arguments.output.extension().string();
    std::ranges::transform(extension, extension.begin(), [](char c) { return static_cast<char>(std::tolower(c)); });
    std::string done, bytes;
    if (arguments.is_layout && extension != ".dxf") {
        bytes = write_layout(pattern, arguments, extension, done);
    } else if (arguments.is_layout) {
        throw sim::InputError("", "--layout", "a cutting layout is a PDF or an SVG");
    } else if (extension == ".pdf") {
        bytes = write_pdf(pattern, arguments, done);
    } else if (extension == ".svg") {
        bytes = write_svg(pattern, arguments, done);
    } else {
        bytes = dxf_of(pattern, arguments.is_astm ? sim::DxfStandard::Astm : sim::DxfStandard::Aama);
        done = arguments.is_astm ? "DXF-ASTM" : "DXF-AAMA";
    }
    sim::write_file_atomically(arguments.output, bytes);
    std::printf("wrote %s: %zu panels, %s\n", arguments.output.string().c_str(), pattern.panels.size(), done.c_str());
    return 0;
}

void add_layout_options(CLI::App& command, PrintArguments& arguments) {
    command.add_flag("--layout", arguments.is_layout, "A cutting layout: all pieces on fabric, and how much it takes")
        ->group("Cutting layout");
    command.add_option("--fabric-width", arguments.fabric_width_cm, "Width of the fabric in cm, without its selvedges")
        ->type_name("CM")
        ->check(CLI::Range(10.0, 1000.0))
        ->capture_default_str()
        ->group("Cutting layout");
    command.add_flag("--folded", arguments.is_folded, "The fabric is folded along its length: pairs are cut at once")
        ->group("Cutting layout");
    command.add_flag("--one-way", arguments.is_one_way, "All pieces point one way, as on velvet")
        ->group("Cutting layout");
}

}  // namespace

void add_print_command(CLI::App& app, int& exit_code) {
    auto arguments = std::make_shared<PrintArguments>();
    CLI::App* command = app.add_subcommand("print", "Write a pattern for the cutting table: PDF, SVG or DXF");
    command->add_option("GARMENT", arguments->garment, "Garment file")->required()->type_name("FILE");
    command->add_option("-o,--output", arguments->output, "File to write: .pdf, .svg or .dxf")
        ->required()
        ->type_name("FILE");
    command
        ->add_option("--paper", arguments->paper,
                     "a4, a3, a2, a1, a0, letter, legal, tabloid, or WIDTHxHEIGHT in mm; of a PDF")
        ->type_name("PAPER")
        ->capture_default_str();
    command->add_flag("--one-page", arguments->is_one_page,
                      "One page at true size for a plotter, as wide as the paper, or as the fabric of a layout");
    command
        ->add_option("--layers", arguments->layers,
                     "What is drawn: cut,sew,fold,grain,notches,drill,internal,labels (default: all); not for DXF")
        ->delimiter(',')
        ->type_name("LIST");
    command
        ->add_option("--allowance", arguments->allowance_mm,
                     "Seam allowance in mm where panel and edge name none (default: the garment's)")
        ->type_name("MM")
        ->check(CLI::Range(0.0, 100.0));
    command->add_flag("--all-pieces", arguments->prints_all,
                      "Draw mirror images, too, instead of \"cut 1 pair\"; SVG and DXF always do");
    command->add_flag("--astm", arguments->is_astm, "DXF by ASTM D6673 instead of AAMA: notches tell their kind");
    add_layout_options(*command, *arguments);
    command->footer(
        "A PDF has a cover with a 10 cm test square and a map, then pages that overlap by 1 cm. Print at 100 %.\n"
        "SVG and DXF are read back by selvedge import with the same outlines, notches and seams.\n"
        "Exit code: 0 written; 2 wrong input.\n"
        "Examples:\n"
        "  selvedge print patterns/tshirt.json -o tshirt.pdf --allowance 10\n"
        "  selvedge print patterns/tshirt.json -o layout.pdf --layout --fabric-width 140");
    command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace selvedge::app
