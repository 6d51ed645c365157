#include "python/bodies.h"

#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/option_texts.h"
#include "app/options.h"
#include "python/errors.h"
#include "python/pickles.h"
#include "python/views.h"
#include "sim/core/error.h"
#include "sim/dress/worn_together.h"
#include "sim/exchange/mesh_file.h"

namespace selvedge::python {
namespace {

BodyPointer make_mannequin(const std::string& sex, const std::map<std::string, double>& measures, int resolution,
                           std::optional<double> stance) {
    sim::MannequinOptions options{.subdivisions = resolution, .stance = stance};
    if (sex != "female" && sex != "male") throw sim::InputError("", "sex", "'" + sex + "' is none of female, male");
    options.sex = sex == "male" ? sim::Sex::Male : sim::Sex::Female;
    for (const auto& [name, value] : measures) {
        std::optional<double>* measure = find_measure(options.measures, name);
        if (measure == nullptr) throw sim::InputError("", name, "is no measure of a mannequin");
        *measure = value;
    }
    const py::gil_scoped_release release;
    return std::make_shared<sim::PreparedBody>(sim::make_body(options));
}

BodyPointer made_from(const app::BodyOptions& options) {
    return std::make_shared<sim::PreparedBody>(app::make_body(options));
}

BodyPointer load_body(const std::filesystem::path& path, const std::string& unit, const std::string& up) {
    const py::gil_scoped_release release;
    app::BodyOptions options = app::read_body_options({"--body-unit=" + unit, "--body-up=" + up});
    options.source = path.string();
    if (!options.is_file()) throw sim::InputError(path.string(), "", "names no file");
    return made_from(options);
}

py::dict measures_of(const sim::PreparedBody& self) {
    py::dict measures;
    if (!self.made().readings) return measures;
    for (const sim::MeasureReading& reading : self.made().readings->readings)
        measures[py::str(std::string(reading.name))] = reading.measured;
    return measures;
}

std::vector<std::string> bone_names(const sim::PreparedBody& self) {
    std::vector<std::string> names;
    for (const sim::Bone& bone : self.body().bones) names.push_back(bone.name);
    return names;
}

py::array joints_of(const py::object& self) {
    const std::vector<sim::Bone>& bones = self.cast<const sim::PreparedBody&>().body().bones;
    return strided_view(bones.empty() ? nullptr : &bones.front().joint, bones.size(), sizeof(sim::Bone), self);
}

void export_body(const sim::PreparedBody& self, const std::filesystem::path& path) {
    const py::gil_scoped_release release;
    app::check_output(path, sim::mesh_extensions());
    write_body(self.body(), path);
}

}  // namespace

BodyPointer default_body(const std::string& named_by_pattern) {
    return made_from({.source = named_by_pattern.empty() ? sim::kDefaultBody : named_by_pattern, .load = {}});
}

void add_bodies(py::module_& module) {
    py::class_<sim::PreparedBody, BodyPointer>(
        module, "Body",
        "A body that is dressed: a closed surface, in metres; y up, +z to the front, "
        "+x to the body's left, the floor at y = 0. It does not change.")
        .def_property_readonly(
            "name", [](const sim::PreparedBody& self) { return self.body().name; }, "Its name.")
        .def_property_readonly(
            "vertices",
            [](const py::object& self) { return view_of(self.cast<const sim::PreparedBody&>().body().x, self); },
            "Positions, float64 of shape (vertices, 3), m. Read-only, no copy.")
        .def_property_readonly(
            "triangles",
            [](const py::object& self) {
                return view_of(self.cast<const sim::PreparedBody&>().body().triangles, self);
            },
            "Indices of vertices, int32 of shape (triangles, 3), counter-clockwise seen from outside. Read-only, no "
            "copy.")
        .def_property_readonly("bone_names", &bone_names,
                               "Names of the bones, parents first; empty without a skeleton.")
        .def_property_readonly("joints", &joints_of,
                               "Starts of the bones, float64 of shape (bones, 3), m. Read-only, no copy.")
        .def_property_readonly(
            "measures", &measures_of,
            "Of a mannequin: its lengths and girths by name, m, as measured on the surface; of other "
            "bodies empty.")
        .def_property_readonly(
            "height", [](const sim::PreparedBody& self) { return sim::height_range(self.body()).high; },
            "Height of the highest point over the floor, m.")
        .def_property_readonly(
            "notes", [](const sim::PreparedBody& self) { return self.made().notes; },
            "A sentence for each measure that could not be met, and each repair of a file.")
        .def(py::pickle([](const sim::PreparedBody& self) { return py::bytes(bytes_of(self)); },
                        [](const py::bytes& state) { return body_from(state); }))
        .def("export", &export_body, py::arg("path"),
             "Writes the surface as .obj, .glb, .ply or .stl. Raises InputError.")
        .def("__repr__", [](const sim::PreparedBody& self) {
            return "<selvedge.Body '" + self.body().name + "', " + std::to_string(self.body().x.size()) + " vertices>";
        });
    module.def("_mannequin", &make_mannequin, py::arg("sex"), py::arg("measures"), py::arg("resolution"),
               py::arg("stance").none(true), "A mannequin from measures in m; stance in rad.");
    module.def(
        "_body_named",
        [](const std::string& source) {
            if (source.empty()) throw sim::InputError("", "body", "names no body");
            return made_from({.source = source, .load = {}});
        },
        py::arg("source"), py::call_guard<py::gil_scoped_release>(),
        "The body of a text as the command's --body takes it.");
    module.def(
        "load_body", &load_body, py::arg("path"), py::kw_only(), py::arg("unit") = "auto", py::arg("up") = "auto",
        "Loads a body from an OBJ, glTF, GLB or FBX file, in metres with y up, and repairs its surface.\n\n"
        "unit: of the file: auto (by its size), m, dm, cm, mm or in. up: its axis that points up: auto, y or z.\n"
        "Raises InputError if the file cannot be read or its surface cannot be closed.");
}

}  // namespace selvedge::python
