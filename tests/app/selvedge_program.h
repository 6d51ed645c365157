#pragma once
// Runs the built selvedge program as a black box.
#include <string>

#include "tests/app/run_program.h"

namespace selvedge::app {

// Runs the program; `arguments` use shell syntax.
inline ProgramResult run_selvedge(const std::string& arguments) {
    return run_command("'" SELVEDGE_PROGRAM "' " + arguments);
}

inline std::string shipped(const std::string& file) {
    return "'" SELVEDGE_SOURCE_DIR "/patterns/" + file + "'";
}

}  // namespace selvedge::app
