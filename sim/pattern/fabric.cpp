#include "sim/pattern/fabric.h"

#include <algorithm>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/json.h"
#include "sim/pattern/fabric_file.h"
#include "sim/pattern/fault.h"
#include "sim/pattern/named_file.h"
#include "sim/pattern/spelling.h"

namespace selvedge::sim {

namespace {

std::string shipped_name(const EmbeddedFile& file) {
    return std::filesystem::path(file.name).stem().string();
}

// Lengths are in metres, as in the rest of the file; a picture's path is relative to it.
SurfaceDesign read_surface(const JsonView& view) {
    FaultReader reader(view.file());
    reader.units_in_meter = 1;
    SurfaceDesign design = read_design(reader, {&view.value(), view.path()});
    for (const Fault& fault : reader.take_faults()) {
        if (fault.severity == Severity::Error) throw InputError(fault.file, fault.place, fault.problem);
    }
    if (design.kind == DesignKind::Picture) design.source = resolve_named_file(design.source, view.file());
    return design;
}

// Other keys may be added by whoever makes a fabric; one that is nearly spelt as ours is a mistake that would not show.
void refuse_misspelt_keys(const JsonView& root) {
    std::vector<std::string_view> known{"name", "title", "note", "evidence", "units", "confidence", "surface"};
    for (const FabricKey& key : fabric_keys()) known.emplace_back(key.key);
    for (const std::string& key : root.keys()) {
        if (std::ranges::find(known, key) != known.end()) continue;
        const std::string_view near = nearly_spelt(key, known);
        if (!near.empty()) root.at(key).fail("unknown key '" + key + "': is '" + std::string(near) + "' meant?");
    }
}

Fabric read_fabric(const JsonView& root, const std::string& file) {
    Fabric fabric;
    fabric.name = root.has("name") ? root.at("name").string() : std::filesystem::path(file).stem().string();
    for (const FabricKey& key : fabric_keys()) {
        if (!root.has(key.key) && !key.is_required) continue;
        fabric.*key.value = root.at(key.key).number_between(key.least, key.most);
    }
    if (root.has("surface")) fabric.surface = read_surface(root.at("surface"));
    refuse_misspelt_keys(root);
    return fabric;
}

void require_in_range(const Fabric& bonded, const std::string& place) {
    for (const FabricKey& key : fabric_keys()) {
        const double value = bonded.*key.value;
        if (value >= key.least && value <= key.most) continue;
        throw InputError("", place,
                         "with its interlinings, '" + std::string(key.key) + "' is " + Json(value).number_text() +
                             ": at most " + Json(key.most).number_text());
    }
}

}  // namespace

Fabric parse_fabric(std::string_view text, const std::string& file) {
    const Json root = parse_json(text, file);
    return read_fabric(JsonView(root, file), file);
}

Fabric find_fabric(std::string_view name_or_file) {
    return read_fabric_file(name_or_file).fabric;
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
