#include "sim/session/dress_check.h"

#include <algorithm>
#include <set>
#include <utility>

#include "sim/core/edge_table.h"
#include "sim/core/error.h"
#include "sim/core/json.h"
#include "sim/core/printable.h"
#include "sim/dress/anchor.h"
#include "sim/dress/dressing.h"
#include "sim/mesh/sew.h"
#include "sim/pattern/fabric.h"

namespace selvedge::sim {
namespace {

std::string text_of(const InputError& error) {
    return fault_line(error.file(), error.place(), error.problem());
}

class Checker {
 public:
    Checker(const Pattern& pattern, const std::string& file, const DressCheck& check)
        : pattern_(pattern), file_(file), check_(check) {}

    std::vector<Fault> take() {
        const std::size_t panels = pattern_.panels.size();
        if (panels > 0 && std::ranges::none_of(pattern_.panels, &Panel::is_worn))
            add("pattern.panels", "no panel that is worn: nothing to dress");
        check_fabrics();
        if (check_.makes_body_and_mesh) check_body();
        if (check_.makes_body_and_mesh && panels > 0 && faults_.empty()) check_mesh();
        return std::move(faults_);
    }

 private:
    void add(std::string place, std::string problem) {
        faults_.push_back({Severity::Error, file_, std::move(place), std::move(problem)});
    }

    // Adds a fault if the function throws an InputError. Returns whether it did not.
    template <class Function>
    bool require(const std::string& place, const Function& function) {
        try {
            function();
            return true;
        } catch (const InputError& error) {
            add(place, text_of(error));
            return false;
        }
    }

    bool require_fabric(const std::string& name, const std::string& place) {
        return name.empty() || require(place, [&] { find_fabric(name); });
    }

    void check_fabrics() {
        if (check_.has_fabrics) require_fabric(pattern_.fabric, "selvedge.fabric");
        for (const Panel& panel : pattern_.panels) {
            const std::string own = json_path("pattern.panels", panel.name) + ".selvedge";
            if (check_.has_fabrics) require_fabric(panel.fabric, own + ".fabric");
            for (std::size_t i = 0; i < panel.interlinings.size(); ++i)
                require_fabric(panel.interlinings[i], own + ".interlinings[" + std::to_string(i) + "]");
        }
        // Together they may be stiffer than a fabric may be.
        if (faults_.empty() && check_.has_fabrics) require("pattern.panels", [&] { fabrics_of(pattern_); });
    }

    void check_body() {
        require(pattern_.body.empty() ? "selvedge.body_height" : "selvedge.body", [&] { check_placed_for(pattern_); });
    }

    void check_mesh() {
        MeshOptions options;
        options.target_edge = check_.edge_length.value_or(pattern_.edge_length.value_or(options.target_edge));
        require("pattern", [&] {
            GarmentMesh mesh = assemble(pattern_, options);
            merge_seams(mesh);
            check_edges(mesh);
        });
    }

    // A seam edge has two triangles, an edge of the outline one.
    void check_edges(const GarmentMesh& sewn) {
        const EdgeTable<int> table(sewn.triangles, &GarmentTriangle::vertices);
        for (const auto edge : table.edges()) {
            std::set<int> together;
            for (const TriangleSide<int>& side : edge)
                together.insert(sewn.triangles[static_cast<std::size_t>(side.triangle)].panel);
            std::string names;
            for (const int panel : together)
                names += (names.empty() ? "'" : " and '") + pattern_.panels[static_cast<std::size_t>(panel)].name + "'";
            if (edge[0].low == edge[0].high)
                return add("pattern.stitches", "sewn like this, an edge of " + names + " shrinks to a point");
            if (edge.size() > 2)
                return add("pattern.stitches", "sewn like this, more than two edges meet in one line, of " + names);
        }
    }

    const Pattern& pattern_;
    const std::string& file_;
    const DressCheck& check_;
    std::vector<Fault> faults_;
};

}  // namespace

std::vector<Fault> dress_faults(const Pattern& pattern, const std::string& file, const DressCheck& check) {
    return Checker(pattern, file, check).take();
}

void refuse_undressable(const Pattern& pattern, const std::string& file, const DressCheck& check) {
    if (pattern.panels.empty())
        throw InputError(file, "pattern.panels",
                         pattern.underlays.empty() ? "no panel that is worn: nothing to dress"
                                                   : "no panel that is worn: nothing to dress before its photos "
                                                     "are traced in the editor");
    for (const Fault& fault : dress_faults(pattern, file, check))
        throw InputError(fault.file, fault.place, fault.problem);
}

}  // namespace selvedge::sim
