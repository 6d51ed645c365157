#include "sim/paper/path_index.h"

#include <cmath>

namespace selvedge::sim {

std::optional<Vec2d> shift_between(const DrawnPath& a, const DrawnPath& b) {
    if (a.edges.size() != b.edges.size() || a.vertices.size() != b.vertices.size() || a.is_closed != b.is_closed)
        return std::nullopt;
    const Vec2d shift = b.vertices.front() - a.vertices.front();
    const auto is_off = [&](const Vec2d& p, const Vec2d& q) { return (q - p - shift).norm() > kSamePathPlace; };
    for (std::size_t i = 0; i < a.vertices.size(); ++i) {
        if (is_off(a.vertices[i], b.vertices[i])) return std::nullopt;
    }
    for (std::size_t i = 0; i < a.edges.size(); ++i) {
        if (a.edges[i].kind != b.edges[i].kind) return std::nullopt;
        if (a.edges[i].kind != CurveKind::Cubic) continue;
        for (std::size_t k = 0; k < 2; ++k) {
            if (is_off(a.edges[i].control[k], b.edges[i].control[k])) return std::nullopt;
        }
    }
    return shift;
}

PathIndex::Key PathIndex::key_of(const DrawnPath& path) const {
    constexpr double kStep = 1, kNear = 3 * kSamePathPlace;  // mm
    Eigen::AlignedBox2d box;
    for (const Vec2d& v : path.vertices) box.extend(v);
    Key key{.edges = path.edges.size(), .is_closed = path.is_closed};
    const std::array<double, 4> values{box.sizes().x(), box.sizes().y(), box.min().x(), box.min().y()};
    for (std::size_t i = 0; i < (is_placed_ ? 4U : 2U); ++i) {
        key.steps[i] = std::lround(values[i] / kStep);
        const double off = values[i] / kStep - static_cast<double>(key.steps[i]);
        key.beside[i] = off > 0.5 - kNear / kStep ? 1 : off < kNear / kStep - 0.5 ? -1 : 0;
    }
    return key;
}

}  // namespace selvedge::sim
