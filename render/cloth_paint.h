#pragma once
// A cloth's paint on its way to GL: a place along a map for each corner, and the map as a row of texels.
#include "render/gl/handle.h"
#include "render/gl/program.h"
#include "render/scene/scene.h"

namespace selvedge {

struct PaintBuffer {
    Buffer places;
    Texture map{};
    int colours = 0;  // 0: not painted
    float ink = 0;    // of edges
};

// Adds the corners' places to the bound vertex array. Pre: the item's paint, where it has any, fits its mesh.
PaintBuffer make_paint_buffer(const GladGLContext& gl, const ClothItem& item);

// How the cloth shader is to draw the mode: a painted one without paint is plain.
int cloth_look(ShowMode show, const PaintBuffer& paint);

// Pre: the program is in use. `unit`: for the map.
void bind_paint(const GladGLContext& gl, const Program& program, const PaintBuffer& paint, int unit);

}  // namespace selvedge
