// selvedge: the program's entry point. Each subcommand has a file of its own.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>

#include "app/commands.h"
#include "app/refused_report.h"
#include "sim/core/error.h"
#include "sim/core/printable.h"
#include "sim/core/version.h"

namespace {

// Prints command-line errors on one line, like every other input error.
int report_usage(const CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::fprintf(stderr, "selvedge: %s (see selvedge --help)\n", selvedge::sim::printable(error.what()).c_str());
    return 2;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Selvedge: cut, sew and drape garments on an adaptive mesh."};
    app.set_version_flag("--version", std::string(selvedge::sim::program_version()));
    app.require_subcommand(1);
    app.footer("Example: selvedge dress patterns/tshirt.json --render tshirt.png");

    int exit_code = 0;
    selvedge::app::add_dress_command(app, exit_code);
    selvedge::app::add_animate_command(app, exit_code);
    selvedge::app::add_batch_command(app, exit_code);
    selvedge::app::add_edit_command(app, exit_code);
    selvedge::app::add_check_command(app, exit_code);
    selvedge::app::add_mannequin_command(app, exit_code);
    selvedge::app::add_import_command(app, exit_code);
    selvedge::app::add_match_command(app, exit_code);
    selvedge::app::add_print_command(app, exit_code);
    selvedge::app::add_render_command(app, exit_code);
    selvedge::app::add_diff_command(app, exit_code);
    selvedge::app::add_bench_command(app, exit_code);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0) selvedge::app::write_refused_report(app, error.what());
        return report_usage(app, error);
    } catch (const selvedge::app::ReportedError& error) {
        std::fprintf(stderr, "selvedge: %s\n", error.what());
        return 2;
    } catch (const selvedge::sim::InputError& error) {
        selvedge::app::write_refused_report(app, error.what());
        std::fprintf(stderr, "selvedge: %s\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "selvedge: %s\n", selvedge::sim::printable(error.what()).c_str());
        return 2;
    }
    return exit_code;
}
