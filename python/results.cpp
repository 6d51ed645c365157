#include "python/results.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>
#include <variant>

#include <pybind11/stl.h>

#include "app/garment_files.h"
#include "app/option_texts.h"
#include "python/errors.h"
#include "python/meshes.h"
#include "python/pickles.h"
#include "python/views.h"
#include "sim/cloth/contact.h"
#include "sim/core/error.h"
#include "sim/dress/worn_together.h"
#include "sim/exchange/garmentcode_element.h"
#include "sim/inspection/report.h"
#include "sim/place/fit.h"
#include "sim/session/share_done.h"
#include "sim/simulation/simulation.h"

namespace selvedge::python {
namespace {

constexpr double kCm = 0.01;  // m

void call(py::handle function, double done, std::string_view text) {
    if (!function.is_none()) function(done, py::str(text.data(), text.size()));
}

}  // namespace

void look_for_signals() {
    const py::gil_scoped_acquire acquire;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

sim::Progress progress_to(py::handle function) {
    return [function](std::string_view phase, double fraction) {
        const py::gil_scoped_acquire acquire;
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        call(function, sim::share_done(phase, fraction), phase);
    };
}

sim::DressOptions dress_options(const DressArguments& arguments) {
    sim::DressOptions options;
    if (!arguments.fabric.empty()) options.fabric = sim::find_fabric(arguments.fabric);
    options.edge_length = within(arguments.edge_length, sim::kEdgeLengthsCm, "edge_length", kCm);
    options.max_level = within(arguments.max_level, sim::kLevels, "max_level");
    options.shortest_edge = within(arguments.shortest_edge, sim::kShortestEdgesCm, "shortest_edge", kCm);
    options.triangle_budget = within(arguments.triangles, sim::kTriangleBudgets, "triangles");
    options.self_collision = arguments.self_collision;
    return options;
}

app::PictureOptions picture_of(const Result& result, app::PictureOptions picture) {
    app::GarmentOptions garment = result.garment;
    app::BodyOptions body{.source = "the result's", .load = {}};
    name_inputs(garment, body, picture, result.pattern);
    fill_in(garment, picture, result.pattern);
    return picture;
}

namespace {

// As the command dresses: see run() in app/dress.cpp.
ResultPointer dress(const DocumentPointer& pattern, const BodyPointer& body, const std::vector<DocumentPointer>& over,
                    const DressArguments& arguments, double seconds, std::optional<int> threads,
                    const py::object& progress) {
    if (!progress.is_none() && !PyCallable_Check(progress.ptr())) throw py::type_error("progress must be callable");
    within(threads, sim::kThreadCounts, "threads");
    auto result = std::make_shared<Result>();
    const py::gil_scoped_release release;
    result->garment.dress = dress_options(arguments);
    result->garment.fabric = arguments.fabric;
    result->garment.dress.max_seconds = within(seconds, sim::kDrapeSeconds, "seconds");
    std::vector<sim::Pattern> outer;
    for (const DocumentPointer& one : over) outer.push_back(one->content.pattern);
    std::vector<std::string> notes;
    result->pattern = sim::worn_together(pattern->content.pattern, outer, pattern->file, notes);
    std::optional<sim::ThreadLimit> limit;
    if (threads) limit.emplace(*threads);
    result->body = body ? body : default_body(result->pattern.body);
    std::ranges::copy(result->body->made().notes, std::back_inserter(notes));
    result->dressed = sim::dress(result->pattern, result->body, result->garment.dress, progress_to(progress));
    std::vector<std::string>& all = result->dressed.report.notes;
    all.insert(all.begin(), notes.begin(), notes.end());
    result->strain = measure_strain(result->dressed.cloth());
    result->report = to_json(result->dressed.report);
    const py::gil_scoped_acquire acquire;
    call(progress, 1, "done");
    return result;
}

GarmentMeshView whole_mesh(const ResultPointer& self) {
    return {std::shared_ptr<const sim::DrawMesh>(self, &self->dressed.mesh)};
}

// A view of the result's mesh: `name` is a property of Mesh.
auto of_mesh(const char* name) {
    return [name](const ResultPointer& self) -> py::object { return py::cast(whole_mesh(self)).attr(name); };
}

py::array strain_view(const py::object& self, float sim::TriangleStrain::*part) {
    const std::vector<sim::TriangleStrain>& strain = self.cast<Result&>().strain;
    const float* first = strain.empty() ? nullptr : &(strain.front().*part);
    return strided_view(first, strain.size(), sizeof(sim::TriangleStrain), self);
}

auto strain_of(float sim::TriangleStrain::*part) {
    return [part](const py::object& self) { return strain_view(self, part); };
}

}  // namespace

const std::vector<float>& clearance_of(Result& result) {
    return result.clearance.get([&] { return measure_clearance(result.dressed.mesh.x, result.body->body()); });
}

const sim::ContactPressure& contact_of(Result& result) {
    return result.contact.get([&] {
        if (result.dressed.report.stopped_because == "bad number")
            throw sim::InputError("", "pressure", "a position is not finite");
        const sim::PreparedBody& body = *result.body;
        const auto collider = body.stands_otherwise() ? std::make_shared<const sim::BodyCollider>(body.body())
                                                      : body.collider();  // which dressing has built
        sim::Simulation simulation = *result.dressed.simulation;
        forget_contacts(simulation.cloth());
        return measure_contact_pressure(std::move(simulation), *collider);
    });
}

const std::vector<std::vector<int>>& seams_of(Result& result) {
    return result.seams.get(
        [&] { return seams_of_vertices(result.dressed.mesh, result.pattern, result.dressed.meshing); });
}

namespace {

py::array clearance_view(const py::object& self) {
    return view_of(clearance_of(self.cast<Result&>()), self);
}

py::array_t<int> first_seams(Result& self) {
    const std::vector<std::vector<int>>& seams = seams_of(self);
    py::array_t<int> array(static_cast<py::ssize_t>(seams.size()));
    for (std::size_t v = 0; v < seams.size(); ++v)
        array.mutable_at(static_cast<py::ssize_t>(v)) = seams[v].empty() ? -1 : seams[v].front();
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

py::array_t<std::uint32_t> seam_vertices(Result& self, const std::variant<int, std::string>& seam) {
    std::vector<int> wanted;
    if (const auto* name = std::get_if<std::string>(&seam)) {
        wanted = find_seams(self.pattern, *name);
        if (wanted.empty()) throw sim::InputError("", "seam", "no seam '" + *name + "'");
    } else {
        wanted = {std::get<int>(seam)};
        if (wanted.front() < 0 || static_cast<std::size_t>(wanted.front()) >= self.pattern.seams.size())
            throw sim::InputError("", "seam", "no seam " + std::to_string(wanted.front()));
    }
    std::vector<std::uint32_t> vertices;
    const std::vector<std::vector<int>>& seams = seams_of(self);
    for (std::size_t v = 0; v < seams.size(); ++v) {
        const bool is_on = std::ranges::find_first_of(seams[v], wanted) != seams[v].end();
        if (is_on) vertices.push_back(static_cast<std::uint32_t>(v));
    }
    return py::array_t<std::uint32_t>(static_cast<py::ssize_t>(vertices.size()), vertices.data());
}

std::vector<std::string> seam_names(const Result& self) {
    std::vector<std::string> names;
    for (const sim::Seam& seam : self.pattern.seams) names.push_back(sim::seam_name(self.pattern, seam));
    return names;
}

py::dict report_of(const Result& self) {
    return py::module_::import("json").attr("loads")(self.report);
}

void export_result(const Result& self, const std::string& path, const std::vector<std::string>& texts) {
    const py::gil_scoped_release release;
    std::vector<std::string> all = texts;
    all.emplace_back("--export=its.obj");  // other options need one
    app::ExportOptions options = app::read_export_options(all);
    options.files.files = {path};
    app::check_garment_files(options.files);
    const app::PictureOptions picture = picture_of(self, options.picture);
    app::GarmentFiles(options.files, picture, self.dressed.mesh, self.body->body()).write(path);
}

void add_arrays(py::class_<Result, ResultPointer>& result) {
    result
        .def_property_readonly("mesh", &whole_mesh,
                               "The triangles of the cloth as a Mesh, which shares the result's memory.")
        .def_property_readonly("positions", of_mesh("positions"), "Positions, float32 of shape (vertices, 3), m.")
        .def_property_readonly("normals", of_mesh("normals"),
                               "Unit normals, float32 of shape (vertices, 3), to the fabric's right side.")
        .def_property_readonly(
            "triangles", of_mesh("triangles"),
            "Vertex indices, uint32 of shape (triangles, 3), counter-clockwise seen from the fabric's right side.")
        .def_property_readonly(
            "material", of_mesh("material"),
            "Material coordinates of each corner, float32 of shape (triangles, 3, 2), m, in the frame "
            "of the panel.")
        .def_property_readonly("panel", of_mesh("panel"), "Index into panel_names, uint16 of shape (triangles,).")
        .def_property_readonly("level", of_mesh("level"),
                               "How often the base mesh was divided there, uint8 of shape (triangles,).")
        .def_property_readonly("panel_names", of_mesh("panel_names"), "Names of the panels.")
        .def_property_readonly("strain_warp", strain_of(&sim::TriangleStrain::warp),
                               "Strain along the warp, float32 of shape (triangles,): 0.01 is 1 % longer.")
        .def_property_readonly("strain_weft", strain_of(&sim::TriangleStrain::weft),
                               "Strain along the weft, float32 of shape (triangles,).")
        .def_property_readonly(
            "shear", strain_of(&sim::TriangleStrain::shear),
            "By how much the angle between warp and weft differs from a right angle, float32 of shape "
            "(triangles,), rad, unsigned.")
        .def_property_readonly(
            "clearance", &clearance_view,
            "Signed distance from the body, float32 of shape (vertices,), m, negative inside. Computed "
            "when first asked for.")
        .def_property_readonly(
            "pressure", [](const py::object& self) { return view_of(contact_of(self.cast<Result&>()).pressure, self); },
            "Pressure of the cloth on the body, float32 of shape (vertices,), N/m^2, 0 where it does not touch: the "
            "part "
            "of `contact_force` along the body's normal, per area of cloth round the vertex. Computed when first asked "
            "for, in a second or more.")
        .def_property_readonly(
            "contact_force",
            [](const py::object& self) { return view_of(contact_of(self.cast<Result&>()).force, self); },
            "Force of the body on each vertex, with friction, float32 of shape (vertices, 3), N. The solver keeps no "
            "force, so it is measured: the cloth goes on for 0.6 s, and once in each step the same sub-step is "
            "computed "
            "with and without the body. Force = mass * difference of positions / sub-step^2, the mean of the last 0.5 "
            "s. "
            "At rest the sum of the forces is the weight.")
        .def_property_readonly(
            "seam", &first_seams,
            "Seam of each vertex, int32 of shape (vertices,): index into seam_names, -1 on none; where "
            "several seams meet, the lowest. A copy.")
        .def(
            "seam_vertices", &seam_vertices, py::arg("seam"),
            "Vertices on a seam, uint32 of shape (n,), ascending; `seam` is its index or its name. Where several seams "
            "meet, a vertex is on each. Raises InputError if there is no such seam.")
        .def_property_readonly("seam_names", &seam_names, "Names of the seams, in the pattern's order.");
}

}  // namespace

void add_results(py::module_& module) {
    py::class_<DressArguments>(module, "_DressArguments", "Arguments that dress() and Session have in common.")
        .def(py::init<std::string, std::optional<double>, int, double, std::optional<int>, bool>(), py::arg("fabric"),
             py::arg("edge_length").none(true), py::arg("max_level"), py::arg("shortest_edge"),
             py::arg("triangles").none(true), py::arg("self_collision"), "Lengths in m.");
    py::class_<Result, ResultPointer> result(
        module, "Result",
        "A dressed garment. It does not change. Its arrays are read-only views of its memory, without "
        "a copy, which keep it alive; where an array is a copy or is computed later, its text says so.");
    add_arrays(result);
    result
        .def_property_readonly(
            "body", [](const Result& self) { return self.body; }, "The body that wears it.")
        .def_property_readonly("report", &report_of,
                               "What came of it: the report of `selvedge dress --report`, a dict.")
        .def_property_readonly(
            "faults", [](const Result& self) -> py::object { return report_of(self)["faults"]; },
            "The report's faults: a list of dicts with kind, class, place and value. Empty: a sound drape.")
        .def_property_readonly(
            "settled", [](const Result& self) { return self.dressed.report.settled; },
            "Whether the garment came to rest.")
        .def(py::pickle([](Result& self) { return py::bytes(bytes_of(self)); },
                        [](const py::bytes& state) { return result_from(state); }))
        .def("_export", &export_result, py::arg("path"), py::arg("options"), "Writes a file, as the command does.")
        .def("__repr__", [](const Result& self) {
            return "<selvedge.Result '" + self.dressed.report.garment + "', " +
                   std::to_string(self.dressed.mesh.triangles.size()) + " triangles>";
        });
    module.def("_dress", &dress, py::arg("pattern"), py::arg("body").none(true), py::arg("over"), py::arg("arguments"),
               py::arg("seconds"), py::arg("threads").none(true), py::arg("progress").none(true),
               "Dresses a body in a pattern.");
}

}  // namespace selvedge::python
