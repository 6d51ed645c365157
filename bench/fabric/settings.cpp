#include <filesystem>
#include <numbers>
#include <span>

#include "bench/fabric/report.h"
#include "sim/core/embedded.h"
#include "sim/core/json.h"

namespace selvedge {

std::span<const EmbeddedFile> embedded_fabrics();

std::vector<std::string> textile_test_names() {
    return {"cantilever", "strip", "bias", "drape", "swing", "energy"};
}

double allowed_error(const MeshSetting& mesh) {
    if (mesh.is_adaptive || mesh.level >= 2) return 0.05;
    return mesh.level == 1 ? 0.1 : -1;
}

std::vector<MeshSetting> level_settings(const FabricExperiment& experiment) {
    if (experiment.is_quick) return {{.level = 1}, {.level = 2}};
    return {{.level = 0}, {.level = 1}, {.level = 2}, {.level = 3}, {.level = 3, .is_adaptive = true}};
}

std::vector<double> mesh_angles(const FabricExperiment& experiment) {
    const double degree = std::numbers::pi / 180;
    if (experiment.is_quick) return {17 * degree};
    return {0, 17 * degree, 45 * degree};
}

DrapeBand published_drape(const std::string& fabric_name) {
    for (const EmbeddedFile& file : embedded_fabrics()) {
        if (std::filesystem::path(file.name).stem() != fabric_name) continue;
        const Json json = parse_json(file.text, std::string(file.name));
        if (json.find("cusick_drape_percent") == nullptr) return {};
        const std::vector<double> band = JsonView(json, std::string(file.name)).at("cusick_drape_percent").numbers();
        return {band.at(0), band.at(1)};
    }
    return {};
}

}  // namespace selvedge
