#pragma once
// Records of patterns: dictionaries, lists and NumPy arrays with the names of selvedge/_pattern.py.
#include <memory>

#include <pybind11/pybind11.h>

#include "python/patterns.h"
#include "sim/pattern/pattern.h"

namespace selvedge::python {

// A panel's key "origin" is the document and its index there.
py::dict record_of(const std::shared_ptr<const Document>& document);

// The pattern of a record; what this does not hold is taken from `base` and from the origins of its panels. Throws
// InputError where a value is of the wrong type, not finite, or no index; outlines and seams are not checked further.
sim::Pattern pattern_of(const py::dict& record, const sim::Pattern& base);

}  // namespace selvedge::python
