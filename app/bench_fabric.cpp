// selvedge bench fabric: textile tests made with virtual cloth, against theory and published figures.
#include <memory>

#include "app/bench.h"
#include "app/progress_bar.h"
#include "bench/fabric/report.h"
#include "sim/core/parallel.h"

namespace selvedge {
namespace {

struct FabricArguments {
    FabricExperiment experiment;
    std::vector<std::string> tests;
    std::string json;
};

int run(const FabricArguments& arguments) {
    check_json_output(arguments.json);
    for (const std::string& name : arguments.experiment.fabrics) find_fabric(name);
    const ThreadLimit limit(1);
    ProgressBar bar(progress_bar_options(false));
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
    Json document = document_of(tables);
    document["rows_with_a_gate"] = rows;
    document["rows_missed"] = missed;
    write_json_output(arguments.json, document);
    return 0;
}

}  // namespace

void add_bench_fabric(CLI::App& bench, int& exit_code) {
    auto arguments = std::make_shared<FabricArguments>();
    CLI::App* command = bench.add_subcommand("fabric", "Textile tests of the fabrics, against theory");
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

}  // namespace selvedge
