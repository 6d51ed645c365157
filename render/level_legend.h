#pragma once
// Which colour is which level, in a corner of a picture drawn with ShowMode::Level.
#include "render/image/image.h"
#include "sim/mesh/plain_mesh.h"

namespace selvedge {

// One swatch with its number for each level up to the mesh's highest, in the lower left corner. A picture too small for
// them is left as it is.
void draw_level_legend(Image& image, const PlainMesh& mesh);

}  // namespace selvedge
