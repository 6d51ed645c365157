#include "app/command_line.h"

#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string>

#include "app/arguments.h"
#include "app/refused_report.h"
#include "sim/core/error.h"
#include "sim/core/printable.h"

namespace selvedge::app {

namespace {

int run(Command& app, int argc, char** argv, const int& exit_code) {
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
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "selvedge: out of memory\n");
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "selvedge: %s\n", sim::printable(error.what()).c_str());
        return 2;
    }
    return exit_code;
}

// What the drivers of OpenGL say would stand between our lines. Whoever sets these variables sees it.
void quiet_drivers() {
    constexpr int kKeep = 0;
    ::setenv("EGL_LOG_LEVEL", "fatal", kKeep);
    ::setenv("LIBGL_DEBUG", "quiet", kKeep);
    ::setenv("MESA_LOG", "null", kKeep);
}

// Whether all that was printed has reached its file: one of a full disk keeps what fits.
bool close_output() {
    errno = 0;
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) return false;
    const int copy = ::dup(STDOUT_FILENO);  // closing it tells what a file system tells late
    return copy < 0 || ::close(copy) == 0;
}

}  // namespace

int run_command_line(Command& app, int argc, char** argv, const int& exit_code) {
    quiet_drivers();
    const int code = run(app, argc, argv, exit_code);
    if (close_output()) return code;
    const std::string reason = errno == 0 ? "" : std::string(": ") + std::strerror(errno);  // 0: it failed before
    std::fprintf(stderr, "selvedge: standard output: cannot write%s\n", reason.c_str());
    return 2;
}

}  // namespace selvedge::app
