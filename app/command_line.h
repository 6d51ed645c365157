#pragma once
// Parses a command line and runs the subcommand that it names. Every error becomes one line on standard error, whatever
// has failed.

namespace selvedge::app {

class Command;

// Returns what the subcommand's action stored in exit_code; 2 for what was refused, then also written to the report
// that the command line asks for (app/refused_report.h), and where standard output did not take all that was printed.
int run_command_line(Command& app, int argc, char** argv, const int& exit_code);

}  // namespace selvedge::app
