#pragma once
// What a file of a garment holds beyond its mesh.
#include <string>

#include "sim/body/body.h"
#include "sim/exchange/uv_atlas.h"

namespace selvedge::sim {

// PNG files in memory, over the packed texture coordinates; empty: none.
struct GarmentTextures {
    std::string base_colour{};  // sRGB
    std::string normal{};       // tangent space, +y up in the picture
};

// A file that belongs to another one in the same folder.
struct FileBeside {
    std::string name{};
    std::string bytes{};
};

struct GarmentExport {
    AtlasOptions atlas{};  // where the panels are in the first set of texture coordinates
    GarmentTextures textures{};
    const Body* body = nullptr;  // as one more mesh of the file; null: none
    std::string name{};          // of the file, without its ending: files beside it begin with it
};

}  // namespace selvedge::sim
