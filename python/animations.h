#pragma once
// Garments on bodies that move, frame by frame, in Python: what the command animate does (app/animation_run.h).
#include <pybind11/pybind11.h>

namespace selvedge::python {

void add_animations(pybind11::module_& module);

}  // namespace selvedge::python
