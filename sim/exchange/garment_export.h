#pragma once
// What a file of a garment holds beyond its mesh.
#include "sim/exchange/uv_atlas.h"

namespace selvedge::sim {

struct GarmentExport {
    AtlasOptions atlas{};  // where the panels are in the first set of texture coordinates
};

}  // namespace selvedge::sim
