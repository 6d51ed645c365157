#pragma once
// How the fields of parts follow their panel when it is turned, mirrored, cut, joined or copied, by their descriptions
// (sim/pattern/field.h). Outlines and what is sewn (Descent::Shape) are left to sim/pattern/edge_shape.h and to the
// functions of the editor's geometry.
#include <optional>
#include <vector>

#include "sim/core/math.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/field.h"
#include "sim/pattern/pattern_fields.h"

namespace selvedge::sim {

// How a value changes: by a map of its panel's plane, or because its line is reversed.
struct PlaneMove {
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    int edge_count = 1;        // of the panel, whose edges are renumbered if it is mirrored: mirrored_edge()
    bool is_reversal = false;  // of the line, not of the plane

    bool is_mirror() const { return map.linear().determinant() < 0; }
};

// The angle of a direction (Measure::Direction) under the linear part of the map; the same bits if it does not turn.
double turned_direction(double angle, const Eigen::Affine2d& map);

template <class T>
void move_value(T&, Measure, const PlaneMove&) {}

inline void move_value(Vec2d& value, Measure measure, const PlaneMove& move) {
    if (measure == Measure::Point) value = move.map * value;
    if (measure == Measure::ClothShift && move.is_mirror()) value.x() = -value.x();
    if (measure == Measure::LeftOfLine && move.is_mirror() != move.is_reversal) value = -value;
}
inline void move_value(double& value, Measure measure, const PlaneMove& move) {
    if (measure == Measure::Direction) value = turned_direction(value, move.map);
    if (measure == Measure::LeftOfLine && move.is_mirror() != move.is_reversal) value = -value;
    if (measure == Measure::EdgeShare && move.is_mirror() != move.is_reversal) value = 1 - value;
}
inline void move_value(int& value, Measure measure, const PlaneMove& move) {
    if (measure == Measure::EdgeIndex && move.is_mirror()) value = mirrored_edge(value, move.edge_count);
}

template <Described Part>
void move_fields(Part& part, const PlaneMove& move);

template <Described Part>
void move_value(Part& part, Measure, const PlaneMove& move) {
    move_fields(part, move);
}
template <class T>
void move_value(std::optional<T>& value, Measure measure, const PlaneMove& move) {
    if (value) move_value(*value, measure, move);
}
template <class T>
void move_value(std::vector<T>& values, Measure measure, const PlaneMove& move) {
    for (T& value : values) move_value(value, measure, move);
}

// Moves a part's fields, all but its shape.
template <Described Part>
void move_fields(Part& part, const PlaneMove& move) {
    visit_fields(part, [&](const auto& field, auto& value) {
        if (field.descent != Descent::Shape) move_value(value, field.measure, move);
    });
}

// Of a part whose line is reversed.
template <Described Part>
void reverse_fields(Part& part) {
    move_fields(part, {.is_reversal = true});
}

template <Described Part>
void flip_fields(Part& part);

template <class T>
void flip_value(T&, Measure) {}

inline void flip_value(Vec2d& value, Measure measure) {
    if (measure == Measure::Point) value.x() = -value.x();
}
inline void flip_value(double& value, Measure measure) {
    if (measure == Measure::Direction) value = -value;
}
template <Described Part>
void flip_value(Part& part, Measure) {
    flip_fields(part);
}
template <class T>
void flip_value(std::optional<T>& value, Measure measure) {
    if (value) flip_value(*value, measure);
}
template <class T>
void flip_value(std::vector<T>& values, Measure measure) {
    for (T& value : values) flip_value(value, measure);
}

// From the drawing of a panel that is clockwise in its file to the panel's frame, in which x is mirrored and edges keep
// their order and directions; all but the shape.
template <Described Part>
void flip_fields(Part& part) {
    visit_fields(part, [&](const auto& field, auto& value) {
        if (field.descent != Descent::Shape) flip_value(value, field.measure);
    });
}

// A copy for another place: without the names that only one part may have.
template <Described Part>
Part copy_of(Part part) {
    const Part usual{};
    visit_fields(part, [&](const auto& field, auto& value) {
        if (field.descent == Descent::Own) value = usual.*field.member;
    });
    return part;
}

// Gives `part` those fields of `from` that the choice tells: is_chosen(descent).
template <Described Part, class Choice>
void take_fields(Part& part, const Part& from, Choice is_chosen) {
    visit_fields(part, [&](const auto& field, auto& value) {
        if (is_chosen(field.descent)) value = from.*field.member;
    });
}

// Gives `part` those fields of `from` that are not defaults.
template <Described Part>
void take_changes(Part& part, const Part& from) {
    const Part usual{};
    visit_fields(part, [&](const auto& field, auto& value) {
        if (from.*field.member != usual.*field.member) value = from.*field.member;
    });
}

// Gives `part`, whose shape was made anew, the other fields of the part that it stands for.
template <Described Part>
void keep_properties(Part& part, const Part& from) {
    take_fields(part, from, [](Descent descent) { return descent != Descent::Shape && descent != Descent::Place; });
}

// Gives `part` the names of the part that it replaces.
template <Described Part>
void keep_names(Part& part, const Part& from) {
    take_fields(part, from, [](Descent descent) { return descent == Descent::Own; });
}

template <Described Part>
bool has_same_shape(const Part& one, const Part& other) {
    bool is_same = true;
    visit_fields(one, [&](const auto& field, const auto& value) {
        if (field.descent == Descent::Shape) is_same = is_same && value == other.*field.member;
    });
    return is_same;
}

bool have_same_shapes(const std::vector<OutlineEdge>& edges, const std::vector<OutlineEdge>& others);

// Whether both are meshed and drawn alike: the same vertices, and edges of the same shape.
bool has_same_outline(const Panel& one, const Panel& other);

// Whether both start in the same way round the body (is_placement).
bool has_same_placement(const Panel& one, const Panel& other);

// Gives the panel the other one's placement.
void take_placement(Panel& panel, const Panel& from);

template <class T>
void gather(T&, const T&) {}
template <class T>
void gather(std::vector<T>& values, const std::vector<T>& more) {
    values.insert(values.end(), more.begin(), more.end());
}

// Adds what is gathered of two panels that become one (Descent::Gathered).
template <Described Part>
void gather_fields(Part& part, const Part& from) {
    visit_fields(part, [&](const auto& field, auto& value) {
        if (field.descent == Descent::Gathered) gather(value, from.*field.member);
    });
}

}  // namespace selvedge::sim
