#include "sim/pattern/field_moves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace selvedge::sim {

double turned_direction(double angle, const Eigen::Affine2d& map) {
    const Vec2d along = map.linear() * Vec2d(-std::sin(angle), std::cos(angle));
    const double turned = std::atan2(-along.x(), along.y());
    return std::abs(std::remainder(turned - angle, 2 * std::numbers::pi)) > 1e-12 ? turned : angle;
}

bool have_same_shapes(const std::vector<OutlineEdge>& edges, const std::vector<OutlineEdge>& others) {
    return std::ranges::equal(
        edges, others, [](const OutlineEdge& edge, const OutlineEdge& other) { return has_same_shape(edge, other); });
}

bool has_same_outline(const Panel& one, const Panel& other) {
    return one.vertices == other.vertices && have_same_shapes(one.edges, other.edges);
}

bool has_same_placement(const Panel& one, const Panel& other) {
    bool is_same = true;
    visit_fields(one, [&](const auto& field, const auto& value) {
        if (is_placement(field.placing)) is_same = is_same && value == other.*field.member;
    });
    return is_same;
}

void take_placement(Panel& panel, const Panel& from) {
    visit_fields(panel, [&](const auto& field, auto& value) {
        if (is_placement(field.placing)) value = from.*field.member;
    });
}

}  // namespace selvedge::sim
