#include "app/print_files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string_view>
#include <system_error>

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/file_extension.h"
#include "sim/core/printable.h"
#include "sim/core/version.h"
#include "sim/print/dxf_file.h"
#include "sim/print/print_pdf.h"
#include "sim/print/svg_file.h"

namespace selvedge::app {
namespace {

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

std::string write_pdf(const sim::Pattern& pattern, const PrintSettings& settings, std::string& done) {
    const sim::PrintedPdf printed = print_pdf(pattern, {.paper = sim::parse_page_size(settings.paper),
                                                        .layers = choose_layers(settings.layers),
                                                        .is_one_page = settings.is_one_page,
                                                        .draws_mirror_images = settings.prints_all,
                                                        .are_halved = settings.is_on_fold});
    if (settings.is_one_page) {
        done = "one page";
    } else {
        done = sim::count_text(static_cast<std::size_t>(printed.pages), "page") + ", " +
               std::to_string(printed.columns) + " across and " + std::to_string(printed.rows) + " down, and a cover";
        const int left_out = printed.columns * printed.rows - printed.pages;
        if (left_out > 0)
            done +=
                " (" + std::to_string(left_out) + " left out, with no piece on " + (left_out == 1 ? "it)" : "them)");
    }
    return printed.bytes;
}

std::string write_layout(const sim::Pattern& pattern, const PrintSettings& settings, const std::string& extension,
                         const std::filesystem::path& file, Printed& printed) {
    const std::vector<sim::PaperSheet> layouts = cutting_layouts(
        pattern, {.width = settings.fabric_width, .is_one_way = settings.is_one_way, .is_folded = settings.is_folded});
    for (const sim::PaperSheet& layout : layouts) {
        printed.what += (printed.what.empty() ? "" : "; ") + describe_layout(layout);
        std::ranges::copy(layout.notes, std::back_inserter(printed.notes));
    }
    if (extension == ".pdf")
        return print_layouts(layouts, sim::parse_page_size(settings.paper), settings.is_one_page).bytes;
    if (layouts.size() > 1)
        throw sim::InputError(
            file.string(), "",
            "an SVG holds the layout of one fabric, and there are " + std::to_string(layouts.size()) + ": write a PDF");
    return svg_of(pattern, layouts.front(), choose_layers(settings.layers));
}

std::string write_svg(const sim::Pattern& pattern, const PrintSettings& settings, std::string& done) {
    constexpr double kWidth = 1.5;  // m
    const sim::PaperSheet sheet = paper_sheet(pattern, paper_pieces(pattern), kWidth);
    done = sheet_text(sheet);
    return svg_of(pattern, sheet, choose_layers(settings.layers));
}

// Now; or, for builds that are to be repeated, the seconds since 1970 in SOURCE_DATE_EPOCH.
std::time_t seconds_of_now() {
    constexpr std::int64_t kLast = 253402300799;  // s, the end of the year 9999
    const char* given = std::getenv("SOURCE_DATE_EPOCH");
    if (given == nullptr) return std::time(nullptr);
    const std::string_view text = given;
    std::int64_t seconds = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
    if (error != std::errc() || end != text.data() + text.size() || seconds < 0 || seconds > kLast)
        throw sim::InputError("", "SOURCE_DATE_EPOCH",
                              "'" + std::string(text.substr(0, 64)) + "' is no number of seconds since 1970");
    return seconds;
}

// In universal time.
sim::DxfStamp stamp_of_now() {
    const std::time_t seconds = seconds_of_now();
    std::tm parts{};
    gmtime_r(&seconds, &parts);
    std::array<char, 32> date{}, time{};
    std::strftime(date.data(), date.size(), "%d-%m-%Y", &parts);
    std::strftime(time.data(), time.size(), "%H:%M", &parts);
    return {.version = std::string(sim::program_version()), .date = date.data(), .time = time.data()};
}

bool has_allowance(const sim::Pattern& pattern) {
    return std::ranges::any_of(pattern.panels, [&](const sim::Panel& panel) {
        return std::ranges::any_of(panel.edges, [&](const sim::OutlineEdge& edge) {
            return allowance_of(panel, edge, pattern.allowance) > 0;
        });
    });
}

// Throws InputError for an option that the kind of file has no use for: it would be passed over without a word.
void refuse_idle_options(const std::string& extension, const PrintSettings& settings) {
    const auto refuse = [](bool is_given, const char* option, const char* problem) {
        if (is_given) throw sim::InputError("", option, problem);
    };
    const bool is_pdf = extension == ".pdf", is_dxf = extension == ".dxf";
    refuse(settings.is_on_fold && !is_pdf, "--on-fold", "only a PDF has halves to cut on a fold");
    refuse(settings.is_on_fold && settings.is_layout, "--on-fold", "a cutting layout has whole pieces, or --folded");
    refuse(settings.is_one_page && !is_pdf, "--one-page", "only a PDF has pages");
    refuse(!settings.layers.empty() && is_dxf, "--layers", "a DXF always has all layers of its standard");
    refuse(!settings.layers.empty() && is_pdf && settings.is_layout, "--layers",
           "a cutting layout in a PDF has its own");
    refuse(settings.is_astm && !is_dxf, "--astm", "only a DXF has it");
    refuse((settings.is_folded || settings.is_one_way) && !settings.is_layout,
           settings.is_folded ? "--folded" : "--one-way", "only a cutting layout has it: --layout");
}

}  // namespace

Printed print_pattern(const sim::Pattern& pattern, const std::filesystem::path& file, const PrintSettings& settings) {
    if (pattern.panels.empty()) throw sim::InputError(pattern.name, "", "no panels: nothing to print");
    Printed printed;
    if (!has_allowance(pattern)) printed.notes.emplace_back("no seam allowance: the sewing line is cut");
    const std::string extension = sim::lower_extension(file);
    refuse_idle_options(extension, settings);
    std::string bytes;
    if (settings.is_layout && extension != ".dxf") {
        bytes = write_layout(pattern, settings, extension, file, printed);
    } else if (settings.is_layout) {
        throw sim::InputError("", "--layout", "a cutting layout is a PDF or an SVG");
    } else if (extension == ".pdf") {
        bytes = write_pdf(pattern, settings, printed.what);
    } else if (extension == ".svg") {
        bytes = write_svg(pattern, settings, printed.what);
    } else {
        bytes = dxf_of(pattern, settings.is_astm ? sim::DxfStandard::Astm : sim::DxfStandard::Aama, stamp_of_now());
        printed.what = settings.is_astm ? "DXF-ASTM" : "DXF-AAMA";
    }
    sim::write_file_atomically(file, bytes);
    return printed;
}

std::string svg_of_pattern(const sim::Pattern& pattern) {
    std::string done;
    return write_svg(pattern, {}, done);
}

}  // namespace selvedge::app
