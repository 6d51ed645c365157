#pragma once
// The program under test, from outside.
#include <string>

#include "tests/app/run_program.h"

namespace selvedge::app {

// Runs the built program; arguments are for the shell.
inline ProgramResult run_selvedge(const std::string& arguments) {
    return run_command("'" SELVEDGE_PROGRAM "' " + arguments);
}

inline std::string shipped(const std::string& file) {
    return "'" SELVEDGE_SOURCE_DIR "/patterns/" + file + "'";
}

}  // namespace selvedge::app
