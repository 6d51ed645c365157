#include "sim/mesh/draw_mesh.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "sim/core/assert.h"
#include "sim/core/edge_table.h"

namespace selvedge::sim {
namespace {

template <class T>
void keep(std::vector<T>& values, const std::vector<std::size_t>& kept) {
    if (values.empty()) return;
    std::vector<T> left;
    left.reserve(kept.size());
    for (const std::size_t i : kept) left.push_back(values[i]);
    values = std::move(left);
}

}  // namespace

DrawMesh with_triangles(DrawMesh mesh, const std::vector<std::size_t>& kept) {
    keep(mesh.triangles, kept);
    keep(mesh.u, kept);
    keep(mesh.panel, kept);
    keep(mesh.level, kept);
    keep(mesh.turned_corners, kept);
    return mesh;
}

namespace {

// Union-find over corners (three per triangle) that also holds whether a corner and the lowest of its group lie on
// triangles whose right sides look to opposite sides of the surface.
class OrientedCorners {
 public:
    explicit OrientedCorners(std::size_t corners) : parent_(corners), is_turned_(corners, false) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }
    // The lowest corner of the group, and whether this corner is turned against it.
    std::pair<std::uint32_t, bool> find(std::uint32_t corner) const {
        bool turned = false;
        for (; parent_[corner] != corner; corner = parent_[corner]) turned = turned != is_turned_[corner];
        return {corner, turned};
    }
    void join(std::uint32_t a, std::uint32_t b, bool are_opposite) {
        const auto [root_a, turned_a] = find(a);
        const auto [root_b, turned_b] = find(b);
        if (root_a == root_b) return;
        const auto [low, high] = std::minmax(root_a, root_b);
        parent_[high] = low;
        is_turned_[high] = (turned_a != turned_b) != are_opposite;
    }

 private:
    std::vector<std::uint32_t> parent_;
    std::vector<bool> is_turned_;  // against the parent
};

}  // namespace

std::vector<std::uint8_t> find_turned_corners(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    const EdgeTable<std::uint32_t> table(triangles);
    OrientedCorners corners(3 * triangles.size());
    const auto corner_of = [](const TriangleSide<std::uint32_t>& side, bool at_low) {
        return 3 * side.triangle + side.corner(at_low);
    };
    bool is_consistent = true;
    for (const auto edge : table.edges()) {
        for (std::size_t i = 1; i < edge.size(); ++i) {
            const auto &a = edge[i - 1], &b = edge[i];
            const bool are_opposite = a.rises == b.rises;
            is_consistent = is_consistent && !are_opposite;
            for (const bool at_low : {true, false})
                corners.join(corner_of(a, at_low), corner_of(b, at_low), are_opposite);
        }
    }
    if (is_consistent) return {};
    std::vector<std::uint8_t> turned(triangles.size(), 0);
    for (std::uint32_t corner = 0; corner < 3 * triangles.size(); ++corner) {
        if (corners.find(corner).second) turned[corner / 3] |= static_cast<std::uint8_t>(1U << corner % 3);
    }
    return turned;
}

std::vector<Vec3f> vertex_normals(const std::vector<Vec3f>& x,
                                  const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                  const std::vector<std::uint8_t>& turned_corners) {
    SELVEDGE_ASSERT(turned_corners.empty() || turned_corners.size() == triangles.size());
    std::vector<Vec3d> sums(x.size(), Vec3d::Zero());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto& [a, b, c] = triangles[t];
        SELVEDGE_ASSERT(a < x.size() && b < x.size() && c < x.size());
        const Vec3d at = x[a].cast<double>();
        const Vec3d area = (x[b].cast<double>() - at).cross(x[c].cast<double>() - at);
        const unsigned turned = turned_corners.empty() ? 0U : turned_corners[t];
        for (std::size_t k = 0; k < 3; ++k) sums[triangles[t][k]] += (turned >> k & 1U) != 0 ? Vec3d(-area) : area;
    }
    std::vector<Vec3f> normals;
    normals.reserve(x.size());
    for (const Vec3d& sum : sums)
        normals.push_back(sum.isZero(0) ? Vec3f(Vec3f::UnitY()) : Vec3f(sum.stableNormalized().cast<float>()));
    return normals;
}

std::vector<Vec3f> vertex_normals(const DrawMesh& mesh) {
    if (mesh.normals.size() == mesh.x.size()) return mesh.normals;
    return vertex_normals(mesh.x, mesh.triangles, mesh.turned_corners);
}

}  // namespace selvedge::sim
