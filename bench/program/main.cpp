// selvedge-bench: the entry point of the experiments.
#include "app/arguments.h"
#include "app/command_line.h"
#include "bench/program/commands.h"

int main(int argc, char** argv) {
    selvedge::app::Command program{"Measure, and print the figures as Markdown tables"};
    set_name(program, "selvedge bench");
    int exit_code = 0;
    selvedge::bench::add_commands(program, exit_code);
    return selvedge::app::run_command_line(program, argc, argv, exit_code);
}
