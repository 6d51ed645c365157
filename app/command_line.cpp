#include "app/command_line.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "app/refused_report.h"
#include "sim/core/error.h"
#include "sim/core/printable.h"

namespace selvedge::app {
namespace {

// Prints command-line errors on one line, like every other input error.
int report_usage(const CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::fprintf(stderr, "selvedge: %s (see selvedge --help)\n", sim::printable(error.what()).c_str());
    return 2;
}

}  // namespace

int run_command_line(CLI::App& app, int argc, char** argv, const int& exit_code) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0) write_refused_report(app, error.what());
        return report_usage(app, error);
    } catch (const ReportedError& error) {
        std::fprintf(stderr, "selvedge: %s\n", error.what());
        return 2;
    } catch (const sim::InputError& error) {
        write_refused_report(app, error.what());
        std::fprintf(stderr, "selvedge: %s\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "selvedge: %s\n", sim::printable(error.what()).c_str());
        return 2;
    }
    return exit_code;
}

}  // namespace selvedge::app
