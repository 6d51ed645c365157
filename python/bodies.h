#pragma once
// Bodies in Python: mannequins from measurements and bodies from files.
#include <memory>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "sim/body/body.h"
#include "sim/mannequin/mannequin.h"

namespace selvedge::python {

namespace py = pybind11;

struct WearingBody {
    std::shared_ptr<const sim::Body> body;
    std::vector<std::string> notes = {};             // one sentence per deviation from the request, or per change
    std::vector<sim::MeasureReading> readings = {};  // of a mannequin
};

// The body that the command dresses if none is named: the pattern's, or the default mannequin.
WearingBody default_body(const std::string& named_by_pattern);

void add_bodies(py::module_& module);

}  // namespace selvedge::python
