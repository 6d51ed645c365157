#include "sim/mesh/mesh_strain.h"

#include <algorithm>
#include <cmath>

#include "sim/core/assert.h"

namespace selvedge {
namespace {

std::uint16_t panel_of(const PlainMesh& mesh, std::size_t triangle) {
    return mesh.panel.empty() ? std::uint16_t{0} : mesh.panel[triangle];
}

// Twice the area in the material, m^2.
float material_area(const std::array<Vec2f, 3>& u) {
    const Vec2f a = u[1] - u[0], b = u[2] - u[0];
    return std::abs(a.x() * b.y() - a.y() * b.x());
}

// How much longer the unit direction of the material became.
float stretch_along(const Vec2f& direction, const std::array<Vec2f, 3>& u, const std::array<Vec3f, 3>& x) {
    const Vec2f a = u[1] - u[0], b = u[2] - u[0];
    const float area = a.x() * b.y() - a.y() * b.x();
    if (area == 0) return 0;
    const float along_a = (direction.x() * b.y() - direction.y() * b.x()) / area;
    const float along_b = (a.x() * direction.y() - a.y() * direction.x()) / area;
    return (along_a * (x[1] - x[0]) + along_b * (x[2] - x[0])).norm() - 1;
}

// A corner's share in a vertex of one panel.
struct Share {
    std::uint64_t key = 0;  // vertex, then panel
    std::uint32_t triangle = 0;
    std::uint32_t corner = 0;

    auto operator<=>(const Share&) const = default;
};

std::vector<Share> sorted_shares(const PlainMesh& mesh) {
    std::vector<Share> shares;
    shares.reserve(3 * mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            const std::uint64_t vertex = mesh.triangles[t][corner];
            shares.push_back({vertex << 16U | panel_of(mesh, t), t, corner});
        }
    }
    std::sort(shares.begin(), shares.end());
    return shares;
}

}  // namespace

std::vector<MeshStrain> measure_strain(const PlainMesh& mesh) {
    SELVEDGE_ASSERT(mesh.u.size() == mesh.triangles.size());
    std::vector<MeshStrain> strains;
    strains.reserve(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const std::array<Vec3f, 3> x{mesh.x[a], mesh.x[b], mesh.x[c]};
        const std::size_t panel = panel_of(mesh, t);
        const float grain = panel < mesh.panel_grain_angles.size() ? mesh.panel_grain_angles[panel] : 0;
        const Vec2f warp(-std::sin(grain), std::cos(grain)), weft(std::cos(grain), std::sin(grain));
        strains.push_back({stretch_along(warp, mesh.u[t], x), stretch_along(weft, mesh.u[t], x)});
    }
    return strains;
}

std::vector<std::array<float, 3>> smooth_in_panels(const PlainMesh& mesh, const std::vector<float>& values) {
    SELVEDGE_ASSERT(values.size() == mesh.triangles.size() && mesh.u.size() == mesh.triangles.size());
    std::vector<std::array<float, 3>> corners(mesh.triangles.size(), {0, 0, 0});
    const std::vector<Share> shares = sorted_shares(mesh);
    for (std::size_t first = 0; first < shares.size();) {
        float sum = 0, weight = 0;
        std::size_t last = first;
        for (; last < shares.size() && shares[last].key == shares[first].key; ++last) {
            const float area = material_area(mesh.u[shares[last].triangle]);
            sum += area * values[shares[last].triangle];
            weight += area;
        }
        for (std::size_t i = first; i < last; ++i)
            corners[shares[i].triangle][shares[i].corner] = weight > 0 ? sum / weight : 0;
        first = last;
    }
    return corners;
}

}  // namespace selvedge
