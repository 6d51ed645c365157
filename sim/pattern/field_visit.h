#pragma once
// Visits all values of a part and of the parts in it, each with the field that describes it (sim/pattern/field.h): what
// is true of all points, all names or all fabrics is said once, and holds for fields that are added.
#include <optional>
#include <type_traits>
#include <vector>

#include "sim/pattern/field.h"

namespace selvedge::sim {

template <class Part, class Visit>
void visit_values(Part& part, Visit&& visit);

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
template <class T>
inline constexpr bool is_list = false;
template <class T>
inline constexpr bool is_list<std::vector<T>> = true;

// visit(field, value) for a value; for each one of a list, or of an optional that has one; for a part, and then for all
// values in it.
template <class SomeField, class T, class Visit>
void visit_value(const SomeField& field, T& value, Visit&& visit) {
    using Value = std::remove_const_t<T>;
    if constexpr (is_optional<Value>) {
        if (value) visit_value(field, *value, visit);
    } else if constexpr (is_list<Value>) {
        for (auto& one : value) visit_value(field, one, visit);
    } else {
        visit(field, value);
        if constexpr (Described<Value>) visit_values(value, visit);
    }
}

template <class Part, class Visit>
void visit_values(Part& part, Visit&& visit) {
    visit_fields(part, [&](const auto& field, auto& value) { visit_value(field, value, visit); });
}

}  // namespace selvedge::sim
