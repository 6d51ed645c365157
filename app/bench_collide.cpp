// selvedge bench collide: what it costs to keep cloth out of bodies of many triangles.
#include <memory>

#include "app/bench.h"
#include "bench/collide.h"

namespace selvedge {
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

void add_bench_collide(CLI::App& bench, int& exit_code) {
    auto arguments = std::make_shared<CollideArguments>();
    CLI::App* command = bench.add_subcommand("collide", "Grid, tree and distance field round a dense body");
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

}  // namespace selvedge
