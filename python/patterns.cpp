#include "python/patterns.h"

#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include "app/print_files.h"
#include "python/errors.h"
#include "python/pattern_record.h"
#include "python/pickles.h"
#include "render/output/pattern_faults.h"
#include "sim/core/error.h"

namespace selvedge::python {
namespace {

DocumentPointer load_document(const std::string& path) {
    const py::gil_scoped_release release;
    return std::make_shared<Document>(Document{sim::load_pattern(path), path});
}

// Throws InputError for the first fault that is an error: those that loading would find.
void check(const Document& document) {
    const std::vector<sim::Fault> faults = sim::check_pattern_text(sim::write_pattern(document.content), "");
    for (const sim::Fault& fault : faults)
        if (fault.severity == sim::Severity::Error) throw sim::InputError("", fault.place, fault.problem);
}

// Panels that were renamed keep what else the file says of them.
void rename_in_file(Document& document, const py::dict& record, const DocumentPointer& base) {
    const py::list panels = record["panels"];
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const py::object origin = panels[i].cast<py::dict>()["origin"];
        if (origin.is_none()) continue;
        const auto [source, index] = origin.cast<std::pair<DocumentPointer, std::size_t>>();
        if (source != base) continue;
        const std::string& before = source->content.pattern.panels[index].name;
        const std::string& now = document.content.pattern.panels[i].name;
        if (before != now) sim::rename_panel_in_file(document.content.json, before, now);
    }
}

DocumentPointer make_document(const py::dict& record, const DocumentPointer& base) {
    auto document = std::make_shared<Document>();
    if (base) *document = *base;
    document->content.pattern = pattern_of(record, document->content.pattern);
    if (base) rename_in_file(*document, record, base);
    const py::gil_scoped_release release;
    check(*document);
    return document;
}

void save(const DocumentPointer& document, const std::string& path) {
    const py::gil_scoped_release release;
    save_pattern(document->content, path);
}

py::list tuples_of(const std::vector<sim::Fault>& faults) {
    py::list tuples;
    for (const sim::Fault& fault : faults)
        tuples.append(py::make_tuple(fault.severity == sim::Severity::Error ? "error" : "warning", fault.file,
                                     fault.place, fault.problem));
    return tuples;
}

std::string svg_of(const DocumentPointer& document) {
    const py::gil_scoped_release release;
    return app::svg_of_pattern(document->content.pattern);
}

py::list faults_of(const DocumentPointer& document) {
    std::vector<sim::Fault> faults;
    {
        const py::gil_scoped_release release;
        faults = sim::check_pattern_text(sim::write_pattern(document->content), document->file);
        if (!has_error(faults)) render::add_faults_of_dressing(document->content.pattern, document->file, faults);
    }
    return tuples_of(faults);
}

py::list faults_of_file(const std::string& path) {
    std::vector<sim::Fault> faults;
    {
        const py::gil_scoped_release release;
        faults = render::faults_of_file(path);
    }
    return tuples_of(faults);
}

}  // namespace

void add_patterns(py::module_& module) {
    py::class_<Document, DocumentPointer>(module, "_Document", "A pattern as the program holds it; it does not change.")
        .def(
            "__deepcopy__", [](const DocumentPointer& self, const py::dict&) { return self; }, py::arg("memo"),
            "The document itself, for it does not change.")
        .def(py::pickle(&state_of, &document_from));
    module.def("_load_document", &load_document, py::arg("path"), "The document of a garment file.");
    module.def(
        "_record", [](const DocumentPointer& document) { return record_of(document); }, py::arg("document"),
        "The document's pattern as dictionaries, lists and arrays.");
    module.def("_make_document", &make_document, py::arg("record"), py::arg("base").none(true),
               "The document of a record; what this does not hold comes from `base`.");
    module.def("_save", &save, py::arg("document"), py::arg("path"), "Writes a garment file.");
    module.def(
        "_text", [](const DocumentPointer& document) { return sim::write_pattern(document->content); },
        py::arg("document"), "The document as the text of a garment file.");
    module.def("_svg", &svg_of, py::arg("document"), "The pattern's sheet as an SVG, at its true size.");
    module.def("_faults", &faults_of, py::arg("document"), "(severity, file, place, problem) of each fault.");
    module.def("_faults_of_file", &faults_of_file, py::arg("path"), "The same of a file.");
}

}  // namespace selvedge::python
