#pragma once
// Pictures of a dropped cloth, its triangles coloured by level. Owns the renderer's context: one at a time.
#include "bench/thesis/drop.h"
#include "render/image/image.h"
#include "render/renderer.h"

namespace selvedge {

class DropPainter {
 public:
    explicit DropPainter(int side_px) : side_px_(side_px) {}

    Image draw(const Cloth& cloth, DropObject object);

 private:
    Renderer renderer_;
    int side_px_;
};

}  // namespace selvedge
