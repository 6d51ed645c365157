#include "python/meshes.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/options.h"
#include "python/errors.h"
#include "python/views.h"
#include "sim/exchange/mesh_file.h"

namespace selvedge::python {
namespace {

const sim::DrawMesh& mesh_of(const py::object& self) {
    return *self.cast<const GarmentMeshView&>().mesh;
}

template <class T>
using Array = py::array_t<T, py::array::c_style | py::array::forcecast>;

// The array of an argument, with this shape; -1: any size.
template <class T>
Array<T> array_argument(py::handle object, const char* place, const std::vector<py::ssize_t>& shape) {
    auto array = Array<T>::ensure(object);
    PyErr_Clear();
    bool fits = array && array.ndim() == static_cast<py::ssize_t>(shape.size());
    for (std::size_t i = 0; fits && i < shape.size(); ++i)
        fits = shape[i] < 0 || array.shape(static_cast<py::ssize_t>(i)) == shape[i];
    if (fits) return array;
    std::string text;
    for (const py::ssize_t size : shape) text += (text.empty() ? "" : ", ") + (size < 0 ? "n" : std::to_string(size));
    throw sim::InputError("", place,
                          "must be an array of numbers of shape (" + text + (shape.size() == 1 ? ",)" : ")"));
}

// Whole numbers from 0 to below `count`: the index of what.
std::vector<std::uint32_t> indices_of(const Array<double>& array, std::size_t count, const char* place) {
    std::vector<std::uint32_t> indices;
    for (py::ssize_t i = 0; i < array.size(); ++i) {
        const double value = array.data()[i];
        if (!(value >= 0 && value < static_cast<double>(count)) || value != std::floor(value))
            throw sim::InputError("", place, short_text(value) + " is no index: there are " + std::to_string(count));
        indices.push_back(static_cast<std::uint32_t>(value));
    }
    return indices;
}

void check_finite(const Array<float>& array, const char* place) {
    const bool is_finite =
        std::all_of(array.data(), array.data() + array.size(), [](float value) { return std::isfinite(value); });
    if (!is_finite) throw sim::InputError("", place, "must be finite");
}

GarmentMeshView make_mesh(const py::object& positions, const py::object& triangles, const py::object& material,
                          const py::object& panel, const std::vector<std::string>& panel_names) {
    sim::DrawMesh mesh;
    const auto x = array_argument<float>(positions, "positions", {-1, 3});
    check_finite(x, "positions");
    for (py::ssize_t i = 0; i < x.shape(0); ++i) mesh.x.emplace_back(x.at(i, 0), x.at(i, 1), x.at(i, 2));
    const auto corners =
        indices_of(array_argument<double>(triangles, "triangles", {-1, 3}), mesh.x.size(), "triangles");
    for (std::size_t i = 0; i < corners.size(); i += 3)
        mesh.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    const auto count = static_cast<py::ssize_t>(mesh.triangles.size());
    if (!material.is_none()) {
        const auto u = array_argument<float>(material, "material", {count, 3, 2});
        check_finite(u, "material");
        for (py::ssize_t t = 0; t < count; ++t)
            mesh.u.push_back({Vec2f(u.at(t, 0, 0), u.at(t, 0, 1)), Vec2f(u.at(t, 1, 0), u.at(t, 1, 1)),
                              Vec2f(u.at(t, 2, 0), u.at(t, 2, 1))});
    }
    mesh.panel_names = panel_names.empty() ? std::vector<std::string>{"panel"} : panel_names;
    if (mesh.panel_names.size() > 65535) throw sim::InputError("", "panel_names", "too many panels");
    if (!panel.is_none()) {
        const auto of_triangles =
            indices_of(array_argument<double>(panel, "panel", {count}), mesh.panel_names.size(), "panel");
        for (const std::uint32_t one : of_triangles) mesh.panel.push_back(static_cast<std::uint16_t>(one));
    }
    mesh.panel_grain_angles.assign(mesh.panel_names.size(), 0);
    mesh.normals = sim::vertex_normals(mesh.x, mesh.triangles);
    return {std::make_shared<const sim::DrawMesh>(std::move(mesh))};
}

GarmentMeshView load_mesh(const std::filesystem::path& path) {
    const py::gil_scoped_release release;
    return {std::make_shared<const sim::DrawMesh>(sim::read_garment(path))};
}

void export_mesh(const GarmentMeshView& self, const std::filesystem::path& path) {
    const py::gil_scoped_release release;
    app::check_output(path, sim::mesh_extensions());
    write_garment(*self.mesh, path);
}

}  // namespace

void add_meshes(py::module_& module) {
    py::class_<GarmentMeshView>(module, "Mesh",
                                "A triangle mesh of cloth, in metres. It does not change, and its arrays are read-only "
                                "views without a copy, which keep it alive.")
        .def(py::init(&make_mesh), py::arg("positions"), py::arg("triangles"), py::kw_only(),
             py::arg("material") = py::none(), py::arg("panel") = py::none(),
             py::arg("panel_names") = std::vector<std::string>(),
             "A mesh from arrays, which are copied: positions (vertices, 3) in m, triangles (triangles, 3) of vertex\n"
             "indices, material (triangles, 3, 2) in m, panel (triangles,) of indices into panel_names.\n"
             "Raises InputError for a wrong shape, an index out of range, or a number that is not finite.")
        .def_property_readonly(
            "positions", [](const py::object& self) { return view_of(mesh_of(self).x, self); },
            "Positions, float32 of shape (vertices, 3), m.")
        .def_property_readonly(
            "normals", [](const py::object& self) { return view_of(mesh_of(self).normals, self); },
            "Unit normals, float32 of shape (vertices, 3), to the fabric's right side; empty if a file had none.")
        .def_property_readonly(
            "triangles", [](const py::object& self) { return view_of(mesh_of(self).triangles, self); },
            "Vertex indices, uint32 of shape (triangles, 3), counter-clockwise seen from the fabric's right side.")
        .def_property_readonly(
            "material", [](const py::object& self) { return view_of(mesh_of(self).u, self); },
            "Material coordinates of each corner, float32 of shape (triangles, 3, 2), m, in the frame of the panel: at "
            "a "
            "seam, corners of one vertex differ. Empty if there are none.")
        .def_property_readonly(
            "panel", [](const py::object& self) { return view_of(mesh_of(self).panel, self); },
            "Index into panel_names, uint16 of shape (triangles,); empty: all 0.")
        .def_property_readonly(
            "level", [](const py::object& self) { return view_of(mesh_of(self).level, self); },
            "How often the base mesh was divided there, uint8 of shape (triangles,); empty: all 0.")
        .def_property_readonly(
            "panel_names", [](const GarmentMeshView& self) { return self.mesh->panel_names; }, "Names of the panels.")
        .def("export", &export_mesh, py::arg("path"),
             "Writes it as .obj, .glb, .ply or .stl, without textures. Raises InputError.")
        .def("__repr__", [](const GarmentMeshView& self) {
            return "<selvedge.Mesh of " + std::to_string(self.mesh->x.size()) + " vertices and " +
                   std::to_string(self.mesh->triangles.size()) + " triangles>";
        });
    module.def("load_mesh", &load_mesh, py::arg("path"),
               "Reads a garment from an .obj or .glb file, of Selvedge or another program. Raises InputError.");
}

}  // namespace selvedge::python
