// selvedge bench EXPERIMENT: measurements that anyone can repeat, as tables.
#include "app/bench.h"

#include <cstdio>

#include "app/commands.h"
#include "app/output_files.h"
#include "sim/core/file.h"

namespace selvedge {

void add_json_option(CLI::App& command, std::string& path) {
    command.add_option("--json", path, "Write the figures here too, as JSON")->type_name("FILE");
}

void check_json_output(const std::string& path) {
    if (!path.empty()) check_output(path);
}

void print_table(const Table& table) {
    std::printf("%s\n", to_markdown(table).c_str());
    std::fflush(stdout);
}

void write_json_output(const std::string& path, const Json& document) {
    if (!path.empty()) write_file_atomically(path, write_json(document));
}

Json document_of(const std::vector<Table>& tables) {
    Json document = Json::object();
    Json& list = document["tables"] = Json::array();
    for (const Table& table : tables) list.push_back(to_json(table));
    return document;
}

void add_bench_command(CLI::App& app, int& exit_code) {
    CLI::App* command = app.add_subcommand("bench", "Measure, and print the figures as Markdown tables");
    command->require_subcommand(1);
    command->footer("Example: selvedge bench thesis --table 3.6 --json figures.json");
    add_bench_collide(*command, exit_code);
    add_bench_drop(*command, exit_code);
    add_bench_fabric(*command, exit_code);
    add_bench_picture(*command, exit_code);
    add_bench_rest(*command, exit_code);
    add_bench_thesis(*command, exit_code);
    add_bench_tshirt(*command, exit_code);
}

}  // namespace selvedge
