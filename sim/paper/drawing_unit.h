#pragma once
// The unit of a drawing whose file names none.
#include "sim/paper/drawing.h"

namespace selvedge::sim {

struct DrawingUnit {
    const char* name;
    double metres;
};

// The first of mm, cm, inch, px, pt and m in which the largest part is as large as panels of a garment are; else mm.
DrawingUnit guess_unit(const Drawing& drawing);

// The longer side of the box of a path, in file units: of the curve itself, for a handle may reach far beyond it.
double size_of(const DrawnPath& path);

}  // namespace selvedge::sim
