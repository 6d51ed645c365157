#include "app/body_options.h"

#include <map>
#include <string_view>

#include "sim/body/mannequin.h"
#include "sim/core/error.h"

namespace selvedge {
namespace {

bool is_mannequin(std::string_view source) {
    return source == "mannequin" || source.starts_with("mannequin:");
}

// The value called `text`, or an error that lists those there are.
template <class T>
T named(const std::map<std::string, T>& values, const std::string& option, const std::string& text) {
    const auto found = values.find(text);
    if (found != values.end()) return found->second;
    std::string names;
    for (const auto& [name, value] : values) names += (names.empty() ? "" : ", ") + name;
    throw InputError("", option, "'" + text + "' is none of " + names);
}

const std::map<std::string, LengthUnit> kUnits{{"auto", LengthUnit::Auto},
                                               {"m", LengthUnit::Metres},
                                               {"cm", LengthUnit::Centimetres},
                                               {"mm", LengthUnit::Millimetres}};
const std::map<std::string, UpAxis> kUpAxes{{"auto", UpAxis::Auto}, {"y", UpAxis::Y}, {"z", UpAxis::Z}};

}  // namespace

bool BodyOptions::is_file() const {
    return !source.empty() && !is_mannequin(source);
}

void add_body_options(CLI::App& command, BodyOptions& options, const std::string& help) {
    using Text = const std::string&;
    const auto add = [&](const char* name, const std::string& text, const std::function<void(Text)>& read) {
        return command.add_option_function<std::string>(name, read, text)->group("Body");
    };
    add("-b,--body", help, [&](Text text) {
        if (is_mannequin(text)) parse_mannequin(text);
        options.source = text;
    })->type_name("BODY");
    add("--body-unit", "Unit of a body's file: auto, m, cm, mm (default auto: by its height)", [&](Text text) {
        options.load.unit = named(kUnits, "--body-unit", text);
    })->type_name("UNIT");
    add("--body-up", "Axis of a body's file that points up: auto, y, z (default auto)", [&](Text text) {
        options.load.up = named(kUpAxes, "--body-up", text);
    })->type_name("AXIS");
}

NotedBody make_body(const BodyOptions& options) {
    if (options.is_file()) {
        LoadBodyReport report;
        Body body = load_body(options.source, options.load, &report);
        return {.body = std::move(body), .notes = std::move(report.notes)};
    }
    Mannequin mannequin = make_mannequin(parse_mannequin(options.source));
    return {.body = std::move(mannequin.body), .notes = std::move(mannequin.report.messages)};
}

}  // namespace selvedge
