#pragma once
// Values in boxes: SI inside, cm, mm or degrees to read and type, with as few figures as say it.
#include <optional>
#include <string>
#include <string_view>

namespace selvedge {

enum class Unit {
    Centimetres,  // of m
    Millimetres,  // of m
    Degrees,      // of rad
    Factor,       // 1.05, or typed 105%
    Plain,
    Whole,  // a whole number
};

// "92.5": without the unit, never "-0".
std::string quantity_figure(double value, Unit unit);

// "92.5 cm".
std::string quantity_text(double value, Unit unit);

// An expression, and another unit behind it if one likes: 92/4+1, 120 mm, 4 in, 105%. None: it is no such value.
std::optional<double> parse_quantity(std::string_view text, Unit unit);

// One press of an arrow key, or two px of dragging: 1 mm, 0.1 mm, 1 degree, 0.01, 0.1, 1.
double step_of(Unit unit);

// What a step leads to: on the raster of steps, where 92.53 + 0.1 is 92.6.
double stepped(double value, Unit unit, double steps);

}  // namespace selvedge
