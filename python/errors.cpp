#include "python/errors.h"

#include <exception>

#include "sim/core/argument_name.h"

namespace selvedge::python {

void translate_errors() {
    py::register_local_exception_translator([](std::exception_ptr pointer) {
        try {
            if (pointer) std::rethrow_exception(pointer);
        } catch (const sim::InputError& error) {
            const py::object type = py::module_::import("selvedge._errors").attr("InputError");
            PyErr_SetObject(type.ptr(),
                            py::make_tuple(error.file(), sim::argument_name(error.place()), error.problem()).ptr());
        }
    });
}

double finite_of(py::handle object, const std::string& place) {
    const double number = value_of<double>(object, place, "a number");
    if (!std::isfinite(number)) throw sim::InputError("", place, "must be finite");
    return number;
}

}  // namespace selvedge::python
