#include "sim/cloth/stretch.h"

#include <algorithm>
#include <cmath>

#include "sim/cloth/material_frame.h"

namespace selvedge {

std::vector<TriangleStrain> measure_strain(const Cloth& cloth) {
    std::vector<TriangleStrain> strains;
    strains.reserve(cloth.mesh.leaf_triangles().size());
    for (const LeafTriangle& triangle : cloth.mesh.leaf_triangles()) {
        const MaterialFrame frame = material_frame(triangle.u, cloth.material.grain_angles[triangle.panel]);
        const Vec4f e1 = cloth.x[triangle.v[1].value] - cloth.x[triangle.v[0].value];
        const Vec4f e2 = cloth.x[triangle.v[2].value] - cloth.x[triangle.v[0].value];
        const Vec4f warp = e1 * frame.a[0] + e2 * frame.a[1];
        const Vec4f weft = e1 * frame.b[0] + e2 * frame.b[1];
        const float lengths = warp.norm() * weft.norm();
        const float cosine = lengths > 0 ? std::clamp(warp.dot(weft) / lengths, -1.0F, 1.0F) : 0.0F;
        strains.push_back({warp.norm() - 1, weft.norm() - 1, std::abs(std::asin(cosine))});
    }
    return strains;
}

}  // namespace selvedge
