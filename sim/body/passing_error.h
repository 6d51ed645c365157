#pragma once
// The exception for input that could not be read for a reason that may be gone at the next try: no process was left for
// its reader, or the reader took too long, as on a busy machine.
#include "sim/core/error.h"

namespace selvedge::sim {

class PassingError : public InputError {
 public:
    using InputError::InputError;
};

}  // namespace selvedge::sim
