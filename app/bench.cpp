// selvedge bench: starts selvedge-bench, the program of the experiments, which lies beside this one.
#include <unistd.h>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "app/commands.h"
#include "sim/core/error.h"
#include "sim/core/file_path.h"

namespace selvedge::app {
namespace {

constexpr const char* kProgram = "selvedge-bench";

// Does not return.
void start(std::vector<std::string> arguments) {
    const std::filesystem::path program = sim::folder_of(sim::canonical_path("/proc/self/exe")) / kProgram;
    std::string name = kProgram;
    std::vector<char*> argv{name.data()};
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    execv(program.c_str(), argv.data());
    if (errno == ENOENT)
        throw sim::InputError(program.string(), "",
                              "no such program: build it with cmake --build --preset release --target selvedge-bench");
    throw sim::InputError(program.string(), "", std::string("cannot be started: ") + std::strerror(errno));
}

}  // namespace

void add_bench_command(Command& app) {
    add_passing_command(app, "bench", "Measure, and print the figures as Markdown tables", start);
}

}  // namespace selvedge::app
