// The native part of the Python module selvedge: selvedge._selvedge. What it holds is typed in selvedge/_selvedge.pyi.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "python/animations.h"
#include "python/bodies.h"
#include "python/errors.h"
#include "python/forks.h"
#include "python/meshes.h"
#include "python/patterns.h"
#include "python/pictures.h"
#include "python/results.h"
#include "python/sessions.h"
#include "render/output/shipped_files.h"
#include "sim/core/version.h"
#include "sim/pattern/fabric.h"
#include "sim/tartan/tartan_file.h"

PYBIND11_MODULE(_selvedge, module) {
    module.doc() = "The native part of selvedge.";
    module.attr("version") = std::string(selvedge::sim::program_version());
    selvedge::render::use_shipped_fonts();
    selvedge::python::translate_errors();
    selvedge::python::add_patterns(module);
    selvedge::python::add_bodies(module);
    selvedge::python::add_meshes(module);
    selvedge::python::add_results(module);
    selvedge::python::add_pictures(module);
    selvedge::python::add_sessions(module);
    selvedge::python::add_animations(module);
    selvedge::python::survive_forks();
    module.def("fabric_names", &selvedge::sim::fabric_names,
               "The names of the fabrics that ship, in alphabetical order.");
    module.def("tartan_names", &selvedge::sim::shipped_tartans,
               "The names of the tartans that ship, in alphabetical order.");
}
