// selvedge bench thesis: the tables and figures of the thesis, measured with this program, and one HTML page of them.
#include <unistd.h>
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <utility>

#include "app/actor.h"
#include "app/arguments.h"
#include "app/edit.h"
#include "app/options.h"
#include "app/picture.h"
#include "bench/program/commands.h"
#include "bench/support/plot.h"
#include "bench/thesis/page.h"
#include "bench/thesis/thesis.h"
#include "render/image/image.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/parallel.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::bench {
namespace {

struct ThesisArguments {
    std::vector<std::string> tables;
    std::vector<std::string> figures;
    std::string folder;
    std::string json;
    app::BodyOptions body;  // of chapter 5 and experiment C; empty: the mannequin
    std::string motion;     // empty: walk
    ThesisOptions options;
};

constexpr std::size_t kMaxRows = 24;  // printed rows of a series
constexpr const char* kPageFile = "index.html";

using Names = std::vector<std::string>;

bool has(const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool any_of(const Names& names, const Names& wanted) {
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) { return has(wanted, name); });
}

// Figure 4.2: the pattern editor with the vertices of a triangle selected for scaling. Its journal goes to a folder of
// its own, which is removed.
ThesisResult draw_editor(const ThesisOptions& options) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path folder = fs::temp_directory_path(error);
    if (error) throw sim::InputError(folder.string(), "", "no folder for temporary files: " + error.message());
    std::string state = (folder / "selvedge-figure-XXXXXX").string();
    if (mkdtemp(state.data()) == nullptr) throw sim::InputError(state, "", "cannot make this folder");
    app::EditorScript script{
        .file = options.tshirt.string(),
        .text = "key t\nclick vertex front 2\nclick vertex front 3 shift\nclick vertex front 4 shift\n",
        .name = "figure 4.2",
        .state = state};
    if (!options.is_quick) script.width_px = 1600, script.height_px = 1000;
    ThesisResult result{.captures = {{"4.2", "editor", app::play_script(script)}}};
    std::error_code ignored;
    fs::remove_all(state, ignored);
    return result;
}

// Those of bench/thesis, and the one that needs the editor.
std::vector<Experiment> all_experiments() {
    std::vector<Experiment> all = thesis_experiments();
    all.push_back({{}, {"4.2"}, draw_editor, true});
    return all;
}

void check_names(const Names& wanted, Names Experiment::*known, const char* option) {
    Names all;
    for (const Experiment& experiment : all_experiments())
        all.insert(all.end(), (experiment.*known).begin(), (experiment.*known).end());
    for (const std::string& name : wanted) {
        if (has(all, name)) continue;
        std::string list;
        for (const std::string& other : all) list += (list.empty() ? "" : ", ") + other;
        throw sim::InputError("", option, "'" + name + "' is none of " + list);
    }
}

void make_result_folder(const std::string& folder) {
    if (folder.empty()) return;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error || access(folder.c_str(), W_OK | X_OK) != 0)
        throw sim::InputError(folder, "", "cannot write: no such folder, and none can be made");
}

// Conditions that hold in every experiment.
std::vector<std::string> conditions() {
    return {
        "The simulation runs on one thread. Times of simulation, adaptation, collision and surfaces are CPU times of "
        "that thread; times of drawing are wall-clock times of the software renderer, with all its threads.",
        "Settings are the product's own (listing 3.5), except those that a caption or the note under a table names.",
        "Times depend on the machine; counts, shapes and pictures do not: the same program gives the same ones on "
        "every "
        "processor of one type."};
}

class Run {
 public:
    explicit Run(const ThesisArguments& arguments)
        : arguments_(arguments), wants_all_(arguments.tables.empty() && arguments.figures.empty()) {
        page_.experiments = all_experiments();
        page_.conditions = conditions();
        page_.is_quick = arguments.options.is_quick;
    }

    bool wants(const Experiment& experiment) const {
        if (experiment.makes_pictures_only && arguments_.folder.empty()) return false;
        return wants_all_ || any_of(experiment.tables, arguments_.tables) ||
               any_of(experiment.figures, arguments_.figures);
    }

    void measure(const Experiment& experiment) {
        const ThesisResult result = experiment.measure(arguments_.options);
        for (const Table& table : result.tables)
            if (wants_table(table.name)) show(table);
        for (const Figure& figure : result.figures)
            if (wants_figure(figure.series.name)) show(figure);
        for (const Drawing& drawing : result.drawings)
            if (wants_figure(drawing.name)) show(drawing);
        for (const Capture& capture : result.captures)
            if (wants_figure(capture.name)) show(capture);
        for (const Trend& trend : result.trends)
            if (wants_item(trend.item)) show(trend);
    }

    void write_page() const {
        if (arguments_.folder.empty()) return;
        sim::write_file_atomically(file(kPageFile), to_html(page_));
        std::printf("wrote %s\n", file(kPageFile).c_str());
    }

    sim::Json document() const {
        sim::Json document = document_of(page_.tables);
        document["figures"] = document_of(figures_)["tables"];
        sim::Json& trends = document["trends"] = sim::Json::array();
        for (const Trend& trend : page_.trends) {
            sim::Json json = sim::Json::object();
            json["item"] = trend.item;
            json["reported"] = trend.reported;
            json["measured"] = trend.measured;
            json["agrees"] = trend.agrees;
            trends.push_back(std::move(json));
        }
        return document;
    }

 private:
    // A table that is named after a figure, such as "figure-3.9", comes with the figure.
    bool wants_table(const std::string& name) const {
        constexpr std::string_view kPrefix = "figure-";
        const bool is_of_figure = name.starts_with(kPrefix) && has(arguments_.figures, name.substr(kPrefix.size()));
        return wants_all_ || is_of_figure || has(arguments_.tables, name);
    }
    bool wants_figure(const std::string& name) const { return wants_all_ || has(arguments_.figures, name); }

    // item: such as "T3.2", "F3.9", "L3.1".
    bool wants_item(const std::string& item) const {
        const std::string number = item.substr(1);
        if (item.front() == 'F') return wants_figure(number);
        return wants_table(item.front() == 'L' ? "listing-" + number : number);
    }

    void show(const Table& table) {
        print_table(table);
        page_.tables.push_back(table);
    }

    void show(const Figure& figure) {
        print_table(thinned(figure.series, kMaxRows));
        figures_.push_back(figure.series);
        if (arguments_.folder.empty()) return;
        const std::string stem = "figure-" + figure.series.name;
        write(stem + ".csv", to_csv(figure.series));
        PageDrawing drawing{.name = figure.series.name,
                            .title = figure.series.title,
                            .note = figure.series.note,
                            .svg = to_svg(plot_of(figure)),
                            .data_file = stem + ".csv"};
        write(stem + ".svg", drawing.svg);
        page_.drawings.push_back(std::move(drawing));
    }

    void show(const Drawing& drawing) {
        if (arguments_.folder.empty()) return;
        write("figure-" + drawing.name + ".svg", drawing.svg);
        page_.drawings.push_back({.name = drawing.name, .title = drawing.title, .svg = drawing.svg});
    }

    void show(const Capture& capture) {
        if (arguments_.folder.empty()) return;
        const std::string name = "figure-" + capture.name + "-" + capture.moment + ".png";
        write_png(file(name), capture.image);
        std::printf("wrote %s\n", file(name).c_str());
        page_.pictures.push_back({.name = capture.name, .file = name, .moment = capture.moment});
    }

    void show(const Trend& trend) {
        std::printf("%s %s. The thesis: %s Here: %s\n\n", trend.item.c_str(), trend.agrees ? "agrees" : "differs",
                    trend.reported.c_str(), trend.measured.c_str());
        page_.trends.push_back(trend);
    }

    void write(const std::string& name, const std::string& text) const {
        sim::write_file_atomically(file(name), text);
        std::printf("wrote %s\n", file(name).c_str());
    }

    std::string file(const std::string& name) const {
        return (std::filesystem::path(arguments_.folder) / name).string();
    }

    const ThesisArguments& arguments_;
    bool wants_all_;
    ThesisPage page_;
    std::vector<Table> figures_;
};

// The body and the motion that were asked for.
void find_actor(ThesisArguments& arguments) {
    if (arguments.body.source.empty() && arguments.motion.empty()) return;
    if (arguments.body.source.empty()) arguments.body.source = "mannequin";
    app::Actor actor = app::make_actor(arguments.body, {.name = arguments.motion.empty() ? "walk" : arguments.motion});
    arguments.options.body = std::move(actor.body);
    arguments.options.motion = std::move(actor.clip);
}

int run(ThesisArguments arguments) {
    check_names(arguments.tables, &Experiment::tables, "--table");
    check_names(arguments.figures, &Experiment::figures, "--figure");
    make_result_folder(arguments.folder);
    check_json_output(arguments.json, {arguments.options.tshirt});
    find_actor(arguments);
    const sim::ThreadLimit one(1);
    Run run(arguments);
    for (const Experiment& experiment : all_experiments()) {
        if (!run.wants(experiment)) continue;
        if (experiment.makes_pictures_only || experiment.draws) render::check_can_draw();
        if (has(experiment.figures, "4.12") || has(experiment.figures, "4.2"))
            sim::load_pattern(arguments.options.tshirt);  // throws before long work
        if (has(experiment.figures, "5.9") || has(experiment.figures, "6.10"))
            sim::load_pattern(arguments.options.dress);  // likewise
    }
    for (const Experiment& experiment : all_experiments()) {
        if (run.wants(experiment)) run.measure(experiment);
    }
    run.write_page();
    write_json_output(arguments.json, run.document());
    return 0;
}

}  // namespace

void add_bench_thesis(app::Command& program, int& exit_code) {
    auto arguments = std::make_shared<ThesisArguments>();
    app::Command& command = add_command(program, "thesis", "The thesis' tables and figures, measured here");
    add_option(command, "--table", arguments->tables, "Only these tables, such as 3.1 or listing-3.1 (default: all)");
    add_option(command, "--figure", arguments->figures, "Only these figures, such as 3.25 (default: all)");
    add_option(command, "--out", arguments->folder,
               "Write a page here (index.html) with every item, and its figures as SVG, CSV and PNG", {.type = "DIR"});
    add_option(command, "--tshirt", arguments->options.tshirt, "Garment of figures 4.3 and 4.11 to 4.13",
               {.type = "FILE", .shows_default = true});
    add_option(command, "--dress", arguments->options.dress, "Garment of chapter 5, table 6.4, figures 6.7 and 6.10",
               {.type = "FILE", .shows_default = true});
    app::add_body_options(command, arguments->body, "Body with bones that wears it (default: the mannequin)");
    add_option(command, "--motion", arguments->motion, "What it does, a loop (default walk)", {.type = "NAME|FILE"});
    add_flag(command, "--quick", arguments->options.is_quick, "Tiny sizes, one run: does all work? Times mean nothing");
    add_json_option(command, arguments->json);
    set_footer(command,
               "Examples:\n"
               "  selvedge bench thesis --out figures\n"
               "  selvedge bench thesis --table 3.1 3.14 --json drops.json\n"
               "  selvedge bench thesis --figure 3.16 4.12 --out figures");
    set_action(command, [arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace selvedge::bench
