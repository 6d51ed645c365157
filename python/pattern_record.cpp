#include "python/pattern_record.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "python/errors.h"
#include "sim/core/json.h"
#include "sim/pattern/enum_names.h"
#include "sim/pattern/fault.h"
#include "sim/pattern/outline.h"

namespace selvedge::python {
namespace {

// From C++ to records. Arrays are copies, which Python may change.

template <class Vector>
py::array_t<double> array_of(const Vector& v) {
    py::array_t<double> array(static_cast<py::ssize_t>(v.size()));
    for (py::ssize_t i = 0; i < v.size(); ++i) array.mutable_at(i) = v[i];
    return array;
}

py::array_t<double> array_of(const std::vector<Vec2d>& points) {
    py::array_t<double> array({static_cast<py::ssize_t>(points.size()), py::ssize_t{2}});
    for (std::size_t i = 0; i < points.size(); ++i)
        for (py::ssize_t k = 0; k < 2; ++k) array.mutable_at(static_cast<py::ssize_t>(i), k) = points[i][k];
    return array;
}

py::array_t<double> array_of(const Eigen::Matrix3d& matrix) {
    py::array_t<double> array({3, 3});
    for (py::ssize_t i = 0; i < 3; ++i)
        for (py::ssize_t k = 0; k < 3; ++k) array.mutable_at(i, k) = matrix(i, k);
    return array;
}

py::object optional_of(const std::optional<double>& value) {
    return value ? py::object(py::float_(*value)) : py::object(py::none());
}

template <class T>
py::str word_of(T value) {
    return {std::string(sim::name_of_value(value))};
}

std::size_t control_count(sim::CurveKind kind) {
    return kind == sim::CurveKind::Cubic ? 2 : (kind == sim::CurveKind::Quadratic ? 1 : 0);
}

py::dict record_of(const sim::OutlineEdge& edge) {
    const std::size_t controls = control_count(edge.kind);
    py::dict record;
    record["start"] = edge.start;
    record["end"] = edge.end;
    record["kind"] = word_of(edge.kind);
    record["control"] = array_of(std::vector<Vec2d>(edge.control.begin(), edge.control.begin() + controls));
    record["radius"] = edge.arc_radius;
    record["is_large_arc"] = edge.is_large_arc;
    record["turns_right"] = edge.turns_right;
    record["label"] = edge.label;
    record["allowance"] = optional_of(edge.allowance);
    record["allowance_corner"] = word_of(edge.allowance_corner);
    return record;
}

py::list records_of_notches(const sim::Panel& panel) {
    py::list records;
    for (const sim::Notch& notch : panel.notches) {
        py::dict record;
        record["edge"] = notch.edge;
        record["at"] = notch.t;
        record["kind"] = word_of(notch.kind);
        record["count"] = notch.count;
        records.append(record);
    }
    return records;
}

py::list records_of_lines(const sim::Panel& panel) {
    py::list records;
    for (const sim::InternalLine& line : panel.internal_lines) {
        py::dict record;
        record["name"] = line.name;
        record["points"] = array_of(line.points);
        record["use"] = word_of(line.use);
        records.append(record);
    }
    return records;
}

py::dict record_of(const sim::Panel& panel) {
    py::dict record;
    record["name"] = panel.name;
    record["vertices"] = array_of(panel.vertices);
    py::list edges;
    for (const sim::OutlineEdge& edge : panel.edges) edges.append(record_of(edge));
    record["edges"] = edges;
    record["translation"] = array_of(panel.translation);
    record["rotation"] = array_of(panel.rotation);
    record["is_mirrored"] = panel.is_mirrored;
    record["grain_angle"] = panel.grain_angle;
    record["sett_offset"] = array_of(panel.sett_offset);
    record["fabric"] = panel.fabric;
    record["interlinings"] = panel.interlinings;
    record["layer"] = panel.layer;
    record["garment"] = panel.garment;
    record["pins"] = panel.pins;
    record["internal_lines"] = records_of_lines(panel);
    record["notches"] = records_of_notches(panel);
    record["drill_points"] = array_of(panel.drill_points);
    record["allowance"] = optional_of(panel.allowance);
    record["pieces"] = panel.pieces;
    record["is_worn"] = panel.is_worn;
    record["wrap_radius"] = panel.wrap_radius;
    record["mirror_of"] = panel.mirror_of;
    record["label"] = panel.label;
    record["sheet_position"] = panel.sheet_position ? py::object(array_of(*panel.sheet_position)) : py::none();
    return record;
}

py::dict record_of(const sim::Seam& seam, const sim::Pattern& pattern) {
    const auto side = [&](const sim::SeamSide& one) { return py::make_tuple(panel_of(pattern, one).name, one.edge); };
    py::dict record;
    record["first"] = side(seam.first);
    record["second"] = side(seam.second);
    record["is_reversed"] = seam.is_reversed;
    record["name"] = seam.name;
    record["is_eased"] = seam.is_eased;
    record["sewing"] = seam.sewing;
    return record;
}

}  // namespace

py::dict record_of(const std::shared_ptr<const Document>& document) {
    const sim::Pattern& pattern = document->content.pattern;
    py::dict record;
    record["name"] = pattern.name;
    py::list panels, seams;
    for (std::size_t i = 0; i < pattern.panels.size(); ++i) {
        py::dict panel = record_of(pattern.panels[i]);
        panel["origin"] = py::make_tuple(std::const_pointer_cast<Document>(document), i);
        panels.append(panel);
    }
    for (const sim::Seam& seam : pattern.seams) seams.append(record_of(seam, pattern));
    record["panels"] = panels;
    record["seams"] = seams;
    record["fabric"] = pattern.fabric;
    record["tartan"] = pattern.tartan;
    record["sett_size"] = optional_of(pattern.sett_size);
    record["sett_position"] = array_of(pattern.sett_position);
    record["body"] = pattern.body;
    record["body_height"] = pattern.body_height;
    record["edge_length"] = optional_of(pattern.edge_length);
    record["allowance"] = pattern.allowance;
    record["size"] = pattern.size;
    return record;
}

// From records to C++.

namespace {

constexpr long kMostVertices = 1'000'000;  // of an array: more is a mistake

py::object item(const py::dict& record, const char* key, const std::string& place) {
    if (!record.contains(key)) throw sim::InputError("", place, std::string("no '") + key + "'");
    return record[key];
}

std::string path(const std::string& place, const char* key) {
    return place.empty() ? key : place + "." + key;
}

// Reads the values of one record; `place` leads to it.
struct RecordReader {
    const py::dict& record;
    std::string place;

    py::object at(const char* key) const { return item(record, key, place); }
    std::string text(const char* key) const { return value_of<std::string>(at(key), path(place, key), "text"); }
    int whole(const char* key) const { return value_of<int>(at(key), path(place, key), "a whole number"); }
    bool flag(const char* key) const { return value_of<bool>(at(key), path(place, key), "True or False"); }
    double number(const char* key) const { return finite_of(at(key), path(place, key)); }
    std::optional<double> optional_number(const char* key) const {
        return at(key).is_none() ? std::nullopt : std::optional(number(key));
    }
    py::list list(const char* key) const {
        const py::object value = at(key);
        if (!py::isinstance<py::list>(value) && !py::isinstance<py::tuple>(value))
            throw sim::InputError("", path(place, key), "must be a list");
        return py::list(value);
    }
    RecordReader inner(const py::dict& one, const char* key, std::size_t index) const {
        return {one, sim::json_path(path(place, key), index)};
    }

    // An array of that many columns, each number within 100 m; rows < 0: any number of them; columns 0: one dimension.
    py::array_t<double> numbers(const char* key, long rows, long columns, double most = sim::kMaxCoordinate) const;
    template <int N>
    Eigen::Matrix<double, N, 1> vector(const char* key) const {
        const py::array_t<double> array = numbers(key, N, 0);
        Eigen::Matrix<double, N, 1> v;
        for (int i = 0; i < N; ++i) v[i] = array.at(i);
        return v;
    }
    std::vector<Vec2d> points(const char* key) const {
        const py::array_t<double> array = numbers(key, -1, 2);
        std::vector<Vec2d> read;
        for (py::ssize_t i = 0; array.ndim() == 2 && i < array.shape(0); ++i)
            read.emplace_back(array.at(i, 0), array.at(i, 1));
        return read;
    }
    template <class T>
    T choice(const char* key) const {
        constexpr auto names = sim::names_of(T{});
        const std::string word = text(key);
        const auto found = std::ranges::find(names.texts, word);
        if (found != names.texts.end()) return static_cast<T>(found - names.texts.begin());
        std::string known;
        for (const std::string_view name : names.texts) known += (known.empty() ? "" : ", ") + std::string(name);
        throw sim::InputError("", path(place, key), "'" + word + "' is none of " + known);
    }
    int index(const char* key, std::size_t count, const char* of_what) const {
        const int value = whole(key);
        if (value >= 0 && static_cast<std::size_t>(value) < count) return value;
        throw sim::InputError(
            "", path(place, key),
            std::string("no ") + of_what + " " + std::to_string(value) + ": there are " + std::to_string(count));
    }
};

py::array_t<double> RecordReader::numbers(const char* key, long rows, long columns, double most) const {
    const auto fail = [&](const std::string& problem) { throw sim::InputError("", path(place, key), problem); };
    const std::string shape = columns > 0
                                  ? "(" + (rows < 0 ? "n" : std::to_string(rows)) + ", " + std::to_string(columns) + ")"
                                  : "(" + std::to_string(rows) + ",)";
    auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(at(key));
    if (!array) {
        PyErr_Clear();
        fail("must be an array of numbers of shape " + shape);
    }
    if (array.size() == 0 && rows < 0) return array;
    const bool has_shape = array.ndim() == (columns > 0 ? 2 : 1) && (rows < 0 || array.shape(0) == rows) &&
                           (columns == 0 || array.shape(1) == columns) && array.size() <= kMostVertices;
    if (!has_shape) fail("must be an array of shape " + shape);
    for (py::ssize_t i = 0; i < array.size(); ++i)
        if (!(std::abs(array.data()[i]) <= most)) fail("must be finite, and not over " + short_text(most));
    return array;
}

sim::OutlineEdge edge_of(const RecordReader& reader, std::size_t vertices) {
    sim::OutlineEdge edge;
    edge.start = reader.index("start", vertices, "vertex");
    edge.end = reader.index("end", vertices, "vertex");
    edge.kind = reader.choice<sim::CurveKind>("kind");
    const std::size_t controls = control_count(edge.kind);
    const std::vector<Vec2d> points = reader.points("control");
    if (points.size() != controls) {
        throw sim::InputError("", path(reader.place, "control"),
                              "must be an array of shape (" + std::to_string(controls) + ", 2) for this kind");
    }
    std::ranges::copy(points, edge.control.begin());
    edge.arc_radius = reader.number("radius");
    edge.is_large_arc = reader.flag("is_large_arc");
    edge.turns_right = reader.flag("turns_right");
    edge.label = reader.text("label");
    edge.allowance = reader.optional_number("allowance");
    edge.allowance_corner = reader.choice<sim::AllowanceCorner>("allowance_corner");
    return edge;
}

// The loop that all work with outlines takes for granted.
void check_loop(const sim::Panel& panel, const std::string& place) {
    if (panel.edges.size() < 2 || panel.edges.size() > sim::kMaxEdges) {
        throw sim::InputError(
            "", place + ".edges",
            std::to_string(panel.edges.size()) + " edges: an outline has 2 to " + std::to_string(sim::kMaxEdges));
    }
    for (std::size_t i = 0; i < panel.edges.size(); ++i) {
        const sim::OutlineEdge& edge = panel.edges[i];
        const std::string at = sim::json_path(place + ".edges", i);
        const auto vertex = [&](int v) { return panel.vertices[static_cast<std::size_t>(v)]; };
        const double chord = (vertex(edge.end) - vertex(edge.start)).norm();
        if (edge.end != panel.edges[(i + 1) % panel.edges.size()].start)
            throw sim::InputError("", at, "must end where the next edge starts");
        if (chord < sim::kShortestEdge) throw sim::InputError("", at, "is shorter than 0.01 mm");
        if (edge.kind == sim::CurveKind::Arc && !(edge.arc_radius * 2 >= chord * (1 - 1e-6)))
            throw sim::InputError("", at + ".radius", "is too small for the distance between the edge's ends");
    }
    const double area = outline_area(panel);
    if (area < 0)
        throw sim::InputError("", place,
                              "the outline is clockwise: it must be counter-clockwise, seen from the right side");
    if (area < sim::kSmallestArea) throw sim::InputError("", place, "the outline encloses no area");
}

void read_marks(const RecordReader& reader, sim::Panel& panel) {
    panel.pins = value_of<std::vector<int>>(reader.at("pins"), path(reader.place, "pins"), "a list of vertices");
    for (const int pin : panel.pins) {
        if (pin < 0 || static_cast<std::size_t>(pin) >= panel.vertices.size())
            throw sim::InputError("", path(reader.place, "pins"), "no vertex " + std::to_string(pin));
    }
    panel.notches.clear();
    const py::list notches = reader.list("notches"), lines = reader.list("internal_lines");
    for (std::size_t i = 0; i < notches.size(); ++i) {
        const py::dict record = notches[i].cast<py::dict>();
        const RecordReader notch = reader.inner(record, "notches", i);
        panel.notches.push_back(
            {.edge = notch.index("edge", panel.edges.size(), "edge"),
             .t = within(notch.number("at"), {0.0, 1.0}, path(notch.place, "at")),
             .kind = notch.choice<sim::NotchKind>("kind"),
             .count = within(notch.whole("count"), {1, sim::kMostNotchesTogether}, path(notch.place, "count"))});
    }
    panel.internal_lines.clear();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const py::dict record = lines[i].cast<py::dict>();
        const RecordReader line = reader.inner(record, "internal_lines", i);
        panel.internal_lines.push_back(
            {.name = line.text("name"), .points = line.points("points"), .use = line.choice<sim::LineUse>("use")});
    }
}

void read_placement(const RecordReader& reader, sim::Panel& panel) {
    panel.translation = reader.vector<3>("translation");
    const py::array_t<double> rotation = reader.numbers("rotation", 3, 3, 2);
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) panel.rotation(i, k) = rotation.at(i, k);
    const bool is_rotation = panel.rotation.isUnitary(1e-6) && panel.rotation.determinant() > 0;
    if (!is_rotation) throw sim::InputError("", path(reader.place, "rotation"), "is no rotation matrix");
    panel.wrap_radius =
        within(reader.number("wrap_radius"), {0.0, sim::kMaxCoordinate}, path(reader.place, "wrap_radius"));
    panel.is_mirrored = reader.flag("is_mirrored");
}

sim::Panel panel_of_record(const RecordReader& reader) {
    sim::Panel panel;
    if (reader.record.contains("origin") && !reader.at("origin").is_none()) {
        const auto origin = reader.at("origin").cast<std::pair<DocumentPointer, std::size_t>>();
        panel = origin.first->content.pattern.panels.at(origin.second);
    }
    panel.name = reader.text("name");
    if (panel.name.empty()) throw sim::InputError("", path(reader.place, "name"), "is empty");
    panel.vertices = reader.points("vertices");
    panel.edges.clear();
    const py::list edges = reader.list("edges");
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const py::dict record = edges[i].cast<py::dict>();
        panel.edges.push_back(edge_of(reader.inner(record, "edges", i), panel.vertices.size()));
    }
    check_loop(panel, reader.place);
    read_placement(reader, panel);
    panel.grain_angle = reader.number("grain_angle");
    panel.sett_offset = reader.vector<2>("sett_offset");
    panel.fabric = reader.text("fabric");
    panel.interlinings = value_of<std::vector<std::string>>(reader.at("interlinings"),
                                                            path(reader.place, "interlinings"), "a list of fabrics");
    panel.layer = within(reader.whole("layer"), {-sim::kHighestLayer, sim::kHighestLayer}, path(reader.place, "layer"));
    panel.garment = reader.text("garment");
    read_marks(reader, panel);
    panel.drill_points = reader.points("drill_points");
    panel.allowance = reader.optional_number("allowance");
    panel.pieces = within(reader.whole("pieces"), {1, sim::kMostPieces}, path(reader.place, "pieces"));
    panel.is_worn = reader.flag("is_worn");
    panel.mirror_of = reader.text("mirror_of");
    panel.label = reader.text("label");
    panel.sheet_position.reset();
    if (!reader.at("sheet_position").is_none()) panel.sheet_position = reader.vector<2>("sheet_position");
    return panel;
}

sim::SeamSide side_of(const RecordReader& reader, const char* key, const sim::Pattern& pattern) {
    const std::string place = path(reader.place, key);
    const auto [name, edge] =
        value_of<std::pair<std::string, int>>(reader.at(key), place, "a panel's name and an edge");
    const auto found = std::ranges::find(pattern.panels, name, &sim::Panel::name);
    if (found == pattern.panels.end()) throw sim::InputError("", place, "no panel '" + name + "'");
    if (edge < 0 || static_cast<std::size_t>(edge) >= found->edges.size())
        throw sim::InputError("", place, "no edge " + std::to_string(edge) + " of panel '" + name + "'");
    return {.panel = static_cast<int>(found - pattern.panels.begin()), .edge = edge};
}

void read_seams(const RecordReader& reader, sim::Pattern& pattern) {
    pattern.seams.clear();
    const py::list seams = reader.list("seams");
    for (std::size_t i = 0; i < seams.size(); ++i) {
        const py::dict record = seams[i].cast<py::dict>();
        const RecordReader seam = reader.inner(record, "seams", i);
        pattern.seams.push_back({.first = side_of(seam, "first", pattern),
                                 .second = side_of(seam, "second", pattern),
                                 .is_reversed = seam.flag("is_reversed"),
                                 .name = seam.text("name"),
                                 .is_eased = seam.flag("is_eased"),
                                 .sewing = seam.text("sewing")});
    }
}

}  // namespace

sim::Pattern pattern_of(const py::dict& record, const sim::Pattern& base) {
    const RecordReader reader{record, ""};
    sim::Pattern pattern = base;
    pattern.name = reader.text("name");
    pattern.panels.clear();
    const py::list panels = reader.list("panels");
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const py::dict one = panels[i].cast<py::dict>();
        sim::Panel panel = panel_of_record(reader.inner(one, "panels", i));
        if (std::ranges::find(pattern.panels, panel.name, &sim::Panel::name) != pattern.panels.end())
            throw sim::InputError("", sim::json_path("panels", i) + ".name",
                                  "there are two panels '" + panel.name + "'");
        pattern.panels.push_back(std::move(panel));
    }
    read_seams(reader, pattern);
    pattern.fabric = reader.text("fabric");
    pattern.tartan = reader.text("tartan");
    pattern.sett_size = reader.optional_number("sett_size");
    pattern.sett_position = reader.vector<2>("sett_position");
    pattern.body = reader.text("body");
    pattern.body_height = reader.number("body_height");
    pattern.edge_length = reader.optional_number("edge_length");
    pattern.allowance = reader.number("allowance");
    pattern.size = reader.text("size");
    return pattern;
}

}  // namespace selvedge::python
