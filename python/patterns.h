#pragma once
// Patterns in Python are data classes (selvedge/_pattern.py). Here they are converted: a document gives a record, of
// dictionaries, lists and arrays, from which Python makes its objects; and a record gives a document. Numbers keep
// their bits on the way. What a record does not hold, such as underlays, comes from the document of which it was made.
#include <memory>
#include <string>

#include <pybind11/pybind11.h>

#include "sim/pattern/pattern_file.h"

namespace selvedge::python {

namespace py = pybind11;

// Does not change once it is made.
struct Document {
    sim::PatternDocument content;
    std::string file;  // that it was read from; empty: none
};

using DocumentPointer = std::shared_ptr<Document>;

void add_patterns(py::module_& module);

}  // namespace selvedge::python
