#include <charconv>
#include <cmath>

#include "sim/body/mannequin_measures.h"
#include "sim/body/mannequin_stance.h"
#include "sim/core/error.h"

namespace selvedge {

namespace {

double read_number(std::string_view name, std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
        throw InputError("mannequin", std::string(name), "'" + std::string(text) + "' is not a number");
    }
    return value;
}

Sex read_sex(std::string_view text) {
    if (text == "female") return Sex::Female;
    if (text == "male") return Sex::Male;
    throw InputError("mannequin", "sex", "'" + std::string(text) + "' is neither female nor male");
}

std::string known_names() {
    std::string names = "sex, resolution, stance";
    for (const std::string_view name : measure_names()) names += ", " + std::string(name);
    return names;
}

void read_setting(MannequinOptions& options, std::string_view setting) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string_view::npos) {
        throw InputError("mannequin", std::string(setting), "'name=value' expected");
    }
    const std::string_view name = setting.substr(0, equals);
    const std::string_view value = setting.substr(equals + 1);
    if (name == "sex") {
        options.sex = read_sex(value);
    } else if (name == "resolution") {
        const double steps = read_number(name, value);
        if (steps != std::floor(steps) || std::abs(steps) > 100) {
            throw InputError("mannequin", "resolution", "'" + std::string(value) + "' is not a number of steps");
        }
        options.subdivisions = static_cast<int>(steps);
    } else if (name == "stance") {
        if (options.stance) throw InputError("mannequin", "stance", "given twice");
        options.stance = radians(read_number(name, value));
    } else if (std::optional<double>* measure = find_measure(options.measures, name)) {
        if (*measure) throw InputError("mannequin", std::string(name), "given twice");
        *measure = read_number(name, value) / 100;
    } else {
        throw InputError("mannequin", std::string(name), "no such measure; known are " + known_names());
    }
}

}  // namespace

std::vector<std::string_view> measure_names() {
    std::vector<std::string_view> names;
    for (const MeasureEntry& entry : measure_entries()) names.push_back(entry.name);
    return names;
}

std::optional<double>* find_measure(MannequinMeasures& measures, std::string_view name) {
    if (name == "hips") name = "hip";
    for (const MeasureEntry& entry : measure_entries()) {
        if (entry.name == name) return &(measures.*entry.value);
    }
    return nullptr;
}

MannequinOptions parse_mannequin(std::string_view text) {
    constexpr std::string_view kKind = "mannequin";
    if (!text.starts_with(kKind)) throw InputError("", std::string(text), "'mannequin:name=value,...' expected");
    text.remove_prefix(kKind.size());
    MannequinOptions options;
    if (!text.empty() && text.front() != ':') {
        throw InputError("mannequin", std::string(text), "':' expected after 'mannequin'");
    }
    if (!text.empty()) text.remove_prefix(1);
    while (!text.empty()) {
        const std::size_t comma = text.find(',');
        read_setting(options, text.substr(0, comma));
        text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
    }
    check_options(options);
    return options;
}

}  // namespace selvedge
