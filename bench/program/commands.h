#pragma once
// The subcommands of the program selvedge-bench, which `selvedge bench` starts, and their common output. Each add_
// function adds one subcommand; its action stores the exit code.
#include <filesystem>
#include <string>
#include <vector>

#include "bench/support/table.h"

namespace selvedge::app {
class Command;
}

namespace selvedge::bench {

void add_commands(app::Command& program, int& exit_code);  // all of them

void add_bench_collide(app::Command& program, int& exit_code);
void add_bench_contact(app::Command& program, int& exit_code);
void add_bench_drop(app::Command& program, int& exit_code);
void add_bench_fabric(app::Command& program, int& exit_code);
void add_bench_motion(app::Command& program, int& exit_code);
void add_bench_picture(app::Command& program, int& exit_code);
void add_bench_rest(app::Command& program, int& exit_code);
void add_bench_thesis(app::Command& program, int& exit_code);
void add_bench_tshirt(app::Command& program, int& exit_code);

// Adds --json FILE, which every experiment has. `path` must outlive the parsing.
void add_json_option(app::Command& command, std::string& path);

// Throws InputError if the --json file cannot be written or is one of those that are read; call it before a long
// experiment.
void check_json_output(const std::string& path, const std::vector<std::filesystem::path>& inputs = {});

// Prints a table to stdout as Markdown.
void print_table(const Table& table);

// Writes a document to the --json file; does nothing if the path is empty.
void write_json_output(const std::string& path, const sim::Json& document);

// {"tables": [...]}
sim::Json document_of(const std::vector<Table>& tables);

}  // namespace selvedge::bench
