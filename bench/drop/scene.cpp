#include "bench/drop/scene.h"

#include <array>
#include <cstdlib>

#include "sim/adaptive/square.h"

namespace selvedge {

Fabric drop_fabric() {
    return {.name = "drop_cotton",
            .area_density = 0.2,
            .stretch_warp = 8000,
            .stretch_weft = 8000,
            .shear = 56,
            .bending_warp = 1e-5,
            .bending_weft = 1e-5,
            .friction = 0.6,
            .damping = 0.6,
            .strain_limit = 1};
}

int triangle_count(int base_quads, int level) {
    const int quads = base_quads << level;
    return 2 * quads * quads;
}

int base_quads_for(int triangles, const DropScene& scene) {
    constexpr std::array kBaseQuads{3, 6, 11, 22};
    int nearest = kBaseQuads[0];
    for (const int quads : kBaseQuads) {
        const int best = std::abs(triangle_count(nearest, scene.level) - triangles);
        if (std::abs(triangle_count(quads, scene.level) - triangles) < best) nearest = quads;
    }
    return nearest;
}

GarmentMesh drop_square(int base_quads, double shift, const DropScene& scene) {
    GarmentMesh square = flat_grid(base_quads, scene);
    for (Vec3d& x : square.x) x.x() += shift;
    return square;
}

GarmentMesh flat_grid(int quads, const DropScene& scene) {
    return make_square(
        {.columns = quads, .rows = quads, .width = scene.side, .depth = scene.side, .height = scene.height});
}

bool is_sampled(int frame) {
    return frame >= 30 && frame <= 90 && frame % 10 == 0;
}

}  // namespace selvedge
