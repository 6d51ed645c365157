// selvedge dress GARMENT: puts a garment on a body; writes pictures, meshes and a report.
#include "sim/session/dress.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/dress_command.h"
#include "app/film.h"
#include "app/garment_files.h"
#include "app/garment_options.h"
#include "app/options.h"
#include "app/picture.h"
#include "app/progress_bar.h"
#include "app/refused_report.h"
#include "app/report_inputs.h"
#include "render/image/image.h"
#include "render/output/interface_fonts.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/parallel.h"
#include "sim/core/passing_error.h"
#include "sim/core/printable.h"
#include "sim/dress/dressing.h"
#include "sim/exchange/garmentcode_element.h"
#include "sim/exchange/mesh_file.h"
#include "sim/inspection/report.h"
#include "sim/pattern/pattern_file.h"
#include "sim/tartan/match.h"

namespace selvedge::app {
namespace {

using Path = std::filesystem::path;

std::vector<Path> all_outputs(const DressArguments& arguments) {
    std::vector<Path> outputs = outputs_of(arguments.exports, arguments.garment.garment);
    outputs.insert(outputs.end(), arguments.body_files.begin(), arguments.body_files.end());
    for (const Path& file : {arguments.picture_file, arguments.report_file, arguments.turntable.file}) {
        if (!file.empty()) outputs.push_back(file);
    }
    return outputs;
}

void check_outputs(const DressArguments& arguments) {
    if (!arguments.picture_file.empty()) check_output(arguments.picture_file, kPictureExtensions);
    if (!arguments.report_file.empty()) check_output(arguments.report_file);
    check_turntable(arguments.turntable, arguments.picture);
    if (arguments.garment.coarsens_back_faces && !arguments.turntable.file.empty())
        throw sim::InputError("", "--coarse-back-faces", "a turntable shows all sides");
    check_garment_files(arguments.exports);
    for (const Path& file : arguments.body_files) check_output(file, sim::mesh_extensions());
    check_distinct(all_outputs(arguments), input_files(arguments.garment, arguments.body));
}

bool draws(const DressArguments& arguments) {
    return !arguments.picture_file.empty() || !arguments.turntable.file.empty();
}

// The files that were written, and the failures.
struct Writing {
    std::vector<std::string> written;
    std::vector<sim::InputError> failures;
};

// One line for all files that one problem, such as a full disk, kept from being written.
std::vector<std::string> failure_lines(const std::vector<sim::InputError>& failures) {
    std::vector<std::pair<std::string, std::string>> files_by_problem;
    for (const sim::InputError& failure : failures) {
        const std::string problem = sim::fault_line("", failure.place(), failure.problem());
        const auto same = std::ranges::find(files_by_problem, problem, &std::pair<std::string, std::string>::second);
        if (same == files_by_problem.end()) {
            files_by_problem.emplace_back(failure.file(), problem);
        } else {
            same->first += ", " + failure.file();
        }
    }
    std::vector<std::string> lines;
    for (const auto& [files, problem] : files_by_problem) lines.push_back(sim::fault_line(files, "", problem));
    return lines;
}

// Of several garments, the pattern is a new document.
sim::PatternDocument document_of(const GarmentOptions& garment, const sim::Pattern& pattern) {
    if (!garment.over.empty()) return {.pattern = pattern, .json = {}};
    return sim::load_pattern(garment.garment);
}

void write_report(const DressArguments& arguments, const sim::DressReport& report) {
    if (arguments.times_file.empty()) return sim::write_file_atomically(arguments.report_file, to_json(report));
    sim::write_file_atomically(arguments.report_file, write_json(json_without_times(report)));
    sim::write_file_atomically(arguments.times_file, write_json(times_json(report)));
}

// Tries to write every file, even if others fail: a garment with non-finite positions has no mesh to export, but has a
// report.
Writing write_outputs(const DressArguments& arguments, const sim::Pattern& pattern, const sim::DressedGarment& dressed,
                      const sim::Body& body) {
    Writing writing;
    const RenderSubject subject{.garment = dressed.mesh, .body = &body, .hierarchy = &dressed.hierarchy};
    const auto write = [&](const Path& file, const auto& how) {
        try {
            how(file);
            writing.written.push_back(file.string());
        } catch (const sim::InputError& error) {
            writing.failures.push_back(error);
        }
    };
    if (!arguments.report_file.empty()) {
        write(arguments.report_file, [&](const Path&) { write_report(arguments, dressed.report); });
    }
    GarmentFiles exports(arguments.exports, arguments.picture, dressed.mesh, body);
    for (const Path& file : arguments.exports.files)
        write(file, [&](const Path& mesh_file) { exports.write(mesh_file); });
    if (!arguments.exports.garmentcode_folder.empty()) {
        write(arguments.exports.garmentcode_folder, [&](const Path& folder) {
            write_garmentcode_element(dressed.mesh, document_of(arguments.garment, pattern), dressed.meshing, folder,
                                      element_name(arguments.garment.garment));
        });
    }
    for (const Path& file : arguments.body_files)
        write(file, [&](const Path& mesh_file) { write_body(body, mesh_file); });
    if (!arguments.picture_file.empty()) {
        write(arguments.picture_file,
              [&](const Path& file) { write_png(file, draw_picture(subject, arguments.picture)); });
    }
    if (!arguments.turntable.file.empty()) {
        write(arguments.turntable.file, [&](const Path&) {
            ProgressBar bar(progress_bar_options(arguments.garment.is_quiet));
            write_turntable(subject, arguments.picture, arguments.turntable, bar.progress());
        });
    }
    return writing;
}

void print_summary(const sim::DressReport& report) {
    std::printf("%s on %s: %d triangles (%d before refining), ", sim::printable(report.garment).c_str(),
                sim::printable(report.body).c_str(), report.mesh.leaf_triangles, report.mesh.base_triangles);
    if (report.settled) {
        std::printf("settled after %.2f simulated seconds\n", report.simulated_seconds);
    } else {
        std::printf("stopped after %.2f simulated seconds: %s\n", report.simulated_seconds,
                    report.stopped_because.c_str());
    }
    for (const std::string& note : report.notes) std::printf("note: %s\n", sim::printable(note).c_str());
}

// Offsets matched for one sett are not valid for another.
void print_sett_note(const sim::Pattern& pattern, const PictureOptions& picture) {
    if (!pattern.matched_sett) return;
    const sim::MatchedSett& matched = *pattern.matched_sett;
    if (!is_sett_of(matched, chosen_sett(picture))) {
        std::printf(
            "note: the setts were matched for %s, repeat %.4g cm, and may not meet at the seams (selvedge match)\n",
            sim::printable(matched.tartan).c_str(), 100 * matched.repeat.x());
    }
}

std::shared_ptr<const sim::PreparedBody> prepared_body(const BodyOptions& options, const KnownBodies& known,
                                                       const sim::Progress& progress) {
    std::shared_ptr<const sim::PreparedBody> ready = known.ready == nullptr ? nullptr : known.ready->find(options);
    if (ready) return ready;
    sim::report(progress, "reading the body", 0);
    return prepare_body(options, known.store);
}

int dress_and_write(DressArguments& arguments, sim::DressReport& refused, const KnownBodies& known) {
    std::vector<std::string> notes;
    const sim::Pattern pattern = load_garments(arguments.garment, notes);
    refused.garment = pattern.name;
    name_inputs(arguments.garment, arguments.body, arguments.picture, pattern);
    check_distinct(all_outputs(arguments), input_files(arguments.garment, arguments.body));
    refused.inputs = report_inputs(arguments.garment, arguments.body, *arguments.picture.pattern);
    refused.options = arguments.garment.dress;
    fill_in(arguments.garment, arguments.picture, pattern);
    refused.options = arguments.garment.dress;
    if (draws(arguments)) {
        check_can_draw(arguments.picture);
        arguments.picture.legend_font = render::read_legend_font();
    }

    std::optional<sim::ThreadLimit> limit;
    if (arguments.garment.threads) limit.emplace(*arguments.garment.threads);
    check_layers(pattern, arguments.garment.dress);
    check_size(pattern);
    ProgressBar bar(progress_bar_options(arguments.garment.is_quiet));
    const auto start = std::chrono::steady_clock::now();
    const auto prepared = prepared_body(arguments.body, known, bar.progress());
    const double body_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const sim::Body& body = prepared->body();
    refused.body = body.name;
    sim::DressedGarment dressed = dress(pattern, prepared, arguments.garment.dress, bar.progress(), known.store);
    bar.finish();
    sim::DressReport& report = dressed.report;
    report.timing.wall_s += body_s;
    report.timing.phases_s["body"] += body_s;
    report.inputs = refused.inputs;
    std::ranges::copy(prepared->made().notes, std::back_inserter(notes));
    report.notes.insert(report.notes.begin(), notes.begin(), notes.end());

    const Writing writing = write_outputs(arguments, pattern, dressed, body);
    if (!arguments.garment.is_quiet) print_summary(report);
    if (!arguments.garment.is_quiet && draws(arguments)) print_sett_note(pattern, arguments.picture);
    print_faults(report);
    if (!arguments.garment.is_quiet)
        for (const std::string& file : writing.written) std::printf("wrote %s\n", sim::printable(file).c_str());
    for (const std::string& line : failure_lines(writing.failures))
        std::fprintf(stderr, "selvedge: %s\n", line.c_str());
    return writing.failures.empty() ? exit_code_of(outcome_of(report)) : 2;
}

void add_run_options(Command& command, DressArguments& arguments) {
    add_number<double>(command, "--seconds", sim::kDrapeSeconds,
                       "Longest simulated time of the drape, in frames of 1/30 s (default 12)", {.type = "S"},
                       [&arguments](double seconds) { arguments.garment.dress.max_seconds = seconds; });
}

void add_output_options(Command& command, DressArguments& arguments) {
    const auto add = [&](const char* name, auto& files, const char* help, const char* type) {
        add_option(command, name, files, help, {.type = type, .group = "Output", .takes_one_value = true});
    };
    add("--render", arguments.picture_file, "Picture of the dressed body", "PNG");
    add_garment_file_options(command, arguments.exports);
    add("--export-body", arguments.body_files, "The body as .obj, .glb, .ply or .stl; may be repeated", "FILE");
    add("--report", arguments.report_file, "What came of it, as JSON", "JSON");
}

}  // namespace

// What is refused has a report too: one of an earlier run would lie. What may pass is not refused.
int run_dress(DressArguments arguments, const KnownBodies& known) {
    check_outputs(arguments);
    sim::DressReport refused;
    try {
        return dress_and_write(arguments, refused, known);
    } catch (const sim::PassingError&) {
        throw;
    } catch (const sim::InputError& error) {
        if (!arguments.report_file.empty()) {
            check_distinct({arguments.report_file}, input_files(arguments.garment, arguments.body));
            refused.problem = error.what();
            write_report(arguments, refused);
        }
        throw ReportedError(error);
    }
}

void add_dress_options(Command& command, DressArguments& arguments) {
    add_garment_options(command, arguments.garment);
    add_run_options(command, arguments);
    add_thread_options(command, arguments.garment);
    add_body_options(command, arguments.body,
                     "Body that wears it: mannequin[:sex=female,bust=92,...] or a file (default: the pattern's, or "
                     "mannequin:sex=female)");
    add_picture_options(command, arguments.picture);
    add_output_options(command, arguments);
    add_turntable_options(command, arguments.turntable);
}

void add_dress_command(Command& app, int& exit_code) {
    auto arguments = std::make_shared<DressArguments>();
    Command& command = add_command(app, "dress", "Put a garment on a body");
    add_dress_options(command, *arguments);
    set_footer(
        command,
        "Exit code: 0 dressed, 2 wrong input or a file that could not be written, 3 dressed with a defect of the "
        "drape,\n"
        "4 dressed well, but the garment does not fit the body.\n"
        "Examples:\n"
        "  selvedge dress patterns/tshirt.json --render tshirt.png\n"
        "  selvedge dress patterns/skirt.json --body mannequin:waist=68,hip=96 --tartan 'Black Watch' \\\n"
        "      --render skirt.png --view three-quarter --export skirt.glb --export-body body.glb\n"
        "  selvedge dress patterns/tshirt.json --over patterns/vest.json --render layers.png\n"
        "  selvedge dress patterns/tshirt.json --show hierarchy --render levels.png --turntable levels.mp4\n"
        "  selvedge dress patterns/tshirt.json --body scan.obj --body-unit cm --fabric silk --report tshirt.json");
    set_action(command, [arguments, &exit_code] { exit_code = run_dress(*arguments); });
}

}  // namespace selvedge::app
