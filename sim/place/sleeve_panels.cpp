#include "sim/place/sleeve_panels.h"

#include <algorithm>
#include <cmath>

#include "sim/core/math.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {

double cap_height(const Pattern& pattern, const SewnEdges& sewn, std::size_t p) {
    const Panel& own = pattern.panels[p];
    const Eigen::AlignedBox2d box = outline_box(own, 1e-3);
    double underarm = box.min().y();
    for (const SewnEdge& edge : sewn[p]) {
        if (as_size(edge.panel) != p) continue;
        for (const double t : {0.0, 1.0})
            underarm = std::max(underarm, outline_point(own, own.edges[as_size(edge.own.edge)], t).y());
    }
    return underarm > box.min().y() ? box.max().y() - underarm : 0;
}

double level_between(const Pattern& pattern, const SewnEdges& sewn, std::size_t p, std::size_t other) {
    const double own_middle = outline_box(pattern.panels[p], 1e-3).center().y();
    const double other_middle = outline_box(pattern.panels[other], 1e-3).center().y();
    double sum = 0;
    int count = 0;
    for (const SewnEdge& edge : sewn[p]) {
        if (as_size(edge.panel) != other) continue;
        sum += (middle_of_edge(pattern, edge.other).y() - other_middle) -
               (middle_of_edge(pattern, edge.own).y() - own_middle);
        ++count;
    }
    return count > 0 ? sum / count : 0;
}

bool are_front_and_back(const Panel& half, const Panel& other) {
    constexpr double kMiddle = 0.25;  // of the width, from the middle to the top of an upper sleeve
    const auto has_top_in_middle = [](const Panel& panel) {
        const Eigen::AlignedBox2d box = outline_box(panel, 1e-3);
        const auto top = std::ranges::max_element(panel.vertices, {}, [](const Vec2d& v) { return v.y(); });
        return std::abs(top->x() - box.center().x()) < kMiddle * box.sizes().x();
    };
    return !has_top_in_middle(half) && !has_top_in_middle(other);
}

}  // namespace selvedge::sim
