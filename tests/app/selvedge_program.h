#pragma once
// Runs the built selvedge program as a black box.
#include <string>

#include "tests/app/run_program.h"
#include "tests/support/checkout.h"

namespace selvedge::app {

// The program's path, quoted.
inline std::string program() {
    return "'" + program_folder() + "/selvedge'";
}

// Runs the program; `arguments` use shell syntax.
inline ProgramResult run_selvedge(const std::string& arguments) {
    return run_command(program() + " " + arguments);
}

inline std::string shipped(const std::string& file) {
    return "'" + source_folder() + "/patterns/" + file + "'";
}

}  // namespace selvedge::app
