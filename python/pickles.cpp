#include "python/pickles.h"

#include <optional>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/flat_bytes.h"
#include "sim/core/version.h"
#include "sim/mannequin/mannequin_bytes.h"
#include "sim/repair/body_bytes.h"

namespace selvedge::python {
namespace {

[[noreturn]] void refuse() {
    throw sim::InputError("", "pickle", "made by another version of selvedge, or broken");
}

sim::FlatWriter begun() {
    sim::FlatWriter writer;
    writer.text(sim::program_version());
    return writer;
}

sim::FlatReader opened(std::string_view bytes) {
    sim::FlatReader reader(bytes);
    if (reader.text() != sim::program_version()) refuse();
    return reader;
}

void write_mesh(sim::FlatWriter& writer, const sim::DrawMesh& mesh) {
    writer.list(mesh.x);
    writer.list(mesh.normals);
    writer.list(mesh.triangles);
    writer.list(mesh.u);
    writer.list(mesh.panel);
    writer.list(mesh.level);
    writer.list(mesh.vertex_level);
    writer.texts(mesh.panel_names);
    writer.list(mesh.panel_grain_angles);
    writer.list(mesh.panel_sett_offsets);
    writer.list(mesh.turned_corners);
}

sim::DrawMesh read_mesh(sim::FlatReader& reader) {
    sim::DrawMesh mesh;
    mesh.x = reader.list<Vec3f>();
    mesh.normals = reader.list<Vec3f>();
    mesh.triangles = reader.list<std::array<std::uint32_t, 3>>();
    mesh.u = reader.list<std::array<Vec2f, 3>>();
    mesh.panel = reader.list<std::uint16_t>();
    mesh.level = reader.list<std::uint8_t>();
    mesh.vertex_level = reader.list<std::uint8_t>();
    mesh.panel_names = reader.texts();
    mesh.panel_grain_angles = reader.list<float>();
    mesh.panel_sett_offsets = reader.list<Vec2f>();
    mesh.turned_corners = reader.list<std::uint8_t>();
    return mesh;
}

constexpr std::string_view kBadNumber = "bad number";

}  // namespace

std::string bytes_of(const sim::PreparedBody& body) {
    const sim::MadeBody& made = body.made();
    sim::FlatWriter writer = begun();
    writer.text(made.source);
    writer.text(to_bytes(*made.body));
    writer.texts(made.notes);
    writer.value(made.readings.has_value());
    if (made.readings) write(writer, *made.readings);
    writer.each(made.clips, [&](const sim::Clip& clip) {
        write(writer, clip);
        writer.texts(clip.notes);
    });
    return writer.bytes();
}

BodyPointer body_from(std::string_view bytes) {
    sim::FlatReader reader = opened(bytes);
    sim::MadeBody made{.source = reader.text()};
    std::optional<sim::Body> body = sim::body_from_bytes(reader.text());
    if (!body) refuse();
    made.body = std::make_shared<const sim::Body>(std::move(*body));
    made.notes = reader.texts();
    if (reader.value<bool>()) made.readings = sim::read_readings(reader);
    made.clips = reader.each<sim::Clip>([&](sim::Clip& clip) {
        read(reader, clip);
        clip.notes = reader.texts();
    });
    if (!reader.is_sound() || !reader.is_at_end()) refuse();
    return std::make_shared<sim::PreparedBody>(std::move(made));
}

std::string bytes_of(Result& result) {
    sim::FlatWriter writer = begun();
    writer.text(sim::write_pattern({.pattern = result.pattern, .json = {}}));
    writer.text(result.pattern.name);
    writer.text(bytes_of(*result.body));
    writer.text(result.garment.fabric);
    writer.text(result.report);
    writer.text(result.dressed.report.garment);
    writer.text(result.dressed.report.stopped_because);
    writer.value(result.dressed.report.settled);
    write_mesh(writer, result.dressed.mesh);
    writer.list(result.dressed.hierarchy);
    writer.list(result.strain);
    writer.list(clearance_of(result));
    const bool is_finite = result.dressed.report.stopped_because != kBadNumber;
    writer.list(is_finite ? contact_of(result).force : std::vector<Vec3f>());
    writer.list(is_finite ? contact_of(result).pressure : std::vector<float>());
    writer.each(seams_of(result), [&](const std::vector<int>& of_vertex) { writer.list(of_vertex); });
    return writer.bytes();
}

ResultPointer result_from(std::string_view bytes) {
    sim::FlatReader reader = opened(bytes);
    auto result = std::make_shared<Result>();
    result->pattern = sim::parse_pattern(reader.text(), "").pattern;
    result->pattern.name = reader.text();
    result->body = body_from(reader.text());
    result->garment.fabric = reader.text();
    result->report = reader.text();
    result->dressed.report.garment = reader.text();
    result->dressed.report.stopped_because = reader.text();
    result->dressed.report.settled = reader.value<bool>();
    result->dressed.mesh = read_mesh(reader);
    result->dressed.hierarchy = reader.list<sim::HierarchyTriangle>();
    result->strain = reader.list<sim::TriangleStrain>();
    result->clearance.set(reader.list<float>());
    sim::ContactPressure contact{.force = reader.list<Vec3f>(), .pressure = {}};
    contact.pressure = reader.list<float>();
    if (result->dressed.report.stopped_because != kBadNumber) result->contact.set(std::move(contact));
    result->seams.set(
        reader.each<std::vector<int>>([&](std::vector<int>& of_vertex) { of_vertex = reader.list<int>(); }));
    if (!reader.is_sound() || !reader.is_at_end()) refuse();
    return result;
}

py::tuple state_of(const Document& document) {
    return py::make_tuple(sim::write_pattern(document.content, document.file), document.file);
}

DocumentPointer document_from(const py::tuple& state) {
    const auto file = state[1].cast<std::string>();
    return std::make_shared<Document>(Document{sim::parse_pattern(state[0].cast<std::string>(), file), file});
}

}  // namespace selvedge::python
