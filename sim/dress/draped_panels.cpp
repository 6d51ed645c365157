#include "sim/dress/draped_panels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/adaptive/criteria.h"

namespace selvedge::sim {
namespace {

constexpr float kCell = 0.03F;  // m

// Barycentric weights of the point in the triangle that is nearest to u (approximate when u is outside).
Vec3f weights_at(const std::array<Vec2f, 3>& triangle, const Vec2f& u) {
    const auto cross = [](const Vec2f& a, const Vec2f& b) { return a.x() * b.y() - a.y() * b.x(); };
    const float area = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    Vec3f weights;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2f& a = triangle[(k + 1) % 3];
        weights[static_cast<int>(k)] = cross(triangle[(k + 2) % 3] - a, u - a) / area;
    }
    if (!weights.allFinite()) return Vec3f::Constant(1.0F / 3);
    weights = weights.cwiseMax(0.0F);  // approximate projection: u is at most slightly outside
    return weights / weights.sum();
}

int cell_of(float u, float low, float size, int count) {
    return std::clamp(static_cast<int>(std::floor((u - low) / size)), 0, count - 1);
}

}  // namespace

DrapedPanels::DrapedPanels(const Cloth& cloth) : cloth_(cloth), panels_(cloth.material.fabrics.size()) {
    std::vector<Eigen::AlignedBox2f> boxes(panels_.size());
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
        for (const Vec2f& u : leaf.u) boxes[leaf.panel].extend(u);
    }
    for (std::size_t p = 0; p < panels_.size(); ++p) {
        if (boxes[p].isEmpty()) continue;
        Cells& cells = panels_[p];
        const Vec2f extent = boxes[p].sizes();
        cells.low = boxes[p].min();
        cells.size = std::max(kCell, extent.maxCoeff() / 128);
        cells.columns = static_cast<int>(extent.x() / cells.size) + 1;
        cells.rows = static_cast<int>(extent.y() / cells.size) + 1;
        cells.leaves.resize(static_cast<std::size_t>(cells.columns) * static_cast<std::size_t>(cells.rows));
    }
    for (std::uint32_t i = 0; i < cloth.mesh.leaf_triangles().size(); ++i) {
        const LeafTriangle& leaf = cloth.mesh.leaf_triangles()[i];
        Cells& cells = panels_[leaf.panel];
        cells.all.push_back(i);
        Eigen::AlignedBox2f box;
        for (const Vec2f& u : leaf.u) box.extend(u);
        const int right = cell_of(box.max().x(), cells.low.x(), cells.size, cells.columns);
        const int top = cell_of(box.max().y(), cells.low.y(), cells.size, cells.rows);
        for (int row = cell_of(box.min().y(), cells.low.y(), cells.size, cells.rows); row <= top; ++row) {
            for (int column = cell_of(box.min().x(), cells.low.x(), cells.size, cells.columns); column <= right;
                 ++column)
                cells.leaves[static_cast<std::size_t>(row * cells.columns + column)].push_back(i);
        }
    }
}

const LeafTriangle* DrapedPanels::nearest_leaf(const MaterialPoint& at) const {
    if (at.panel >= panels_.size() || panels_[at.panel].all.empty()) return nullptr;
    const Cells& cells = panels_[at.panel];
    const LeafTriangle* nearest = nullptr;
    float least = std::numeric_limits<float>::max();
    const auto look = [&](const std::vector<std::uint32_t>& leaves) {
        for (const std::uint32_t i : leaves) {
            const LeafTriangle& leaf = cloth_.mesh.leaf_triangles()[i];
            const float distance = distance_to_triangle(at.u, leaf.u);
            if (distance >= least) continue;
            least = distance;
            nearest = &leaf;
            if (distance == 0) return;
        }
    };
    const int column = cell_of(at.u.x(), cells.low.x(), cells.size, cells.columns);
    const int row = cell_of(at.u.y(), cells.low.y(), cells.size, cells.rows);
    look(cells.leaves[static_cast<std::size_t>(row * cells.columns + column)]);
    if (least > 0) look(cells.all);
    return nearest;
}

Vec3f DrapedPanels::position(const MaterialPoint& at) const {
    const LeafTriangle* leaf = nearest_leaf(at);
    if (leaf == nullptr) return Vec3f::Zero();
    const Vec3f weights = weights_at(leaf->u, at.u);
    Vec3f x = Vec3f::Zero();
    for (std::size_t k = 0; k < 3; ++k) x += weights[static_cast<int>(k)] * cloth_.x[leaf->v[k].value].head<3>();
    return x;
}

VertexId DrapedPanels::nearest_vertex(const MaterialPoint& at) const {
    const LeafTriangle* leaf = nearest_leaf(at);
    if (leaf == nullptr) return {};
    const auto distance = [&](std::size_t k) { return (leaf->u[k] - at.u).squaredNorm(); };
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < 3; ++k) {
        if (distance(k) < distance(nearest)) nearest = k;
    }
    return leaf->v[nearest];
}

MaterialPoint DrapedPanels::place_of(const Cloth& cloth, VertexId v, std::uint16_t panel) {
    for (const TriangleId t : cloth.mesh.triangles_at(v)) {
        const AdaptiveTriangle& triangle = cloth.mesh.triangle(t);
        if (triangle.panel == panel) return {panel, triangle.u[corner_at(triangle, v)]};
    }
    return {panel, Vec2f::Zero()};
}

}  // namespace selvedge::sim
