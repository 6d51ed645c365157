// selvedge match GARMENT: offsets the sett under each panel so that stripes continue across the seams, and writes the
// offsets into the garment file.
#include "sim/tartan/match.h"
#include "app/arguments.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/garment_options.h"
#include "app/options.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/json.h"
#include "sim/core/printable.h"
#include "sim/pattern/named_file.h"
#include "sim/pattern/pattern.h"
#include "sim/pattern/pattern_file.h"
#include "sim/tartan/named_tartan.h"
#include "sim/tartan/offset_graph.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge::app {
namespace {

using Path = std::filesystem::path;

constexpr std::size_t kMaxNames = 60;  // number of names to list in an error message

struct MatchArguments {
    Path garment;
    Path output;  // empty: the garment file itself
    Path json_file;
    std::vector<std::string> seams;
    std::string centre;  // name of a panel; empty: none
    std::string tartan;  // empty: the pattern's
    std::optional<double> sett_size_cm;
    bool is_dry = false;
};

// The names of the seams; only the first kMaxNames if there are more.
std::string known_names(const sim::Pattern& pattern) {
    std::string names;
    for (std::size_t i = 0; i < pattern.seams.size() && i < kMaxNames; ++i) {
        names += (names.empty() ? "" : ", ") + seam_name(pattern, pattern.seams[i]);
    }
    if (pattern.seams.empty()) return "none: nothing is sewn";
    return pattern.seams.size() > kMaxNames ? names + ", ..." : names;
}

std::vector<int> seams_of(const sim::Pattern& pattern, const std::vector<std::string>& names) {
    std::vector<int> seams;
    for (const std::string& name : names) {
        const std::vector<int> found = find_seams(pattern, name);
        if (found.empty())
            throw sim::InputError("", "--seams",
                                  "no seam '" + name.substr(0, 64) + "'; known are " + known_names(pattern));
        for (const int seam : found) {
            if (std::find(seams.begin(), seams.end(), seam) == seams.end()) seams.push_back(seam);
        }
    }
    return seams;
}

std::optional<int> centred_panel(const sim::Pattern& pattern, const std::string& name, const sim::Sett& sett) {
    if (name.empty()) return {};
    if (!warp_repeat(sett).mirror) throw sim::InputError("", "--centre", "the sett has no mirror to be centred");
    std::string known;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
        if (pattern.panels[p].name == name) return static_cast<int>(p);
        if (p < kMaxNames) known += (known.empty() ? "" : ", ") + pattern.panels[p].name;
    }
    throw sim::InputError("", "--centre", "no panel '" + name.substr(0, 64) + "'; known are " + known);
}

std::string tartan_of(const MatchArguments& arguments, const sim::Pattern& pattern) {
    if (!arguments.tartan.empty()) return arguments.tartan;
    if (pattern.tartan.empty())
        throw sim::InputError(arguments.garment.string(), "selvedge.tartan", "names no tartan to match: --tartan");
    return pattern.tartan;
}

// m. The pattern's size applies only to the pattern's own tartan.
std::optional<double> sett_size(const MatchArguments& arguments, const sim::Pattern& pattern) {
    if (arguments.sett_size_cm) return *arguments.sett_size_cm / 100;
    return arguments.tartan.empty() ? pattern.sett_size : std::nullopt;
}

sim::Sett sett_of(const MatchArguments& arguments, const sim::Pattern& pattern) {
    const std::string name = tartan_of(arguments, pattern);
    const sim::Sett sett = arguments.tartan.empty()
                               ? sim::named_tartan(name, arguments.garment.string(), "selvedge.tartan")
                               : sim::named_tartan(name, "", "--tartan");
    const std::optional<double> size = sett_size(arguments, pattern);
    return size ? with_repeat_size(sett, *size) : sett;
}

std::vector<Path> outputs_of(const MatchArguments& arguments) {
    std::vector<Path> outputs;
    if (!arguments.is_dry) outputs.push_back(arguments.output.empty() ? arguments.garment : arguments.output);
    if (!arguments.json_file.empty()) outputs.push_back(arguments.json_file);
    return outputs;
}

void check_arguments(const MatchArguments& arguments) {
    const std::optional<double>& size = arguments.sett_size_cm;
    if (size && !(*size >= 0.1 && *size <= 500)) throw sim::InputError("", "--sett-size", "must be from 0.1 to 500 cm");
    const std::vector<Path> outputs = outputs_of(arguments);
    if (!arguments.is_dry) check_output(outputs.front(), kGarmentExtensions);
    if (!arguments.json_file.empty()) check_output(arguments.json_file);
    check_distinct(outputs, {});
    if (!arguments.json_file.empty()) check_distinct({arguments.json_file}, {arguments.garment});
}

// Rounds to multiples of 1/parts, so that the decimal text is short.
double rounded(double value, double parts) {
    return std::round(value * parts) / parts + 0.0;
}

std::string to_json(const sim::SettMatch& match, const sim::MatchedSett& sett) {
    sim::Json seams = sim::Json::array();
    for (const sim::SeamMatch& seam : match.seams) {
        sim::Json entry = sim::Json::object();
        entry["name"] = seam.name;
        entry["length_m"] = rounded(seam.length, 1e5);
        entry["before_mm"] = rounded(1e3 * seam.before, 1e3);
        entry["after_mm"] = rounded(1e3 * seam.after, 1e3);
        entry["rms_before_mm"] = rounded(1e3 * seam.rms_before, 1e3);
        entry["rms_after_mm"] = rounded(1e3 * seam.rms_after, 1e3);
        entry["met"] = rounded(seam.met, 1e3);
        if (!seam.why.empty()) entry["why"] = seam.why;
        seams.push_back(std::move(entry));
    }
    sim::Json root = sim::Json::object();
    root["tartan"] = sett.tartan;
    root["repeat_m"] = sim::Json::array({rounded(sett.repeat.x(), 1e6), rounded(sett.repeat.y(), 1e6)});
    root["seams"] = std::move(seams);
    return write_json(root);
}

void print_table(const sim::SettMatch& match, const sim::MatchedSett& sett) {
    std::printf("%s, repeat %.1f cm", sim::printable(sett.tartan).c_str(), 100 * sett.repeat.x());
    if (sett.repeat.x() != sett.repeat.y()) std::printf(", of the weft %.1f cm", 100 * sett.repeat.y());
    std::printf("\n");
    if (match.seams.empty()) return void(std::printf("no seams: nothing to match\n"));
    std::size_t width = 4;
    for (const sim::SeamMatch& seam : match.seams) width = std::max(width, std::min<std::size_t>(seam.name.size(), 60));
    std::printf("%-*s %9s %10s %9s %7s\n", static_cast<int>(width), "seam", "length cm", "before mm", "after mm",
                "met %");
    for (const sim::SeamMatch& seam : match.seams) {
        std::printf("%-*s %9.1f %10.1f %9.1f %7.0f%s%s\n", static_cast<int>(width), sim::printable(seam.name).c_str(),
                    100 * seam.length, 1e3 * seam.before, 1e3 * seam.after, 100 * seam.met,
                    seam.why.empty() ? "" : "  ", sim::printable(seam.why).c_str());
    }
}

int run(const MatchArguments& arguments) {
    check_arguments(arguments);
    sim::PatternDocument document = sim::load_pattern(arguments.garment);
    const auto newer = newer_format(document.json);
    if (newer && !arguments.is_dry) throw sim::InputError(arguments.garment.string(), "selvedge.format", *newer);
    sim::Pattern& pattern = document.pattern;
    const std::vector<std::string> named = named_files(pattern);
    check_distinct(outputs_of(arguments), {named.begin(), named.end()});
    const sim::Sett sett = sett_of(arguments, pattern);
    const sim::SettMatch match = match_sett(pattern, sett,
                                            {.first_seams = seams_of(pattern, arguments.seams),
                                             .centred_panel = centred_panel(pattern, arguments.centre, sett)});
    const sim::MatchedSett matched{.tartan = tartan_of(arguments, pattern),
                                   .repeat = Vec2d(repeat_size(sett), weft_repeat_size(sett))};
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) pattern.panels[p].sett_offset = match.offsets[p];
    pattern.matched_sett = matched;
    pattern.sett_size = sett_size(arguments, pattern);
    if (!arguments.tartan.empty()) pattern.tartan = matched.tartan;  // the offsets are valid only for this tartan

    tell_warnings(document.warnings);
    print_table(match, matched);
    if (!arguments.json_file.empty()) sim::write_file_atomically(arguments.json_file, to_json(match, matched));
    if (arguments.is_dry) return 0;
    const Path& target = arguments.output.empty() ? arguments.garment : arguments.output;
    save_pattern(document, target);
    std::printf("wrote %s\n", sim::printable(target.string()).c_str());
    return 0;
}

}  // namespace

void add_match_command(Command& app, int& exit_code) {
    auto arguments = std::make_shared<MatchArguments>();
    Command& command = add_command(app, "match", "Match the tartan at a garment's seams");
    add_option(command, "GARMENT", arguments->garment, "Garment file (patterns/FORMAT.md)",
               {.type = "FILE", .is_required = true});
    add_option(command, "-o,--output", arguments->output, "Garment file to write (default: GARMENT itself)",
               {.type = "FILE"});
    add_option(command, "--seams", arguments->seams,
               "Seams to match first, the most important first (default: the longest). Names as the table has "
               "them, or labels of edges",
               {.type = "NAME,...", .takes_one_value = true, .delimiter = ','});
    add_option(command, "--centre", arguments->centre,
               "Panel in whose middle the sett should mirror, where seams leave the choice (default: the first "
               "panel stays)",
               {.type = "PANEL"});
    add_option(command, "--tartan", arguments->tartan,
               "A shipped tartan or a threadcount, which becomes the garment's (default: the garment's)",
               {.type = "NAME"});
    add_option(command, "--sett-size", arguments->sett_size_cm, "Size of the tartan's repeat in cm (default its own)",
               {.type = "CM"});
    add_option(command, "--json", arguments->json_file, "The table as JSON", {.type = "JSON"});
    add_flag(command, "--dry-run", arguments->is_dry, "Find and show, but leave the garment as it is");
    set_footer(
        command,
        "Before and after: the largest distance along the seam, across the stripes, from where a stripe arrives to "
        "where\n"
        "the other side goes on with it; stripes that meet the seam at less than 15 degrees do not count. met: the "
        "share\n"
        "of the seam where they meet within 2 mm. A seam with ease or gathers is matched from its lower end, or in "
        "its\n"
        "middle if it lies level.\n"
        "Exit code: 0 done, whatever could be matched; 2 wrong input or a file that could not be written.\n"
        "Examples:\n"
        "  selvedge match tshirt.json\n"
        "  selvedge match skirt.json -o matched.json --seams front.1+back.2,front.3+back.0 --tartan gordon\n"
        "  selvedge match tshirt.json --dry-run --sett-size 12 --json seams.json");
    set_action(command, [arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace selvedge::app
