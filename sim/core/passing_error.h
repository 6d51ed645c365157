#pragma once
// The exception for what failed for a reason that may be gone at the next try: no process was left for the reader of a
// file, it took too long, as on a busy machine, or more memory than this process may have; no picture can be drawn
// here.
#include "sim/core/error.h"

namespace selvedge::sim {

class PassingError : public InputError {
 public:
    using InputError::InputError;
};

}  // namespace selvedge::sim
