#include "editor/inspectors/quantity.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "editor/drafting/expression.h"

namespace selvedge {
namespace {

constexpr double kDegree = std::numbers::pi / 180;  // rad
constexpr double kInch = 0.0254;                    // m

struct UnitRow {
    double size = 1;  // of one such unit, SI
    int decimals = 0;
    const char* word = "";
    double step = 1;  // of such units
};

UnitRow row_of(Unit unit) {
    switch (unit) {
        case Unit::Centimetres:
            return {.size = 0.01, .decimals = 2, .word = " cm", .step = 0.1};
        case Unit::Millimetres:
            return {.size = 0.001, .decimals = 1, .word = " mm", .step = 0.1};
        case Unit::Degrees:
            return {.size = kDegree, .decimals = 2, .word = "\u00B0", .step = 1};
        case Unit::Factor:
            return {.size = 1, .decimals = 4, .word = "", .step = 0.01};
        case Unit::Plain:
            return {.size = 1, .decimals = 3, .word = "", .step = 0.1};
        case Unit::Whole:
            break;
    }
    return {};
}

bool is_length(Unit unit) {
    return unit == Unit::Centimetres || unit == Unit::Millimetres;
}

struct Suffix {
    std::string_view word;
    double size = 1;  // SI
    bool (*fits)(Unit) = nullptr;
};

// Longer words before those that end them.
constexpr std::array<Suffix, 8> kSuffixes{{
    {"cm", 0.01, is_length},
    {"mm", 0.001, is_length},
    {"m", 1, is_length},
    {"in", kInch, is_length},
    {"\"", kInch, is_length},
    {"\u00B0", kDegree, [](Unit unit) { return unit == Unit::Degrees; }},
    {"deg", kDegree, [](Unit unit) { return unit == Unit::Degrees; }},
    {"%", 0.01, [](Unit unit) { return unit == Unit::Factor; }},
}};

std::string_view without_blanks_behind(std::string_view text) {
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

}  // namespace

std::string quantity_figure(double value, Unit unit) {
    const UnitRow row = row_of(unit);
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "%.*f", row.decimals, value / row.size);
    std::string text = buffer;
    if (text.find('.') != std::string::npos) {
        while (text.back() == '0') text.pop_back();
        if (text.back() == '.') text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

std::string quantity_text(double value, Unit unit) {
    return quantity_figure(value, unit) + row_of(unit).word;
}

std::optional<double> parse_quantity(std::string_view text, Unit unit) {
    text = without_blanks_behind(text);
    double size = row_of(unit).size;
    for (const Suffix& suffix : kSuffixes) {
        if (!suffix.fits(unit) || !text.ends_with(suffix.word)) continue;
        text = without_blanks_behind(text.substr(0, text.size() - suffix.word.size()));
        size = suffix.size;
        break;
    }
    const std::optional<double> figure = evaluate(text);
    if (!figure || !std::isfinite(*figure * size)) return std::nullopt;
    if (unit == Unit::Whole && (*figure != std::round(*figure) || std::abs(*figure) > 1e9)) return std::nullopt;
    return *figure * size;
}

double step_of(Unit unit) {
    const UnitRow row = row_of(unit);
    return row.step * row.size;
}

double stepped(double value, Unit unit, double steps) {
    const double step = step_of(unit);
    return std::round((value + steps * step) / step) * step;
}

}  // namespace selvedge
