// selvedge bench thesis: the tables and figures of the thesis' chapters 3, 4 and 6, measured here.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

#include "app/bench.h"
#include "app/output_files.h"
#include "app/picture.h"
#include "bench/thesis/thesis.h"
#include "render/image/png.h"
#include "sim/core/error.h"
#include "sim/core/file.h"

namespace selvedge {
namespace {

struct ThesisArguments {
    std::vector<std::string> tables;
    std::vector<std::string> figures;
    std::string folder;
    std::string json;
    ThesisOptions options;
};

constexpr std::size_t kMostRows = 24;  // of a series, printed

using Names = std::vector<std::string>;

bool has(const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool any_of(const Names& names, const Names& wanted) {
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) { return has(wanted, name); });
}

void check_names(const Names& wanted, Names Experiment::*known, const char* option) {
    Names all;
    for (const Experiment& experiment : thesis_experiments())
        all.insert(all.end(), (experiment.*known).begin(), (experiment.*known).end());
    for (const std::string& name : wanted) {
        if (has(all, name)) continue;
        std::string list;
        for (const std::string& other : all) list += (list.empty() ? "" : ", ") + other;
        throw InputError("", option, "'" + name + "' is none of " + list);
    }
}

void check_folder(const std::string& folder) {
    if (folder.empty()) return;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error || access(folder.c_str(), W_OK | X_OK) != 0)
        throw InputError(folder, "", "cannot write: no such folder, and none can be made");
}

class Run {
 public:
    explicit Run(const ThesisArguments& arguments)
        : arguments_(arguments), wants_all_(arguments.tables.empty() && arguments.figures.empty()) {}

    bool wants(const Experiment& experiment) const {
        if (experiment.makes_pictures_only && arguments_.folder.empty()) return false;
        return wants_all_ || any_of(experiment.tables, arguments_.tables) ||
               any_of(experiment.figures, arguments_.figures);
    }

    void measure(const Experiment& experiment) {
        const ThesisResult result = experiment.measure(arguments_.options);
        for (const Table& table : result.tables)
            if (wants_all_ || has(arguments_.tables, table.name)) show(table);
        for (const Figure& figure : result.figures)
            if (wants_all_ || has(arguments_.figures, figure.series.name)) show(figure);
        for (const Capture& capture : result.captures)
            if (wants_all_ || has(arguments_.figures, capture.name)) show(capture);
    }

    Json document() const {
        Json document = document_of(tables_);
        document["figures"] = document_of(figures_)["tables"];
        return document;
    }

 private:
    void show(const Table& table) {
        print_table(table);
        tables_.push_back(table);
    }

    void show(const Figure& figure) {
        print_table(thinned(figure.series, kMostRows));
        figures_.push_back(figure.series);
        if (arguments_.folder.empty()) return;
        const std::string stem = "figure-" + figure.series.name;
        write_file_atomically(file(stem + ".csv"), to_csv(figure.series));
        std::printf("wrote %s\n", file(stem + ".csv").c_str());
        if (!figure.is_plotted) return;
        if (plot(figure, file(stem + ".png"))) {
            std::printf("wrote %s\n", file(stem + ".png").c_str());
        } else if (!std::exchange(has_said_no_plot_, true)) {
            std::printf("no plots: gnuplot is not installed, or failed\n");
        }
    }

    void show(const Capture& capture) {
        if (arguments_.folder.empty()) return;
        const std::string path = file("figure-" + capture.name + "-" + capture.moment + ".png");
        write_png(path, capture.image);
        std::printf("wrote %s\n", path.c_str());
    }

    std::string file(const std::string& name) const {
        return (std::filesystem::path(arguments_.folder) / name).string();
    }

    const ThesisArguments& arguments_;
    bool wants_all_;
    bool has_said_no_plot_ = false;
    std::vector<Table> tables_;
    std::vector<Table> figures_;
};

int run(const ThesisArguments& arguments) {
    check_names(arguments.tables, &Experiment::tables, "--table");
    check_names(arguments.figures, &Experiment::figures, "--figure");
    check_folder(arguments.folder);
    check_json_output(arguments.json);
    Run run(arguments);
    for (const Experiment& experiment : thesis_experiments()) {
        if (run.wants(experiment) && (experiment.makes_pictures_only || experiment.draws)) check_can_draw();
    }
    for (const Experiment& experiment : thesis_experiments()) {
        if (run.wants(experiment)) run.measure(experiment);
    }
    write_json_output(arguments.json, run.document());
    return 0;
}

}  // namespace

void add_bench_thesis(CLI::App& bench, int& exit_code) {
    auto arguments = std::make_shared<ThesisArguments>();
    CLI::App* command = bench.add_subcommand("thesis", "The thesis' tables and figures, measured here");
    command->add_option("--table", arguments->tables, "Only these tables, such as 3.1 (default: all)");
    command->add_option("--figure", arguments->figures, "Only these figures, such as 3.25 (default: all)");
    command
        ->add_option("--out", arguments->folder,
                     "Write figures here: series as CSV and plot, pictures (3.23, 3.24, 6.2, 6.3, 6.6) as PNG")
        ->type_name("DIR");
    command->add_flag("--quick", arguments->options.is_quick, "Tiny sizes, one run: does all work? Times mean nothing");
    add_json_option(*command, arguments->json);
    command->footer(
        "Examples:\n"
        "  selvedge bench thesis\n"
        "  selvedge bench thesis --table 3.1 3.14 --json drops.json\n"
        "  selvedge bench thesis --figure 3.25 --out figures");
    command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace selvedge
