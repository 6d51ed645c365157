#pragma once
// A square of cloth, the thesis' test piece.
#include "sim/mesh/garment_mesh.h"

namespace selvedge::bench {

struct SquareOptions {
    int columns = 4;  // quads of two triangles each
    int rows = 4;
    double width = 1.0;   // m, along x
    double depth = 1.0;   // m, along y of the material, -z of the room
    double height = 0.0;  // m, its y
};

// Horizontal, right side up, centred on the y axis; one panel. Vertex (column, row) is row * (columns + 1) + column.
// The quads' diagonals alternate, so that no direction is preferred. Pre: columns, rows >= 1.
sim::GarmentMesh make_square(const SquareOptions& options = {});

}  // namespace selvedge::bench
