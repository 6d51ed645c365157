// selvedge bench EXPERIMENT: repeatable measurements, reported as tables.
#include "bench/program/commands.h"

#include <unistd.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

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

void add_json_option(CLI::App& command, std::string& path) {
    command.add_option("--json", path, "Write the figures here too, as JSON")->type_name("FILE");
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

void add_commands(CLI::App& program, int& exit_code) {
    program.require_subcommand(1);
    program.footer("Example: selvedge bench thesis --table 3.6 --json figures.json");
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

void add_bench_collide(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<CollideArguments>();
    CLI::App* command = program.add_subcommand("collide", "Grid, tree and distance field round a dense body");
    command->add_option("--triangles", arguments->options.triangles, "Bodies: about so many triangles each")
        ->type_name("N")
        ->check(CLI::Range(17184, 4000000))
        ->capture_default_str();
    command->add_option("--points", arguments->options.points.points, "Points of cloth")
        ->check(CLI::Range(16, 1000000))
        ->capture_default_str();
    command->add_option("--rounds", arguments->options.rounds, "Figures are medians of so many")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    add_json_option(*command, arguments->json);
    command->footer("Example: selvedge bench collide --triangles 67000 500000 --json collide.json");
    command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
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

void add_bench_contact(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<ContactArguments>();
    CLI::App* command = program.add_subcommand("contact", "Cloth that meets itself and other cloth, with and without");
    command->add_option("GARMENT", arguments->experiment.pattern, "Garment file (default patterns/tshirt.json)")
        ->type_name("FILE");
    command
        ->add_option("--scene", arguments->experiment.only,
                     "Run this scene only (\"garments\": the garment, once and over another)")
        ->type_name("NAME");
    command
        ->add_option("--rest", arguments->experiment.rest_seconds,
                     "Time in s by which the scenes go on after what is measured (default 0)")
        ->check(CLI::Range(0.0, 60.0))
        ->type_name("S");
    add_json_option(*command, arguments->json);
    command->footer("Example: selvedge bench contact --json contact.json");
    command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
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

void add_bench_drop(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<DropArguments>();
    DropExperiment& experiment = arguments->experiment;
    CLI::App* command = program.add_subcommand("drop", "A square dropped on a sphere: time at equal quality");
    command->add_option("--triangles", experiment.triangles, "1152, 4608, 15488 or 61952; the nearest is taken")
        ->check(CLI::Range(1, 1000000));
    command
        ->add_option("--max-stretch", experiment.gates.max_stretch,
                     "99th percentile of warp and weft stretch to be met (default 0.05)")
        ->check(CLI::Range(0.0001, 1.0));
    command->add_option("--substeps", experiment.substeps, "Sub-steps per frame, instead of searching for the least")
        ->check(CLI::Range(1, 10000));
    command->add_option("--most-substeps", experiment.max_substeps, "Where the search gives up (default 256)")
        ->check(CLI::Range(1, 10000));
    command->add_option("--repetitions", experiment.repetitions, "Timed runs of the chosen setting (default 5)")
        ->check(CLI::Range(1, 1000));
    command->add_flag("--timing-only{false}", experiment.passes_quality_checks,
                      "Leave out rest, energy and the converged runs");
    add_json_option(*command, arguments->json);
    command->footer("Example: selvedge bench drop --triangles 15488 --max-stretch 0.05 --json drop.json");
    command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
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

void add_bench_fabric(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<FabricArguments>();
    CLI::App* command = program.add_subcommand("fabric", "Textile tests of the fabrics, against theory");
    command->add_option("--fabric", arguments->experiment.fabrics, "Shipped fabrics or fabric files (default: all)")
        ->type_name("NAME|FILE");
    command->add_option("--test", arguments->tests, "cantilever, strip, bias, drape, swing, energy (default: all)")
        ->check(CLI::IsMember(textile_test_names()));
    command->add_flag("--quick", arguments->experiment.is_quick, "Levels 1 and 2 at 17 degrees alone, four fabrics");
    command
        ->add_option("--substeps", arguments->experiment.stepping.substeps,
                     "Sub-steps per step of 1/120 s (default 12, as when dressing)")
        ->check(CLI::Range(1, 1000));
    add_json_option(*command, arguments->json);
    command->footer("Example: selvedge bench fabric --test cantilever --fabric denim --json fabric.json");
    command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
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
        scene.bodies.push_back(render::make_body_item(app::make_body(arguments.body).body));
    const Table table = table_of(measure_pictures(scene, arguments.experiment));
    print_table(table);
    write_json_output(arguments.json, document_of({table}));
    return 0;
}

}  // namespace

void add_bench_picture(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<PictureArguments>();
    PictureExperiment& experiment = arguments->experiment;
    CLI::App* command = program.add_subcommand("picture", "The first picture, and those after it");
    command->add_option("MESH", arguments->garment, "Garment, as dress exports it (.obj or .glb)")->required();
    app::add_body_options(*command, arguments->body, "Body that wears it: a file, or mannequin[:bust=92,...]");
    command->add_option("--triangles", experiment.triangles, "Of the cloth, at least (default 20000)")
        ->check(CLI::Range(1, 5000000));
    command->add_option("--pictures", experiment.pictures, "Of each kind (default 12)")->check(CLI::Range(1, 1000));
    command->add_option("--side", experiment.render.width_px, "Of the square picture, px (default 1024)")
        ->check(CLI::Range(16, 8192));
    add_json_option(*command, arguments->json);
    command->footer(
        "Example:\n"
        "  selvedge dress patterns/tshirt.json --export tshirt.glb --export-body body.glb\n"
        "  selvedge bench picture tshirt.glb --body body.glb --json picture.json");
    command->callback([arguments, &exit_code] {
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

void add_bench_rest(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<RestArguments>();
    CLI::App* command = program.add_subcommand("rest", "A dressed garment at rest against the same pulled about");
    command->add_option("GARMENT", arguments->experiment.pattern, "Garment file (default patterns/tshirt.json)")
        ->type_name("FILE");
    add_json_option(*command, arguments->json);
    command->footer("Example: selvedge bench rest patterns/tshirt.json");
    command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
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

void add_bench_tshirt(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<TshirtArguments>();
    TshirtExperiment& experiment = arguments->experiment;
    experiment.sway.allocations = allocations_of_this_thread;
    CLI::App* command = program.add_subcommand("tshirt", "One adaptation and four steps of a dressed garment");
    command->add_option("GARMENT", experiment.pattern, "Garment file (default patterns/tshirt.json)")
        ->type_name("FILE");
    command
        ->add_option("--body-triangles", experiment.body_triangles, "Triangles of the body, at least (default 67000)")
        ->check(CLI::Range(1, 5000000));
    command->add_option("--min-leaves", experiment.min_leaves, "Refined until there are so many (default 6000)")
        ->check(CLI::Range(0, 1000000));
    command
        ->add_option("--max-stretch", experiment.max_stretch,
                     "Share of length, 99th percentile of warp and weft (default 0.05)")
        ->check(CLI::Range(1e-4, 1.0));
    command->add_option("--substeps", experiment.substeps, "Per step, instead of searching for the fewest")
        ->check(CLI::Range(1, 1000));
    command->add_option("--cycles", experiment.sway.cycles, "Adaptations that are measured (default 90)")
        ->check(CLI::Range(1, 100000));
    command->add_flag(
        "--no-growth{false}", experiment.has_growth,
        "Leave out the other rows: a body of 500,000 triangles, the sub-steps of dressing, 25,000 leaves");
    add_json_option(*command, arguments->json);
    command->footer("Example: selvedge bench tshirt --json tshirt.json");
    command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace selvedge::bench
