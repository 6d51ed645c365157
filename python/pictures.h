#pragma once
// Pictures of garments in Python: the pictures of the commands dress and render, as arrays.
#include <mutex>

#include <pybind11/pybind11.h>

namespace selvedge::python {

// Held by the thread that draws: one draws at a time.
std::mutex& drawing();

void add_pictures(pybind11::module_& module);

}  // namespace selvedge::python
