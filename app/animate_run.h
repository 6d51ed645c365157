#pragma once
// What the command animate does once its options are known: dresses a body, lets it move, and prints what came of it.
#include "app/animation_run.h"

namespace selvedge::app {

// Returns the exit code. Throws InputError for wrong input, and for a file that cannot be written. A signal that stops
// the program ends the motion early.
int run_animate(AnimateArguments arguments);

}  // namespace selvedge::app
