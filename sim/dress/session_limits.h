#pragma once
// What a session makes of options that nobody checked.
#include "sim/dress/session.h"

namespace selvedge {

inline constexpr int kDeepestSessionLevel = 8;  // a base edge of 5 cm then is 0.2 mm long

// The nearest options that can be worked with.
SessionOptions within_limits(SessionOptions options);

}  // namespace selvedge
