#pragma once
// The JSON form of commands and of their fields, in journals and scripts (editor/document/command.h): writing leaves
// out fields with their default value, reading keeps the values of fields that are left out.
#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "editor/document/command_types.h"
#include "editor/document/part_commands.h"
#include "sim/core/json.h"
#include "sim/pattern/enum_names.h"
#include "sim/pattern/field.h"
#include "sim/pattern/pattern_fields.h"

namespace selvedge::editor {

inline constexpr double kMaxCommandNumber = 1000;  // m or rad, limit of all numbers in commands

// Types with fields. Numbers, strings, Eigen vectors and std::vector are not aggregates.
template <class T>
concept Record = std::is_aggregate_v<T>;

// The fields of the types that commands contain, in the form of a command's own `fields`.
template <class Visitor>
void visit_named(PartRef& part, Visitor&& visit) {
    visit("panel", part.panel);
    visit("index", part.index);
}

template <class Visitor>
void visit_named(SpanRef& span, Visitor&& visit) {
    visit("panel", span.panel);
    visit("edge", span.edge);
    visit("from", span.from);
    visit("to", span.to);
}

template <class Visitor>
void visit_named(PanelPlacement& place, Visitor&& visit) {
    visit("panel", place.panel);
    visit("translation", place.translation);
    visit("rotation", place.rotation);
    visit("wrap_radius", place.wrap_radius);
}

template <class Visitor>
void visit_named(PlaneMap& map, Visitor&& visit) {
    visit("x_axis", map.x_axis);
    visit("y_axis", map.y_axis);
    visit("shift", map.shift);
}

// Parts of patterns, by the descriptions of their fields.
template <sim::Described T, class Visitor>
void visit_named(T& part, Visitor&& visit) {
    sim::visit_fields(part, [&](const auto& field, auto& value) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, std::array<Vec2d, 2>>) {
            visit(std::string_view("control"), value[0]);
            visit(std::string_view("control_2"), value[1]);
        } else {
            visit(field.journal, value);
        }
    });
}

template <class T>
requires(!sim::Described<T>) && requires {
    T::name;
}
void visit_named(T& command, auto&& visit) {
    command.fields(visit);
}

template <class Vector>
sim::Json numbers_json(const Vector& v) {
    sim::Json list = sim::Json::array();
    for (Eigen::Index i = 0; i < v.size(); ++i) list.push_back(sim::Json(v.data()[i]));
    return list;
}

inline sim::Json encode(bool value) {
    return sim::Json(value);
}
inline sim::Json encode(int value) {
    return sim::Json(value);
}
inline sim::Json encode(double value) {
    return sim::Json(value);
}
inline sim::Json encode(const std::string& value) {
    return sim::Json(value);
}
inline sim::Json encode(const Vec2d& value) {
    return numbers_json(value);
}
inline sim::Json encode(const Vec3d& value) {
    return numbers_json(value);
}
inline sim::Json encode(const Eigen::Matrix3d& value) {
    return numbers_json(value);
}  // column by column
template <std::same_as<sim::Json> T>
sim::Json encode(const T& value) {
    return value;
}
template <class T>
requires std::is_enum_v<T> sim::Json encode(T value) {
    return sim::Json(sim::name_of_value(value));
}

template <Record T>
sim::Json encode(const T& value);

template <class T>
sim::Json encode(const std::optional<T>& value) {
    return value ? encode(*value) : sim::Json();
}

template <class T>
sim::Json encode_fields(const T& value);
template <class T>
sim::Json encode(const std::vector<T>& values);

template <Record T>
sim::Json encode(const T& value) {
    return encode_fields(value);
}

template <class T>
sim::Json encode(const std::vector<T>& values) {
    sim::Json list = sim::Json::array();
    for (const T& value : values) list.push_back(encode(value));
    return list;
}

template <class T>
sim::Json all_fields(T value) {
    sim::Json object = sim::Json::object();
    visit_named(value, [&](std::string_view key, const auto& field) { object[key] = encode(field); });
    return object;
}

// Without fields that have their default value.
template <class T>
sim::Json encode_fields(const T& value) {
    sim::Json object = all_fields(value);
    const sim::Json usual = all_fields(T{});
    std::erase_if(object.members(), [&](const sim::Json::Member& member) {
        return write_json(member.value, -1) == write_json(*usual.find(member.key), -1);
    });
    return object;
}

template <class T>
void decode(const sim::JsonView& view, std::vector<T>& values);
template <class T>
void decode(const sim::JsonView& view, std::optional<T>& value);
template <Record T>
void decode(const sim::JsonView& view, T& value);

inline void decode(const sim::JsonView& view, bool& value) {
    value = view.boolean();
}
inline void decode(const sim::JsonView& view, int& value) {
    value = view.integer();
}
inline void decode(const sim::JsonView& view, double& value) {
    value = view.number_between(-kMaxCommandNumber, kMaxCommandNumber);
}
inline void decode(const sim::JsonView& view, std::string& value) {
    value = view.string();
}

template <std::same_as<sim::Json> T>
void decode(const sim::JsonView& view, T& value) {
    value = view.value();
}

template <class Scalar, int rows, int columns>
void decode(const sim::JsonView& view, Eigen::Matrix<Scalar, rows, columns>& value) {
    constexpr std::size_t count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
    if (view.size() != count) view.fail(std::to_string(count) + " numbers should be here");
    for (std::size_t i = 0; i < count; ++i) decode(view.at(i), value.data()[i]);
}

template <class T>
requires std::is_enum_v<T>
void decode(const sim::JsonView& view, T& value) {
    std::string known;
    constexpr auto names = names_of(T{});
    for (std::size_t i = 0; i < names.texts.size(); ++i) {
        if (view.string() == names.texts[i]) {
            value = static_cast<T>(i);
            return;
        }
        known += (known.empty() ? "" : ", ") + std::string(names.texts[i]);
    }
    view.fail("'" + view.string() + "' is none of " + known);
}

template <class T>
void decode(const sim::JsonView& view, std::optional<T>& value) {
    value.reset();
    if (!view.value().is_null()) decode(view, value.emplace());
}

template <Record T>
void decode(const sim::JsonView& view, T& value) {
    for (const std::string& key : view.keys()) {
        bool is_known = false;
        visit_named(value, [&](std::string_view field, const auto&) { is_known = is_known || key == field; });
        if (!is_known) view.at(key).fail("there is no such field");
    }
    visit_named(value, [&](std::string_view key, auto& field) {
        if (view.has(key)) decode(view.at(key), field);
    });
}

template <class T>
void decode(const sim::JsonView& view, std::vector<T>& values) {
    values.clear();
    for (std::size_t i = 0; i < view.size(); ++i) decode(view.at(i), values.emplace_back());
}

}  // namespace selvedge::editor
