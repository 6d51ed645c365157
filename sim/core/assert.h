#pragma once
// Checks of our own logic, on in every build: a broken promise stops the program at its place instead of far from it.
// Wrong input is never an assert: see sim/core/error.h.

namespace selvedge::sim {

[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);

}  // namespace selvedge::sim

#define SELVEDGE_ASSERT(condition) \
    (static_cast<bool>(condition) ? void(0) : ::selvedge::sim::assertion_failed(#condition, __FILE__, __LINE__))
