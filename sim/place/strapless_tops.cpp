#include "sim/place/strapless_tops.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "sim/pattern/garments.h"

namespace selvedge::sim {
namespace {

constexpr std::string_view kUpperEdge = "strapless_top", kNeckline = "_collar";  // labels of GarmentCode

}  // namespace

double raise_strapless_tops(Pattern& pattern, const MeasuredBody& body) {
    const std::optional<double>& armpit = body.landmarks().armpit;
    if (!armpit) return 0;
    const std::vector<std::size_t> parts = sewn_parts(pattern);
    struct UpperEdge {
        double moment = 0;  // m^2
        double length = 0;  // m
    };
    std::map<std::size_t, UpperEdge> upper_edges;  // by part
    std::set<std::size_t> on_shoulders;            // parts
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
        const Panel& panel = pattern.panels[p];
        for (const OutlineEdge& edge : panel.edges) {
            if (edge.label.ends_with(kNeckline)) on_shoulders.insert(parts[p]);
            if (edge.label != kUpperEdge) continue;
            const Vec3d start = panel.place(panel.vertices[static_cast<std::size_t>(edge.start)]);
            const Vec3d end = panel.place(panel.vertices[static_cast<std::size_t>(edge.end)]);
            UpperEdge& whole = upper_edges[parts[p]];
            whole.moment += (end - start).norm() * (start.y() + end.y()) / 2;
            whole.length += (end - start).norm();
        }
    }
    double largest = 0;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
        const auto found = upper_edges.find(parts[p]);
        if (found == upper_edges.end() || on_shoulders.contains(found->first) || found->second.length <= 0) continue;
        const double rise = std::max(0.0, *armpit - found->second.moment / found->second.length);
        pattern.panels[p].translation.y() += rise;
        largest = std::max(largest, rise);
    }
    return largest;
}

}  // namespace selvedge::sim
