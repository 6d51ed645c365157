#pragma once
// The mesh of a square of cloth, the test piece of the thesis (3.8): of experiments, examples and tests.
#include "sim/mesh/garment_mesh.h"

namespace selvedge::sim {

struct SquareOptions {
    int columns = 4;  // quads of two triangles each
    int rows = 4;
    double width = 1.0;   // m, along x
    double depth = 1.0;   // m, along y in material coordinates, -z in the world
    double height = 0.0;  // m, world y of all vertices
};

// One horizontal panel, right side up, centred on the y axis. The index of vertex (column, row) is
// row * (columns + 1) + column. The diagonals of the quads alternate, so that no direction is preferred.
// Pre: columns, rows >= 1.
GarmentMesh make_square(const SquareOptions& options = {});

}  // namespace selvedge::sim
