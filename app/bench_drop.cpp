// selvedge bench drop: cloth on a sphere, the yardstick by which cloth solvers are compared.
#include <memory>
#include <optional>

#include "app/bench.h"
#include "app/progress_bar.h"
#include "bench/drop/report.h"

namespace selvedge {
namespace {

struct DropArguments {
    DropExperiment experiment;
    std::string json;
};

int run(const DropArguments& arguments) {
    check_json_output(arguments.json);
    ProgressBar bar(progress_bar_options(false));
    const DropReport report = measure_drop(arguments.experiment, bar.progress());
    bar.finish();
    for (const Table& table : tables_of(report)) print_table(table);
    write_json_output(arguments.json, to_json(report));
    return 0;
}

}  // namespace

void add_bench_drop(CLI::App& bench, int& exit_code) {
    auto arguments = std::make_shared<DropArguments>();
    DropExperiment& experiment = arguments->experiment;
    CLI::App* command = bench.add_subcommand("drop", "A square dropped on a sphere: time at equal quality");
    command->add_option("--triangles", experiment.triangles, "1152, 4608, 15488 or 61952; the nearest is taken")
        ->check(CLI::Range(1, 1000000));
    command
        ->add_option("--max-stretch", experiment.gates.max_stretch,
                     "99th percentile of warp and weft stretch to be met (default 0.05)")
        ->check(CLI::Range(0.0001, 1.0));
    command->add_option("--substeps", experiment.substeps, "Sub-steps per frame, instead of searching for the least")
        ->check(CLI::Range(1, 10000));
    command->add_option("--most-substeps", experiment.most_substeps, "Where the search gives up (default 256)")
        ->check(CLI::Range(1, 10000));
    command->add_option("--repetitions", experiment.repetitions, "Timed runs of the chosen setting (default 5)")
        ->check(CLI::Range(1, 1000));
    command->add_flag("--timing-only{false}", experiment.is_honest, "Leave out rest, energy and the converged runs");
    add_json_option(*command, arguments->json);
    command->footer("Example: selvedge bench drop --triangles 15488 --max-stretch 0.05 --json drop.json");
    command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace selvedge
