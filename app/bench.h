#pragma once
// The subcommands of `selvedge bench`. Each function adds one, in a file of its own; its callback stores the exit code.
#include <string>
#include <vector>

#include "bench/support/table.h"

namespace CLI {
class App;
}

namespace selvedge::app {

void add_bench_collide(CLI::App& bench, int& exit_code);
void add_bench_drop(CLI::App& bench, int& exit_code);
void add_bench_fabric(CLI::App& bench, int& exit_code);
void add_bench_picture(CLI::App& bench, int& exit_code);
void add_bench_rest(CLI::App& bench, int& exit_code);
void add_bench_thesis(CLI::App& bench, int& exit_code);
void add_bench_tshirt(CLI::App& bench, int& exit_code);

// --json FILE, which every experiment has. The path must outlive the parsing.
void add_json_option(CLI::App& command, std::string& path);

// Throws InputError when the file of --json cannot be written; call it before the work begins.
void check_json_output(const std::string& path);

// Prints one table as Markdown.
void print_table(const bench::Table& table);

// Writes a document to the file of --json; does nothing when there is no path.
void write_json_output(const std::string& path, const sim::Json& document);

// {"tables": [...]}
sim::Json document_of(const std::vector<bench::Table>& tables);

}  // namespace selvedge::app
