#pragma once
// Triangle meshes of garments in Python.
#include <memory>

#include <pybind11/pybind11.h>

#include "sim/mesh/draw_mesh.h"

namespace selvedge::python {

namespace py = pybind11;

// It may be a part of something larger, which the pointer then keeps.
struct GarmentMeshView {
    std::shared_ptr<const sim::DrawMesh> mesh;
};

void add_meshes(py::module_& module);

}  // namespace selvedge::python
