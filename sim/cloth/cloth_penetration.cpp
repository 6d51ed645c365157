#include "sim/cloth/cloth_penetration.h"

#include <array>
#include <cstdint>
#include <vector>

#include "sim/cloth/cloth.h"

namespace selvedge::sim {

Penetration find_penetration(const Cloth& cloth, const SurfaceBvh& surface, const PenetrationOptions& options) {
    std::vector<Vec3f> x;
    for (const Vec4f& point : cloth.x) x.push_back(point.head<3>());
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles())
        triangles.push_back({leaf.v[0].value, leaf.v[1].value, leaf.v[2].value});
    return find_penetration(x, triangles, surface, options);
}

}  // namespace selvedge::sim
