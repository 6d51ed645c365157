#include "python/pattern_record.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "python/errors.h"
#include "sim/core/json.h"
#include "sim/pattern/enum_names.h"
#include "sim/pattern/fault.h"
#include "sim/pattern/field.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/pattern_fields.h"

namespace selvedge::python {
namespace {

// From C++ to records. Arrays are copies, which Python may change.

template <int N>
py::array_t<double> array_of(const Eigen::Matrix<double, N, 1>& v) {
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

std::size_t control_count(sim::CurveKind kind) {
    return kind == sim::CurveKind::Cubic ? 2 : (kind == sim::CurveKind::Quadratic ? 1 : 0);
}

template <sim::Described Part>
py::dict record_of(const Part& part);

// One value of a part.
template <class T>
py::object python_of(const T& value) {
    if constexpr (std::is_enum_v<T>) {
        return py::str(std::string(sim::name_of_value(value)));
    } else if constexpr (sim::Described<T>) {
        return record_of(value);
    } else if constexpr (requires { value.has_value(); }) {
        return value ? python_of(*value) : py::none();
    } else if constexpr (requires { array_of(value); }) {
        return array_of(value);
    } else {
        return py::cast(value);
    }
}
template <sim::Described T>
py::object python_of(const std::vector<T>& parts) {
    py::list records;
    for (const T& part : parts) records.append(record_of(part));
    return records;
}

// The fields of a part by their names.
template <sim::Described Part>
py::dict record_of(const Part& part) {
    py::dict record;
    sim::visit_fields(part, [&](const auto& field, const auto& value) {
        if (!field.is_in_python) return;
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, std::array<Vec2d, 2>>) {
            const auto end = value.begin() + control_count(part.kind);
            record[field.name.data()] = array_of(std::vector<Vec2d>(value.begin(), end));
        } else {
            record[field.name.data()] = python_of(value);
        }
    });
    return record;
}

}  // namespace

py::dict record_of(const std::shared_ptr<const Document>& document) {
    const sim::Pattern& pattern = document->content.pattern;
    py::dict record = record_of(pattern);
    const py::list panels = record["panels"], seams = record["seams"];
    for (std::size_t i = 0; i < pattern.panels.size(); ++i)
        panels[i]["origin"] = py::make_tuple(std::const_pointer_cast<Document>(document), i);
    const auto side = [&](const sim::SeamSide& one) { return py::make_tuple(panel_of(pattern, one).name, one.edge); };
    for (std::size_t i = 0; i < pattern.seams.size(); ++i) {
        seams[i]["first"] = side(pattern.seams[i].first);
        seams[i]["second"] = side(pattern.seams[i].second);
    }
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

// The control points of an edge whose kind was read.
void read_control(const RecordReader& reader, sim::OutlineEdge& edge) {
    const std::size_t controls = control_count(edge.kind);
    const std::vector<Vec2d> points = reader.points("control");
    if (points.size() != controls) {
        throw sim::InputError("", path(reader.place, "control"),
                              "must be an array of shape (" + std::to_string(controls) + ", 2) for this kind");
    }
    std::ranges::copy(points, edge.control.begin());
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

// Reads the fields of a part by their names. `panel`: the part or its panel, for indices.
template <sim::Described Part>
void read_fields(const RecordReader& reader, const sim::Panel* panel, Part& part);

template <class SomeField>
void read_value(const RecordReader& reader, const sim::Panel*, const SomeField& field, bool& value) {
    value = reader.flag(field.name.data());
}
template <class SomeField>
void read_value(const RecordReader& reader, const sim::Panel*, const SomeField& field, double& value) {
    const char* key = field.name.data();
    value = within(reader.number(key), {field.range.least, field.range.most}, path(reader.place, key));
}
template <class SomeField>
void read_value(const RecordReader& reader, const sim::Panel* panel, const SomeField& field, int& value) {
    const char* key = field.name.data();
    if (field.measure == sim::Measure::EdgeIndex) {
        value = reader.index(key, panel->edges.size(), "edge");
    } else if (field.measure == sim::Measure::VertexIndex) {
        value = reader.index(key, panel->vertices.size(), "vertex");
    } else {
        const int least = static_cast<int>(field.range.least), most = static_cast<int>(field.range.most);
        value = within(reader.whole(key), {least, most}, path(reader.place, key));
    }
}
template <class SomeField>
void read_value(const RecordReader& reader, const sim::Panel*, const SomeField& field, std::string& value) {
    const char* key = field.name.data();
    value = reader.text(key);
    if (field.measure == sim::Measure::Colour && !sim::is_colour_text(value))
        throw sim::InputError("", path(reader.place, key), "'" + value + "' is no colour: #RRGGBB is");
}
template <class SomeField, int N>
void read_value(const RecordReader& reader, const sim::Panel*, const SomeField& field,
                Eigen::Matrix<double, N, 1>& value) {
    const char* key = field.name.data();
    value = reader.vector<N>(key);
    for (const double one : value) within(one, {field.range.least, field.range.most}, path(reader.place, key));
}
template <class SomeField>
void read_value(const RecordReader& reader, const sim::Panel*, const SomeField& field, Eigen::Matrix3d& value) {
    const char* key = field.name.data();
    const py::array_t<double> rotation = reader.numbers(key, 3, 3, 2);
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) value(i, k) = rotation.at(i, k);
    const bool is_rotation = value.isUnitary(1e-6) && value.determinant() > 0;
    if (!is_rotation) throw sim::InputError("", path(reader.place, key), "is no rotation matrix");
}
template <class SomeField>
void read_value(const RecordReader& reader, const sim::Panel*, const SomeField& field, std::vector<Vec2d>& value) {
    value = reader.points(field.name.data());
}
template <class SomeField>
void read_value(const RecordReader& reader, const sim::Panel* panel, const SomeField& field, std::vector<int>& value) {
    const std::string place = path(reader.place, field.name.data());
    value = value_of<std::vector<int>>(reader.at(field.name.data()), place, "a list of vertices");
    for (const int vertex : value) {
        if (vertex < 0 || static_cast<std::size_t>(vertex) >= panel->vertices.size())
            throw sim::InputError("", place, "no vertex " + std::to_string(vertex));
    }
}
template <class SomeField>
void read_value(const RecordReader& reader, const sim::Panel*, const SomeField& field,
                std::vector<std::string>& value) {
    const char* key = field.name.data();
    value = value_of<std::vector<std::string>>(reader.at(key), path(reader.place, key), "a list of fabrics");
}
template <class SomeField, class T>
requires std::is_enum_v<T>
void read_value(const RecordReader& reader, const sim::Panel*, const SomeField& field, T& value) {
    value = reader.choice<T>(field.name.data());
}
template <class SomeField, sim::Described T>
void read_value(const RecordReader& reader, const sim::Panel* panel, const SomeField& field, T& value) {
    const char* key = field.name.data();
    const auto record = value_of<py::dict>(reader.at(key), path(reader.place, key), "a record");
    read_fields(RecordReader{record, path(reader.place, key)}, panel, value);
}
template <class SomeField, class T>
void read_value(const RecordReader& reader, const sim::Panel* panel, const SomeField& field, std::optional<T>& value) {
    value.reset();
    if (!reader.at(field.name.data()).is_none()) read_value(reader, panel, field, value.emplace());
}
template <class SomeField, sim::Described T>
void read_value(const RecordReader& reader, const sim::Panel* panel, const SomeField& field, std::vector<T>& values) {
    values.clear();
    const py::list records = reader.list(field.name.data());
    for (std::size_t i = 0; i < records.size(); ++i) {
        const py::dict record = records[i].cast<py::dict>();
        read_fields(reader.inner(record, field.name.data(), i), panel, values.emplace_back());
    }
}

template <sim::Described Part>
void read_fields(const RecordReader& reader, const sim::Panel* panel, Part& part) {
    sim::visit_fields(part, [&]<class SomeField, class T>(const SomeField& field, T& value) {
        if constexpr (std::is_same_v<T, std::array<Vec2d, 2>>) {
            read_control(reader, part);
        } else if constexpr (!std::is_same_v<T, sim::SeamSide>) {
            if (field.is_in_python) read_value(reader, panel, field, value);
        }
        if constexpr (std::is_same_v<T, std::vector<sim::OutlineEdge>>) check_loop(*panel, reader.place);
    });
}

sim::Panel panel_of_record(const RecordReader& reader) {
    sim::Panel panel;
    if (reader.record.contains("origin") && !reader.at("origin").is_none()) {
        const auto origin = reader.at("origin").cast<std::pair<DocumentPointer, std::size_t>>();
        panel = origin.first->content.pattern.panels.at(origin.second);
    }
    if (reader.text("name").empty()) throw sim::InputError("", path(reader.place, "name"), "is empty");
    const std::vector<sim::OutlineEdge> edges = panel.edges;
    read_fields(reader, &panel, panel);
    if (panel.edges.size() != edges.size()) panel.last_key = panel.fold_key = 0;
    for (std::size_t e = 0; panel.last_key > 0 && e < edges.size(); ++e) panel.edges[e].key = edges[e].key;
    return panel;
}

void read_seams(const RecordReader& reader, sim::Pattern& pattern) {
    pattern.seams.clear();
    const py::list seams = reader.list("seams");
    for (std::size_t i = 0; i < seams.size(); ++i) {
        const py::dict record = seams[i].cast<py::dict>();
        const RecordReader inner = reader.inner(record, "seams", i);
        sim::Seam& seam = pattern.seams.emplace_back();
        seam.first = side_of(inner, "first", pattern);
        seam.second = side_of(inner, "second", pattern);
        read_fields(inner, nullptr, seam);
    }
}

}  // namespace

sim::Pattern pattern_of(const py::dict& record, const sim::Pattern& base) {
    const RecordReader reader{record, ""};
    sim::Pattern pattern = base;
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
    sim::visit_fields(pattern, [&]<class SomeField, class T>(const SomeField& field, T& value) {
        if constexpr (!std::is_same_v<T, std::vector<sim::Panel>> && !std::is_same_v<T, std::vector<sim::Seam>>) {
            if (field.is_in_python) read_value(reader, nullptr, field, value);
        }
    });
    return pattern;
}

}  // namespace selvedge::python
