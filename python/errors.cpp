#include "python/errors.h"

#include <algorithm>
#include <charconv>
#include <exception>
#include <string_view>

namespace selvedge::python {

namespace {

// The argument's name for a place that is an option of the command line: "--sett-size" gives "sett_size".
std::string argument_name(std::string place) {
    if (!place.starts_with("--")) return place;
    place.erase(0, 2);
    std::ranges::replace(place, '-', '_');
    constexpr std::string_view kBody = "body_";
    if (place == "from") return "start";  // a word of the language
    if (place == "to") return "end";
    return place.starts_with(kBody) ? place.substr(kBody.size()) : place;
}

}  // namespace

void translate_errors() {
    py::register_local_exception_translator([](std::exception_ptr pointer) {
        try {
            if (pointer) std::rethrow_exception(pointer);
        } catch (const sim::InputError& error) {
            const py::object type = py::module_::import("selvedge._errors").attr("InputError");
            PyErr_SetObject(type.ptr(),
                            py::make_tuple(error.file(), argument_name(error.place()), error.problem()).ptr());
        }
    });
}

std::string short_text(double number) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

double finite_of(py::handle object, const std::string& place) {
    const double number = value_of<double>(object, place, "a number");
    if (!std::isfinite(number)) throw sim::InputError("", place, "must be finite");
    return number;
}

}  // namespace selvedge::python
