#pragma once
// Pictures of garments in Python: the pictures of the commands dress and render, as arrays.
#include <pybind11/pybind11.h>

namespace selvedge::python {

void add_pictures(pybind11::module_& module);

}  // namespace selvedge::python
