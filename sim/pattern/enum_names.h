#pragma once
// The words that garment files and journals of edits have for the values of the pattern's enumerations.
#include <array>
#include <string_view>

#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// In the order of the enumeration's values.
template <class T, std::size_t N>
struct EnumNames {
    std::array<std::string_view, N> texts;

    std::string_view operator[](T value) const { return texts[static_cast<std::size_t>(value)]; }
};

constexpr EnumNames<CurveKind, 4> names_of(CurveKind) {
    return {{"line", "quadratic", "cubic", "circle"}};
}
constexpr EnumNames<NotchKind, 5> names_of(NotchKind) {
    return {{"slit", "v", "t", "castle", "u"}};
}
constexpr EnumNames<LineUse, 2> names_of(LineUse) {
    return {{"mark", "fold"}};
}
constexpr EnumNames<AllowanceCorner, 3> names_of(AllowanceCorner) {
    return {{"mitred", "squared", "mirrored"}};
}
constexpr EnumNames<EdgeRole, 2> names_of(EdgeRole) {
    return {{"drawn", "image"}};
}

constexpr EnumNames<DesignKind, 4> names_of(DesignKind) {
    return {{"tartan", "colour", "picture", "test"}};
}

// The word for a value of one of these enumerations.
template <class T>
constexpr std::string_view name_of_value(T value) {
    return names_of(value)[value];
}

}  // namespace selvedge::sim
