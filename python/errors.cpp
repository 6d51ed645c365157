#include "python/errors.h"

#include <exception>
#include <string>

#include "sim/core/argument_name.h"

namespace selvedge::python {
namespace {

// As sim::argument_name(), but of arguments whose names on the command line are words of Python.
std::string argument_of(const std::string& place) {
    if (place == "--from") return "start";
    if (place == "--to") return "end";
    return sim::argument_name(place);
}

}  // namespace

void translate_errors() {
    py::register_local_exception_translator([](std::exception_ptr pointer) {
        try {
            if (pointer) std::rethrow_exception(pointer);
        } catch (const sim::InputError& error) {
            const py::object type = py::module_::import("selvedge._errors").attr("InputError");
            PyErr_SetObject(type.ptr(),
                            py::make_tuple(error.file(), argument_of(error.place()), error.problem()).ptr());
        }
    });
}

double finite_of(py::handle object, const std::string& place) {
    const double number = value_of<double>(object, place, "a number");
    if (!std::isfinite(number)) throw sim::InputError("", place, "must be finite");
    return number;
}

}  // namespace selvedge::python
