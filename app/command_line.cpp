#include "app/command_line.h"

#include <cstdio>
#include <exception>

#include "app/arguments.h"
#include "app/refused_report.h"
#include "sim/core/error.h"
#include "sim/core/printable.h"

namespace selvedge::app {

int run_command_line(Command& app, int argc, char** argv, const int& exit_code) {
    try {
        if (!parse_arguments(app, argc, argv)) return 0;
    } catch (const UsageError& error) {
        write_refused_report(app, error.problem());
        std::fprintf(stderr, "selvedge: %s (see selvedge --help)\n", error.what());
        return 2;
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
