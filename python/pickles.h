#pragma once
// Results, bodies and documents of patterns as bytes, so that Python can pickle them: a Pool of processes passes them.
#include <string>
#include <string_view>

#include "python/bodies.h"
#include "python/patterns.h"
#include "python/results.h"

namespace selvedge::python {

// For the same version of the program on a machine of the same kind. The functions that read throw InputError for other
// bytes.
std::string bytes_of(const sim::PreparedBody& body);
BodyPointer body_from(std::string_view bytes);

// All that a result gives, also what would be computed when it is first asked for; not the cloth's simulation.
std::string bytes_of(Result& result);
ResultPointer result_from(std::string_view bytes);

// The text of a garment file, and the name of the file that it was read from.
py::tuple state_of(const Document& document);
DocumentPointer document_from(const py::tuple& state);

}  // namespace selvedge::python
