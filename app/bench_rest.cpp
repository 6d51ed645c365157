// selvedge bench rest: what a garment costs that has come to rest.
#include <memory>

#include "app/bench.h"
#include "app/progress_bar.h"
#include "bench/tshirt/rest.h"

namespace selvedge {
namespace {

struct RestArguments {
    RestExperiment experiment{.pattern = "patterns/tshirt.json"};
    std::string json;
};

int run(const RestArguments& arguments) {
    check_json_output(arguments.json);
    ProgressBar bar(progress_bar_options(false));
    const Table table = table_of(measure_rest(arguments.experiment, bar.progress()));
    bar.finish();
    print_table(table);
    write_json_output(arguments.json, document_of({table}));
    return 0;
}

}  // namespace

void add_bench_rest(CLI::App& bench, int& exit_code) {
    auto arguments = std::make_shared<RestArguments>();
    CLI::App* command = bench.add_subcommand("rest", "A dressed garment at rest against the same pulled about");
    command->add_option("GARMENT", arguments->experiment.pattern, "Garment file (default patterns/tshirt.json)")
        ->type_name("FILE");
    add_json_option(*command, arguments->json);
    command->footer("Example: selvedge bench rest patterns/tshirt.json");
    command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace selvedge
