#include "bench/support/bias_theory.h"

#include <cmath>

namespace selvedge {

double bias_stiffness(const Fabric& fabric) {
    return 4 / (1 / fabric.stretch_warp + 1 / fabric.stretch_weft + 1 / fabric.shear);
}

double bias_strain(const Fabric& fabric, double force) {
    double shear = force / (2 * fabric.shear);  // rad
    for (int i = 0; i < 50; ++i) shear = force * (std::cos(shear / 2) - std::sin(shear / 2)) / (2 * fabric.shear);
    const double turned = std::cos(shear / 2) + std::sin(shear / 2) - 1;
    return turned + force / 4 * (1 / fabric.stretch_warp + 1 / fabric.stretch_weft);
}

}  // namespace selvedge
