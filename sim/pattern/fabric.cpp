#include "sim/pattern/fabric.h"

#include <algorithm>
#include <filesystem>
#include <span>

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/json.h"
#include "sim/pattern/fault.h"

namespace selvedge::sim {

namespace {

// A key of a fabric file, the value that it sets, and the smallest and largest value that is accepted.
struct Figure {
    const char* key;
    double Fabric::*value;
    double least;
    double most;
    bool is_required;
};

constexpr std::array kFigures{
    Figure{"area_density", &Fabric::area_density, 0.005, 5, true},
    Figure{"stretch_warp", &Fabric::stretch_warp, 10, 1e6, true},
    Figure{"stretch_weft", &Fabric::stretch_weft, 10, 1e6, true},
    Figure{"shear", &Fabric::shear, 0.1, 1e5, true},
    Figure{"bending_warp", &Fabric::bending_warp, 0, 0.1, true},
    Figure{"bending_weft", &Fabric::bending_weft, 0, 0.1, true},
    Figure{"bending_hysteresis", &Fabric::bending_hysteresis, 0, 1, false},
    Figure{"shear_hysteresis", &Fabric::shear_hysteresis, 0, 1e3, false},
    Figure{"thickness", &Fabric::thickness, 1e-5, 0.02, true},
    Figure{"friction", &Fabric::friction, 0, 2, false},
    Figure{"damping", &Fabric::damping, 0, 100, false},
    Figure{"air_drag", &Fabric::air_drag, 0, 100, false},
    Figure{"strain_limit", &Fabric::strain_limit, 1e-4, 2, false},
    Figure{"gloss", &Fabric::gloss, 0, 1, false},
    Figure{"roughness", &Fabric::roughness, 0.05, 1, false},
    Figure{"sheen", &Fabric::sheen, 0, 1, false},
};

std::string shipped_name(const EmbeddedFile& file) {
    return std::filesystem::path(file.name).stem().string();
}

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

// Lengths are in metres, as in the rest of the file; a picture's path is relative to it.
SurfaceDesign read_surface(const JsonView& view) {
    FaultReader reader(view.file());
    reader.units_in_meter = 1;
    SurfaceDesign design = read_design(reader, {&view.value(), view.path()});
    for (const Fault& fault : reader.take_faults()) throw InputError(fault.file, fault.place, fault.problem);
    if (design.kind == DesignKind::Picture) {
        const std::filesystem::path folder = std::filesystem::absolute(view.file()).parent_path();
        design.source = (folder / design.source).lexically_normal().string();
    }
    return design;
}

Fabric read_fabric(const JsonView& root, const std::string& file) {
    Fabric fabric;
    fabric.name = root.has("name") ? root.at("name").string() : std::filesystem::path(file).stem().string();
    for (const Figure& figure : kFigures) {
        if (!root.has(figure.key) && !figure.is_required) continue;
        fabric.*figure.value = root.at(figure.key).number_between(figure.least, figure.most);
    }
    if (root.has("surface")) fabric.surface = read_surface(root.at("surface"));
    return fabric;
}

void require_in_range(const Fabric& bonded, const std::string& place) {
    for (const Figure& figure : kFigures) {
        const double value = bonded.*figure.value;
        if (value >= figure.least && value <= figure.most) continue;
        throw InputError("", place,
                         "with its interlinings, '" + std::string(figure.key) + "' is " + Json(value).number_text() +
                             ": at most " + Json(figure.most).number_text());
    }
}

}  // namespace

Fabric parse_fabric(std::string_view text, const std::string& file) {
    const Json root = parse_json(text, file);
    return read_fabric(JsonView(root, file), file);
}

Fabric find_fabric(std::string_view name_or_file) {
    const std::string name(name_or_file.empty() ? Fabric().name : name_or_file);
    for (const EmbeddedFile& file : embedded_fabrics()) {
        if (shipped_name(file) == name) return parse_fabric(file.text, std::string(file.name));
    }
    if (name.ends_with(".json")) {
        const Json root = read_json(name);
        return read_fabric(JsonView(root, name), name);
    }
    throw InputError("", "",
                     "no fabric '" + name + "': known are " + joined(fabric_names()) + ", or name a .json file");
}

Fabric bonded(Fabric shell, std::span<const Fabric> interlinings, const std::string& place) {
    for (const Fabric& interlining : interlinings) {
        for (double Fabric::*value : {&Fabric::area_density, &Fabric::stretch_warp, &Fabric::stretch_weft,
                                      &Fabric::shear, &Fabric::bending_warp, &Fabric::bending_weft,
                                      &Fabric::bending_hysteresis, &Fabric::shear_hysteresis, &Fabric::thickness}) {
            shell.*value += interlining.*value;
        }
        shell.strain_limit = std::min(shell.strain_limit, interlining.strain_limit);
        shell.name += " + " + interlining.name;
    }
    if (!interlinings.empty()) require_in_range(shell, place);
    return shell;
}

std::vector<std::string> fabric_names() {
    std::vector<std::string> names;
    for (const EmbeddedFile& file : embedded_fabrics()) names.push_back(shipped_name(file));
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace selvedge::sim
