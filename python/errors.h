#pragma once
// Errors of the module: what the program throws as InputError arrives in Python as selvedge.InputError, a ValueError
// with file, place and problem. Also the checks of arguments at the door.
#include <cmath>
#include <optional>
#include <string>

#include <pybind11/pybind11.h>

#include "app/garment_options.h"
#include "sim/core/error.h"

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

// The shortest text of a number: 0.5, 10000000.
std::string short_text(double number);

// A number that is finite.
double finite_of(py::handle object, const std::string& place);

// Throws InputError if the value is not within the limits: "must be from ... to ...". scale: of the limits' unit in
// that of the value, 0.01 for limits in centimetres and a value in metres.
template <class T>
T within(T value, app::Limits<T> limits, const std::string& place, double scale = 1) {
    const double number = static_cast<double>(value);
    const double least = scale * static_cast<double>(limits.least), most = scale * static_cast<double>(limits.most);
    if (std::isfinite(number) && number >= least && number <= most) return value;
    throw sim::InputError("", place, "must be from " + short_text(least) + " to " + short_text(most));
}

template <class T>
std::optional<T> within(const std::optional<T>& value, app::Limits<T> limits, const std::string& place,
                        double scale = 1) {
    if (value) within(*value, limits, place, scale);
    return value;
}

}  // namespace selvedge::python
