#include "app/pattern_faults.h"

#include <cstdio>
#include <optional>
#include <utility>

#include "render/looks/cloth_looks.h"
#include "sim/core/error.h"
#include "sim/core/json.h"
#include "sim/pattern/pattern_file.h"
#include "sim/session/dress_check.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge::app {
namespace {

// Looks up the names in the pattern in the same way as dress does.
void add_faults_of_names(const sim::Pattern& pattern, const std::string& file, std::vector<sim::Fault>& faults) {
    try {
        if (!pattern.tartan.empty()) named_tartan(pattern.tartan, file, "selvedge.tartan");
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
            render::ClothLooks(render::ClothLooks::Unknown::Fail).read(one);
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
        render::ClothLooks(render::ClothLooks::Unknown::Fail).read(pattern);  // those of fabrics too
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

sim::Sett named_tartan(const std::string& name, const std::string& file, const std::string& place) {
    try {
        return sim::find_tartan(name);
    } catch (const sim::InputError& error) {
        const std::string stripe = error.place() == "tartan" || error.place().empty() ? "" : error.place() + ": ";
        throw sim::InputError(file, place, stripe + error.problem());
    }
}

void tell_warnings(const std::vector<sim::Fault>& warnings) {
    for (const sim::Fault& warning : warnings) std::fprintf(stderr, "selvedge: note: %s\n", describe(warning).c_str());
}

}  // namespace selvedge::app
