#include "bench/thesis/diagonal_choices.h"

namespace selvedge::bench {

using sim::Diagonal;

std::function<float(const Diagonal&)> diagonal_cost(const sim::Cloth& cloth, DiagonalChoice choice) {
    switch (choice) {
        case DiagonalChoice::Length:
            return [&x = cloth.x](const Diagonal& d) {
                return (x[d.b.value].head<3>() - x[d.a.value].head<3>()).squaredNorm();
            };
        case DiagonalChoice::RestLength:
            return [](const Diagonal& d) { return (d.u_b - d.u_a).squaredNorm(); };
        case DiagonalChoice::Curvature:
            return
                [&normals = cloth.normals](const Diagonal& d) { return -normals[d.a.value].dot(normals[d.b.value]); };
        case DiagonalChoice::MinimalChange:
            break;
    }
    return {};
}

}  // namespace selvedge::bench
