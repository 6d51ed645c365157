// selvedge bench EXPERIMENT: repeatable measurements, reported as tables.
#include "bench/program/commands.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

#include "app/arguments.h"
#include "app/options.h"
#include "app/picture.h"
#include "app/progress_bar.h"
#include "bench/collide/collide.h"
#include "bench/contact/contact.h"
#include "bench/drop/report.h"
#include "bench/fabric/report.h"
#include "bench/picture/picture.h"
#include "bench/program/allocation_counter.h"
#include "bench/tshirt/rest.h"
#include "bench/tshirt/tshirt.h"
#include "render/image/image.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/parallel.h"
#include "sim/exchange/mesh_file.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge::bench {

void add_json_option(app::Command& command, std::string& path) {
    add_option(command, "--json", path, "Write the figures here too, as JSON", {.type = "FILE"});
}

void check_json_output(const std::string& path, const std::vector<std::filesystem::path>& inputs) {
    if (path.empty()) return;
    app::check_output(path);
    app::check_distinct({path}, inputs);
}

void print_table(const Table& table) {
    std::printf("%s\n", to_markdown(table).c_str());
    std::fflush(stdout);
}

void write_json_output(const std::string& path, const sim::Json& document) {
    if (!path.empty()) sim::write_file_atomically(path, write_json(document));
}

sim::Json document_of(const std::vector<Table>& tables) {
    sim::Json document = sim::Json::object();
    sim::Json& list = document["tables"] = sim::Json::array();
    for (const Table& table : tables) list.push_back(to_json(table));
    return document;
}

void add_commands(app::Command& program, int& exit_code) {
    require_command(program);
    set_footer(program, "Example: selvedge bench thesis --table 3.6 --json figures.json");
    add_bench_collide(program, exit_code);
    add_bench_contact(program, exit_code);
    add_bench_drop(program, exit_code);
    add_bench_fabric(program, exit_code);
    add_bench_motion(program, exit_code);
    add_bench_picture(program, exit_code);
    add_bench_rest(program, exit_code);
    add_bench_thesis(program, exit_code);
    add_bench_tshirt(program, exit_code);
}

// selvedge bench collide: the cost of collision handling against bodies with many triangles.

namespace {

struct CollideArguments {
    CollideOptions options;
    std::string json;
};

int run(const CollideArguments& arguments) {
    check_json_output(arguments.json);
    const std::vector<Table> tables = bench_collide(arguments.options);
    for (const Table& table : tables) print_table(table);
    write_json_output(arguments.json, document_of(tables));
    return 0;
}

}  // namespace

void add_bench_collide(app::Command& program, int& exit_code) {
    auto arguments = std::make_shared<CollideArguments>();
    app::Command& command = add_command(program, "collide", "Grid, tree and distance field round a dense body");
    add_option(command, "--triangles", arguments->options.triangles, "Bodies: about so many triangles each",
               {.type = "N", .shows_default = true, .range = app::Limits<int>{17184, 4000000}});
    add_option(command, "--points", arguments->options.points.points, "Points of cloth",
               {.shows_default = true, .range = app::Limits<int>{16, 1000000}});
    add_option(command, "--rounds", arguments->options.rounds, "Figures are medians of so many",
               {.shows_default = true, .range = app::Limits<int>{1, 1000}});
    add_json_option(command, arguments->json);
    set_footer(command, "Example: selvedge bench collide --triangles 67000 500000 --json collide.json");
    set_action(command, [arguments, &exit_code] { exit_code = run(*arguments); });
}

// selvedge bench contact: cloth against itself.

namespace {

struct ContactArguments {
    ContactExperiment experiment;
    std::string json;
};

int run(const ContactArguments& arguments) {
    check_json_output(arguments.json);
    app::ProgressBar bar(app::progress_bar_options(false));
    const std::vector<Table> tables = tables_of(measure_contact(arguments.experiment, bar.progress()));
    bar.finish();
    for (const Table& table : tables) print_table(table);
    write_json_output(arguments.json, document_of(tables));
    return 0;
}

}  // namespace

void add_bench_contact(app::Command& program, int& exit_code) {
    auto arguments = std::make_shared<ContactArguments>();
    app::Command& command =
        add_command(program, "contact", "Cloth that meets itself and other cloth, with and without");
    add_option(command, "GARMENT", arguments->experiment.pattern, "Garment file (default patterns/tshirt.json)",
               {.type = "FILE"});
    add_option(command, "--scene", arguments->experiment.only,
               "Run this scene only (\"garments\": the garment, once and over another)", {.type = "NAME"});
    add_option(command, "--rest", arguments->experiment.rest_seconds,
               "Time in s by which the scenes go on after what is measured (default 0)",
               {.type = "S", .range = app::Limits<double>{0.0, 60.0}});
    add_json_option(command, arguments->json);
    set_footer(command, "Example: selvedge bench contact --json contact.json");
    set_action(command, [arguments, &exit_code] { exit_code = run(*arguments); });
}

// selvedge bench drop: cloth dropped on a sphere, a common benchmark of cloth solvers.

namespace {

struct DropArguments {
    DropExperiment experiment;
    std::string json;
};

int run(const DropArguments& arguments) {
    check_json_output(arguments.json);
    app::ProgressBar bar(app::progress_bar_options(false));
    const DropReport report = measure_drop(arguments.experiment, bar.progress());
    bar.finish();
    for (const Table& table : tables_of(report)) print_table(table);
    write_json_output(arguments.json, to_json(report));
    return 0;
}

}  // namespace

void add_bench_drop(app::Command& program, int& exit_code) {
    auto arguments = std::make_shared<DropArguments>();
    DropExperiment& experiment = arguments->experiment;
    app::Command& command = add_command(program, "drop", "A square dropped on a sphere: time at equal quality");
    add_option(command, "--triangles", experiment.triangles, "1152, 4608, 15488 or 61952; the nearest is taken",
               {.range = app::Limits<int>{1, 1000000}});
    add_option(command, "--max-stretch", experiment.gates.max_stretch,
               "99th percentile of warp and weft stretch to be met (default 0.05)",
               {.range = app::Limits<double>{0.0001, 1.0}});
    add_option(command, "--substeps", experiment.substeps, "Sub-steps per frame, instead of searching for the least",
               {.range = app::Limits<int>{1, 10000}});
    add_option(command, "--most-substeps", experiment.max_substeps, "Where the search gives up (default 256)",
               {.range = app::Limits<int>{1, 10000}});
    add_option(command, "--repetitions", experiment.repetitions, "Timed runs of the chosen setting (default 5)",
               {.range = app::Limits<int>{1, 1000}});
    add_flag(command, "--timing-only{false}", experiment.passes_quality_checks,
             "Leave out rest, energy and the converged runs");
    add_json_option(command, arguments->json);
    set_footer(command, "Example: selvedge bench drop --triangles 15488 --max-stretch 0.05 --json drop.json");
    set_action(command, [arguments, &exit_code] { exit_code = run(*arguments); });
}

// selvedge bench fabric: virtual textile tests, compared with theory and published values.

namespace {

struct FabricArguments {
    FabricExperiment experiment;
    std::vector<std::string> tests;
    std::string json;
};

int run(const FabricArguments& arguments) {
    const std::vector<std::string>& fabrics = arguments.experiment.fabrics;
    check_json_output(arguments.json, {fabrics.begin(), fabrics.end()});
    for (const std::string& name : arguments.experiment.fabrics) sim::find_fabric(name);
    const sim::ThreadLimit limit(1);
    app::ProgressBar bar(app::progress_bar_options(false));
    std::vector<Table> tables;
    int rows = 0;
    int missed = 0;
    for (const std::string& test : arguments.tests.empty() ? textile_test_names() : arguments.tests) {
        const FabricTables measured = measure_fabrics(test, arguments.experiment, bar.progress());
        bar.finish();
        for (const Table& table : measured.tables) print_table(table);
        tables.insert(tables.end(), measured.tables.begin(), measured.tables.end());
        rows += measured.rows;
        missed += measured.missed;
    }
    std::printf("%d of %d rows with a gate missed it.\n", missed, rows);
    sim::Json document = document_of(tables);
    document["rows_with_a_gate"] = rows;
    document["rows_missed"] = missed;
    write_json_output(arguments.json, document);
    return 0;
}

}  // namespace

void add_bench_fabric(app::Command& program, int& exit_code) {
    auto arguments = std::make_shared<FabricArguments>();
    app::Command& command = add_command(program, "fabric", "Textile tests of the fabrics, against theory");
    add_option(command, "--fabric", arguments->experiment.fabrics, "Shipped fabrics or fabric files (default: all)",
               {.type = "NAME|FILE"});
    add_option(command, "--test", arguments->tests, "cantilever, strip, bias, drape, swing, energy (default: all)",
               {.one_of = textile_test_names()});
    add_flag(command, "--quick", arguments->experiment.is_quick, "Levels 1 and 2 at 17 degrees alone, four fabrics");
    add_option(command, "--substeps", arguments->experiment.stepping.substeps,
               "Sub-steps per step of 1/120 s (default 12, as when dressing)", {.range = app::Limits<int>{1, 1000}});
    add_json_option(command, arguments->json);
    set_footer(command, "Example: selvedge bench fabric --test cantilever --fabric denim --json fabric.json");
    set_action(command, [arguments, &exit_code] { exit_code = run(*arguments); });
}

// selvedge bench picture: the cost of the first picture and of the following ones.

namespace {

struct PictureArguments {
    std::string garment;
    app::BodyOptions body;
    PictureExperiment experiment;
    std::string json;
};

int run(const PictureArguments& arguments) {
    check_json_output(arguments.json, {arguments.garment});
    render::Scene scene;
    render::ClothItem cloth;
    cloth.mesh = sim::read_garment(arguments.garment);
    cloth.sett = sim::find_tartan(sim::kDefaultTartan);
    scene.cloths.push_back(std::move(cloth));
    if (!arguments.body.source.empty())
        scene.bodies.push_back(render::make_body_item(*app::make_body(arguments.body).body));
    const Table table = table_of(measure_pictures(scene, arguments.experiment));
    print_table(table);
    write_json_output(arguments.json, document_of({table}));
    return 0;
}

}  // namespace

void add_bench_picture(app::Command& program, int& exit_code) {
    auto arguments = std::make_shared<PictureArguments>();
    PictureExperiment& experiment = arguments->experiment;
    app::Command& command = add_command(program, "picture", "The first picture, and those after it");
    add_option(command, "MESH", arguments->garment, "Garment, as dress exports it (.obj or .glb)",
               {.is_required = true});
    app::add_body_options(command, arguments->body, "Body that wears it: a file, or mannequin[:bust=92,...]");
    add_option(command, "--triangles", experiment.triangles, "Of the cloth, at least (default 20000)",
               {.range = app::Limits<int>{1, 5000000}});
    add_option(command, "--pictures", experiment.pictures, "Of each kind (default 12)",
               {.range = app::Limits<int>{1, 1000}});
    add_option(command, "--side", experiment.render.width_px, "Of the square picture, px (default 1024)",
               {.range = app::Limits<int>{16, 8192}});
    add_json_option(command, arguments->json);
    set_footer(command,
               "Example:\n"
               "  selvedge dress patterns/tshirt.json --export tshirt.glb --export-body body.glb\n"
               "  selvedge bench picture tshirt.glb --body body.glb --json picture.json");
    set_action(command, [arguments, &exit_code] {
        arguments->experiment.render.height_px = arguments->experiment.render.width_px;
        exit_code = run(*arguments);
    });
}

// selvedge bench rest: the cost of simulating a garment at rest.

namespace {

struct RestArguments {
    RestExperiment experiment{.pattern = "patterns/tshirt.json"};
    std::string json;
};

int run(const RestArguments& arguments) {
    check_json_output(arguments.json, {arguments.experiment.pattern});
    app::ProgressBar bar(app::progress_bar_options(false));
    const Table table = table_of(measure_rest(arguments.experiment, bar.progress()));
    bar.finish();
    print_table(table);
    write_json_output(arguments.json, document_of({table}));
    return 0;
}

}  // namespace

void add_bench_rest(app::Command& program, int& exit_code) {
    auto arguments = std::make_shared<RestArguments>();
    app::Command& command = add_command(program, "rest", "A dressed garment at rest against the same pulled about");
    add_option(command, "GARMENT", arguments->experiment.pattern, "Garment file (default patterns/tshirt.json)",
               {.type = "FILE"});
    add_json_option(command, arguments->json);
    set_footer(command, "Example: selvedge bench rest patterns/tshirt.json");
    set_action(command, [arguments, &exit_code] { exit_code = run(*arguments); });
}

// selvedge bench tshirt: the cost of one adaptation and four simulation steps of a garment on a body.

namespace {

struct TshirtArguments {
    TshirtExperiment experiment{.pattern = "patterns/tshirt.json"};
    std::string json;
};

int run(const TshirtArguments& arguments) {
    check_json_output(arguments.json, {arguments.experiment.pattern});
    app::ProgressBar bar(app::progress_bar_options(false));
    const TshirtReport report = measure_tshirt(arguments.experiment, bar.progress());
    bar.finish();
    print_table(table_of(report));
    write_json_output(arguments.json, to_json(report));
    return 0;
}

}  // namespace

void add_bench_tshirt(app::Command& program, int& exit_code) {
    auto arguments = std::make_shared<TshirtArguments>();
    TshirtExperiment& experiment = arguments->experiment;
    experiment.sway.allocations = allocations_of_this_thread;
    app::Command& command = add_command(program, "tshirt", "One adaptation and four steps of a dressed garment");
    add_option(command, "GARMENT", experiment.pattern, "Garment file (default patterns/tshirt.json)", {.type = "FILE"});
    add_option(command, "--body-triangles", experiment.body_triangles,
               "Triangles of the body, at least (default 67000)", {.range = app::Limits<int>{1, 5000000}});
    add_option(command, "--min-leaves", experiment.min_leaves, "Refined until there are so many (default 6000)",
               {.range = app::Limits<int>{0, 1000000}});
    add_option(command, "--max-stretch", experiment.max_stretch,
               "Share of length, 99th percentile of warp and weft (default 0.05)",
               {.range = app::Limits<double>{1e-4, 1.0}});
    add_option(command, "--substeps", experiment.substeps, "Per step, instead of searching for the fewest",
               {.range = app::Limits<int>{1, 1000}});
    add_option(command, "--cycles", experiment.sway.cycles, "Adaptations that are measured (default 90)",
               {.range = app::Limits<int>{1, 100000}});
    add_flag(command, "--no-growth{false}", experiment.has_growth,
             "Leave out the other rows: a body of 500,000 triangles, the sub-steps of dressing, 25,000 leaves");
    add_json_option(command, arguments->json);
    set_footer(command, "Example: selvedge bench tshirt --json tshirt.json");
    set_action(command, [arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace selvedge::bench
