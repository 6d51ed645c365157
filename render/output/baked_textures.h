#pragma once
// Bakes what cloth looks like into textures for other programs: the colour and the relief of its weave, or a printed
// picture, over the charts in which the panels are packed (sim/exchange/uv_atlas.h).
//
// Colours are the mean over each texel: of a woven cloth by prefix sums along warp and weft, as the renderer's shader
// does; of a picture by samples. Charts are baked with their margins, and beyond the outlines of the panels: what is
// drawn is on the fabric everywhere, so that no seam shows between texels.
#include <optional>
#include <vector>

#include "render/image/image.h"
#include "render/scene/scene.h"
#include "sim/exchange/garment_export.h"
#include "sim/mesh/draw_mesh.h"

namespace selvedge::render {

struct BakedTextures {
    Image base_colour;  // sRGB
    // Tangent space, +x along u, +y up in the picture, 128 = 0. None: no texel is fine enough to show a yarn.
    std::optional<Image> normal;
};

// cloths: what the panels look like, as ClothLooks::parts() divides the mesh's panels; they name all panels in the same
// order as the mesh. Throws InputError if the panels do not fit in the texture. Pre: the mesh has material coordinates,
// and there is a cloth.
BakedTextures bake(const sim::DrawMesh& mesh, const std::vector<ClothItem>& cloths, const sim::AtlasOptions& atlas);

// The same as PNG files in memory; none for a mesh without material coordinates, or for size 0.
sim::GarmentTextures bake_pngs(const sim::DrawMesh& mesh, const std::vector<ClothItem>& cloths,
                               const sim::AtlasOptions& atlas);

}  // namespace selvedge::render
