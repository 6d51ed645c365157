#pragma once
// The processor time of this process so far, for tests that work grows no faster than its input. A test allows many
// times what it takes, and less than a quadratic way would.
#include <ctime>

namespace selvedge {

inline double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace selvedge
