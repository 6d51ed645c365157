#include "render/output/pattern_faults.h"

#include <optional>
#include <utility>

#include "render/looks/cloth_looks.h"
#include "sim/core/error.h"
#include "sim/core/json.h"
#include "sim/pattern/pattern_file.h"
#include "sim/session/dress_check.h"
#include "sim/tartan/named_tartan.h"

namespace selvedge::render {
namespace {

// Looks up the names in the pattern in the same way as dress does.
void add_faults_of_names(const sim::Pattern& pattern, const std::string& file, std::vector<sim::Fault>& faults) {
    try {
        if (!pattern.tartan.empty()) sim::named_tartan(pattern.tartan, file, "selvedge.tartan");
    } catch (const sim::InputError& error) {
        faults.push_back({.severity = sim::Severity::Error,
                          .file = error.file(),
                          .place = error.place(),
                          .problem = error.problem()});
    }
}

// Reads pictures and looks up tartans of surface designs.
void add_faults_of_designs(const sim::Pattern& pattern, const std::string& file, std::vector<sim::Fault>& faults) {
    const auto check = [&](const std::optional<sim::SurfaceDesign>& design, const std::string& place) {
        if (!design) return;
        try {
            sim::Pattern one;
            one.surface = design;
            ClothLooks(ClothLooks::Unknown::Fail).read(one);
        } catch (const sim::InputError& error) {
            const std::string picture = error.file().empty() ? "" : error.file() + ": ";
            faults.push_back(
                {.severity = sim::Severity::Error, .file = file, .place = place, .problem = picture + error.problem()});
        }
    };
    check(pattern.surface, "selvedge.surface");
    for (const sim::Panel& panel : pattern.panels)
        check(panel.surface, sim::json_path("pattern.panels", panel.name) + ".selvedge.surface");
    if (has_error(faults)) return;
    try {
        ClothLooks(ClothLooks::Unknown::Fail).read(pattern);  // those of fabrics too
    } catch (const sim::InputError& error) {
        faults.push_back(
            {.severity = sim::Severity::Error, .file = file, .place = "selvedge.fabric", .problem = error.what()});
    }
}

// What dress refuses. A warning about the same value says no more.
void add_faults_of_dress(const sim::Pattern& pattern, const std::string& file, std::vector<sim::Fault>& faults) {
    for (sim::Fault& found : dress_faults(pattern, file)) {
        std::erase_if(faults, [&](const sim::Fault& other) { return other.place == found.place; });
        faults.push_back(std::move(found));
    }
}

}  // namespace

void add_faults_of_dressing(const sim::Pattern& pattern, const std::string& file, std::vector<sim::Fault>& faults) {
    add_faults_of_dress(pattern, file, faults);
    add_faults_of_names(pattern, file, faults);
    if (!has_error(faults)) add_faults_of_designs(pattern, file, faults);
}

std::vector<sim::Fault> faults_of_file(const std::filesystem::path& path) {
    std::vector<sim::Fault> faults = sim::check_pattern_file(path);
    if (has_error(faults)) return faults;
    add_faults_of_dressing(sim::load_pattern(path).pattern, path.string(), faults);
    return faults;
}

}  // namespace selvedge::render
