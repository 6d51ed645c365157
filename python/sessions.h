#pragma once
// A drape that is stepped by hand in Python: a sim::Session without a thread of its own.
#include <pybind11/pybind11.h>

namespace selvedge::python {

void add_sessions(pybind11::module_& module);

}  // namespace selvedge::python
