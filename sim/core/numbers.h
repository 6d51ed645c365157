#pragma once
// Numbers that come from outside: read from texts, held to limits, and told.
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/error.h"

namespace selvedge::sim {

// Parses the whole text as finite numbers separated by commas; none if it is anything else.
std::optional<std::vector<double>> parse_number_list(std::string_view text);

// The shortest text of a number: 0.5, 10000000.
std::string short_text(double number);

template <class T>
struct Limits {
    T least;
    T most;
};

// Throws InputError if the value is not within the limits: "must be from ... to ...". scale: of the limits' unit in
// that of the value, 0.01 for limits in centimetres and a value in metres.
template <class T>
T within(T value, Limits<T> limits, const std::string& place, double scale = 1) {
    const double number = static_cast<double>(value);
    const double least = scale * static_cast<double>(limits.least), most = scale * static_cast<double>(limits.most);
    if (std::isfinite(number) && number >= least && number <= most) return value;
    throw InputError("", place, "must be from " + short_text(least) + " to " + short_text(most));
}

template <class T>
std::optional<T> within(const std::optional<T>& value, Limits<T> limits, const std::string& place, double scale = 1) {
    if (value) within(*value, limits, place, scale);
    return value;
}

}  // namespace selvedge::sim
