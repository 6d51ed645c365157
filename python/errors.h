#pragma once
// Errors of the module: what the program throws as InputError arrives in Python as selvedge.InputError, a ValueError
// with file, place and problem. Also the checks of arguments at the door.
#include <cmath>
#include <optional>
#include <string>

#include <pybind11/pybind11.h>

#include "app/garment_options.h"
#include "sim/core/error.h"
#include "sim/core/numbers.h"

namespace selvedge::python {

namespace py = pybind11;

// Makes the module translate exceptions. Pre: selvedge._errors can be imported.
void translate_errors();

// The value that a Python object holds. Throws InputError if it is of another type: "`place`: must be `what`".
template <class T>
T value_of(py::handle object, const std::string& place, const char* what) {
    py::detail::make_caster<T> caster;
    if (object.is_none() || !caster.load(object, true)) {
        PyErr_Clear();
        throw sim::InputError("", place, std::string("must be ") + what);
    }
    return py::detail::cast_op<T>(std::move(caster));
}

// A number that is finite.
double finite_of(py::handle object, const std::string& place);

using sim::short_text;
using sim::within;

}  // namespace selvedge::python
