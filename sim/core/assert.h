#pragma once
// An assertion that is active in every build type. It checks for programming errors (broken preconditions and
// invariants), prints the condition, file and line, and aborts. Wrong user input throws InputError (sim/core/error.h).

namespace selvedge::sim {

[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);

}  // namespace selvedge::sim

#define SELVEDGE_ASSERT(condition) \
    (static_cast<bool>(condition) ? void(0) : ::selvedge::sim::assertion_failed(#condition, __FILE__, __LINE__))
