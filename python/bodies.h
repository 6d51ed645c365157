#pragma once
// Bodies in Python: mannequins from measurements and bodies from files.
#include <memory>
#include <string>

#include <pybind11/pybind11.h>

#include "sim/dress/prepared_body.h"

namespace selvedge::python {

namespace py = pybind11;

// It does not change; pybind11 holds no pointers to what is const.
using BodyPointer = std::shared_ptr<sim::PreparedBody>;

// The body that the command dresses if none is named: the pattern's, or the default mannequin.
BodyPointer default_body(const std::string& named_by_pattern);

void add_bodies(py::module_& module);

}  // namespace selvedge::python
