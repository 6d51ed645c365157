#include "sim/place/strapless_tops.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "sim/core/disjoint_sets.h"

namespace selvedge::sim {
namespace {

constexpr std::string_view kUpperEdge = "strapless_top", kNeckline = "_collar";  // labels of GarmentCode

}  // namespace

double raise_strapless_tops(Pattern& pattern, const MeasuredBody& body) {
    const std::optional<double>& armpit = body.landmarks().armpit;
    if (!armpit) return 0;
    DisjointSets parts(pattern.panels.size());
    for (const Seam& seam : pattern.seams) parts.join(seam.first.panel, seam.second.panel);
    struct UpperEdge {
        double moment = 0;  // m^2
        double length = 0;  // m
    };
    std::map<int, UpperEdge> upper_edges;  // by part
    std::set<int> on_shoulders;            // parts
    for (int p = 0; p < static_cast<int>(pattern.panels.size()); ++p) {
        const Panel& panel = pattern.panels[static_cast<std::size_t>(p)];
        for (const OutlineEdge& edge : panel.edges) {
            if (edge.label.ends_with(kNeckline)) on_shoulders.insert(parts.find(p));
            if (edge.label != kUpperEdge) continue;
            const Vec3d start = panel.place(panel.vertices[static_cast<std::size_t>(edge.start)]);
            const Vec3d end = panel.place(panel.vertices[static_cast<std::size_t>(edge.end)]);
            UpperEdge& whole = upper_edges[parts.find(p)];
            whole.moment += (end - start).norm() * (start.y() + end.y()) / 2;
            whole.length += (end - start).norm();
        }
    }
    double largest = 0;
    for (int p = 0; p < static_cast<int>(pattern.panels.size()); ++p) {
        const auto found = upper_edges.find(parts.find(p));
        if (found == upper_edges.end() || on_shoulders.contains(found->first) || found->second.length <= 0) continue;
        const double rise = std::max(0.0, *armpit - found->second.moment / found->second.length);
        pattern.panels[static_cast<std::size_t>(p)].translation.y() += rise;
        largest = std::max(largest, rise);
    }
    return largest;
}

}  // namespace selvedge::sim
