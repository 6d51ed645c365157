#pragma once
// Parses a command line and runs the subcommand that it names. Every error becomes one line on standard error, whatever
// has failed.

namespace CLI {
class App;
}

namespace selvedge::app {

// Returns what the subcommand's callback stored in exit_code; 2 for what was refused, then also written to the report
// that the command line asks for (app/refused_report.h).
int run_command_line(CLI::App& app, int argc, char** argv, const int& exit_code);

}  // namespace selvedge::app
