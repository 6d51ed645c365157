// selvedge bench tshirt: what one adaption and four steps cost a garment on a body.
#include <memory>

#include "app/allocation_counter.h"
#include "app/bench.h"
#include "app/progress_bar.h"
#include "bench/tshirt/tshirt.h"

namespace selvedge {
namespace {

struct TshirtArguments {
    TshirtExperiment experiment{.pattern = "patterns/tshirt.json"};
    std::string json;
};

int run(const TshirtArguments& arguments) {
    check_json_output(arguments.json);
    ProgressBar bar(progress_bar_options(false));
    const TshirtReport report = measure_tshirt(arguments.experiment, bar.progress());
    bar.finish();
    print_table(table_of(report));
    write_json_output(arguments.json, to_json(report));
    return 0;
}

}  // namespace

void add_bench_tshirt(CLI::App& bench, int& exit_code) {
    auto arguments = std::make_shared<TshirtArguments>();
    TshirtExperiment& experiment = arguments->experiment;
    experiment.sway.allocations = allocations_of_this_thread;
    CLI::App* command = bench.add_subcommand("tshirt", "One adaption and four steps of a dressed garment");
    command->add_option("GARMENT", experiment.pattern, "Garment file (default patterns/tshirt.json)")
        ->type_name("FILE");
    command
        ->add_option("--body-triangles", experiment.body_triangles, "Triangles of the body, at least (default 67000)")
        ->check(CLI::Range(1, 5000000));
    command->add_option("--min-leaves", experiment.least_leaves, "Refined until there are so many (default 6000)")
        ->check(CLI::Range(0, 1000000));
    command
        ->add_option("--max-stretch", experiment.most_stretch,
                     "Share of length, 99th percentile of warp and weft (default 0.05)")
        ->check(CLI::Range(1e-4, 1.0));
    command->add_option("--substeps", experiment.substeps, "Per step, instead of searching for the fewest")
        ->check(CLI::Range(1, 1000));
    command->add_option("--cycles", experiment.sway.cycles, "Adaptions that are measured (default 90)")
        ->check(CLI::Range(1, 100000));
    command->add_flag(
        "--no-growth{false}", experiment.has_growth,
        "Leave out the other rows: a body of 500,000 triangles, the sub-steps of dressing, 25,000 leaves");
    add_json_option(*command, arguments->json);
    command->footer("Example: selvedge bench tshirt --json tshirt.json");
    command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace selvedge
